/// @file
/// Contract of lecture 03: the inertia tensor, kinetic energy and angular momentum of a rigid body, principal axes.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// Inertia tensor of point masses about the origin.
///
/// \f[ I_{ij} = \sum_p m_p \left( \delta_{ij}\, r_p^2 - r_{p,i}\, r_{p,j} \right) \f]
///
/// The products of inertia (the entries off the diagonal) carry a minus sign: \f$I_{xy} = -\sum_p m_p x_p y_p\f$.
///
/// @param m  masses of the points, kg
/// @param r  positions of the points as columns, 3×n, m
/// @return   symmetric 3×3 matrix, kg m²
/// @pre as many masses as columns; no point at all is legal and gives zero
/// @pre each mass > 0
/// @par Source
/// S0 s10, S1 s3–4, S2 s9, S3 p~8, S4 p~9
Matrix3d inertia_of_points(const VectorXd& m, const Matrix3Xd& r);

/// Kinetic energy of a body that rotates with angular velocity omega about the origin of its inertia tensor.
///
/// \f[ T = \tfrac12\,\vec\omega \cdot \Inertia \cdot \vec\omega \f]
///
/// The origin is a point of the body at rest, or T is the energy of rotation about the centre of mass.
///
/// @param I      inertia tensor, kg m²
/// @param omega  angular velocity on the same axes, rad/s
/// @return       energy, J
/// @pre I is an inertia tensor
/// @par Source
/// S0 s10, S1 s3, S2 s9, S3 p~8, S4 p~9
double kinetic_energy(const Matrix3d& I, const Vector3d& omega);

/// Angular momentum about the origin of the inertia tensor.
///
/// \f[ \vec L = \Inertia \cdot \vec\omega \f]
///
/// L is parallel to omega only if omega lies along a principal axis.
///
/// @param I      inertia tensor, kg m²
/// @param omega  angular velocity on the same axes, rad/s
/// @return       angular momentum on these axes, kg m²/s
/// @pre I is an inertia tensor
/// @par Source
/// S1 s5, S4 p~10
Vector3d angular_momentum(const Matrix3d& I, const Vector3d& omega);

/// Moment of inertia about an axis through the origin.
///
/// \f[ I_n = \hat{\vec n} \cdot \Inertia \cdot \hat{\vec n}, \qquad \hat{\vec n} = \vec n / |\vec n| \f]
///
/// @param I     inertia tensor, kg m²
/// @param axis  direction of the axis, of any length but zero
/// @return      moment about that axis, kg m²
/// @pre I is an inertia tensor
/// @pre axis ≠ 0
/// @par Source
/// follows from the kinetic energy of S0 s10 with \f$\vec\omega = \omega\,\hat{\vec n}\f$
double moment_about_axis(const Matrix3d& I, const Vector3d& axis);

/// Inertia tensor of a uniform cuboid about its corner at the origin.
///
/// \f[ \Inertia = M \begin{pmatrix}
///   \tfrac13 (b^2 + c^2) & -\tfrac14 ab & -\tfrac14 ac \\[2pt]
///   -\tfrac14 ab & \tfrac13 (a^2 + c^2) & -\tfrac14 bc \\[2pt]
///   -\tfrac14 ac & -\tfrac14 bc & \tfrac13 (a^2 + b^2) \end{pmatrix} \f]
///
/// @param M  mass, kg
/// @param a  edge along +x, m
/// @param b  edge along +y, m
/// @param c  edge along +z, m
/// @return   symmetric 3×3 matrix, kg m²
/// @pre M > 0
/// @pre a, b, c ≥ 0: a plate and a rod are legal
/// @par Source
/// S0 s11, S2 s10, S3 p~9, S4 p~11
Matrix3d cuboid_about_corner(double M, double a, double b, double c);

/// Principal moments of inertia: the eigenvalues of the tensor.
///
/// @param I  inertia tensor, kg m²
/// @return   moments in ascending order, kg m²
/// @pre I is an inertia tensor
/// @par Source
/// S0 s12, S2 s11, S3 p~10, S4 p~12
Vector3d principal_moments(const Matrix3d& I);

/// Principal axes of inertia: the eigenvectors of the tensor.
///
/// The columns solve \f$\Inertia\cdot\unit e_i = I_i\,\unit e_i\f$ in the order of principal_moments() and form a
/// right-handed triad. A sign common to two columns is free; where two moments are equal, so is the choice of
/// the axes within their plane.
///
/// @param I  inertia tensor, kg m²
/// @return   3×3 rotation matrix with the axes as columns
/// @pre I is an inertia tensor
/// @par Source
/// S0 s12, s16, S1 s4, S2 s11, s15, S3 p~10, p~14, S4 p~12, p~16
Matrix3d principal_axes(const Matrix3d& I);

/// The inertia tensor of a rotated body, on axes that did not rotate.
///
/// \f[ \Inertia_\inertialframe = \mat A\,\Inertia_\bodyframe\,\mat A\T \f]
///
/// @param I_body                inertia tensor on axes fixed in the body, kg m²
/// @param A_inertial_from_body  rotation matrix A: \f$\vec V_\inertialframe = \mat A\,\vec V_\bodyframe\f$
/// @return                      the same tensor on the inertial axes, kg m²
/// @pre I_body is an inertia tensor
/// @pre AᵀA = 1 and det A = +1
/// @par Source
/// follows from L = I ω (S1 s5) written on both sets of axes
Matrix3d rotated_inertia(const Matrix3d& I_body, const Matrix3d& A_inertial_from_body);

}  // namespace rigid
