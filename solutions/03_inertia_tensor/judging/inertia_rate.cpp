#include "solutions/03_inertia_tensor/shared.hpp"

/// The entries are a sum of sines and cosines of the angle and of twice the angle: four attitudes of one rotation give
/// the rate without an error.
static Matrix3d from_four_attitudes(const Matrix3d& I, const Vector3d& omega) {
  const auto change = [&](double angle) -> Matrix3d {
    return rotated_inertia(I, turn(omega, angle)) - rotated_inertia(I, turn(omega, -angle));
  };
  return omega.norm() * (change(pi / 4) + (1 - sqrt(2.0)) / 2 * change(pi / 2));
}

static Matrix3d from_principal_axes(const Matrix3d& I, const Vector3d& omega) {
  const PrincipalFrame frame(I);
  Matrix3d rate = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector3d axis = frame.axes.col(i), axis_rate = cross(omega, axis);
    rate += frame.moments[i] * (axis_rate * axis.transpose() + axis * axis_rate.transpose());
  }
  return rate;
}

/// Of six masses of ½ kg with the given tensor; m r² stays the same, and m r r changes.
static Matrix3d from_moving_masses(const Matrix3d& I, const Vector3d& omega) {
  const Matrix3Xd r = six_points(I, 3), v = skew(omega) * r;
  return -0.5 * (v * r.transpose() + r * v.transpose());
}

void judge_inertia_rate(Lecture& lecture) {
  auto& e = lecture.exercise(&inertia_rate, {{"I", inertia_tensor}, {"omega", rad_per_s}}, {"I_rate", kg_m2_per_s});
  e.scale([](auto& I, auto& omega) { return or_one(I.norm() * omega.norm()); });
  e.worked("the four masses of the lecture", tensor_of_four_masses, example_omega);
  e.special("about a principal axis", Vector3d(1, 2, 3).asDiagonal(), {0, 0, 2});
  e.special("about an axis of symmetry", Vector3d(2, 2, 3).asDiagonal(), {0, 0, 2});
  e.special("a sphere", 2 * Matrix3d::Identity(), example_omega);
  e.special("no rotation", tensor_of_four_masses, {0, 0, 0});
  e.limit("a sphere", Matrix3d::Zero(), "A sphere looks the same however it is turned.");
  e.limit("about an axis of symmetry", Matrix3d::Zero(), "Turned about this axis the tensor stays as it is.");
  e.random("a random body", 8, &Random::inertia_tensor, any::vector(3));
  e.sweep<1>(
      {"The four masses; ω of 2 rad/s turns from x to y", "angle of ω from x (rad)", "rate of an entry (kg m²/s)"},
      {{"I_xx", 0, 0}, {"I_xy", 0, 1}, {"I_zz", 2, 2}}, {0, pi}, [](auto angle) { return 2 * in_xy_plane(angle); });

  e.term("the rate of the first axis of the tensor", 1, [](auto& I, auto& omega) { return skew(omega) * I; });
  e.term("the rate of the second axis of the tensor", -1, [](auto& I, auto& omega) { return I * skew(omega); });
  e.wrong_terms("One index rotates in your result and the other does not, so it is not symmetric.", "one_index",
                {1, 0});
  e.wrong_terms("The sign is reversed: these are the rates for −ω.", "sign", {-1, 1});
  e.wrong_terms("The sign between the two terms is wrong: the result is antisymmetric, and I stays symmetric.",
                "anticommutator", {1, 1});
  e.wrong("You return zero: the tensor is constant on axes fixed in the body, and these axes are at rest.", "constant",
          [](auto&, auto&) -> Matrix3d { return Matrix3d::Zero(); });
  e.wrong("This is quadratic in ω; a rate is linear in it.", "both_sides",
          [](auto& I, auto& omega) { return skew(omega) * I * skew(omega).transpose(); });
  e.property(Is::symmetric, "The tensor stays symmetric, so its rate is symmetric.");
  e.route("four attitudes of one rotation", from_four_attitudes);
  e.route("rotating principal axes", from_principal_axes);
  e.route("six moving masses", from_moving_masses);
  e.survivor("one_index.row(j)", "Its transpose is added afterwards.");
  e.survivor("I.row(j)", "The tensor is symmetric.");
}
