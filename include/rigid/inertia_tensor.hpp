/// @file
/// Contract of lecture 03: the inertia tensor, kinetic energy and angular momentum of a rigid body, principal axes.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// Inertia tensor of point masses about the origin.
///
/// <!-- I_ij = Σ_p m_p (δ_ij r_p² - r_p,i r_p,j) -->
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
/// S0 s10, S1 s3–4, S2 s9, S3 p. 8, S4 p. 9
Matrix3d inertia_of_points(const VectorXd& m, const Matrix3Xd& r);

/// Kinetic energy of a body that rotates with angular velocity omega about the origin of its inertia tensor.
///
/// <!-- T = ½ ω · I · ω -->
/// \f[ T = \tfrac12\,\vec\omega \cdot \Inertia \cdot \vec\omega \f]
///
/// The origin is a point of the body at rest, or T is the energy of rotation about the centre of mass.
///
/// @param I      inertia tensor, kg m²
/// @param omega  angular velocity on the same axes, rad/s
/// @return       energy, J
/// @pre I is an inertia tensor
/// @par Source
/// S0 s10, S1 s3, S2 s9, S3 p. 8, S4 p. 9
double kinetic_energy(const Matrix3d& I, const Vector3d& omega);

/// Angular momentum about the origin of the inertia tensor.
///
/// <!-- L = I · ω -->
/// \f[ \vec L = \Inertia \cdot \vec\omega \f]
///
/// L is parallel to omega only if omega lies along a principal axis.
///
/// @param I      inertia tensor, kg m²
/// @param omega  angular velocity on the same axes, rad/s
/// @return       angular momentum on these axes, kg m²/s
/// @pre I is an inertia tensor
/// @par Source
/// S1 s5, S4 p. 10
Vector3d angular_momentum(const Matrix3d& I, const Vector3d& omega);

/// Moment of inertia about an axis through the origin.
///
/// <!-- I_n = n · I · n of the unit vector along n -->
/// \f[ I_n = \unit n \cdot \Inertia \cdot \unit n, \qquad \unit n = \vec n / |\vec n| \f]
///
/// @param I     inertia tensor, kg m²
/// @param axis  direction of the axis, of any length but zero
/// @return      moment about that axis, kg m²
/// @pre I is an inertia tensor
/// @pre axis ≠ 0
/// @par Source
/// follows from the kinetic energy of S0 s10 with \f$\vec\omega = \omega\,\unit n\f$
double moment_about_axis(const Matrix3d& I, const Vector3d& axis);

/// Inertia tensor of a uniform cuboid about its corner at the origin.
///
/// <!-- I = M (⅓(b² + c²), -¼ab, -¼ac; -¼ab, ⅓(a² + c²), -¼bc; -¼ac, -¼bc, ⅓(a² + b²)), row by row -->
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
/// S0 s11, S2 s10, S3 p. 9, S4 p. 11
Matrix3d cuboid_about_corner(double M, double a, double b, double c);

/// Principal moments of inertia: the eigenvalues of the tensor.
///
/// @param I  inertia tensor, kg m²
/// @return   moments in ascending order, kg m²
/// @pre I is an inertia tensor
/// @par Source
/// S0 s12, S2 s11, S3 p. 10, S4 p. 12
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
/// S0 s12, s16, S1 s4, S2 s11, s15, S3 p. 10, p. 14, S4 p. 12, p. 16
Matrix3d principal_axes(const Matrix3d& I);

/// The inertia tensor of a rotated body, on axes that did not rotate.
///
/// <!-- I_inertial = A I_body Aᵀ -->
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

/// The largest possible angle between the angular momentum and the angular velocity of a body.
///
/// The body rotates about an axis through the origin of its inertia tensor, and all axes are tried.
///
/// @param I  principal moments, in any order, kg m²
/// @return   the largest angle between L and ω, rad
/// @pre I > 0, and no moment is larger than the sum of the two others; two or three of them may be equal
/// @par Source
/// an application of L = I ω (S1 s5); the inequality behind it: L. V. Kantorovich 1948
double largest_angle_between_L_and_omega(const Vector3d& I);

/// Can a matrix be the inertia tensor of a body made of positive masses?
///
/// What is violated by less than 10⁻⁹ of the largest entry counts as rounding.
///
/// @param I  any matrix, kg m²: unsymmetric ones, negative ones and zero included
/// @return   1 if some body has this inertia tensor, about some origin; otherwise 0
/// @pre what a body requires is violated by less than 10⁻⁹ of the largest entry, or by more than 10⁻⁶ of it
/// @par Source
/// follows from S0 s10; two of the matrices are from the tests of Drake
int is_inertia_tensor(const Matrix3d& I);

/// Inertia tensor of a uniform body that is given by its surface.
///
/// The surface consists of triangles. Columns 3k, 3k + 1 and 3k + 2 of corners are the corners of triangle number k
/// (counted from 0), anticlockwise as seen from outside. The surface of a hollow belongs to it; there *outside* is
/// inside the hollow.
///
/// @param corners  corners of the triangles as columns, m
/// @param density  kg/m³
/// @return         inertia tensor about the origin, wherever the origin lies, kg m²
/// @pre the surface is closed: every edge belongs to two triangles, which run along it in opposite senses
/// @pre density > 0; the enclosed volume is positive, or there is no triangle at all, which gives zero
/// @par Source
/// F. Tonon 2005; B. Mirtich, J. Graphics Tools 1 (2), 1996
Matrix3d inertia_of_mesh(const Matrix3Xd& corners, double density);

/// Where to fasten two masses to a rotor so that its bearings do not feel the rotation, at any speed.
///
/// The rotor turns about the z axis. It consists of point masses. One mass is added in the plane z = planes[0], another
/// one in the plane z = planes[1].
///
/// @param m           masses of the rotor, kg
/// @param r           their positions as columns, 3×n, m
/// @param planes      where the two planes cross the axis, m
/// @param correction  each of the two added masses, kg
/// @return            two columns: the positions of the two added masses, m
/// @pre as many masses as columns; none at all is legal, and then both added masses sit on the axis
/// @pre each mass > 0, correction > 0, planes[0] ≠ planes[1]
/// @par Source
/// an application of the principal axes of S0 s12; the practice: ISO 21940-11, balancing in two planes
Matrix3Xd balance_rotor(const VectorXd& m, const Matrix3Xd& r, const Vector2d& planes, double correction);

/// The rate at which the inertia tensor of a rotating rigid body changes, on axes that do not rotate.
///
/// The body rotates about a fixed point, the origin of the tensor.
///
/// @param I      inertia tensor at this moment, on the axes at rest, kg m²
/// @param omega  angular velocity on the same axes, rad/s
/// @return       rates of the nine entries of I, kg m²/s
/// @pre I is an inertia tensor
/// @par Source
/// follows from L = I ω (S1 s5) and the transport theorem of lecture 01
Matrix3d inertia_rate(const Matrix3d& I, const Vector3d& omega);

}  // namespace rigid
