/// @file
/// Contract of lecture 08: the kinetic energy in Euler angles and what follows from it.
///
/// Angles are the slides' z–y–z angles \f$(\phi, \theta, \psi)\f$: φ about the fixed z axis, θ about the new y axis
/// (the line of nodes), ψ about the body's z axis. Short forms in the formulas: \f$s_\theta = \sin\theta\f$,
/// \f$c_\theta = \cos\theta\f$.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// Kinetic energy of a rigid body, from its Euler angles and their rates.
///
/// <!-- T = ½ I₁ (-φ̇ sin θ cos ψ + θ̇ sin ψ)² + ½ I₂ (φ̇ sin θ sin ψ + θ̇ cos ψ)² + ½ I₃ (φ̇ cos θ + ψ̇)² -->
/// \f[ T = \tfrac12 I_1 (-\dot\phi\, s_\theta c_\psi + \dot\theta\, s_\psi)^2
///       + \tfrac12 I_2 (\dot\phi\, s_\theta s_\psi + \dot\theta\, c_\psi)^2
///       + \tfrac12 I_3 (\dot\phi\, c_\theta + \dot\psi)^2 \f]
///
/// @param I       principal moments about the fixed point, or about the centre of mass, kg m²
/// @param angles  \f$(\phi, \theta, \psi)\f$, any real numbers, rad
/// @param rates   \f$(\dot\phi, \dot\theta, \dot\psi)\f$, rad/s
/// @return        energy of rotation, J
/// @pre each moment > 0
/// @par Source
/// S1 s18
double kinetic_energy_euler(const Vector3d& I, const Vector3d& angles, const Vector3d& rates);

/// Kinetic energy of a symmetric body, I₁ = I₂: the angles φ and ψ drop out.
///
/// <!-- T = ½ I₁ (φ̇² sin²θ + θ̇²) + ½ I₃ (φ̇ cos θ + ψ̇)² -->
/// \f[ T = \tfrac12 I_1 (\dot\phi^2 s_\theta^2 + \dot\theta^2) + \tfrac12 I_3 (\dot\phi\, c_\theta + \dot\psi)^2 \f]
///
/// @param I1     the two equal principal moments, kg m²
/// @param I3     principal moment about the symmetry axis, kg m²
/// @param theta  angle between the symmetry axis and the fixed z axis, any real number, rad
/// @param rates  \f$(\dot\phi, \dot\theta, \dot\psi)\f$, rad/s
/// @return       energy of rotation, J
/// @pre I1 > 0 and I3 > 0: a thin rod, I3 = 0, is excluded; a sphere, I3 = I1, is legal
/// @par Source
/// S1 s18
double kinetic_energy_symmetric(double I1, double I3, double theta, const Vector3d& rates);

/// Canonical momenta of the Euler angles.
///
/// <!-- p_φ = ∂T/∂φ̇ = L · e₃⁰, p_θ = ∂T/∂θ̇ = L · e₂', p_ψ = ∂T/∂ψ̇ = L · e₃ -->
/// \f[ p_\phi = \frac{\partial T}{\partial \dot\phi} = \vec L \cdot \unit e^0_3, \qquad
///     p_\theta = \frac{\partial T}{\partial \dot\theta} = \vec L \cdot \unit e_2', \qquad
///     p_\psi = \frac{\partial T}{\partial \dot\psi} = \vec L \cdot \unit e_3 \f]
///
/// Each is the component of the angular momentum along the axis about which its angle rotates the body. The three axes
/// are not orthogonal, so these are no Cartesian components of L.
///
/// @param I       principal moments, kg m²
/// @param angles  \f$(\phi, \theta, \psi)\f$, any real numbers, rad
/// @param rates   \f$(\dot\phi, \dot\theta, \dot\psi)\f$, rad/s
/// @return        \f$(p_\phi, p_\theta, p_\psi)\f$, kg m²/s
/// @pre each moment > 0; θ = 0 and θ = π are legal
/// @par Source
/// follows from S1 s18; not on the slides
Vector3d canonical_momenta(const Vector3d& I, const Vector3d& angles, const Vector3d& rates);

