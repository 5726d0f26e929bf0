#include "rigid/inertia_tensor.hpp"

namespace rigid {

Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A) { return A * I_body * A.transpose(); }

}  // namespace rigid
