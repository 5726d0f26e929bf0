/// @file
/// Contract of lecture 01: how a vector changes when its basis rotates, and the angular velocity of a basis.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// The matrix that does what ω× does.
///
/// <!-- [ω]× = (0, -ω_z, ω_y; ω_z, 0, -ω_x; -ω_y, ω_x, 0), row by row, and [ω]× V = ω × V -->
/// \f[ [\vec\omega]_\times = \begin{pmatrix}
///   0 & -\omega_z & \omega_y \\[2pt]
///   \omega_z & 0 & -\omega_x \\[2pt]
///   -\omega_y & \omega_x & 0 \end{pmatrix}, \qquad [\vec\omega]_\times \vec V = \vec\omega \times \vec V \f]
///
/// @param omega  any vector, here an angular velocity, rad/s; may be zero
/// @return       antisymmetric 3×3 matrix on the same axes and in the same unit as omega
/// @par Source
/// the ω× of S0 s7–8, S2 s6–7, S3 p. 5–6, S4 p. 6–7 written as a matrix
Matrix3d cross_matrix(const Vector3d& omega);

/// Rate of change of a vector in the inertial frame, from its rate in a rotating frame: the transport theorem.
///
/// <!-- (dV/dt)_inertial = (dV/dt)_body + ω × V -->
/// \f[ \ratein{\vec V}{\inertialframe} = \ratein{\vec V}{\bodyframe} + \vec\omega \times \vec V \f]
///
/// All three arguments are expressed on one and the same set of axes, and so is the result; any set will do.
///
/// @param rate_body  rate that an observer in the rotating frame sees, \f$\sum_i \dot V_i\,\unit e_i\f$, unit of V
///                   per s
/// @param omega      angular velocity of the rotating frame, rad/s
/// @param V          the vector itself, in any unit
/// @return           rate in the inertial frame, unit of V per s
/// @par Source
/// S0 s6, s8; S2 s4, s7; S3 p. 3, p. 6; S4 p. 4, p. 7
Vector3d inertial_rate(const Vector3d& rate_body, const Vector3d& omega, const Vector3d& V);

/// The basis after it has rotated for a time dt with constant angular velocity.
///
/// Every basis vector obeys \f$\dot{\unit e}_i = \vec\omega \times \unit e_i\f$. With
/// \f$\Theta = |\vec\omega|\,\dd t\f$ and \f$\unit n = \vec\omega/|\vec\omega|\f$ the exact solution (Rodrigues) is
/// <!-- e_i(dt) = e_i + sin Θ n × e_i + (1 - cos Θ) n × (n × e_i) -->
/// \f[ \unit e_i(\dd t) = \unit e_i + \sin\Theta\;\unit n \times \unit e_i
///                  + (1 - \cos\Theta)\;\unit n \times (\unit n \times \unit e_i) . \f]
///
/// Exact for every angle, not only to first order in dt; with omega = 0 or dt = 0 the basis stays as it is.
///
/// @param E      3×3 rotation matrix: its columns are the basis vectors in inertial components
/// @param omega  angular velocity in inertial components, constant, rad/s; may be zero
/// @param dt     time, s; may be negative
/// @return       3×3 rotation matrix with the rotated basis vectors as columns, inertial components
/// @pre EᵀE = 1 and det E = +1
/// @par Source
/// S0 s7, S2 s6, S3 p. 5, S4 p. 6, where the rotation is infinitesimal
Matrix3d rotated_basis(const Matrix3d& E, const Vector3d& omega, double dt);

/// The angular velocity with which a basis rotates.
///
/// <!-- [ω]× = Ȧ Aᵀ and ω = ½ Σ_i e_i × ė_i -->
/// \f[ [\vec\omega]_\times = \dot{\mat A}\,\mat A\T, \qquad
///     \vec\omega = \tfrac12 \sum_i \unit e_i \times \dot{\unit e}_i \f]
///
/// @param E       3×3 rotation matrix \f$\mat A\f$: its columns are the basis vectors in inertial components
/// @param E_rate  3×3, the rates \f$\dot{\unit e}_i\f$ as columns, 1/s; zero for a basis at rest
/// @return        angular velocity in inertial components, rad/s
/// @pre EᵀE = 1 and det E = +1
/// @pre the rates belong to a rotation: \f$\dot{\mat A}\,\mat A\T\f$ is antisymmetric
/// @par Source
/// the inverse of \f$\dot{\unit e} = \vec\omega\times\unit e\f$: S0 s7, S2 s6, S3 p. 5, S4 p. 6
Vector3d angular_velocity_of_basis(const Matrix3d& E, const Matrix3d& E_rate);

