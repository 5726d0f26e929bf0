/// @file
/// Contract of lecture 07: Euler angles (z–y–z), the rotation matrix that they make, and the angular velocity from
/// their rates.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// The rotation matrix that takes inertial components to body components.
///
/// <!-- V_body = R V_inertial, R = R_ψ R_θ R_φ; row by row R_φ = (cos φ, sin φ, 0; -sin φ, cos φ, 0; 0, 0, 1),
///      R_θ = (cos θ, 0, -sin θ; 0, 1, 0; sin θ, 0, cos θ), and R_ψ is R_φ with ψ -->
/// \f[ \vec V_\bodyframe = \mat R\,\vec V_\inertialframe, \qquad \mat R = \mat R_\psi \mat R_\theta \mat R_\phi \f]
/// \f[ \mat R_\phi = \begin{pmatrix}
///   \cos\phi & \sin\phi & 0 \\[2pt] -\sin\phi & \cos\phi & 0 \\[2pt] 0 & 0 & 1 \end{pmatrix}, \qquad
///   \mat R_\theta = \begin{pmatrix}
///   \cos\theta & 0 & -\sin\theta \\[2pt] 0 & 1 & 0 \\[2pt] \sin\theta & 0 & \cos\theta \end{pmatrix}, \qquad
///   \mat R_\psi = \begin{pmatrix}
///   \cos\psi & \sin\psi & 0 \\[2pt] -\sin\psi & \cos\psi & 0 \\[2pt] 0 & 0 & 1 \end{pmatrix} \f]
///
/// The matrices are passive: the vector does not move, the axes do. The transpose \f$\mat A = \mat R\T\f$ has the body
/// axes as columns, in inertial components.
///
/// @param angles  (φ, θ, ψ), rad, any real numbers: φ about ê₃⁰, then θ about the new ê₂′, then ψ about ê₃
/// @return        3×3 rotation matrix, from inertial to body components
/// @par Source
/// S1 s14–15, s20
Matrix3d rotation_matrix(const Vector3d& angles);

/// The inertial components of a vector whose body components are known.
///
/// <!-- V_inertial = Rᵀ V_body = R_φᵀ R_θᵀ R_ψᵀ V_body -->
/// \f[ \vec V_\inertialframe = \mat R\T\,\vec V_\bodyframe
///   = \mat R_\phi\T \mat R_\theta\T \mat R_\psi\T\,\vec V_\bodyframe \f]
///
/// @param V_body  components on the body axes, any unit
/// @param angles  Euler angles (φ, θ, ψ) of the body, any real numbers, rad
/// @return        components of the same vector on the inertial axes, in the same unit
/// @par Source
/// the inverse of S1 s20
Vector3d inertial_components(const Vector3d& V_body, const Vector3d& angles);

/// Euler angles of an attitude.
///
/// <!-- R₃₃ = cos θ, (R₃₁, R₃₂) = sin θ (cos φ, sin φ), (R₁₃, R₂₃) = sin θ (-cos ψ, sin ψ) -->
/// \f[ R_{33} = \cos\theta, \qquad (R_{31}, R_{32}) = \sin\theta\,(\cos\phi, \sin\phi), \qquad
///   (R_{13}, R_{23}) = \sin\theta\,(-\cos\psi, \sin\psi) \f]
///
/// Where \f$\sin\theta = 0\f$ only φ + ψ (θ = 0) or ψ − φ (θ = π) is determined: there every choice that gives R
/// back is right. θ always lies in [0, π]; where a library gives θ < 0, (φ + π, −θ, ψ + π) is the same attitude. φ and
/// ψ may differ by full turns.
///
/// @param R_body_from_inertial  rotation matrix R: \f$\vec V_\bodyframe = \mat R\,\vec V_\inertialframe\f$
/// @return                      (φ, θ, ψ), rad, with θ in [0, π]
/// @pre RᵀR = 1 and det R = +1; sin θ = 0 is legal
/// @par Source
/// the inverse of S1 s20; range and singularity are not on the slides
Vector3d euler_angles(const Matrix3d& R_body_from_inertial);

/// The line of nodes ê₂′, the axis of the second rotation, in body components.
///
/// <!-- e₂' = sin ψ e₁ + cos ψ e₂ -->
/// \f[ \unit e_2' = \sin\psi\,\unit e_1 + \cos\psi\,\unit e_2 = \mat R_\psi \begin{pmatrix} 0 \\[2pt] 1 \\[2pt] 0
/// \end{pmatrix} \f]
///
/// @param psi  third Euler angle ψ, any real number, rad
/// @return     unit vector, body components
/// @par Source
/// S1 s14
Vector3d line_of_nodes(double psi);

