#include "rigid/parallel_axis.hpp"

#include <numbers>

namespace rigid {

double gravity_from_kater(double h1, double T1, double h2, double T2) {
  constexpr double turn = 2 * std::numbers::pi;
  return turn * turn * (h1 - h2) * (h1 + h2) / (h1 * T1 * T1 - h2 * T2 * T2);
}

}  // namespace rigid
