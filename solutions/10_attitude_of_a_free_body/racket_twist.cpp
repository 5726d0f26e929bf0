#include "rigid/attitude_of_a_free_body.hpp"

#include <boost/numeric/odeint.hpp>

#include <numbers>
#include <vector>

namespace rigid {

double racket_twist(const Vector3d& I, const Vector3d& omega0) {
  // The direction of L on the axes of the body, and the twist. The clock is the angle of the handle about L, so that
  // the end need not be searched for; how fast the racket is thrown does not count.
  using State = std::vector<double>;
  const auto rates = [&I](const State& now, State& rate, double) {
    const Vector3d l(now[0], now[1], now[2]);
    const double handle = (l[1] * l[1] / I[1] + l[2] * l[2] / I[2]) / (l[1] * l[1] + l[2] * l[2]);
    const Vector3d change = l.cross(l.cwiseQuotient(I)) / handle;
    rate = {change[0], change[1], change[2], l[0] * (1 / I[0] - handle) / handle};
  };
  const Vector3d start = I.cwiseProduct(omega0).normalized();
  State state = {start[0], start[1], start[2], 0};
  constexpr int steps = 1000;
  boost::numeric::odeint::runge_kutta_fehlberg78<State, double> stepper;
  boost::numeric::odeint::integrate_n_steps(stepper, rates, state, double(0), 2 * std::numbers::pi_v<double> / steps, steps);
  return state[3];
}

}  // namespace rigid
