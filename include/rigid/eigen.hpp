/// @file
/// Contract of lecture 00: three functions to learn Eigen by.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// The matrix that rotates a vector about the z axis.
///
/// <!-- R = (cos α, -sin α, 0; sin α, cos α, 0; 0, 0, 1), row by row, and R x = cos α x + sin α y -->
/// \f[ \mat R = \begin{pmatrix}
///   \cos\alpha & -\sin\alpha & 0 \\[2pt]
///   \sin\alpha & \cos\alpha & 0 \\[2pt]
///   0 & 0 & 1 \end{pmatrix}, \qquad \mat R\,\unit x = \cos\alpha\,\unit x + \sin\alpha\,\unit y \f]
///
/// @param angle  the angle \f$\alpha\f$, rad; positive from x towards y
/// @return       3×3 rotation matrix
/// @par Source
/// the definition of sine and cosine; lecture 00
Matrix3d rotation_about_z(double angle);

/// The mean of points: the centre of mass of equal masses.
///
/// <!-- the mean of r_p, p = 1 … n -->
/// \f[ \bar{\vec r} = \frac1n\sum_{p=1}^n\vec r_p \f]
///
/// @param r  3×n, m: a point in each column
/// @return   their mean, m
/// @pre at least one point
/// @par Source
/// the definition; lecture 00
Vector3d center_of_points(const Matrix3Xd& r);

/// The volume of the tetrahedron between the origin and three points, with a sign.
///
/// <!-- V = ⅙ a · (b × c) -->
/// \f[ V = \tfrac16\,\vec a\cdot(\vec b\times\vec c) \f]
///
/// @param a  the first point, m
/// @param b  the second point, m
/// @param c  the third point, m
/// @return   the volume, m³: positive if a, b, c are right-handed, 0 if they lie in one plane with the origin
/// @par Source
/// a sixth of the parallelepiped with these edges; lecture 00
double tetrahedron_volume(const Vector3d& a, const Vector3d& b, const Vector3d& c);

}  // namespace rigid
