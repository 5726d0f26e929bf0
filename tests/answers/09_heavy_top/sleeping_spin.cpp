#include <cmath>
#include <rigid/heavy_top.hpp>
double sleeping_spin(double I1, double I3, double mgl) {
//! right: bisection for the spin at which the upright axis turns unstable
  // small tilt x + iy: I1 z'' - i I3 w z' - mgl z = 0; real frequencies while (I3 w)² > 4 I1 mgl
  const auto oscillates = [&](double w) { return (w * I3 / I1) * (w * I3 / mgl) >= 4; };
  double low = 0, high = 1e-9;
  while (!oscillates(high)) high *= 2;
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (oscillates(middle) ? high : low) = middle;
  }
  return high;
//! right: three roots
double sleeping_spin(double I1, double I3, double mgl) { return 2 * std::sqrt(I1 / I3) * std::sqrt(mgl / I3); }
//! wrong: angular momentum returned
double sleeping_spin(double I1, double, double mgl) { return 2 * std::sqrt(I1 * mgl); }
//! wrong: the expansion of the cosine without its half
  // p² θ²/(8 I1) against mgl θ²
  return std::sqrt(8 * I1 * mgl) / I3;
//! wrong: root never taken
double sleeping_spin(double I1, double I3, double mgl) { return 4 * I1 * mgl / (I3 * I3); }
//! wrong: exponent one half in whole numbers
double sleeping_spin(double I1, double I3, double mgl) { return 2 * std::pow(I1 * mgl, 1 / 2) / I3; }
//! wrong: precession as fast as the spin
double sleeping_spin(double, double I3, double mgl) { return std::sqrt(mgl / I3); }
//! wrong: 4 left outside of the root
double sleeping_spin(double I1, double I3, double mgl) { return 4 * std::sqrt(I1 * mgl) / I3; }
