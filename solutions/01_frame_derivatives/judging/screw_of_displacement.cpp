#include "solutions/01_frame_derivatives/shared.hpp"

namespace {

Matrix3Xd two_columns(const Vector3d& point, const Vector3d& shift) {
  return (Eigen::Matrix<double, 3, 2>() << point, shift).finished();
}

/// The right shift, and the point at (a + b n ×) d⊥ with a and b of one's own.
template <class Factors>
auto at_point(const Factors& factors) {
  return [factors](auto& rotation, auto& d) {
    const double angle = rotation.norm();
    const Vector3d n = rotation / angle, shift = n * n.dot(d), across = d - shift;
    const auto [a, b] = factors(angle);
    return two_columns(a * across + b * cross(n, across), shift);
  };
}

/// ∫ exp(s [ω]×) ds over the unit of time: what a steady screw makes of a velocity. Simpson's rule.
Matrix3d displaced_by(const Vector3d& omega) {
  const int steps = 400;
  Matrix3d sum = Matrix3d::Zero();
  for (int i = 0; i <= steps; ++i)
    sum += (i == 0 || i == steps ? 1 : i % 2 == 0 ? 2 : 4) * turn(omega, omega.norm() * i / steps);
  return sum / (3 * steps);
}

}  // namespace

void judge_screw_of_displacement(Lecture& lecture) {
  auto& e = lecture.exercise(&screw_of_displacement, {{"rotation", nonzero(rad)}, {"d", metre}}, {"screw", metre});
  e.domain([](auto& rotation, auto&) { return rotation.norm() >= 1e-3 && rotation.norm() <= 2 * pi - 1e-3; });
  const Vector3d to_shelf(0.4, 0.2, 1.1);
  e.worked("a book put on a shelf", pi / 2 * z_axis, to_shelf);
  e.worked("any axis and angle", {0.2, 0.5, -0.3}, {0.3, -0.7, 0.2});
  e.special("half a turn", pi * y_axis, to_shelf);
  e.special("more than half a turn", {2, -3, 1.5}, to_shelf);
  e.special("a small angle", {0, 0.002, 0}, to_shelf);
  e.special("a rotation about the origin", {0.2, 0.5, -0.3}, zero);
  e.special("a shift along the axis", {0.2, 0.5, -0.3}, {-0.4, -1, 0.6});
  e.special("a shift across the axis", pi / 3 * z_axis, {0.4, 0.2, 0});
  e.random("a random displacement", 10, [](Random& random) {
    const Vector3d axis = random.vector(1).normalized(), d = random.vector(2);
    const double angle = random.sign() > 0 ? random.uniform(0.4, 1.3) : random.uniform(1.8, 2.8);
    return tuple(Vector3d(angle * axis), d);
  });
  e.scale([](auto& rotation, auto& d) { return or_one(d.norm() * (1 + abs(1 / tan(rotation.norm() / 2)))); });
  e.sweep({"A book goes 0.4 m to the right and 0.2 m back: about which line?", "angle (rad)", "point of the line (m)"},
          {{"x", 0, 0}, {"y", 1, 0}}, {0.4, 5.9},
          [=](auto angle) { return tuple(Vector3d(angle * z_axis), to_shelf); });

  e.wrong("The cotangent is that of the whole angle; the bisector halves it.", "whole_angle",
          at_point([](double angle) { return tuple(0.5, 0.5 / tan(angle)); }));
  e.wrong("The tangent stands where the cotangent belongs: a small angle has its line far away.", "tangent",
          at_point([](double angle) { return tuple(0.5, 0.5 * tan(angle / 2)); }));
  e.wrong("The line is on the other side: n̂ × d has the wrong sign.", "sign",
          at_point([](double angle) { return tuple(0.5, -0.5 / tan(angle / 2)); }));
  e.wrong("This is half-way between the origin and its new place; that is right for half a turn only.", "half_way",
          at_point([](double) { return tuple(0.5, 0.0); }));
  e.wrong("The factor ½ of the point is missing.", "no_half",
          at_point([](double angle) { return tuple(1.0, 1 / tan(angle / 2)); }));
  e.wrong("This is the line of a small rotation, as for velocities; here the angle is finite.", "as_for_velocities",
          at_point([](double angle) { return tuple(0.0, 1 / angle); }));
  e.wrong_output(
      "This is a point of the line, but not the nearest to the origin: d enters with its part along the axis.",
      "not_nearest", [](auto& screw) { screw.col(0) += screw.col(1) / 2; });
  e.wrong_output("The shift is the whole of d; the part across the axis is made by the rotation.", "whole_shift",
                 [](auto& screw, auto&, auto& d) { screw.col(1) = d; });
  e.wrong_output("The columns are exchanged: first the point, then the shift.", "exchanged",
                 [](auto& screw) -> Matrix3Xd { return screw.rowwise().reverse(); });
  e.wrong("n̂ is not of length 1 here: the rotation vector has to be divided by its length.", "not_normalised",
          [](auto& rotation, auto& d) {
            const Vector3d shift = rotation * rotation.dot(d), across = d - shift;
            return two_columns((across + cross(rotation, d) / tan(rotation.norm() / 2)) / 2, shift);
          });
  e.route("linear equations for a point that moves along the line only", [](auto& rotation, auto& d) {
    const Vector3d n = rotation.normalized(), shift = n * n.dot(d);
    const Matrix3d A = turn(rotation, rotation.norm());
    return two_columns((Matrix3d::Identity() - A + dyad(n)).inverse() * (d - shift), shift);
  });
  e.route("complex numbers in the plane across the axis", [](auto& rotation, auto& d) {
    const Vector3d n = rotation.normalized(), x = n.unitOrthogonal(), y = cross(n, x);
    const std::complex across(d.dot(x), d.dot(y));
    const auto c = across / (1.0 - polar(1.0, rotation.norm()));
    return two_columns(c.real() * x + c.imag() * y, n * n.dot(d));
  });
  e.route("the axis of a steady motion that does it in a second", [](auto& rotation, auto& d) {
    const Vector3d velocity = displaced_by(rotation).inverse() * d, n = rotation.normalized();
    return two_columns(point_on_screw_axis(zero, velocity, rotation), n * n.dot(velocity));
  });
}
