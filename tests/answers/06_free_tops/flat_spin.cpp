//! wrong: smallest moment
#include "rigid/free_tops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector2d flat_spin(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I.minCoeff();
  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), L.norm() / i};
}

}  // namespace rigid
//! wrong: third moment
#include "rigid/free_tops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector2d flat_spin(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I[2];
  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), L.norm() / i};
}

}  // namespace rigid
//! wrong: energy without the half
#include "rigid/free_tops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector2d flat_spin(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I.maxCoeff();
  return {L.dot(omega) - L.squaredNorm() / i, L.norm() / i};
}

}  // namespace rigid
//! wrong: final energy, not the loss
#include "rigid/free_tops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector2d flat_spin(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I.maxCoeff();
  return {L.squaredNorm() / (2 * i), L.norm() / i};
}

}  // namespace rigid
//! wrong: rate kept
#include "rigid/free_tops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector2d flat_spin(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I.maxCoeff();
  return {0.5 * L.dot(omega) - L.squaredNorm() / (2 * i), omega.norm()};
}

}  // namespace rigid
//! wrong: order of the results
#include "rigid/free_tops.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector2d flat_spin(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  const double i = I.maxCoeff();
  return {L.norm() / i, 0.5 * L.dot(omega) - L.squaredNorm() / (2 * i)};
}

}  // namespace rigid
