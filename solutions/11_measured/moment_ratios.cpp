#include "rigid/measured.hpp"

namespace rigid {

Vector2d moment_ratios(double a, double c) {
  // r - s = a and r + c s = 1 for the ratios r = I_y/I_x, s = I_z/I_x.
  return Vector2d(1 + a * c, 1 - a) / (1 + c);
}

}  // namespace rigid
