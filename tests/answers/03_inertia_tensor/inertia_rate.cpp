//! wrong: angular momentum rate on the diagonal
#include "rigid/inertia_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Matrix3d inertia_rate(const Matrix3d& I, const Vector3d& omega) {
  const Vector3d d = omega.cross(I * omega);
  return d.asDiagonal();
}

}  // namespace rigid
//! wrong: half of it
#include "rigid/inertia_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Matrix3d inertia_rate(const Matrix3d& I, const Vector3d& omega) {
  Matrix3d W;
  W << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
  return 0.5 * (W * I - I * W);
}

}  // namespace rigid
//! wrong: one sign in the matrix
#include "rigid/inertia_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Matrix3d inertia_rate(const Matrix3d& I, const Vector3d& omega) {
  Matrix3d W;
  W << 0, -omega[2], omega[1], omega[2], 0, omega[0], -omega[1], omega[0], 0;
  return W * I - I * W;
}

}  // namespace rigid
//! wrong: triple product
#include "rigid/inertia_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Matrix3d inertia_rate(const Matrix3d& I, const Vector3d& omega) {
  Matrix3d W;
  W << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
  return W * I * W;
}

}  // namespace rigid
//! right: by the commutator
#include "rigid/inertia_tensor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Matrix3d inertia_rate(const Matrix3d& I, const Vector3d& omega) {
  Matrix3d W;
  W << 0, -omega[2], omega[1], omega[2], 0, -omega[0], -omega[1], omega[0], 0;
  return W * I - I * W;
}

}  // namespace rigid
