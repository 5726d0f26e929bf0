#include "rigid/frame_derivatives.hpp"

namespace rigid {

Matrix3d cross_matrix(const Vector3d& omega) {
  return Matrix3d{{0, -omega.z(), omega.y()},  //
                  {omega.z(), 0, -omega.x()},  //
                  {-omega.y(), omega.x(), 0}};
}

}  // namespace rigid