/// Second derivatives of the Euler angles of a body that rotates without torque.
///
/// They solve the Euler–Lagrange equations for \f$q = (\phi, \theta, \psi)\f$,
///
/// <!-- d/dt ∂T/∂q̇ = ∂T/∂q -->
/// \f[ \frac{\dd}{\dd t} \frac{\partial T}{\partial \dot q} = \frac{\partial T}{\partial q} , \f]
///
/// or, which is the same, Euler's equations with \f$\tilde{\vec\omega} = \mat B(q)\,\dot q\f$:
///
/// <!-- q̈ = B⁻¹ (ω̇ - Ḃ q̇) -->
/// \f[ \ddot q = \mat B^{-1} \left( \dot{\tilde{\vec\omega}} - \dot{\mat B}\,\dot q \right) \f]
///
/// @param I       principal moments, kg m²
/// @param angles  \f$(\phi, \theta, \psi)\f$, any real numbers, rad
/// @param rates   \f$(\dot\phi, \dot\theta, \dot\psi)\f$, rad/s
/// @return        \f$(\ddot\phi, \ddot\theta, \ddot\psi)\f$, rad/s²
/// @pre each moment > 0
/// @pre |sin θ| > 10⁻⁶; at sin θ = 0 the angles are singular
/// @par Source
/// follows from S1 s18 and Euler's equations, S1 s8; not on the slides
Vector3d euler_angle_accelerations(const Vector3d& I, const Vector3d& angles, const Vector3d& rates);

/// The Hamiltonian of a free body: its kinetic energy as a function of the Euler angles and their canonical momenta.
///
/// @param I        principal moments, kg m²
/// @param angles   \f$(\phi, \theta, \psi)\f$, rad; φ does not matter
/// @param momenta  \f$(p_\phi, p_\theta, p_\psi)\f$, kg m²/s; zero is legal
/// @return         energy of rotation, J
/// @pre each moment > 0
/// @pre |sin θ| ≥ 0.05; at sin θ = 0 the angles are singular
/// @par Source
/// not on the slides
double hamiltonian(const Vector3d& I, const Vector3d& angles, const Vector3d& momenta);

/// The Poisson brackets of the components of the angular momentum on the body axes.
///
/// These components \f$\tilde L_1, \tilde L_2, \tilde L_3\f$ are functions of the Euler angles \f$q\f$ and of their
/// momenta \f$p\f$; no moment of inertia enters. The sign of a bracket is
///
/// <!-- {f, g} = Σ_k (∂f/∂q_k ∂g/∂p_k - ∂f/∂p_k ∂g/∂q_k) -->
/// \f[ \{f, g\} = \sum_k \left( \frac{\partial f}{\partial q_k} \frac{\partial g}{\partial p_k}
///     - \frac{\partial f}{\partial p_k} \frac{\partial g}{\partial q_k} \right) . \f]
///
/// They are asked for to 10⁻⁸ of |L|: a careful numerical differentiation is good enough.
///
/// @param angles   \f$(\phi, \theta, \psi)\f$, rad
/// @param momenta  \f$(p_\phi, p_\theta, p_\psi)\f$, kg m²/s; zero is legal
/// @return         matrix with \f$\{\tilde L_i, \tilde L_j\}\f$ in row i and column j, kg m²/s
/// @pre |sin θ| ≥ 0.05; at sin θ = 0 the angles are singular
/// @par Source
/// not on the slides; J. E. Marsden and T. S. Ratiu, chapter 10
Matrix3d momentum_brackets(const Vector3d& angles, const Vector3d& momenta);

/// Kinetic energy of a cone that lies on its side on a level table and rolls without slipping.
///
/// The cone is solid, uniform, circular and right. It touches the table along a line from its apex to its rim; the apex
/// stays where it is, and the line goes round it.
///
/// @param M           mass, kg
/// @param height      from the apex to the centre of the base, m
/// @param half_angle  between the axis of the cone and its side, rad
/// @param rate        at which the line of contact turns on the table, rad/s; either sign, zero is legal
/// @return            energy, J
/// @pre M > 0, height > 0 and 0 < half_angle < π/2
/// @par Source
/// not on the slides; Landau and Lifshitz, §32, problem 7
double rolling_cone_energy(double M, double height, double half_angle, double rate);

/// How fast the point of contact of a settling coin runs around.
///
/// A thin uniform coin rolls on its edge without slipping. Its plane keeps the same inclination to the level table, and
/// its centre is at rest.
///
/// @param radius       of the coin, m
/// @param g            acceleration of gravity, m/s²
/// @param inclination  between the plane of the coin and the table, rad
/// @return             rate at which the point of contact goes round its circle on the table, rad/s, positive
/// @pre radius > 0, g > 0 and 0 < inclination < π/2
/// @par Source
/// not on the slides; H. K. Moffatt 2000
double spinning_coin(double radius, double g, double inclination);

}  // namespace rigid
