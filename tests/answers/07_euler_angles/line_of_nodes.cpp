#include <cmath>
#include <rigid/euler_angles.hpp>
Vector3d line_of_nodes(double psi) {
//! right: rotation of the y axis
Vector3d line_of_nodes(double psi) { return Eigen::AngleAxisd(-psi, Vector3d::UnitZ()) * Vector3d::UnitY(); }
//! right: by the half angle
  const double s = std::sin(psi / 2), c = std::cos(psi / 2);
  return {2 * s * c, c * c - s * s, 0};
//! wrong: sine and cosine exchanged
Vector3d line_of_nodes(double psi) { return {std::cos(psi), std::sin(psi), 0}; }
//! wrong: rotated the other way
Vector3d line_of_nodes(double psi) { return {-std::sin(psi), std::cos(psi), 0}; }
//! wrong: about x, as in z-x-z
Vector3d line_of_nodes(double psi) { return {std::cos(psi), -std::sin(psi), 0}; }
//! wrong: degrees
  const double angle = psi / 180 * M_PI;
  return {std::sin(angle), std::cos(angle), 0};
//! wrong: the third component is never set
  Vector3d nodes;
  nodes[0] = std::sin(psi);
  nodes[1] = std::cos(psi);
  return nodes;
//! wrong: cosine from the sine, without its sign
  const double s = std::sin(psi);
  return {s, std::sqrt(1 - s * s), 0};
