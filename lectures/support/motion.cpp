#include "lectures/support/motion.hpp"

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <cmath>

namespace workbook {

using Eigen::Vector3d;

namespace {

using State = std::vector<double>;  // ω, then the rows of A
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Motion motion_of(const State& state) { return {Vector3d(state[0], state[1], state[2]), RowMajor::Map(&state[3])}; }

}  // namespace

Eigen::Matrix3d shortest_turn(const Vector3d& from, const Vector3d& to) {
  const Vector3d across = from.cross(to);
  return Eigen::AngleAxisd(std::atan2(across.norm(), from.dot(to)), across.stableNormalized()).toRotationMatrix();
}

Motion integrated(const Vector3d& I, const Motion& start, double time, const Torque& torque) {
  State state(12);
  std::copy(start.omega.begin(), start.omega.end(), state.begin());
  RowMajor::Map(&state[3]) = start.A;
  const auto system = [&](const State& now, State& rate, double) {
    const Motion motion = motion_of(now);
    Vector3d L_rate = I.cwiseProduct(motion.omega).cross(motion.omega);
    if (torque) L_rate += torque(motion);
    const Vector3d omega_rate = L_rate.cwiseQuotient(I);
    std::copy(omega_rate.begin(), omega_rate.end(), rate.begin());
    // A row of A [ω]× is the cross product of the row of A with ω.
    for (int i = 0; i < 3; ++i) {
      const Vector3d row = motion.A.row(i);
      Vector3d::Map(&rate[3 + 3 * static_cast<std::size_t>(i)]) = row.cross(motion.omega);
    }
  };
  namespace odeint = boost::numeric::odeint;
  const auto stepper = odeint::make_controlled(1e-17, 1e-14, odeint::runge_kutta_fehlberg78<State>());
  if (time != 0) odeint::integrate_adaptive(stepper, system, state, 0.0, time, time / 100);
  return motion_of(state);
}

std::vector<Motion> history(const Vector3d& I, const Motion& start, double duration, int count) {
  std::vector<Motion> motion{start};
  while (static_cast<int>(motion.size()) < count)
    motion.push_back(integrated(I, motion.back(), duration / (count - 1)));
  return motion;
}

AngleMotion integrated(const AngleMotion& start, double time, const Accelerations& accelerations) {
  State state(6);
  std::copy(start.angles.begin(), start.angles.end(), state.begin());
  std::copy(start.rates.begin(), start.rates.end(), state.begin() + 3);
  const auto system = [&](const State& now, State& rate, double) {
    const Vector3d angles = Vector3d::Map(now.data()), rates = Vector3d::Map(now.data() + 3);
    Vector3d::Map(rate.data()) = rates;
    Vector3d::Map(rate.data() + 3) = accelerations(angles, rates);
  };
  namespace odeint = boost::numeric::odeint;
  const auto stepper = odeint::make_controlled(1e-14, 1e-14, odeint::runge_kutta_fehlberg78<State>());
  if (time != 0) odeint::integrate_adaptive(stepper, system, state, 0.0, time, 1e-3 * time);
  return {Vector3d::Map(state.data()), Vector3d::Map(state.data() + 3)};
}

std::vector<AngleMotion> history(const AngleMotion& start, double duration, int count,
                                 const Accelerations& accelerations) {
  std::vector<AngleMotion> motion{start};
  while (static_cast<int>(motion.size()) < count)
    motion.push_back(integrated(motion.back(), duration / (count - 1), accelerations));
  return motion;
}

}  // namespace workbook
