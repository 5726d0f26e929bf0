#include "rigid/euler_equations.hpp"

namespace rigid {

Vector3d splitting_step(const Vector3d& I, const Vector3d& omega, double h) {
  Vector3d L = I.cwiseProduct(omega);
  const auto follow_term = [&](int i, double time) {
    // With this term alone ω is L_i/I_i along axis i: the body turns about it and sees L turn the other way.
    L = Eigen::AngleAxisd(-time * L[i] / I[i], Vector3d::Unit(i)) * L;
  };
  follow_term(0, h / 2);
  follow_term(1, h / 2);
  follow_term(2, h);
  follow_term(1, h / 2);
  follow_term(0, h / 2);
  return L.cwiseQuotient(I);
}

}  // namespace rigid
