#include "rigid/heavy_top.hpp"

#include <boost/numeric/odeint.hpp>

#include <array>
#include <cmath>

namespace rigid {

Vector2d moon_libration(double asymmetry, double eccentricity, double orbital_rate, double theta0, double rate0,
                        double t) {
  // The eccentric anomaly is the clock; time in units of 1/orbital_rate, lengths in units of the half-axis.
  const double e = eccentricity, mean = orbital_rate * t;
  double end = mean + e * std::sin(mean);
  for (int i = 0; i < 10; ++i) end -= (end - e * std::sin(end) - mean) / (1 - e * std::cos(end));

  using State = std::array<double, 2>;
  const auto rates = [&](const State& now, State& rate, double E) {
    const double r = 1 - e * std::cos(E);
    const double direction = std::atan2(std::sqrt(1 - e * e) * std::sin(E), std::cos(E) - e);
    rate = {r * now[1], -1.5 * asymmetry * std::sin(2 * (now[0] - direction)) / (r * r)};
  };
  State state = {theta0, rate0 / orbital_rate};
  constexpr int steps = 1600;  // a motion may be chaotic, and amplify what each of them leaves out
  boost::numeric::odeint::runge_kutta_fehlberg78<State, double> stepper;
  boost::numeric::odeint::integrate_n_steps(stepper, rates, state, double(0), end / steps, steps);
  return {state[0], orbital_rate * state[1]};
}

}  // namespace rigid
