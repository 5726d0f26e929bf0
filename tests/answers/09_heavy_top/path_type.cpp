#include <cmath>
#include <rigid/heavy_top.hpp>
int path_type(double I1, double I3, double mgl, double theta, double phi_rate, double omega3) {
//! right: the energy at the inclination where the precession stops
  if (phi_rate == 0) return 0;
  const double s2 = std::sin(theta) * std::sin(theta), p = I3 * omega3;
  const double u = std::cos(theta) + I1 * s2 * phi_rate / p;
  if (std::abs(u) >= 1) return 1;
  return 0.5 * I1 * s2 * phi_rate * phi_rate + mgl * std::cos(theta) > mgl * u ? -1 : 1;
//! wrong: psi rate in the momentum
-  const double s2 = std::sin(theta) * std::sin(theta), p = I3 * omega3;
+  const double s2 = std::sin(theta) * std::sin(theta), p = I3 * (omega3 - phi_rate * std::cos(theta));
//! right: the four intervals of the push
  const double p = I3 * omega3, push = omega3 > 0 ? phi_rate : -phi_rate, a = std::abs(p);
  if (push == 0) return 0;
  if (push < 0) return push > -a / (I1 * (1 - std::cos(theta))) ? -1 : 1;
  return push > 2 * mgl / a && push < a / (I1 * (1 + std::cos(theta))) ? -1 : 1;
//! wrong: forwards is a wave
  if (phi_rate == 0) return 0;
  return phi_rate * omega3 > 0 ? 1 : -1;
//! wrong: any push beyond twice the rate
  if (phi_rate == 0) return 0;
  const double cusp = 2 * mgl / (I3 * omega3);
  return phi_rate / cusp < 0 || phi_rate / cusp > 1 ? -1 : 1;
//! wrong: the sign of the push
  (void)I1, (void)I3, (void)mgl, (void)theta, (void)omega3;
  return phi_rate > 0 ? 1 : phi_rate < 0 ? -1 : 0;
//! wrong: sense of the spin ignored
  const double limit = mgl / (I3 * omega3) ;
  const double w = I3 * std::abs(omega3), c = std::cos(theta);
  (void)limit;
  if (phi_rate == 0) return 0;
  if (phi_rate < 0) return -1;
  const double top = 2 * mgl / w;
  (void)c;
  return phi_rate > top ? -1 : 1;
