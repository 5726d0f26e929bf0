/// @file
/// Contract of lecture 02: acceleration in a rotating frame, fictitious forces, and what they do on the rotating Earth.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// Acceleration in the inertial frame of a point whose motion is known in a frame that rotates about the common origin.
///
/// \f[ a_{inertial} = a_{body} + 2\,\omega\times v_{body} + \alpha\times r + \omega\times(\omega\times r) \f]
///
/// In this order: acceleration in the rotating frame, Coriolis term, Euler term, centripetal term. All vectors are
/// expressed on one and the same set of axes, and so is the result.
///
/// @param a_body  acceleration seen in the rotating frame, m/s²
/// @param v_body  velocity seen in the rotating frame, m/s
/// @param r       position from the common origin, m
/// @param omega   angular velocity of the rotating frame, rad/s
/// @param alpha   its rate \f$\alpha = \dot\omega\f$, the same in both frames, rad/s²
/// @return        acceleration in the inertial frame, m/s²
/// @par Source
/// S0 s8, S2 s7, S3 p~6, S4 p~7 (printed there without the brackets of the last term)
Vector3d inertial_acceleration(const Vector3d& a_body, const Vector3d& v_body, const Vector3d& r, const Vector3d& omega,
                               const Vector3d& alpha);

/// The fictitious force: what must be added to the real forces for Newton's second law to hold in the rotating frame.
///
/// \f[ F_{fictitious} = -m\left[\, 2\,\omega\times v_{body} + \alpha\times r + \omega\times(\omega\times r) \right],
///     \qquad m\, a_{body} = F + F_{fictitious} \f]
///
/// In this order: Coriolis, Euler and centrifugal force, the last pointing away from the axis.
///
/// @param m       mass, kg
/// @param r       position from the common origin, m
/// @param v_body  velocity seen in the rotating frame, m/s
/// @param omega   angular velocity of the rotating frame, rad/s
/// @param alpha   its rate \f$\dot\omega\f$, rad/s²
/// @return        force, N, on the axes of the arguments
/// @pre m > 0
/// @par Source
/// S0 s8, S2 s7, S3 p~6, S4 p~7, brought to the other side of \f$m\,a_{inertial} = F\f$
Vector3d fictitious_force(double m, const Vector3d& r, const Vector3d& v_body, const Vector3d& omega,
                          const Vector3d& alpha);

/// Coriolis acceleration at a place on the Earth.
///
/// \f[ a = -2\,\Omega\times v, \qquad \Omega = \Omega_E\,(0,\ \cos\lambda,\ \sin\lambda) \f]
///
/// The components are those on the local axes east, north, up: the Earth's axis lies in the plane of north and up.
///
/// @param v_enu       velocity relative to the ground: east, north, up, m/s
/// @param latitude    latitude λ, rad; positive north of the equator, negative south of it, ±π/2 at the poles
/// @param earth_rate  angular velocity of the Earth \f$\Omega_E\f$, rad/s (7.292115e-5 for ours)
/// @return            acceleration east, north, up, m/s²
/// @pre |latitude| ≤ π/2
/// @pre earth_rate > 0
/// @par Source
/// the Coriolis term of S0 s8, S2 s7, S3 p~6, S4 p~7 on the rotating Earth; Fetter & Walecka, chapter 2
Vector3d coriolis_acceleration(const Vector3d& v_enu, double latitude, double earth_rate);

/// How far to the east of the plumb line a body lands that is dropped from rest, to first order in the Earth's rate.
///
/// \f[ d = \tfrac13\,\Omega_E\, g\, t^3 \cos\lambda, \qquad t = \sqrt{2h/g} \f]
///
/// No air; g is constant along the fall and points along the plumb line.
///
/// @param height      height of the fall h, m
/// @param latitude    latitude λ, rad, north or south
/// @param g           acceleration of free fall, m/s²
/// @param earth_rate  angular velocity of the Earth \f$\Omega_E\f$, rad/s
/// @return            deflection, m, positive to the east
/// @pre height ≥ 0 (no height, no deflection)
/// @pre |latitude| ≤ π/2
/// @pre g > 0 and earth_rate > 0
/// @par Source
/// the Coriolis term of S0 s8, S2 s7, S3 p~6, S4 p~7 integrated twice; Fetter & Walecka, chapter 2
double eastward_deflection(double height, double latitude, double g, double earth_rate);

/// Time in which the plane of swing of a Foucault pendulum rotates once round.
///
/// \f[ P = \frac{P_{day}}{\sin\lambda} \f]
///
/// @param latitude      latitude λ on the northern hemisphere, rad
/// @param sidereal_day  P_day, one rotation of the Earth among the stars, s (86164.0989 for ours)
/// @return              time P of a full rotation by 360°, s
/// @pre 0 < latitude ≤ π/2 (on the equator the plane of swing does not rotate)
/// @pre sidereal_day > 0
/// @par Source
/// the Coriolis term of S0 s8, S2 s7, S3 p~6, S4 p~7 applied to a pendulum; Fetter & Walecka, chapter 2
double foucault_period(double latitude, double sidereal_day);

}  // namespace rigid
