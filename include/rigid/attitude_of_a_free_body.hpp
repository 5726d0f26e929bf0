/// @file
/// Contract of lecture 10: Poinsot's picture of a free body, its exact angular velocity and attitude, and the angle
/// through which it turns about L in a period.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// How fast an axis of a free body goes round L at this moment.
///
/// Whoever watches a thrown stick sees its axis go round a direction that stands still, that of L. The rate is that of
/// the azimuth of axis 3 about L:
///
/// <!-- φ̇ = (ω · L/L - ω₃ cos θ) / sin²θ, cos θ = I₃ ω₃ / L -->
/// \f[ \dot\phi = \frac{\vec\omega\cdot\vec L/L - \tilde\omega_3\cos\theta}{\sin^2\theta} , \qquad
///     \cos\theta = \frac{I_3\tilde\omega_3}{L} \f]
///
/// @param I      principal moments in any order, kg m²
/// @param omega  angular velocity at this moment, body components, rad/s
/// @return       rate, rad/s, right-handed about L, to nine digits
/// @pre each moment > 0; equal ones are legal
/// @pre axis 3 does not point along L: across axis 3, L has a component of at least 10⁻⁵ L
/// @par Source
/// not on the slides; L. D. Landau and E. M. Lifshitz, Mechanics, §37
double azimuth_rate(const Vector3d& I, const Vector3d& omega);

/// Where the ellipsoid of a free body touches the plane on which it rolls.
///
/// Fix in the body the ellipsoid of all angular velocities that have the energy of the present motion, drawn about the
/// centre of mass. It touches a plane that stands still in space, and rolls on it.
///
/// @param I      principal moments in any order, kg m²
/// @param omega  angular velocity at this moment, body components, rad/s
/// @return       {distance of the plane from the centre of the ellipsoid, distance of the point of contact from the
///               foot of the perpendicular from the centre to the plane}, lengths in the space of ω: rad/s
/// @pre each moment > 0; equal ones are legal; omega ≠ 0
/// @pre the second distance is asked for to nine digits wherever it is at least 10⁻⁵ |ω|, where ω is nearly along L too
/// @par Source
/// not on the slides; L. Poinsot 1834
Vector2d poinsot(const Vector3d& I, const Vector3d& omega);

/// The ring in which the herpolhode lies.
///
/// While the ellipsoid of `poinsot` rolls, its point of contact draws a curve on the plane, between two circles around
/// the foot of the perpendicular.
///
/// @param I       principal moments in ascending order, kg m²
/// @param omega0  angular velocity at any one time, body components, rad/s
/// @return        radii of the two circles, the smaller first, rad/s
/// @pre 0 < I₁ ≤ I₂ ≤ I₃ and I₁ < I₃; for a symmetric top the two radii are equal
/// @pre \f$|L^2 - 2TI_2| \ge 10^{-3}L^2\f$ and omega0 ≠ 0; a spin about axis 1 or axis 3 alone is legal and gives
///      {0, 0}
/// @par Source
/// not on the slides; L. D. Landau and E. M. Lifshitz, Mechanics, §37
Vector2d herpolhode_radii(const Vector3d& I, const Vector3d& omega0);

/// The angular velocity of a free body, exact even after days.
///
/// @param I       principal moments in ascending order, kg m²
/// @param omega0  angular velocity at time 0, body components, rad/s
/// @param t       time, s; may be negative or 0
/// @return        angular velocity at time t, body components, rad/s, to 10⁻⁷ |omega0|
/// @pre a real body, 0 < I₁ < I₂ < I₃ ≤ I₁ + I₂, neighbours at least 5 % of I₃ apart
/// @pre 0.1 ≤ |omega0| ≤ 2 rad/s and |t| ≤ 10⁶ s; signs are arbitrary, and one component may vanish
/// @pre \f$|L^2 - 2TI_2| \ge 0.01\,L^2\f$: not close to the separatrix
/// @pre no pure spin: across axis 1, and across axis 3, omega0 has a part of at least 0.05 |omega0|
/// @par Source
/// not on the slides; C. G. J. Jacobi 1850; L. D. Landau and E. M. Lifshitz, Mechanics, §37
Vector3d exact_rotation(const Vector3d& I, const Vector3d& omega0, double t);

