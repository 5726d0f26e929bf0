#include "rigid/heavy_top.hpp"

#include <cmath>

namespace rigid {

double least_rolling_speed(double radius, double g, double axial, double transverse) {
  return std::sqrt(g * radius * transverse / (axial * (axial + 1)));
}

}  // namespace rigid
