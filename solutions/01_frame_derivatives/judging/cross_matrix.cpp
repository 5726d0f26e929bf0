#include "solutions/01_frame_derivatives/shared.hpp"

void judge_cross_matrix(Lecture& lecture) {
  auto& e = lecture.exercise(&cross_matrix, {{"omega", rad_per_s}}, {"[omega]x", rad_per_s});
  e.worked("the angular velocity of the lecture", example_omega);
  e.special("rotation about z", {0, 0, 2});
  e.special("no rotation", {0, 0, 0});
  e.special("the component about y is zero", {1.5, 0, -0.5});
  e.random("a random angular velocity", 8, any::vector(3));
  e.scale([](auto& w) { return or_one(w.norm()); });
  e.sweep({"ω of 1 rad/s turns in the x–y plane, with 0.5 rad/s along z beside it", "direction of ω in the plane (rad)",
           "entry of the matrix (rad/s)"},
          {{"row x, column y", 0, 1}, {"row x, column z", 0, 2}, {"row y, column z", 1, 2}}, {0, 2 * pi},
          [](auto angle) { return in_xy_plane(angle) + 0.5 * z_axis; });

  const char* const entries[] = {"ω_x in rows and columns y, z", "ω_y in rows and columns z, x",
                                 "ω_z in rows and columns x, y"};
  for (int i = 0; i < 3; ++i) e.term(entries[i], 1, [i](auto& w) { return skew(w[i] * Vector3d::Unit(i)); });
  e.wrong_output("All signs are reversed: your matrix computes V × ω instead of ω × V.", "transposed", transposed);
  e.wrong("Your matrix has no minus signs; each component of ω stands in it once with + and once with −.", "symmetric",
          [](auto& w) -> Matrix3d { return skew(w).cwiseProduct(skew(Vector3d::Ones())); });
  e.wrong_output(
      "The signs of your second row are reversed: the y component of the expanded determinant takes a minus.",
      "row_y_sign", [](auto& W) { W.row(1) *= -1; });
  e.wrong_input<0>("Both entries with ω_y have the wrong sign: row x, column z holds +ω_y.", "omega_y_sign", negate(1));
  e.wrong_input<0>("ω_x and ω_z have changed places: the entries in rows and columns x and y hold ω_z.",
                   "order_of_components", exchange(0, 2));
  e.wrong_input<0>("Your matrix has ω_x and −ω_y where +ω_z and +ω_y belong: column x is ω × x̂ = (0, ω_z, −ω_y).",
                   "order_and_sign", [](auto& w) { return Vector3d(w[2], -w[1], w[0]); });
  e.wrong("Your matrix multiplies component by component; ω × V mixes them, so it has zeros on its diagonal.",
          "diagonal", [](auto& w) -> Matrix3d { return w.asDiagonal(); });
  e.wrong_output("The entries below the diagonal are missing: they are minus those above it.", "upper_only",
                 [](Matrix3d& W) -> Matrix3d { return W.triangularView<Eigen::Upper>(); });
  e.wrong_output("The entries above the diagonal are missing: they are minus those below it.", "lower_only",
                 [](Matrix3d& W) -> Matrix3d { return W.triangularView<Eigen::Lower>(); });
  e.wrong_input<0>("Your entries are those of the unit vector ω/|ω|; ω × V also grows with the length of ω.",
                   "unit_vector", [](auto& w) { w.stableNormalize(); });
  e.property(Is::antisymmetric, "The matrix of ω× is antisymmetric, because ω × V is perpendicular to V for every V.");
  e.route("column by column", [](auto& w) { return columns(cross(w, x_axis), cross(w, y_axis), cross(w, z_axis)); });
  e.route("upper triangle less its mirror image", [](auto& w) {
    const Matrix3d upper{{0, -w.z(), w.y()}, {0, 0, -w.x()}, {0, 0, 0}};
    return upper - upper.transpose();
  });
  e.route("the permutation symbol", [](auto& w) {
    Matrix3d W = Matrix3d::Zero();
    for (int n = 0; n < 27; ++n) {
      const int i = n % 3, j = n / 3 % 3, k = n / 9;
      W(i, k) += (i - j) * (j - k) * (k - i) / 2.0 * w[j];
    }
    return W;
  });
}