/// How far the axis of the largest moment goes round L while ω runs through one period.
///
/// After the period of `tumbling_period` ω is the same again on the axes of the body, but these axes have moved.
///
/// @param I       principal moments in ascending order, kg m²
/// @param omega0  angular velocity at any one time, body components, rad/s
/// @return        angle through which axis 3 goes round L in a period, whole turns counted, rad; right-handed about L
/// @pre a real body, 0 < I₁ < I₂ < I₃ ≤ I₁ + I₂, neighbours at least 5 % of I₃ apart
/// @pre 0.1 ≤ |omega0| ≤ 2 rad/s; signs are arbitrary, and one component may vanish
/// @pre \f$|L^2 - 2TI_2| \ge 10^{-3}L^2\f$: not close to the separatrix
/// @pre no pure spin: across axis 1, and across axis 3, omega0 has a part of at least 0.05 |omega0|; so
///      axis 3 never points along L
/// @par Source
/// not on the slides; L. D. Landau and E. M. Lifshitz, Mechanics, §37
double turn_per_period(const Vector3d& I, const Vector3d& omega0);

/// How far a thrown racket twists about its handle while the handle goes once round.
///
/// Throw a tennis racket end over end and catch it when the handle has gone round once: the other face is up, although
/// nobody twisted it. The handle of a free body is its axis 1. It goes round L, which stands still in space; meanwhile
/// the body also rotates about the handle. The twist is the angle through which it has turned about the handle, as seen
/// from the plane of L and the handle, when this plane has gone round L once.
///
/// A racket whose other two moments are equal twists steadily, and one that rotates exactly about axis 2 or axis 3 does
/// not twist at all.
///
/// @param I       principal moments in ascending order, kg m²
/// @param omega0  angular velocity at the throw, body components, rad/s
/// @return        the twist in one round of the handle, whole turns counted, rad, to 10⁻⁶; right-handed about axis 1
/// @pre a real body, 0 < I₁ ≤ I₂ ≤ I₃ ≤ I₁ + I₂, and I₁ ≥ I₃/20; equal moments are legal
/// @pre omega0 ≠ 0, and L has a component across axis 1 of at least L/2; the separatrix and a pure spin about axis 2 or
///      axis 3 are legal
/// @par Source
/// not on the slides; M. S. Ashbaugh, C. C. Chicone and R. H. Cushman, J. Dyn. Differ. Equ. 3 (1991) 67
double racket_twist(const Vector3d& I, const Vector3d& omega0);

/// The solid angle that the direction of L encloses on the axes of the body.
///
/// On these axes the direction of L moves along a closed curve on the unit sphere, once in the period of
/// `tumbling_period`: around axis 3 or around axis 1, at the end of this axis to which it is closer.
///
/// @param I       principal moments in ascending order, kg m²
/// @param omega0  angular velocity at any one time, body components, rad/s
/// @return        solid angle on the side of that end of the axis, between 0 and 2π, rad (steradian), to 10⁻⁹
/// @pre a real body, 0 < I₁ < I₂ < I₃ ≤ I₁ + I₂, neighbours at least 5 % of I₃ apart
/// @pre 0.1 ≤ |omega0| ≤ 2 rad/s; signs are arbitrary, and one component may vanish
/// @pre \f$|L^2 - 2TI_2| \ge 10^{-3}L^2\f$: not close to the separatrix
/// @pre no pure spin: across axis 1, and across axis 3, omega0 has a part of at least 0.05 |omega0|
/// @par Source
/// not on the slides; R. Montgomery, Am. J. Phys. 59 (1991) 394
double geometric_phase(const Vector3d& I, const Vector3d& omega0);

/// The attitude of a free body, exact even after days.
///
/// At time 0 the principal axes coincide with the inertial axes, as for `free_attitude` of lecture 05.
///
/// @param I       principal moments in ascending order, kg m²
/// @param omega0  angular velocity at time 0, body components, rad/s
/// @param t       time, s; may be negative or 0
/// @return        the principal axes at time t in inertial components, as columns; each entry to 10⁻⁶
/// @pre a real body, 0 < I₁ < I₂ < I₃ ≤ I₁ + I₂, neighbours at least 5 % of I₃ apart
/// @pre 0.1 ≤ |omega0| ≤ 2 rad/s and |t| ≤ 10⁶ s; signs are arbitrary, and one component may vanish
/// @pre \f$|L^2 - 2TI_2| \ge 0.01\,L^2\f$: not close to the separatrix
/// @pre no pure spin: across axis 1, and across axis 3, omega0 has a part of at least 0.2 |omega0|
/// @par Source
/// not on the slides; C. G. J. Jacobi 1850; R. van Zon and J. Schofield, J. Comput. Phys. 225 (2007) 145
Matrix3d exact_attitude(const Vector3d& I, const Vector3d& omega0, double t);

}  // namespace rigid
