//! wrong: the transpose
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Matrix3d cross_matrix(const Vector3d& omega) {
  Matrix3d m;
  m << 0, omega.z(), -omega.y(), -omega.z(), 0, omega.x(), omega.y(), -omega.x(), 0;
  return m;
}
}  // namespace rigid

//! wrong: the y component with the other sign
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Matrix3d cross_matrix(const Vector3d& omega) {
  Matrix3d m;
  m << 0, -omega[2], -omega[1], omega[2], 0, -omega[0], omega[1], omega[0], 0;
  return m;
}
}  // namespace rigid

//! wrong: symmetric
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Matrix3d cross_matrix(const Vector3d& omega) {
  Matrix3d m = Matrix3d::Zero();
  m(0, 1) = m(1, 0) = omega.z();
  m(0, 2) = m(2, 0) = omega.y();
  m(1, 2) = m(2, 1) = omega.x();
  return m;
}
}  // namespace rigid

//! wrong: the diagonal is never set
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Matrix3d cross_matrix(const Vector3d& omega) {
  Matrix3d m;
  m(0, 1) = -omega.z();
  m(0, 2) = omega.y();
  m(1, 0) = omega.z();
  m(1, 2) = -omega.x();
  m(2, 0) = -omega.y();
  m(2, 1) = omega.x();
  return m;
}
}  // namespace rigid

//! wrong: whole numbers
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Matrix3d cross_matrix(const Vector3d& omega) {
  const int x = omega.x(), y = omega.y(), z = omega.z();
  Matrix3d m;
  m << 0, -z, y, z, 0, -x, -y, x, 0;
  return m;
}
}  // namespace rigid

//! right: columns are the products with the unit vectors
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Matrix3d cross_matrix(const Vector3d& omega) {
  Matrix3d m;
  for (int i = 0; i < 3; ++i) m.col(i) = omega.cross(Vector3d::Unit(i));
  return m;
}
}  // namespace rigid

//! right: row by row
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Matrix3d cross_matrix(const Vector3d& omega) { return Matrix3d::Identity().rowwise().cross(omega); }
}  // namespace rigid

//! right: upper part minus its transpose
#include <rigid/frame_derivatives.hpp>
namespace rigid {
Matrix3d cross_matrix(const Vector3d& omega) {
  Matrix3d upper = Matrix3d::Zero();
  upper(0, 1) = -omega[2];
  upper(0, 2) = omega[1];
  upper(1, 2) = -omega[0];
  return upper - upper.transpose();
}
}  // namespace rigid
