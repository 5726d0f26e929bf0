#pragma once

#include "rigid/euler_angles.hpp"
#include "solutions/judging/judging.hpp"

using Eigen::Quaterniond;

inline const Vector3d example_angles(0.3, 0.7, 1.1), example_rates(0.5, -0.2, 0.9);

// One mistake, one sentence: these serve several exercises.
inline constexpr const char* zxz_notes = "euler_angles_zxz";
inline constexpr const char* turns_notes = "euler_angles_turns";
inline constexpr const char* vertical_notes = "euler_angles_vertical";
inline constexpr const char* nodes_notes = "euler_angles_nodes";
inline constexpr const char* omega_notes = "euler_angles_omega";
inline constexpr const char* inertial_notes = "euler_angles_inertial";
inline const Sentence turned_about_x{"Your middle turn is about x (z–x–z); on the slides it is about y′ (z–y–z).",
                                     zxz_notes};
inline const Sentence turned_about_x_last{
    "Your last turn is about x (yaw, pitch, roll); on the slides it is about z again.", zxz_notes};
inline const Sentence omega_of_zxz{"This is ω for z–x–z angles (Goldstein, Landau); the slides' line of nodes is y′.",
                                   zxz_notes};

// Elementary matrices, passive as on the slides.
inline Matrix3d about_x(double angle) { return turn(x_axis, -angle); }
inline Matrix3d about_y(double angle) { return turn(y_axis, -angle); }
inline Matrix3d about_z(double angle) { return turn(z_axis, -angle); }

/// Three turns as in Goldstein, Landau and Wikipedia's figure; yaw, pitch and roll, as for aircraft.
inline Matrix3d zxz(const Vector3d& angles) { return about_z(angles[2]) * about_x(angles[1]) * about_z(angles[0]); }
inline Matrix3d zyx(const Vector3d& angles) { return about_x(angles[2]) * about_y(angles[1]) * about_z(angles[0]); }

/// From half angles, with w of either sign: it follows the angles without a jump.
inline Quaterniond body_to_inertial(const Vector3d& q) {
  const auto about = [](const Vector3d& axis, double angle) { return Quaterniond(Eigen::AngleAxisd(angle, axis)); };
  return about(z_axis, q[0]) * about(y_axis, q[1]) * about(z_axis, q[2]);
}

/// The three turns done on a triad, each about an axis of the triad as it stands by then. Columns: the body axes.
inline Matrix3d turned_triad(const Vector3d& angles) {
  Matrix3d axes = Matrix3d::Identity();
  for (const int k : {0, 1, 2}) axes = turn(axes.col(k == 1 ? 1 : 2), angles[k]) * axes;
  return axes;
}

/// The matrix E with the three axes of rotation as columns, in body components: ω = E (rates).
inline Matrix3d rates_to_omega(const Vector3d& q) {
  return columns(turned_triad(q).row(2).transpose(), about_z(q[2]).col(1), z_axis);
}

/// The rate of change of something that depends on the angles.
template <class Function>
auto rate_along(const Vector3d& angles, const Vector3d& rates, const Function& f) {
  return derivative_at_0([&](double t) { return f(angles + t * rates); }, 0.02 / or_one(rates.norm()));
}

/// Opposite quadrants taken for one, as by the arctangent of a quotient.
inline double folded(double angle) { return atan(tan(angle)); }
inline const Sentence quadrant =
    "An arctangent of a quotient cannot tell opposite quadrants; atan2(y, x) takes both signs.";

/// An angle away from the multiples of π/4.
inline double oblique_angle(Random& random) {
  return random.whole(-4, 3) * pi / 2 + pi / 4 + random.sign() * random.uniform(0.15, 0.65);
}

/// What turns z–y–z into z–x–z components.
inline constexpr auto quarter_turn = [](Vector3d& v) { v = Vector3d(v[1], -v[0], v[2]); };

/// The cases of both angular velocities.
template <class Exercise>
void add_angles_and_rates(Exercise& e) {
  e.worked("angles and rates of the lecture", example_angles, example_rates);
  e.special("at rest", example_angles, zero);
  e.special("all angles zero", zero, example_rates);
  e.special("θ = 0: φ̇ and ψ̇ add up", {0.4, 0, 0.9}, example_rates);
  e.special("θ = π: φ̇ and ψ̇ are opposed", {0.4, pi, 0.9}, example_rates);
  e.special("θ = π/2", {0.4, pi / 2, 0.9}, example_rates);
  e.special("φ = ψ and equal rates of both", {0.6, 1.2, 0.6}, {0.5, 0.3, 0.5});
  e.special("a tiny θ", {-2.5, 1e-8, 0.3}, example_rates);
  e.random("any attitude and rates", 8, &Random::euler_angles, any::vector(3));
  e.scale([](auto&, auto& rates) { return max(rates.norm(), 1e-3); });
}
