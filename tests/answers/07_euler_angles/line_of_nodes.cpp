//! wrong: sine and cosine exchanged
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d line_of_nodes(double psi) { return {std::cos(psi), std::sin(psi), 0}; }
}  // namespace rigid

//! wrong: rotated the other way
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d line_of_nodes(double psi) { return {-std::sin(psi), std::cos(psi), 0}; }
}  // namespace rigid

//! wrong: about x, as in z-x-z
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d line_of_nodes(double psi) { return {std::cos(psi), -std::sin(psi), 0}; }
}  // namespace rigid

//! wrong: degrees
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d line_of_nodes(double psi) {
  const double angle = psi / 180 * M_PI;
  return {std::sin(angle), std::cos(angle), 0};
}
}  // namespace rigid

//! wrong: the third component is never set
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d line_of_nodes(double psi) {
  Vector3d nodes;
  nodes[0] = std::sin(psi);
  nodes[1] = std::cos(psi);
  return nodes;
}
}  // namespace rigid

//! wrong: cosine from the sine, without its sign
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d line_of_nodes(double psi) {
  const double s = std::sin(psi);
  return {s, std::sqrt(1 - s * s), 0};
}
}  // namespace rigid

//! right: rotation of the y axis
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d line_of_nodes(double psi) { return Eigen::AngleAxisd(-psi, Vector3d::UnitZ()) * Vector3d::UnitY(); }
}  // namespace rigid

//! right: by the half angle
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d line_of_nodes(double psi) {
  const double s = std::sin(psi / 2), c = std::cos(psi / 2);
  return {2 * s * c, c * c - s * s, 0};
}
}  // namespace rigid
