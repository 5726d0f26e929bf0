/// @file
/// Contract of lecture 04: how the inertia tensor changes with the origin.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// Inertia tensor about a point, from the tensor about the centre of mass: the parallel-axis theorem.
///
/// \f[ \Inertia = \Inertia_\CM + M \left( d^2\,\One - \vec d\,\vec d \right) \f]
///
/// Both tensors are on parallel axes. The formula is even in d, so the sense of the arrow does not matter here.
///
/// @param I_cm  inertia tensor about the centre of mass, kg m²
/// @param M     mass, kg
/// @param d     from the centre of mass to the point, on the axes of the tensor, m
/// @return      inertia tensor about the point, on the same axes, kg m²
/// @pre I_cm is an inertia tensor
/// @pre M > 0
/// @par Source
/// S0 s13–14, S2 s12–13, S3 p~11–12, S4 p~13–14, read from the centre of mass outwards
Matrix3d inertia_from_center_of_mass(const Matrix3d& I_cm, double M, const Vector3d& d);

/// Inertia tensor about the centre of mass, from the tensor about the origin.
///
/// \f[ \Inertia_\CM = \Inertia - M \left( r_\CM^2\,\One - \vec r_\CM\,\vec r_\CM \right) \f]
///
/// @param I_origin  inertia tensor about the origin, kg m²
/// @param M         mass, kg
/// @param r_cm      position of the centre of mass, on the axes of the tensor, m
/// @return          inertia tensor about the centre of mass, on the same axes, kg m²
/// @pre M > 0
/// @pre I_origin is the tensor of a body with this mass and centre of mass: inertia_to_center_of_mass() returns an
///      inertia tensor
/// @par Source
/// S0 s14, S2 s13, S3 p~12, S4 p~14: the shift \f$\vec R = -\vec r_\CM\f$
Matrix3d inertia_to_center_of_mass(const Matrix3d& I_origin, double M, const Vector3d& r_cm);

/// Inertia tensor about a shifted origin, which neither before nor after need be the centre of mass.
///
/// All positions change by the same vector, \f$\vec r'_p = \vec r_p + \vec R\f$. So R points from the new origin to the
/// old one, and the new origin lies at −R.
///
/// \f[ I'_{ij} = I_{ij} + M \left( R^2 \delta_{ij} - R_i R_j \right)
///     + M \left( 2\,\vec r_\CM \cdot \vec R\;\delta_{ij} - r_{\CM,i} R_j - R_i r_{\CM,j} \right) \f]
///
/// @param I_origin  inertia tensor about the old origin, kg m²
/// @param M         mass, kg
/// @param r_cm      position of the centre of mass seen from the old origin, on the axes of the tensor, m
/// @param R         what is added to every position, on the same axes, m
/// @return          inertia tensor about the new origin, on the same axes, kg m²
/// @pre M > 0
/// @pre I_origin is the tensor of a body with this mass and centre of mass: inertia_to_center_of_mass() returns an
///      inertia tensor
/// @par Source
/// S0 s13, S2 s12, S3 p~11, S4 p~13
Matrix3d inertia_about_shifted_origin(const Matrix3d& I_origin, double M, const Vector3d& r_cm, const Vector3d& R);

/// Inertia tensor of a uniform cuboid about its centre.
///
/// \f[ \Inertia = \frac{M}{12} \begin{pmatrix}
///   b^2 + c^2 & 0 & 0 \\[2pt]
///   0 & a^2 + c^2 & 0 \\[2pt]
///   0 & 0 & a^2 + b^2 \end{pmatrix} \f]
///
/// @param M  mass, kg
/// @param a  whole edge along x, m
/// @param b  whole edge along y, m
/// @param c  whole edge along z, m
/// @return   diagonal 3×3 matrix, kg m²
/// @pre M > 0
/// @pre a, b, c ≥ 0: a plate and a rod are legal
/// @par Source
/// S0 s15, S2 s14, S3 p~13, S4 p~15
Matrix3d cuboid_about_center(double M, double a, double b, double c);

/// Inertia tensor of several bodies fixed to one another, about their common centre of mass.
///
/// \f[ \Inertia = \sum_k \left[ \Inertia_k + m_k \left( d_k^2\,\One - \vec d_k\,\vec d_k \right) \right], \qquad
///     \vec d_k = \vec r_k - \frac{\sum_l m_l\,\vec r_l}{\sum_l m_l} \f]
///
/// @param masses   masses of the n bodies, kg
/// @param centers  their centres of mass as columns, 3×n, m
/// @param tensors  n inertia tensors, each about the centre of mass of its own body, all on parallel axes, kg m²
/// @return         inertia tensor of the whole about the common centre of mass, on the same axes, kg m²
/// @pre n ≥ 1, and as many columns and tensors as masses
/// @pre each mass > 0
/// @pre each of the tensors is an inertia tensor
/// @par Source
/// follows from the change of origin of S0 s13, body by body
Matrix3d combined_inertia(const VectorXd& masses, const Matrix3Xd& centers, const std::vector<Matrix3d>& tensors);

}  // namespace rigid
