#include "rigid/euler_equations.hpp"

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace rigid {

namespace {

using State = std::vector<double>;  // the state type that odeint resizes and copies by itself

Vector3d as_vector(const State& state) { return {state[0], state[1], state[2]}; }

/// Moves the state from one time to the other, forwards or backwards; the stepper chooses its steps by itself.
void advance(const Vector3d& I, State& state, double from, double to) {
  using namespace boost::numeric::odeint;
  if (from == to) return;
  const auto system = [&I](const State& omega, State& omega_rate, double) {
    omega_rate = {omega[1] * omega[2] * (I[1] - I[2]) / I[0], omega[2] * omega[0] * (I[2] - I[0]) / I[1],
                  omega[0] * omega[1] * (I[0] - I[1]) / I[2]};
  };
  // The tightest tolerance that double precision honours; ω has length 1 at the start.
  const auto stepper = make_controlled(1e-14, 1e-14, runge_kutta_fehlberg78<State, double>());
  const double first_step = std::copysign(std::min<double>(1e-2, std::abs(to - from)), to - from);
  integrate_adaptive(stepper, system, state, from, to, first_step);
}

}  // namespace

Matrix3Xd free_rotation(const Vector3d& I, const Vector3d& omega0, const VectorXd& times) {
  // Go outwards from t = 0, once into the future and once into the past, so that no stretch is integrated twice.
  std::vector<Eigen::Index> outwards(static_cast<std::size_t>(times.size()));
  std::iota(outwards.begin(), outwards.end(), 0);
  std::sort(outwards.begin(), outwards.end(),
            [&](Eigen::Index j, Eigen::Index k) { return std::abs(times[j]) < std::abs(times[k]); });

  // Twice as fast, the same motion takes half the time: with ω in units of its size at t = 0, and times in units of the
  // inverse, one tolerance of the integration serves bodies that turn slowly and fast.
  const double size = omega0.norm();
  if (size == 0) return Matrix3Xd::Zero(3, times.size());
  const Vector3d start = omega0 / size;

  Matrix3Xd omega(3, times.size());
  for (const bool future : {true, false}) {
    State state = {start[0], start[1], start[2]};
    double now = 0.0;
    for (const Eigen::Index k : outwards) {
      if ((times[k] >= 0) != future) continue;
      advance(I, state, now, size * times[k]);
      now = size * times[k];
      omega.col(k) = size * as_vector(state);
    }
  }
  return omega;
}

}  // namespace rigid
