// The two rates at which a heavy symmetric top with the spin omega3 precesses without nutation at the inclination
// theta: that of smaller magnitude first, both to nine digits.
#include <rigid/heavy_top.hpp>

namespace rigid {

Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