/// The screw that takes a body from one place to another: Chasles' theorem.
///
/// <!-- c = ½ (d_⊥ + cot(Θ/2) n × d), d_∥ = n (n · d), d_⊥ = d - d_∥ -->
/// \f[ \vec c = \tfrac12\left(\vec d_\perp + \cot\tfrac\Theta2\;\hat{\vec n}\times\vec d\right) , \qquad
///     \vec d_\parallel = \hat{\vec n}\,(\hat{\vec n}\cdot\vec d) , \qquad \vec d_\perp = \vec d - \vec d_\parallel \f]
///
/// Every point of the body goes from r to A r + d, where A rotates about n̂ through the angle Θ. The same displacement
/// is a rotation through Θ about a line along n̂ and a shift along this line.
///
/// @param rotation  Θ n̂, rad: along the axis by the right-hand rule, its length is the angle
/// @param d         where the body's point at the origin goes, m; may be zero
/// @return          3×2, m: first the point c of the line that is nearest to the origin, then the shift along the line
/// @pre 0.001 ≤ Θ ≤ 2π − 0.001 (without a rotation there is no line)
/// @par Source
/// the finite rotation to S0 s7, S2 s6, S3 p. 5, S4 p. 6; M. Chasles 1830
Matrix3Xd screw_of_displacement(const Vector3d& rotation, const Vector3d& d);

/// Angular acceleration of a rotor that is mounted on a rotating platform.
///
/// The platform rotates with omega, and omega changes. The rotor rotates relative to the platform; an observer on the
/// platform measures spin and sees it change at the rate spin_rate. Asked for is the rate of change, in the inertial
/// frame, of the angular velocity that the rotor has there.
///
/// @param E          3×3 rotation matrix: its columns are the axes of the platform in inertial components
/// @param omega      angular velocity of the platform, inertial components, rad/s
/// @param alpha      its rate in the inertial frame, inertial components, rad/s²
/// @param spin       angular velocity of the rotor relative to the platform, components on the platform's axes, rad/s
/// @param spin_rate  rates of these components, rad/s²
/// @return           angular acceleration of the rotor in the inertial frame, inertial components, rad/s²
/// @pre EᵀE = 1 and det E = +1; any of the vectors may be zero
/// @par Source
/// addition of angular velocities and the transport theorem, S0 s7–8, S2 s6–7, S3 p. 5–6, S4 p. 6–7
Vector3d composed_angular_acceleration(const Matrix3d& E, const Vector3d& omega, const Vector3d& alpha,
                                       const Vector3d& spin, const Vector3d& spin_rate);

/// The rotation vector of a rotation: along its axis, and as long as its angle.
///
/// The axes of a body were those of the inertial frame; now they are the columns of E. One rotation about one axis that
/// does not move achieves this, through an angle of at most half a turn. Nine digits are asked for at every angle,
/// however small.
///
/// @param E  3×3 rotation matrix: its columns are the axes of the body in inertial components
/// @return   the vector along the axis, by the right-hand rule, whose length is the angle in rad; zero for E = 1.
///           At exactly half a turn there are two, opposite to each other, and either is right
/// @pre EᵀE = 1 and det E = +1
/// @par Source
/// the finite rotation to S0 s7, S2 s6, S3 p. 5, S4 p. 6, read backwards
Vector3d rotation_vector(const Matrix3d& E);

/// Angular velocity of a rigid body, from three of its points.
///
/// The body moves in any way: it rotates, and its centre moves too. Positions and velocities are those of one moment,
/// on the same axes.
///
/// @param r  3×3, the positions of the three points as columns, m
/// @param v  3×3, their velocities as columns, m/s; all zero for a body at rest
/// @return   angular velocity, rad/s; in any direction, that of the triangle's plane included
/// @pre v belongs to a rigid motion, up to rounding
/// @pre the points form a triangle none of whose heights is smaller than a tenth of its longest side
/// @par Source
/// \f$\dot{\unit e} = \vec\omega\times\unit e\f$ of S0 s7, S2 s6, S3 p. 5, S4 p. 6, for oblique lines on the body
Vector3d angular_velocity_from_three_points(const Matrix3d& r, const Matrix3d& v);

/// Point of the instantaneous screw axis that is nearest to the origin.
///
/// At one moment a rigid body has the angular velocity omega, and its point at r has the velocity v. There is exactly
/// one straight line all of whose points have velocities along the line, the body being thought of as extended as far
/// as needed.
///
/// @param r      position of a point of the body, m
/// @param v      velocity of this point, m/s; may be zero, or parallel to omega
/// @param omega  angular velocity of the body, rad/s
/// @return       point of the line with the smallest distance from the origin, m
/// @pre omega ≠ 0 (a pure translation has no such line)
/// @par Source
/// \f$\dot{\unit e} = \vec\omega\times\unit e\f$ of S0 s7, S2 s6, S3 p. 5, S4 p. 6; Chasles' theorem for velocities
Vector3d point_on_screw_axis(const Vector3d& r, const Vector3d& v, const Vector3d& omega);

}  // namespace rigid
