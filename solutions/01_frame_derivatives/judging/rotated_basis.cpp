#include "solutions/01_frame_derivatives/shared.hpp"

static Vector3d unit_of(const Vector3d& omega) { return omega.stableNormalized(); }
static Matrix3d turn_of(const Vector3d& omega, double dt) { return turn(omega, omega.norm() * dt); }

/// exp(W) by halving W until its series is short, and squaring the result: a route without axis and angle.
static Matrix3d exponential(const Matrix3d& W) {
  const int halvings = max(0, static_cast<int>(std::ceil(std::log2(max(W.norm(), 1e-300)))) + 4);
  Matrix3d power = Matrix3d::Identity(), result = power;
  for (int k = 1; k <= 14; ++k) {
    power = power * W / std::exp2(halvings) / k;
    result += power;
  }
  for (int k = 0; k < halvings; ++k) result = result * result;
  return result;
}

static void add_cases(auto& e) {
  const Matrix3d E0 = example_basis;
  const Vector3d unit = unit_of(example_omega);
  e.worked("the basis of the lecture, after 0.8 s", E0, example_omega, 0.8);
  e.special("no time passes", E0, example_omega, 0);
  e.special("no rotation", E0, {0, 0, 0}, 0.8);
  e.special("from the inertial basis", Matrix3d::Identity(), example_omega, 0.8);
  e.special("an angle of 1e-8", E0, unit, 1e-8);
  e.special("a very slow rotation", E0, 1e-9 * unit, 0.8);
  e.special("with the Earth on its orbit, for a hundred days", E0, 1.99e-7 * unit, 8.64e6);
  e.special("just short of half a turn", E0, unit, pi - 1e-8);
  e.special("half a turn", E0, unit, pi);
  e.special("just short of a full turn", E0, unit, 2 * pi - 1e-8);
  e.worked("back in time", E0, example_omega, -0.8);
  e.worked("many turns", E0, example_omega, 60);
  e.random("a random basis and angular velocity", 8, &Random::rotation, any::vector(2), any::uniform(0.3, 1.2));
  e.scale(1);
  e.template sweep<2>({"The first basis vector during one turn with ω = (0.3, −0.2, 0.5) rad/s", "time (s)",
                       "component of the first basis vector"},
                      {"x", "y", "z"}, {0, 2 * pi / example_omega.norm(), 121});
}

