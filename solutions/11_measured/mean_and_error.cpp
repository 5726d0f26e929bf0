#include "rigid/measured.hpp"

#include <cmath>

namespace rigid {

Vector2d mean_and_error(const VectorXd& values) {
  const double mean = values.mean(), n = static_cast<double>(values.size());
  return {mean, (values.array() - mean).matrix().stableNorm() / std::sqrt(n * (n - 1))};
}

}  // namespace rigid
