#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/euler_angles.hpp>
//! right: half sums and half differences
VectorXd attitude_quaternion(const Vector3d& angles) {
  const double a = (angles[0] + angles[2]) / 2, b = (angles[2] - angles[0]) / 2, c = std::cos(angles[1] / 2),
               s = std::sin(angles[1] / 2);
  VectorXd q(4);
  q << c * std::cos(a), s * std::sin(b), s * std::cos(b), c * std::sin(a);
  return q;
}
//! wrong: scalar last
-  q << c * std::cos(a), s * std::sin(b), s * std::cos(b), c * std::sin(a);
+  q << s * std::sin(b), s * std::cos(b), c * std::sin(a), c * std::cos(a);
//! wrong: whole angles
-  const double a = (angles[0] + angles[2]) / 2, b = (angles[2] - angles[0]) / 2, c = std::cos(angles[1] / 2),
-               s = std::sin(angles[1] / 2);
+  const double a = angles[0] + angles[2], b = angles[2] - angles[0], c = std::cos(angles[1]), s = std::sin(angles[1]);
//! wrong: conjugate
-  q << c * std::cos(a), s * std::sin(b), s * std::cos(b), c * std::sin(a);
+  q << c * std::cos(a), -s * std::sin(b), -s * std::cos(b), -c * std::sin(a);
//! wrong: difference with the other sign
-  const double a = (angles[0] + angles[2]) / 2, b = (angles[2] - angles[0]) / 2, c = std::cos(angles[1] / 2),
+  const double a = (angles[0] + angles[2]) / 2, b = (angles[0] - angles[2]) / 2, c = std::cos(angles[1] / 2),
//! wrong: only three numbers
-  VectorXd q(4);
-  q << c * std::cos(a), s * std::sin(b), s * std::cos(b), c * std::sin(a);
+  VectorXd q(3);
+  q << s * std::sin(b), s * std::cos(b), c * std::sin(a);
//! wrong: integer halves
-  const double a = (angles[0] + angles[2]) / 2, b = (angles[2] - angles[0]) / 2, c = std::cos(angles[1] / 2),
+  const double a = 1 / 2 * (angles[0] + angles[2]), b = 1 / 2 * (angles[2] - angles[0]), c = std::cos(angles[1] / 2),
