#pragma once

#include "rigid/kinetic_energy.hpp"
#include "solutions/judging/judging.hpp"

using Complex = std::complex<double>;

inline const Vector3d lecture_angles(0.3, 0.7, 1.1), lecture_rates(0.5, -0.2, 0.9);

// One mistake, one sentence: these serve several exercises.
inline const Sentence exchanged_moments{"Your first two moments are exchanged, as with z–x–z angles or with I₂ for I₁.",
                                        "kinetic_energy_conventions"};
inline const Sentence phi_for_psi{
    "φ stands where ψ belongs: how the body's axes 1 and 2 lie is told by ψ, and φ does not enter.",
    "kinetic_energy_angles"};
inline const Sentence one_for_two{
    "I₂ does not enter: I₁ stands in both places, which is right only for a symmetric top.",
    "kinetic_energy_symmetric_top"};
inline const Sentence mixed_signs{
    "The mixed terms in φ̇ θ̇ have the wrong sign, as if θ or ψ were counted the other way round.",
    "kinetic_energy_angles"};
inline constexpr const char* rates_as_components =
    "The rates stand for the components of ω here; they turn the body about ê3⁰, ê2' and ê3.";
inline constexpr const char* apart =
    "The term I₃ φ̇ ψ̇ cos θ is missing: φ̇ cos θ and ψ̇ add up along the body's axis before they are squared.";
inline constexpr const char* rates_exchanged = "The rates of φ and ψ are exchanged; they come as (φ̇, θ̇, ψ̇).";

/// B in ω = B q̇: the axes of φ̇, θ̇ and ψ̇ as columns, in body components.
template <class Number>
Eigen::Matrix<Number, 3, 3> rate_axes(const Eigen::Matrix<Number, 3, 1>& q) {
  const Number s = sin(q[1]), c = cos(q[1]), s_psi = sin(q[2]), c_psi = cos(q[2]);
  return Eigen::Matrix<Number, 3, 3>{{-s * c_psi, s_psi, 0}, {s * s_psi, c_psi, 0}, {c, 0, 1}};
}

inline Vector3d omega_body(const Vector3d& q, const Vector3d& v) { return rate_axes(q) * v; }
inline Vector3d L_body(const Vector3d& I, const Vector3d& q, const Vector3d& v) {
  return I.cwiseProduct(omega_body(q, v));
}

/// The body components of L from the momenta p = Bᵀ L̃, complex ones too.
template <class Number>
Eigen::Matrix<Number, 3, 1> L_of_momenta(const Eigen::Matrix<Number, 3, 1>& q, const Eigen::Matrix<Number, 3, 1>& p) {
  return rate_axes(q).transpose().inverse() * p;
}

/// The inertial components of L, whose projections on the vertical, the line of nodes and ê₃ are the momenta.
inline Vector3d L_inertial_of_momenta(const Vector3d& q, const Vector3d& p) {
  const Vector3d nodes(-sin(q[0]), cos(q[0]), 0), body = attitude(q).col(2);
  return (p[0] * cross(nodes, body) + p[1] * cross(body, z_axis) + p[2] * cross(z_axis, nodes)) /
         z_axis.dot(cross(nodes, body));
}

/// The matrix of the energy: T = ½ q̇·M q̇, p = M q̇.
template <class Number>
Eigen::Matrix<Number, 3, 3> mass_matrix(const Vector3d& I, const Eigen::Matrix<Number, 3, 1>& q) {
  return rate_axes(q).transpose() * (I.cast<Number>().asDiagonal() * rate_axes(q));
}

/// The derivative of what depends on the angles when they move with the rates v, by a complex step: exact to rounding.
template <class Function>
auto derivative_along(const Vector3d& q, const Vector3d& v, const Function& f) {
  constexpr double step = 1e-100;
  return f(Eigen::Vector3cd(q.cast<Complex>() + Complex(0, step) * v.cast<Complex>())).imag() / step;
}

inline double energy(const Vector3d& I, const Vector3d& omega) { return 0.5 * I.dot(omega.cwiseAbs2()); }

inline constexpr auto first_for_second = [](Vector3d& I) { I[1] = I[0]; };

/// The sweeps in which the body turns by ψ at constant rates.
inline auto turned_by_psi(double psi) {
  return tuple(Vector3d(1, 2, 3), Vector3d(0.3, 0.7, psi), Vector3d(1.5, 0.8, 0.4));
}
