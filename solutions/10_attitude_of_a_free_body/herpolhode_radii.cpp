#include "rigid/attitude_of_a_free_body.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {

Vector2d herpolhode_radii(const Vector3d& I, const Vector3d& omega0) {
  // T and L² are linear in the squares of the components, so these move to and fro on a straight line. |ω|², and with
  // it the distance from the foot of the perpendicular, grows along it as ω2² falls, at a rate that has the sign of (I₃
  // − I₂)(I₂ − I₁)(I₃ − I₁). So the larger radius is where ω2 vanishes, the smaller one where ω1 or ω3 does.
  const Vector3d squares = omega0.cwiseAbs2();
  const Vector3d share((I[2] - I[1]) / I[0], -(I[2] - I[0]) / I[1], (I[1] - I[0]) / I[2]);
  const double until_second_vanishes = -squares[1] / share[1];
  const double since_another_vanished = std::min(squares[0] / share[0], squares[2] / share[2]);
  const double L2 = I.cwiseProduct(omega0).squaredNorm();
  const auto radius = [&](double along) {
    const Vector3d now = squares + along * share;
    double sum = 0;  // |ω × L|², of which only one component is left at an end
    for (int i = 0; i < 3; ++i) sum += std::pow(I[(i + 1) % 3] - I[i], 2) * now[i] * now[(i + 1) % 3];
    return std::sqrt(std::max<double>(sum, 0.0) / L2);
  };
  return {radius(-since_another_vanished), radius(until_second_vanishes)};
}

}  // namespace rigid
