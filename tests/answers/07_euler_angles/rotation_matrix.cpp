#include <cmath>
#include <rigid/euler_angles.hpp>
Matrix3d rotation_matrix(const Vector3d& angles) {
//! right: the library's rotations, transposed
  using Eigen::AngleAxisd;
  const Matrix3d A = (AngleAxisd(angles[0], Vector3d::UnitZ()) * AngleAxisd(angles[1], Vector3d::UnitY()) *
                      AngleAxisd(angles[2], Vector3d::UnitZ()))
                         .toRotationMatrix();
  return A.transpose();
//! wrong: z-x-z of the other books
-  const Matrix3d A = (AngleAxisd(angles[0], Vector3d::UnitZ()) * AngleAxisd(angles[1], Vector3d::UnitY()) *
+  const Matrix3d A = (AngleAxisd(angles[0], Vector3d::UnitZ()) * AngleAxisd(angles[1], Vector3d::UnitX()) *
//! wrong: degrees
-  const Matrix3d A = (AngleAxisd(angles[0], Vector3d::UnitZ()) * AngleAxisd(angles[1], Vector3d::UnitY()) *
-                      AngleAxisd(angles[2], Vector3d::UnitZ()))
+  const Vector3d rad = angles * M_PI / 180;
+  const Matrix3d A = (AngleAxisd(rad[0], Vector3d::UnitZ()) * AngleAxisd(rad[1], Vector3d::UnitY()) *
+                      AngleAxisd(rad[2], Vector3d::UnitZ()))
//! right: all nine entries
  const double cf = std::cos(angles[0]), sf = std::sin(angles[0]);
  const double ct = std::cos(angles[1]), st = std::sin(angles[1]);
  const double cp = std::cos(angles[2]), sp = std::sin(angles[2]);
  Matrix3d R;
  R << cp * ct * cf - sp * sf, cp * ct * sf + sp * cf, -cp * st, -sp * ct * cf - cp * sf, -sp * ct * sf + cp * cf,
      sp * st, st * cf, st * sf, ct;
  return R;
//! wrong: order of the three rotations
  const auto z = [](double a) {
    Matrix3d m;
    m << std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1;
    return m;
  };
  Matrix3d y;
  y << std::cos(angles[1]), 0, -std::sin(angles[1]), 0, 1, 0, std::sin(angles[1]), 0, std::cos(angles[1]);
  return z(angles[0]) * y * z(angles[2]);
//! wrong: sense of the second rotation
-  y << std::cos(angles[1]), 0, -std::sin(angles[1]), 0, 1, 0, std::sin(angles[1]), 0, std::cos(angles[1]);
-  return z(angles[0]) * y * z(angles[2]);
+  y << std::cos(angles[1]), 0, std::sin(angles[1]), 0, 1, 0, -std::sin(angles[1]), 0, std::cos(angles[1]);
+  return z(angles[2]) * y * z(angles[0]);
//! wrong: the first angle used twice
-  return z(angles[0]) * y * z(angles[2]);
+  return z(angles[0]) * y * z(angles[0]);
//! wrong: active, the transpose
  using Eigen::AngleAxisd;
  return (AngleAxisd(angles[0], Vector3d::UnitZ()) * AngleAxisd(angles[1], Vector3d::UnitY()) *
          AngleAxisd(angles[2], Vector3d::UnitZ()))
      .toRotationMatrix();
