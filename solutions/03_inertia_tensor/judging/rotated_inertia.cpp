#include "solutions/03_inertia_tensor/shared.hpp"

void judge_rotated_inertia(Lecture& lecture) {
  auto& e = lecture.exercise(&rotated_inertia, {{"I_body", inertia_tensor}, {"A_inertial_from_body", rotation}},
                             {"I", kg_m2});
  const Matrix3d moments = Vector3d(1, 2, 3).asDiagonal();
  e.worked("moments 1, 2, 3 and the attitude (0.3, 0.7, 1.1)", moments, attitude({0.3, 0.7, 1.1}));
  e.special("no rotation", moments, Matrix3d::Identity());
  e.special("half a turn about z", tensor_of_four_masses, turn(z_axis, pi));
  e.random("a random body and attitude", 8, &Random::inertia_tensor, &Random::rotation);
  e.sweep<1>({"The tensor diag(1, 2, 3) kg m² turned about the direction (1, 1, 1)", "angle of rotation (rad)",
              "entry of I (kg m²)"},
             {"I_xx", {"I_xy", 0, 1}, {"I_xz", 0, 2}}, {0, 2 * pi},
             [](auto angle) { return turn(Vector3d::Ones(), angle); });

  e.wrong_input<1>("The tensor is turned backwards: AᵀIA leads to body axes.", "inverse_rotation", transposed);
  e.wrong("Only the left side is turned: a tensor has two indices, so it takes A on the left and Aᵀ on the right.",
          "left_only", [](auto& I, auto& A) { return A * I; });
  e.wrong("Only the right side is turned: a tensor has two indices, so it takes A on the left and Aᵀ on the right.",
          "right_only", [](auto& I, auto& A) { return I * A.transpose(); });
  e.wrong("A stands on both sides without a transpose: A I A; on the right it must be Aᵀ.", "no_transpose",
          [](auto& I, auto& A) { return A * I * A; });
  e.wrong("This is the body's tensor unchanged; on inertial axes it depends on the attitude.", "not_turned",
          [](auto& I, auto&) { return I; });
  e.wrong_output("This is only the diagonal of the turned tensor.", "diagonal_only", diagonal_part);
  e.property(Is::symmetric, "An inertia tensor is symmetric on every set of axes.");
  e.route("with the inverse", [](auto& I, auto& A) { return A * (I * A.inverse()); });
  e.route("with a quaternion", [](auto& I, auto& A) {
    const Eigen::Quaterniond q(A);
    Matrix3d turned;
    for (int j = 0; j < 3; ++j) turned.col(j) = q * Vector3d(I * (q.conjugate() * Vector3d(Vector3d::Unit(j))));
    return turned;
  });
  e.route("turned principal axes", [](auto& I, auto& A) {
    const auto [values, axes] = PrincipalFrame(I);
    return A * axes * values.asDiagonal() * (A * axes).transpose();
  });
}
