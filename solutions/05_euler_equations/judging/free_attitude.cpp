#include "solutions/05_euler_equations/shared.hpp"

namespace {

using Motion = Eigen::Matrix<double, 3, 4>;  // ω, and the attitude beside it

/// The attitude after the classical Runge-Kutta method, with the rates of ω and of the attitude as one likes.
template <class OmegaRate, class AttitudeRate>
Matrix3d integrated(const Vector3d& start, double t, const OmegaRate& omega_rate, const AttitudeRate& attitude_rate) {
  const auto rates = [&](const Motion& now) {
    const Vector3d omega = now.col(0);
    const Matrix3d A = now.rightCols<3>();
    return (Motion() << omega_rate(omega), attitude_rate(A, omega)).finished();
  };
  const Motion now = (Motion() << start, Matrix3d::Identity()).finished();
  return followed(now, t, 1 + static_cast<int>(abs(t) / 0.01), rates).template rightCols<3>();
}

auto euler(const Vector3d& I, double sign = 1) {
  return [=](const Vector3d& w) { return sign * euler_equations(I, w, zero); };
}
Matrix3d body_rate(const Matrix3d& A, const Vector3d& w) { return A * skew(w); }

/// The exact ω at two Gauss points of each of many short steps, given to `use` with the length of the step.
template <class Use>
void at_gauss_points(const Vector3d& I, const Vector3d& start, double t, const Use& use) {
  const ExactTop top(I, start);
  constexpr int steps = 1600;
  const double h = t / steps, off = sqrt(3) / 6;
  for (int i = 0; i < steps; ++i) use(top.omega((i + 0.5 - off) * h), top.omega((i + 0.5 + off) * h), h);
}

}  // namespace