/// The inertial vertical ê₃⁰, the axis of the first rotation, in body components.
///
/// <!-- e₃⁰ = -sin θ cos ψ e₁ + sin θ sin ψ e₂ + cos θ e₃ -->
/// \f[ \unit e^0_3 = -\sin\theta\cos\psi\,\unit e_1 + \sin\theta\sin\psi\,\unit e_2 + \cos\theta\,\unit e_3
///   = \mat R_\psi \mat R_\theta \begin{pmatrix} 0 \\[2pt] 0 \\[2pt] 1 \end{pmatrix} \f]
///
/// It is the third column of R and independent of φ.
///
/// @param theta  second Euler angle θ, any real number, rad
/// @param psi    third Euler angle ψ, any real number, rad
/// @return       unit vector, body components
/// @par Source
/// S1 s15
Vector3d vertical_in_body(double theta, double psi);

/// The angular velocity in body components, from the Euler angles and their rates.
///
/// <!-- ω_body = (-φ̇ sin θ cos ψ + θ̇ sin ψ, φ̇ sin θ sin ψ + θ̇ cos ψ, φ̇ cos θ + ψ̇) -->
/// \f[ \tilde{\vec\omega} = \dot\phi\,\unit e^0_3 + \dot\theta\,\unit e_2' + \dot\psi\,\unit e_3
///   = \begin{pmatrix} -\dot\phi\sin\theta\cos\psi + \dot\theta\sin\psi \\[2pt]
///     \dot\phi\sin\theta\sin\psi + \dot\theta\cos\psi \\[2pt]
///     \dot\phi\cos\theta + \dot\psi \end{pmatrix} \f]
///
/// @param angles  (φ, θ, ψ), any real numbers, rad; φ does not matter
/// @param rates   \f$(\dot\phi, \dot\theta, \dot\psi)\f$, rad/s
/// @return        angular velocity on the body axes, rad/s
/// @par Source
/// S1 s13, s16–17
Vector3d angular_velocity_body(const Vector3d& angles, const Vector3d& rates);

/// The same angular velocity in inertial components.
///
/// <!-- ω_inertial = (-θ̇ sin φ + ψ̇ sin θ cos φ, θ̇ cos φ + ψ̇ sin θ sin φ, φ̇ + ψ̇ cos θ) -->
/// \f[ \vec\omega_\inertialframe = \begin{pmatrix} -\dot\theta\sin\phi + \dot\psi\sin\theta\cos\phi \\[2pt]
///     \dot\theta\cos\phi + \dot\psi\sin\theta\sin\phi \\[2pt]
///     \dot\phi + \dot\psi\cos\theta \end{pmatrix} \f]
///
/// @param angles  (φ, θ, ψ), any real numbers, rad; ψ does not matter
/// @param rates   \f$(\dot\phi, \dot\theta, \dot\psi)\f$, rad/s
/// @return        angular velocity on the inertial axes, rad/s
/// @par Source
/// not on the slides; S1 s13 with each axis in inertial components
Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates);

/// The rates of the Euler angles, from the angular velocity in body components.
///
/// <!-- φ̇ = (-ω₁ cos ψ + ω₂ sin ψ) / sin θ, θ̇ = ω₁ sin ψ + ω₂ cos ψ, ψ̇ = ω₃ + cot θ (ω₁ cos ψ - ω₂ sin ψ) -->
/// \f[ \dot\phi = \frac{-\tilde\omega_1\cos\psi + \tilde\omega_2\sin\psi}{\sin\theta}, \qquad
///   \dot\theta = \tilde\omega_1\sin\psi + \tilde\omega_2\cos\psi, \qquad
///   \dot\psi = \tilde\omega_3 + \cot\theta\,(\tilde\omega_1\cos\psi - \tilde\omega_2\sin\psi) \f]
///
/// At \f$\sin\theta = 0\f$ there is no answer: two of the three axes coincide.
///
/// @param angles      (φ, θ, ψ), rad
/// @param omega_body  angular velocity on the body axes, rad/s
/// @return            \f$(\dot\phi, \dot\theta, \dot\psi)\f$, rad/s
/// @pre |sin θ| > 10⁻⁶; at sin θ = 0 the angles are singular (gimbal lock)
/// @par Source
/// the inverse of S1 s16; not on the slides
Vector3d euler_angle_rates(const Vector3d& angles, const Vector3d& omega_body);

