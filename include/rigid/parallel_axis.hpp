/// @file
/// Contract of lecture 04: how the inertia tensor changes with the origin.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// Inertia tensor about a point, from the tensor about the centre of mass: the parallel-axis theorem.
///
/// <!-- I = I_CM + M (d² 1 - d dᵀ) -->
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
/// S0 s13–14, S2 s12–13, S3 p. 11–12, S4 p. 13–14, read from the centre of mass outwards
Matrix3d inertia_from_center_of_mass(const Matrix3d& I_cm, double M, const Vector3d& d);

/// Inertia tensor about the centre of mass, from the tensor about the origin.
///
/// <!-- I_CM = I - M (r_CM² 1 - r_CM r_CMᵀ) -->
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
/// S0 s14, S2 s13, S3 p. 12, S4 p. 14: the shift \f$\vec R = -\vec r_\CM\f$
Matrix3d inertia_to_center_of_mass(const Matrix3d& I_origin, double M, const Vector3d& r_cm);

/// Inertia tensor about a shifted origin, which neither before nor after need be the centre of mass.
///
/// All positions change by the same vector, \f$\vec r'_p = \vec r_p + \vec R\f$. So R points from the new origin to the
/// old one, and the new origin lies at −R.
///
/// <!-- I'_ij = I_ij + M (R² δ_ij - R_i R_j) + M (2 r_CM · R δ_ij - r_CM,i R_j - R_i r_CM,j) -->
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
/// S0 s13, S2 s12, S3 p. 11, S4 p. 13
Matrix3d inertia_about_shifted_origin(const Matrix3d& I_origin, double M, const Vector3d& r_cm, const Vector3d& R);

/// Inertia tensor of a uniform cuboid about its centre.
///
/// <!-- I = M/12 diag(b² + c², a² + c², a² + b²) -->
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
/// S0 s15, S2 s14, S3 p. 13, S4 p. 15
Matrix3d cuboid_about_center(double M, double a, double b, double c);

/// Inertia tensor of several bodies fixed to one another, about their common centre of mass.
///
/// <!-- I = Σ_k [I_k + m_k (d_k² 1 - d_k d_kᵀ)], d_k = r_k - Σ_l m_l r_l / Σ_l m_l -->
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

/// Inertia tensor of a uniform block with a spherical hole, about the centre of mass of what remains.
///
/// @param density  of the block, kg/m³
/// @param edges    whole edges of the block along x, y, z, m; its centre is the origin
/// @param center   centre of the hole, m
/// @param radius   of the hole, m
/// @return         inertia tensor about the centre of mass of what remains, on the axes of the block, kg m²
/// @pre density > 0, edges > 0
/// @pre radius ≥ 0: no hole is legal; the hole lies inside the block and may touch its faces
/// @par Source
/// follows from the change of origin of S0 s13 and the cuboid of S0 s15
Matrix3d block_with_hole(double density, const Vector3d& edges, const Vector3d& center, double radius);

/// The acceleration of free fall, from the periods of a pendulum that hangs from one and then from another knife edge.
///
/// The pendulum is rigid; its mass and its moment of inertia are unknown. The knife edges are parallel, on opposite
/// sides of the centre of mass, and one straight line passes through all three. The swings are small.
///
/// @param h1  distance of the first knife edge from the centre of mass, m
/// @param T1  period on the first knife edge, to and fro, s
/// @param h2  distance of the second knife edge from the centre of mass, m
/// @param T2  period on the second knife edge, s
/// @return    acceleration of free fall, m/s²
/// @pre all four > 0; h1 and h2 differ by a tenth of the larger one or more
/// @pre some rigid pendulum has these periods; T1 = T2 is legal
/// @par Source
/// H. Kater 1818, F. W. Bessel 1826
double gravity_from_kater(double h1, double T1, double h2, double T2);

/// The speed above which a sliding block topples over a ridge.
///
/// A uniform block slides over a smooth horizontal floor. Its lower front edge meets a low ridge, fixed to the floor
/// and parallel to the edge; the edge neither rebounds from the ridge nor slips off it.
///
/// @param length  edge of the block along its motion, m
/// @param height  vertical edge, m
/// @param g       acceleration of free fall, m/s²
/// @return        the least speed before the blow with which the block topples, m/s
/// @pre all > 0
/// @par Source
/// follows from the change of origin of S0 s13–15; a problem of many books, for a cube in T. W. B. Kibble, Classical
/// Mechanics
double toppling_speed(double length, double height, double g);

/// The velocity with which a point of a free body begins to move when another point is struck.
///
/// The body is at rest before. The vectors start at its centre of mass.
///
/// @param M        mass, kg
/// @param I_cm     inertia tensor about the centre of mass, kg m²
/// @param r        the point that is struck, on the axes of the tensor, m
/// @param impulse  what it receives, on the same axes, N s
/// @param p        the point whose velocity is asked for, on the same axes, m
/// @return         velocity of the point p after the blow, on the same axes, m/s
/// @pre M > 0; I_cm is an inertia tensor, but not that of a body on one straight line
/// @par Source
/// follows from momentum and angular momentum about the centre of mass, König's theorem
Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p);

}  // namespace rigid
