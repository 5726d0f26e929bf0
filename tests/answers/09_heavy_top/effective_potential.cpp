#include <cmath>
#include <rigid/heavy_top.hpp>
double effective_potential(double I1, double I3, double mgl, double p_phi, double p_psi, double theta) {
//! right: rates from the matrix of the momenta
  const double c = std::cos(theta), s = std::sin(theta);
  // p_phi = (I1 s² + I3 c²) φ̇ + I3 c ψ̇, p_psi = I3 c φ̇ + I3 ψ̇
  const double m11 = I1 * s * s + I3 * c * c, m12 = I3 * c, determinant = I1 * I3 * s * s;
  const double phi_rate = (I3 * p_phi - m12 * p_psi) / determinant;
  const double psi_rate = (m11 * p_psi - m12 * p_phi) / determinant;
  return 0.5 * (p_phi * phi_rate + p_psi * psi_rate) + mgl * c;
//! right: angular momentum across the axis
  const Vector3d up(0, 0, 1), axis(std::sin(theta), 0, std::cos(theta));
  // L lies in the plane of both, because θ̇ = 0
  const double across = (p_phi - p_psi * axis.dot(up)) / axis.cross(up).norm();
  return across * across / 2 / I1 + p_psi * p_psi / 2 / I3 + mgl * axis.z();
//! wrong: the square of the bracket without its middle term
  const double c = std::cos(theta), s2 = 1 - c * c;
  return (p_phi * p_phi + p_psi * p_psi * c * c) / (2 * I1 * s2) + p_psi * p_psi / (2 * I3) + mgl * c;
//! wrong: one half in whole numbers
  const double bracket = (p_phi - p_psi * std::cos(theta)) / std::sin(theta);
  return 1 / 2 * (bracket * bracket / I1 + p_psi * p_psi / I3) + mgl * std::cos(theta);
//! wrong: psi rate for the spin
  const double c = std::cos(theta), s = std::sin(theta);
  const double phi_rate = (p_phi - p_psi * c) / (I1 * s * s);
  const double psi_rate = p_psi / I3;
  const double spin = psi_rate + phi_rate * c;
  return 0.5 * I1 * phi_rate * phi_rate * s * s + 0.5 * I3 * spin * spin + mgl * c;
//! wrong: height of the centre of mass from the sine
  const double s = std::sin(theta), a = p_phi - p_psi * std::cos(theta);
  return a * a / (2 * I1 * s * s) + p_psi * p_psi / (2 * I3) + mgl * s;
//! wrong: energy of the spin with the other moment
  const double s = std::sin(theta), a = p_phi - p_psi * std::cos(theta);
  return (a * a / (s * s) + p_psi * p_psi) / (2 * I1) + mgl * std::cos(theta);
//! wrong: squares written with the hat
  double T1 = (p_phi - p_psi * cos(theta)) ^ 2 / (2 * I1 * sin(theta) ^ 2);
  return T1 + p_psi * p_psi / (2 * I3) + mgl * cos(theta);
//! wrong: only the part that the nutation feels
double effective_potential(double I1, double, double mgl, double p_phi, double p_psi, double theta) {
  return std::pow((p_phi - p_psi * std::cos(theta)) / std::sin(theta), 2) / (2 * I1) + mgl * std::cos(theta);
}
