#include "solutions/07_euler_angles/shared.hpp"

namespace {

double wrapped(double angle) { return std::remainder(angle, 2 * pi); }
bool is_upright(const Vector3d& q) { return abs(sin(q[1])) < 1e-9; }

/// z–x–z angles with θ in [0, π] and the others as they come: in their ranges, and 0 for ψ where ê₃ is upright.
Vector3d in_range(Vector3d q) {
  if (is_upright(q)) q = Vector3d(q[0] + cos(q[1]) * q[2], q[1], 0);
  return {wrapped(q[0]), q[1], wrapped(q[2])};
}

/// Three angles of any size, converted as one likes and brought into their ranges.
template <class Change>
auto converted_by(const Change& change) {
  return [change](auto& angles) {
    Vector3d q = angles;
    change(q);
    q[1] = wrapped(q[1]);
    if (q[1] < 0) q = Vector3d(q[0] + pi, -q[1], q[2] + pi);
    return in_range(q);
  };
}

/// The result without one of its conventions.
template <class Convention>
auto careless(const Convention& convention) {
  return [convention](auto& q, auto& angles) { convention(q, angles); };
}

}  // namespace

void judge_to_zxz(Lecture& lecture) {
  auto& e = lecture.exercise(&to_zxz, {{"angles", rad}}, {"angles_zxz", rad});
  e.domain([](auto& q) {
    const double sine = abs(sin(q[1]));
    const Vector3d found = to_zxz(q);
    return q.cwiseAbs().maxCoeff() < 100 && (sine > 1e-6 || sine < 1e-12) &&
           max(abs(found[0]), abs(found[2])) < pi - 1e-6;
  });
  e.worked("the angles of the lecture", example_angles);
  e.worked("the orbit of the lecture", {-50 * degree, 51.6 * degree, 120 * degree});
  e.special("φ beyond its range", {2, 0.7, 1.1});
  e.special("ψ beyond its range", {0.4, 0.9, -2.5});
  e.special("a negative θ", {0.4, -0.9, 1.2});
  e.special("θ beyond π", {0.4, 4, 1.2});
  e.special("full turns more", {7.5, 0.7 - 4 * pi, -8.2});
  e.special("ê₃ upwards: only the sum counts", {0.4, 0, 0.9});
  e.special("ê₃ upwards, θ a full turn", {2.4, 2 * pi, 1.9});
  e.special("ê₃ downwards: only the difference counts", {0.4, pi, 1.9});
  e.special("ê₃ downwards, θ = −π", {0.4, -pi, 0.9});
  e.special("nearly upright", {0.4, 1e-5, 0.9});
  e.special("nearly upside down", {0.4, pi - 1e-5, 0.9});
  e.special("no turn at all", zero);
  e.random("any attitude", 10, [](Random& random) {
    Vector3d angles;
    do {
      angles = random.euler_angles();
    } while (to_zxz(angles).cwiseAbs().maxCoeff() > 3);
    return angles;
  });
  e.random("ê₃ upright", 4, [](Random& random) {
    const double theta = random.whole(0, 1) * pi, phi = random.sign() * random.uniform(0.3, 1.4);
    const double psi = random.sign() * random.uniform(0.2, 1.4);
    return Vector3d(phi, theta, psi);
  });
  e.scale(1);
  e.sweep({"φ = 0.3, ψ = 1.1: a body that tilts over and over", "θ, z–y–z (rad)", "angle, z–x–z (rad)"},
          {"φ", "θ", "ψ"}, {-6, 6.1, 97}, [](auto theta) { return Vector3d(0.3, theta, 1.1); });

  e.wrong("These are the z–y–z angles; with the same numbers z–x–z is another attitude.", "unchanged",
          converted_by([](auto&) {}));
  e.wrong("The quarter turns have the wrong signs: y′ is x′ after a quarter turn forwards.", "quarter_turns_exchanged",
          converted_by([](auto& q) { q += Vector3d(-pi / 2, 0, pi / 2); }));
  e.wrong("Only φ has its quarter turn; ψ makes up for it with one backwards.", "first_only",
          converted_by([](auto& q) { q[0] += pi / 2; }));
  e.wrong("Both quarter turns have the same sign; the second one undoes the first.", "both_forwards",
          converted_by([](auto& q) { q += Vector3d(pi / 2, 0, pi / 2); }));
  e.wrong("These are z–x–z angles of the inverse rotation.", "inverse",
          converted_by([](auto& q) { q = Vector3d(pi / 2 - q[2], -q[1], -q[0] - pi / 2); }));
  e.wrong_output(
      "A negative θ is only made positive; the line of nodes is reversed with it, so φ and ψ take half a turn.",
      "theta_made_positive", careless([](auto& q, auto& angles) {
        if (sin(angles[1]) < -1e-9) q = in_range(q + Vector3d(pi, 0, pi));
      }));
  e.wrong_output("Your θ leaves its range from 0 to π.", "theta_as_it_comes", careless([](auto& q, auto& angles) {
                   if (angles[1] < 0 || angles[1] > pi) q = in_range(angles + Vector3d(pi / 2, 0, -pi / 2));
                 }));
  e.wrong_output("φ and ψ lie between 0 and 2π; asked for is the range from −π to π.", "from_0_to_2_pi",
                 careless([](auto& q, auto&) {
                   for (const int i : {0, 2}) q[i] += q[i] < 0 ? 2 * pi : 0;
                 }));
  e.wrong_output(
      "Where ê₃ is upright your ψ is not 0: there every split of the turn is right, and this one is asked for.",
      "no_convention", careless([](auto& q, auto& angles) {
        if (!is_upright(angles)) return;
        q[2] = wrapped(angles[2] - pi / 2);
        q[0] = wrapped(q[0] - cos(angles[1]) * q[2]);
      }));
  e.wrong_output("Where ê₃ points down the turns are added; there the last one counts backwards.", "always_added",
                 careless([](auto& q, auto& angles) {
                   if (is_upright(angles) && cos(angles[1]) < 0) q[0] = wrapped(angles[0] + angles[2]);
                 }));
  e.wrong("The sums are right, but they are not brought into their ranges, and where ê₃ is upright ψ is not 0.",
          "as_they_come", [](auto& q) { return q + Vector3d(pi / 2, 0, -pi / 2); });
  e.angles_read_as_degrees(turns_notes);
  e.route("entries of the matrix", [](auto& q) {
    const Matrix3d R = rotation_matrix(q);
    const double theta = atan2(hypot(R(2, 0), R(2, 1)), R(2, 2));
    if (is_upright(q)) return Vector3d(atan2(R(0, 1), R(0, 0)), theta, 0);
    return Vector3d(atan2(R(2, 0), -R(2, 1)), theta, atan2(R(0, 2), R(1, 2)));
  });
  e.route("half angles of the quaternion", [](auto& angles) {
    const Quaterniond q = body_to_inertial(angles);
    const double half_sum = atan2(q.z(), q.w()), half_difference = atan2(q.y(), q.x());  // of φ and ψ
    const double theta = 2 * atan2(hypot(q.x(), q.y()), hypot(q.z(), q.w()));
    if (is_upright(angles)) return Vector3d(wrapped(2 * (theta < 1 ? half_sum : half_difference)), theta, 0);
    return in_range(Vector3d(half_sum + half_difference, theta, half_sum - half_difference));
  });
  e.route("directions of ê₃ and of the line of nodes", [](auto& q) {
    const Matrix3d axes = turned_triad(q);
    const Vector3d top = axes.col(2), level = is_upright(q) ? Vector3d(axes.col(0)) : cross(z_axis, top);
    const Vector3d nodes = level.normalized();
    return Vector3d(atan2(nodes.y(), nodes.x()), atan2(hypot(top.x(), top.y()), top.z()),
                    is_upright(q) ? 0 : atan2(-nodes.dot(axes.col(1)), nodes.dot(axes.col(0))));
  });
}
