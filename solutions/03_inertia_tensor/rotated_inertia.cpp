#include "rigid/inertia_tensor.hpp"

namespace rigid {

Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body) {
  return A_inertial_from_body * I_body * A_inertial_from_body.transpose();
}

}  // namespace rigid