void judge_free_attitude(Lecture& lecture) {
  auto& e =
      lecture.exercise(&free_attitude, {{"I", positive(kg_m2)}, {"omega0", rad_per_s}, {"t", second}}, {"A", none});
  e.domain([](auto& I, auto& w, auto t) { return is_inertia_tensor(I.asDiagonal()) && w.norm() <= 2 && abs(t) <= 30; });
  e.worked("moments 1.2, 2, 2.7 after 12 s", {1.2, 2, 2.7}, {0.4, -0.9, 0.6}, 12);
  e.worked("the same in the past", {1.2, 2, 2.7}, {0.4, -0.9, 0.6}, -7.5);
  e.worked("a spin near the middle axis", example_moments, {0.1, 1, 0.1}, 20);
  e.special("a symmetric body", {1, 1, 1.8}, {0.3, 0.1, 1.9}, 0.7);
  e.special("a symmetric body, its axis first", {0.6, 1, 1}, {1.5, -0.3, 0.8}, -6);
  e.special("a sphere", {2, 2, 2}, example_omega, 9);
  e.special("a spin about the middle axis alone", example_moments, {0, 1, 0}, 10);
  e.special("nearly equal components of ω", {1.2, 2, 2.7}, {0.7, 0.70005, 0.69992}, 28);
  // A number of steps that does not grow with the time is too small here; steps of a fixed length are not.
  e.special("fast, for half a minute", {1.2, 2, 2.7}, {0.8, -1.5, 1}, 30);
  e.special("time 0", {1.2, 2, 2.7}, {0.4, -0.9, 0.6}, 0);
  e.special("no rotation", example_moments, zero, 5);
  e.limit("a sphere", turn(example_omega.normalized(), 9 * example_omega.norm()),
          "ω is along L and stays: the body turns steadily about one direction.");
  e.limit("a spin about the middle axis alone", turn(y_axis, 10),
          "A spin exactly about a principal axis lasts, even where it is unstable.");
  e.random("a random motion", 8, &Random::principal_moments, any::vector(1.1), any::spin(2, 12));
  e.tolerance(
      1e-6,
      "The answer is integrated in steps: a method of fourth order with steps of 0.01 s stays within a millionth "
      "of the exact attitude.");
  e.scale(1);
  e.sweep({"Moments 1, 2, 3 kg m², ω = (0.1, 1, 0.1) rad/s at t = 0: how far each axis is from where it was",
           "time (s)", "cosine of the angle"},
          {{"axis 1", 0, 0}, {"axis 2", 1, 1}, {"axis 3", 2, 2}}, {0, 30, 91},
          [](auto t) { return tuple(example_moments, Vector3d(0.1, 1, 0.1), t); });

  const char* const invariants = "euler_equations_invariants";
  e.wrong_output("This is the transposed matrix: the principal axes are its rows; they should be its columns.",
                 "transposed", transposed);
  e.wrong({"This comes out as if ω came in inertial components; its components are those on the axes of the body.",
           "euler_equations_tilde"},
          "left_product", [](auto& I, auto& w, auto t) {
            return integrated(w, t, euler(I), [](auto& A, auto& now) { return skew(now) * A; });
          });
  e.wrong(
      "This is a single rotation by the integral of ω; the axis moves, and rotations about different axes do not add.",
      "exponential_of_integral", [](auto& I, auto& w, auto t) {
        Vector3d sum = zero;
        at_gauss_points(I, w, t,
                        [&](const Vector3d& one, const Vector3d& other, double h) { sum += h / 2 * (one + other); });
        return turn(sum, sum.norm());
      });
  e.wrong({"Your ω keeps its first value; without a torque L is constant in space, but ω is not.", invariants},
          "constant_omega", [](auto&, auto& w, auto t) { return turn(w, w.norm() * t); });
  e.wrong("Your body turns twice as fast as ω says: the rate of a quaternion is half of its product with ω.",
          "quaternion_rate_doubled", [](auto& I, auto& w, auto t) {
            return integrated(w, t, euler(I), [](auto& A, auto& now) { return body_rate(A, 2 * now); });
          });
  e.wrong({"The sign of the gyroscopic term is wrong in your ω: with this attitude L does not stand still in space.",
           invariants},
          "sign_of_euler", [](auto& I, auto& w, auto t) { return integrated(w, t, euler(I, -1), body_rate); });
  e.property(Is::rotation_matrix, "The principal axes stay at right angles and of length 1, and right-handed.");
  e.route("the matrix by Runge-Kutta", [](auto& I, auto& w, auto t) { return integrated(w, t, euler(I), body_rate); });
  e.route("many short turns about the exact ω", [](auto& I, auto& w, auto t) {
    Matrix3d A = Matrix3d::Identity();  // Magnus's series to fourth order
    at_gauss_points(I, w, t, [&](const Vector3d& one, const Vector3d& other, double h) {
      const Vector3d angle = h / 2 * (one + other) + sqrt(3) / 12 * h * h * cross(one, other);
      A = A * turn(angle, angle.norm());
    });
    return A;
  });
  e.route("many short turns about the principal axes", [](auto& I, auto& w, auto t) {
    Matrix3d A = Matrix3d::Identity();
    const Vector3d L = L_of(I, w);  // at rest in space
    const auto turn_about = [&](int i, double h) { A = A * turn(Vector3d::Unit(i), h * A.col(i).dot(L) / I[i]); };
    const int steps = 1 + static_cast<int>(abs(t) / 0.01);
    const double outer = 1 / (2 - std::cbrt(2));  // Yoshida's fourth order
    for (int i = 0; i < steps; ++i) {
      for (const double share : {outer, 1 - 2 * outer, outer}) {
        const double h = share * t / steps;
        for (const int axis : {0, 1}) turn_about(axis, h / 2);
        turn_about(2, h);
        for (const int axis : {1, 0}) turn_about(axis, h / 2);
      }
    }
    return A;
  });
  e.survivor("Numbers state = ", "Quaternions of any length are normalised at the end.");
  e.survivor("Eigen::Quaterniond(1, omega", "This stretches the quaternion, which is normalised at the end.");
  e.survivor("Eigen::Quaterniond(2, omega", "This stretches the quaternion, which is normalised at the end.");
  e.survivor("if ( -t != 0)", "−t vanishes with t.");
  e.survivor("make_controlled(", "Tolerances nearby reach the accuracy that is asked for.");
  e.survivor("integrate_adaptive(", "The stepper corrects its first step.");
  e.survivor("state[5]).toRotationMatrix()", "The steps keep the length to far more digits than are asked for.");
}