void judge_rotated_basis(Lecture& lecture) {
  auto& e = lecture.exercise(&rotated_basis, {{"E", rotation}, {"omega", rad_per_s}, {"dt", second}}, {"basis", none});
  add_cases(e);
  const char* const small = "frame_derivatives_small";
  e.term("e", 1, [](auto& E, auto&, auto) { return E; });
  e.term("sin θ n × e", 1, [](auto& E, auto& w, auto dt) { return sin(w.norm() * dt) * skew(unit_of(w)) * E; });
  e.term("(1 − cos θ) n × (n × e)", 1, [](auto& E, auto& w, auto dt) {
    const Matrix3d N = skew(unit_of(w));
    return 2 * pow(sin(w.norm() * dt / 2), 2) * N * N * E;
  });
  e.wrong({"This is the first-order step E + ω × E dt, which leaves the circle: E is not orthonormal.", small},
          "first_order", [](auto& E, auto& w, auto dt) { return E + dt * skew(w) * E; });
  e.wrong("This is the series of the rotation up to dt²; the sum of the whole series is Rodrigues' formula.",
          "second_order", [](auto& E, auto& w, auto dt) { return E + dt * skew(w) * (E + dt / 2 * skew(w) * E); });
  e.wrong({"This is the first-order step made of unit vectors: the right length, but not the direction.", small},
          "first_order_normalised",
          [](auto& E, auto& w, auto dt) -> Matrix3d { return (E + dt * skew(w) * E).colwise().normalized(); });
  e.wrong({"This is Cayley's rotation, by 2 atan(|ω| dt/2), which is |ω| dt for a small angle only.", small}, "cayley",
          [](auto& E, auto& w, auto dt) { return turn(w, 2 * atan(w.norm() * dt / 2)) * E; });
  e.wrong("With the rotation on the right of E, ω acts as if its components were on the body axes; they are inertial.",
          "body_components", [](auto& E, auto& w, auto dt) { return E * turn_of(w, dt); });
  e.wrong_input<2>({"Your basis turns backwards: the slides' matrix acts on the basis vectors, Rᵀ on components.",
                    "frame_derivatives_transposed"},
                   "inverse_rotation", negated);
  e.wrong("The rotation is on the right of E and backwards; ω is inertial, so that by +ω dt stands on the left of E.",
          "body_components_backwards", [](auto& E, auto& w, auto dt) { return E * turn_of(w, -dt); });
  e.wrong_input<2>("This comes out when |ω| dt, in radians, is converted from degrees.", "degrees", times(degree));
  e.wrong_input<2>("This comes out when the angle is in degrees; sine, cosine and Eigen's AngleAxisd take radians.",
                   "to_degrees", times(1 / degree));
  e.wrong("This is a rotation by the angle dt; the angle is |ω| dt.", "angle_is_dt",
          [](auto& E, auto& w, auto dt) { return turn(w, dt) * E; });
  e.wrong_input<2>("This is a rotation by |ω|, whatever the time; the angle is |ω| dt.", "angle_is_omega", fixed(1.0));
  e.wrong("This comes out with ω for the axis; Rodrigues' formula and AngleAxisd take the unit vector ω/|ω|.",
          "axis_not_unit", [](auto& E, auto& w, auto dt) { return Eigen::AngleAxisd(w.norm() * dt, w) * E; });
  const Sentence three_turns =
      "These are three turns about x, y and z in succession, another rotation: turns do not commute.";
  const auto about = [](int axis, auto& w, auto dt) { return turn(Vector3d::Unit(axis), w[axis] * dt); };
  e.wrong(three_turns, "three_turns",
          [=](auto& E, auto& w, auto dt) { return about(0, w, dt) * about(1, w, dt) * about(2, w, dt) * E; });
  e.wrong(three_turns, "three_turns_other_order",
          [=](auto& E, auto& w, auto dt) { return about(2, w, dt) * about(1, w, dt) * about(0, w, dt) * E; });
  e.wrong_output(
      "The part of e along the axis shrinks with cos θ: (1 − cos θ) n (n·e) is missing.", "no_parallel_part",
      [](auto& turned, auto& E, auto& w, auto dt) { turned -= (1 - cos(w.norm() * dt)) * dyad(unit_of(w)) * E; });
  e.wrong_input<0>("This is the rotation itself; the basis E that is to be turned does not enter.", "rotation_only",
                   fixed<Matrix3d>(Matrix3d::Identity()));
  const Sentence two_forms =
      "Two forms of Rodrigues' formula are mixed: (1 − cos θ) n × (n × e) goes with e, and (1 − cos θ) n (n·e) with "
      "cos θ e.";
  e.wrong_output(two_forms, "forms_mixed",
                 [](auto& turned, auto& E, auto& w, auto dt) { turned -= (1 - cos(w.norm() * dt)) * E; });
  e.wrong_output(two_forms, "forms_mixed_other_way",
                 [](auto& turned, auto& E, auto& w, auto dt) { turned += (1 - cos(w.norm() * dt)) * E; });
  e.wrong_output("The basis vectors are the rows of your result; they belong into its columns.", "rows", transposed);
  e.wrong_input<0>("The rows of E are turned here; the basis vectors are its columns.", "rows_turned", transposed);
  e.wrong_terms("This is the basis as it was at the start.", "not_turned", {1, 0, 0});
  e.property(Is::rotation_matrix, "Basis vectors that turn stay orthonormal and right-handed: EᵀE = 1, det E = +1.");
  e.route("exponential of the cross matrix", [](auto& E, auto& w, auto dt) { return exponential(dt * skew(w)) * E; });
  e.route("unit quaternion", [](auto& E, auto& w, auto dt) {
    const double half = 0.5 * w.norm() * dt;
    const Vector3d v = sin(half) * unit_of(w);
    return Eigen::Quaterniond(cos(half), v[0], v[1], v[2]).toRotationMatrix() * E;
  });
  e.route("parallel and perpendicular part", [](auto& E, auto& w, auto dt) {
    const Matrix3d along = dyad(unit_of(w)) * E, across = skew(unit_of(w)) * E;
    return along + cos(w.norm() * dt) * (E - along) + sin(w.norm() * dt) * across;
  });
  e.route("on the body axes, from the right",
          [](auto& E, auto& w, auto dt) { return E * turn(E.transpose() * w, w.norm() * dt); });
  e.route("a thousand small turns", [](auto& E, auto& w, auto dt) {
    Matrix3d turned = E;
    for (int k = 0; k < 1000; ++k) turned = turn_of(w, dt / 1000) * turned;
    return turned;
  });
  e.survivor("return turn * E", "Eigen turns a matrix by an AngleAxis as by its matrix.");
}
