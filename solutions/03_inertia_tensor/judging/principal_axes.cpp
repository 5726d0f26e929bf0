#include "solutions/03_inertia_tensor/shared.hpp"

void judge_principal_axes(Lecture& lecture) {
  auto& e = lecture.exercise(&principal_axes, {{"I", inertia_tensor}}, {"axes", none});
  e.compare(eigenvectors);
  add_tensors(e);
  e.sweep({"Axis of the smallest moment of a 1 kg cuboid (a, 1 m, 2 m) about its corner", "edge a (m)",
           "component of the first axis, overall sign free"},
          {"e1_x", "e1_y", "e1_z"}, {0.1, 3}, [](auto a) { return cuboid_about_corner(1, a, 1, 2); });

  e.wrong_output("The axes are the rows of your matrix; the columns are asked for (transpose it).", "rows", transposed);
  e.wrong_output("Your axes form a left-handed triad (determinant −1): turn one round.", "left_handed", negated);
  e.wrong_output("Your columns lie along the axes but are no unit vectors: their third component is set to 1.",
                 "unnormalised", [](auto& axes) { axes.array().rowwise() /= axes.row(2).array().eval(); });
  e.wrong_output("The axes come in the order of descending moments; ascending is asked for.", "descending",
                 [](auto& axes) { return axes * turn(y_axis, -pi / 2); });
  e.wrong_input<0>(products_of_opposite_sign, "products_flipped", products_flipped);
  e.wrong("These are the coordinate axes; they are principal axes only if the products of inertia vanish.", "identity",
          [](auto&) -> Matrix3d { return Matrix3d::Identity(); });
  e.property(Is::rotation_matrix, "Principal axes form an orthonormal, right-handed triad: VᵀV = 1, det V = +1.");
  e.route("Jacobi rotations", [](auto& I) { return axes_by_jacobi_rotations(I); });
  e.route("singular vectors", [](auto& I) {
    Matrix3d axes = Eigen::JacobiSVD<Matrix3d>(I, Eigen::ComputeFullU).matrixU().rowwise().reverse();
    if (axes.determinant() < 0) axes.col(1) = -axes.col(1);
    return axes;
  });
  e.route("other signs", [](auto& I) -> Matrix3d { return principal_axes(I) * Vector3d(-1, -1, 1).asDiagonal(); });
  e.survivor("axes = - ", "Eigenvectors are right up to their signs; handedness is restored.");
  e.survivor("determinant() <= 0", "The determinant of a triad is 1 or −1.");
}