/// The angles of the other convention, z–x–z, for an attitude whose z–y–z angles are known.
///
/// <!-- φ_zxz = φ + π/2, θ_zxz = θ, ψ_zxz = ψ - π/2 -->
/// \f[ \phi_{zxz} = \phi + \tfrac\pi2, \qquad \theta_{zxz} = \theta, \qquad \psi_{zxz} = \psi - \tfrac\pi2 \f]
///
/// brought into their ranges: θ in [0, π], the two others in (−π, π]. The attitude stays the same: the angles
/// (φ + π, −θ, ψ + π) and full turns more do that. Where sin θ = 0 only one combination of φ and ψ is determined; there
/// ψ_zxz = 0.
///
/// @param angles  (φ, θ, ψ), z–y–z, any real numbers, rad; θ below 0 and beyond π too
/// @return        (φ_zxz, θ_zxz, ψ_zxz), rad
/// @pre |sin θ| is above 10⁻⁶ or, where θ is a multiple of π up to rounding, below 10⁻¹²
/// @pre neither φ_zxz nor ψ_zxz is within 10⁻⁶ of ±π, where rounding chooses the end of the range
/// @par Source
/// not on the slides; H. Goldstein, Classical Mechanics, appendix A
Vector3d to_zxz(const Vector3d& angles);

/// Yaw, pitch and roll of a body whose z–y–z angles are known.
///
/// A pilot brings the inertial axes onto the same body axes by three other turns: yaw about axis 3, then pitch about
/// the new axis 2, then roll about the axis 1 that these two have made.
///
/// Where the pitch is ±π/2 these angles have their gimbal lock, and any choice that gives the attitude back is right;
/// so are full turns more of yaw or roll. At θ = 0, where the z–y–z angles fail, nothing special happens.
///
/// @param angles  (φ, θ, ψ), rad, any real numbers; pitch ±π/2 is legal
/// @return        (yaw, pitch, roll), rad, with the pitch in [−π/2, π/2]
/// @par Source
/// not on the slides; the angles of aircraft
Vector3d yaw_pitch_roll(const Vector3d& angles);

/// The attitude of a body as a unit quaternion.
///
/// It stands for the rotation that carries the inertial axes onto the body axes:
/// \f$\vec V_\inertialframe = q\,\vec V_\bodyframe\,q^*\f$, with Hamilton's product, \f$i\,j = k\f$. Both signs are
/// right.
///
/// @param angles  (φ, θ, ψ), rad, any real numbers, full turns and half turns (w = 0) included
/// @return        the four numbers w, x, y, z in this order, of a quaternion w + x i + y j + z k of length 1
/// @par Source
/// not on the slides
VectorXd attitude_quaternion(const Vector3d& angles);

/// The smallest angle of a single rotation about one axis that takes a body from one attitude to another.
///
/// It is asked for to 10⁻⁹ rad, also for attitudes that differ by less than 10⁻⁷ rad or by half a turn.
///
/// @param angles1  (φ, θ, ψ) of the first attitude, rad, any real numbers
/// @param angles2  (φ, θ, ψ) of the second attitude, rad, any real numbers; equal attitudes may have different angles
/// @return         angle from 0 to π, rad
/// @par Source
/// not on the slides; every rotation has an axis: Euler 1776
double angle_between_attitudes(const Vector3d& angles1, const Vector3d& angles2);

/// The rotation by the smallest possible angle that carries the direction of one vector into that of another.
///
/// The matrix is active: the vector turns and the axes stay, \f$\vec b/|\vec b| = \mat D\,\vec a/|\vec a|\f$ with the
/// matrix D that is returned.
///
/// @param a  any vector but zero; only its direction counts
/// @param b  likewise, in the same unit
/// @return   rotation matrix
/// @pre a ≠ 0 and b ≠ 0; the angle between them is at most π − 0.02, because opposite directions have no single answer;
/// parallel directions are legal
/// @par Source
/// not on the slides; T. Möller and J. F. Hughes 1999
Matrix3d shortest_rotation(const Vector3d& a, const Vector3d& b);

}  // namespace rigid
