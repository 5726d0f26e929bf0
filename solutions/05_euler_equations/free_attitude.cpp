#include "rigid/euler_equations.hpp"

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rigid {

Matrix3d free_attitude(const Vector3d& I, const Vector3d& omega0, double t) {
  using namespace boost::numeric::odeint;
  using Numbers = std::vector<double>;  // body components of ω, then the quaternion x, y, z, w of the attitude
  Numbers state = {omega0[0], omega0[1], omega0[2], 0, 0, 0, 1};
  const auto rate = [&I](const Numbers& now, Numbers& rates, double) {
    const Vector3d omega(now[0], now[1], now[2]);
    const Eigen::Quaterniond q(now[6], now[3], now[4], now[5]);
    const Vector3d omega_rate = I.cwiseProduct(omega).cross(omega).cwiseQuotient(I);
    // ω comes on the axes of the body, and rotations about these multiply from the right.
    const Eigen::Quaterniond doubled = q * Eigen::Quaterniond(0, omega[0], omega[1], omega[2]);
    rates.assign(omega_rate.begin(), omega_rate.end());
    for (const double component : doubled.coeffs()) rates.push_back(component / 2);
  };
  if (t != 0) {
    const auto stepper = make_controlled(1e-14, 1e-14, runge_kutta_fehlberg78<Numbers, double>());
    integrate_adaptive(stepper, rate, state, double(0), t, std::copysign(std::min<double>(1e-2, std::abs(t)), t));
  }
  return Eigen::Quaterniond(state[6], state[3], state[4], state[5]).normalized().toRotationMatrix();
}

}  // namespace rigid
