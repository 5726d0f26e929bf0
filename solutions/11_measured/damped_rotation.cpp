#include "rigid/measured.hpp"

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rigid {

Vector3d damped_rotation(const Vector3d& I, const Vector3d& omega0, double gamma, double t) {
  namespace odeint = boost::numeric::odeint;
  using State = std::vector<double>;  // the state type that odeint resizes and copies by itself
  const double size = omega0.stableNorm();
  if (size == 0 || t == 0) return omega0;
  // The body follows the curve of the free motion and shrinks by e^(−γt); the clock of the free motion slows down with
  // it.
  const double free_time = gamma == 0 ? t : -std::expm1(-gamma * t) / gamma;
  // In units of ω at the start one tolerance serves bodies that turn slowly and fast.
  const auto rate = [&I](const State& now, State& rates, double) {
    rates = {now[1] * now[2] * (I[1] - I[2]) / I[0], now[2] * now[0] * (I[2] - I[0]) / I[1],
             now[0] * now[1] * (I[0] - I[1]) / I[2]};
  };
  State state = {omega0[0] / size, omega0[1] / size, omega0[2] / size};
  const auto stepper = odeint::make_controlled(1e-14, 1e-14, odeint::runge_kutta_fehlberg78<State, double>());
  odeint::integrate_adaptive(stepper, rate, state, double(0), size * free_time, std::min<double>(1e-2, size * free_time));
  return size * std::exp(-gamma * t) * Vector3d(state[0], state[1], state[2]);
}

}  // namespace rigid
