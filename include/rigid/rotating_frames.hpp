/// @file
/// Contract of lecture 02: acceleration in a rotating frame, fictitious forces, and what they do on the rotating Earth.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// Acceleration in the inertial frame of a point whose motion is known in a frame that rotates about the common origin.
///
/// <!-- a_inertial = a_body + 2 ω × v_body + α × r + ω × (ω × r) -->
/// \f[ \vec a_\inertialframe = \vec a_\bodyframe + 2\,\vec\omega\times\vec v_\bodyframe + \vec\alpha\times\vec r
///     + \vec\omega\times(\vec\omega\times\vec r) \f]
///
/// In this order: acceleration in the rotating frame, Coriolis term, Euler term, centripetal term. All vectors are
/// expressed on one and the same set of axes, and so is the result.
///
/// @param a_body  acceleration seen in the rotating frame, m/s²
/// @param v_body  velocity seen in the rotating frame, m/s
/// @param r       position from the common origin, m
/// @param omega   angular velocity of the rotating frame, rad/s
/// @param alpha   its rate \f$\vec\alpha = \dot{\vec\omega}\f$, the same in both frames, rad/s²
/// @return        acceleration in the inertial frame, m/s²
/// @par Source
/// S0 s8, S2 s7, S3 p. 6, S4 p. 7 (printed there without the brackets of the last term)
Vector3d inertial_acceleration(const Vector3d& a_body, const Vector3d& v_body, const Vector3d& r, const Vector3d& omega,
                               const Vector3d& alpha);

/// The fictitious force: what must be added to the real forces for Newton's second law to hold in the rotating frame.
///
/// <!-- F_fictitious = -m [2 ω × v_body + α × r + ω × (ω × r)] and m a_body = F + F_fictitious -->
/// \f[ \vec F_\mathrm{fictitious} = -m\left[\, 2\,\vec\omega\times\vec v_\bodyframe + \vec\alpha\times\vec r
///     + \vec\omega\times(\vec\omega\times\vec r) \right], \qquad
///     m\,\vec a_\bodyframe = \vec F + \vec F_\mathrm{fictitious} \f]
///
/// In this order: Coriolis, Euler and centrifugal force, the last pointing away from the axis.
///
/// @param m       mass, kg
/// @param r       position from the common origin, m
/// @param v_body  velocity seen in the rotating frame, m/s
/// @param omega   angular velocity of the rotating frame, rad/s
/// @param alpha   its rate \f$\dot{\vec\omega}\f$, rad/s²
/// @return        force, N, on the axes of the arguments
/// @pre m > 0
/// @par Source
/// S0 s8, S2 s7, S3 p. 6, S4 p. 7, brought to the other side of \f$m\,\vec a_\inertialframe = \vec F\f$
Vector3d fictitious_force(double m, const Vector3d& r, const Vector3d& v_body, const Vector3d& omega,
                          const Vector3d& alpha);

/// Coriolis acceleration at a place on the Earth.
///
/// <!-- a = -2 Ω × v, Ω = Ω_E (0, cos λ, sin λ) -->
/// \f[ \vec a = -2\,\vec\Omega\times\vec v, \qquad \vec\Omega = \Omega_\mathrm E\,(0,\ \cos\lambda,\ \sin\lambda) \f]
///
/// The components are those on the local axes east, north, up: the Earth's axis lies in the plane of north and up.
///
/// @param v_enu       velocity relative to the ground: east, north, up, m/s
/// @param latitude    latitude λ, rad; positive north of the equator, negative south of it, ±π/2 at the poles
/// @param earth_rate  angular velocity of the Earth \f$\Omega_\mathrm E\f$, rad/s (7.292115e-5 for ours)
/// @return            acceleration east, north, up, m/s²
/// @pre |latitude| ≤ π/2
/// @pre earth_rate > 0
/// @par Source
/// the Coriolis term of S0 s8, S2 s7, S3 p. 6, S4 p. 7 on the rotating Earth; Fetter & Walecka, chapter 2
Vector3d coriolis_acceleration(const Vector3d& v_enu, double latitude, double earth_rate);

/// How far to the east of the plumb line a body lands that is dropped from rest, to first order in the Earth's rate.
///
/// <!-- d = ⅓ Ω_E g t³ cos λ, t = √(2h/g) -->
/// \f[ d = \tfrac13\,\Omega_\mathrm E\, g\, t^3 \cos\lambda, \qquad t = \sqrt{2h/g} \f]
///
/// No air; g is constant along the fall and points along the plumb line.
///
/// @param height      height of the fall h, m
/// @param latitude    latitude λ, rad, north or south
/// @param g           acceleration of free fall, m/s²
/// @param earth_rate  angular velocity of the Earth \f$\Omega_\mathrm E\f$, rad/s
/// @return            deflection, m, positive to the east
/// @pre height ≥ 0 (no height, no deflection)
/// @pre |latitude| ≤ π/2
/// @pre g > 0 and earth_rate > 0
/// @par Source
/// the Coriolis term of S0 s8, S2 s7, S3 p. 6, S4 p. 7 integrated twice; Fetter & Walecka, chapter 2
double eastward_deflection(double height, double latitude, double g, double earth_rate);

/// Time in which the plane of swing of a Foucault pendulum rotates once round.
///
/// <!-- P = P_day / sin λ -->
/// \f[ P = \frac{P_\mathrm{day}}{\sin\lambda} \f]
///
/// @param latitude      latitude λ on the northern hemisphere, rad
/// @param sidereal_day  P_day, one rotation of the Earth among the stars, s (86164.0989 for ours)
/// @return              time P of a full rotation by 360°, s
/// @pre 0 < latitude ≤ π/2 (on the equator the plane of swing does not rotate)
/// @pre sidereal_day > 0
/// @par Source
/// the Coriolis term of S0 s8, S2 s7, S3 p. 6, S4 p. 7 applied to a pendulum; Fetter & Walecka, chapter 2
double foucault_period(double latitude, double sidereal_day);

/// Gravity as a plumb line and a scale register it aboard a moving ship.
///
/// A planet is a sphere that attracts towards its centre and rotates. The ship sails over its surface at a constant
/// speed along a great circle drawn on the planet. Asked for is the acceleration with which a body let go aboard begins
/// to fall relative to the ship.
///
/// @param latitude    geocentric latitude of the ship, rad; positive north of the equator, ±π/2 at the poles
/// @param radius      radius of the planet, m
/// @param g0          acceleration by the attraction at the surface, m/s²
/// @param earth_rate  angular velocity of the planet, rad/s
/// @param v           velocity of the ship relative to the ground: east, north, m/s; zero for a plumb line ashore
/// @return            acceleration of free fall relative to the ship, m/s²: east, north, up (away from the centre)
/// @pre |latitude| ≤ π/2
/// @pre radius > 0, g0 > 0 and earth_rate > 0
/// @pre the ship does not lift off: the component up is negative
/// @par Source
/// the four terms of S0 s8, S2 s7, S3 p. 6, S4 p. 7; the Eötvös effect
Vector3d apparent_gravity(double latitude, double radius, double g0, double earth_rate, const Vector2d& v);

/// How far a shell lands beside the line of fire because the Earth rotates, to first order in its rate.
///
/// There is no air; the ground is flat, and g is constant and points along the plumb line. If the Earth did not rotate,
/// the shell would land at the distance range after the time given.
///
/// @param latitude    latitude, rad; positive north of the equator
/// @param azimuth     direction of fire, rad, from north clockwise: π/2 is east
/// @param range       distance from gun to impact without rotation, m; 0 for a shot straight up
/// @param time        time of flight without rotation, s
/// @param g           acceleration of free fall, m/s²
/// @param earth_rate  angular velocity of the Earth, rad/s
/// @return            distance of the impact from the line of fire, m, positive to the right of the line
/// @pre |latitude| ≤ π/2
/// @pre range ≥ 0, time > 0, g > 0 and earth_rate > 0
/// @par Source
/// the Coriolis term of S0 s8, S2 s7, S3 p. 6, S4 p. 7; Fetter & Walecka, chapter 2
double shell_drift(double latitude, double azimuth, double range, double time, double g, double earth_rate);

/// Position of the bob of a Foucault pendulum on the floor.
///
/// The bob is pulled aside and released from rest relative to the floor. The swings are small, so that it moves level
/// and is pulled back in proportion to its distance from the lowest point, the origin. Of the fictitious forces only
/// the Coriolis force counts; to first order in earth_rate, but earth_rate·t may be large.
///
/// @param start       where the bob is released: east, north, m; zero leaves it at rest
/// @param length      length of the pendulum, m
/// @param g           acceleration of free fall, m/s²
/// @param latitude    latitude, rad; positive north of the equator
/// @param earth_rate  angular velocity of the Earth, rad/s
/// @param t           time since the release, s
/// @return            where the bob is: east, north, m
/// @pre |start| ≤ length/10, 0 < length ≤ 100 m and 0 ≤ t ≤ 1800 s
/// @pre |latitude| ≤ π/2
/// @pre g > 0, earth_rate > 0 and earth_rate² t ≤ 3.2·10⁻⁵ √(g/length): what is of second order in earth_rate is less
/// than
///      2·10⁻⁵ of |start|, and may be kept or left out
/// @par Source
/// the Coriolis term of S0 s8, S2 s7, S3 p. 6, S4 p. 7 applied to a pendulum; Fetter & Walecka, chapter 2
Vector2d foucault_path(const Vector2d& start, double length, double g, double latitude, double earth_rate, double t);

/// How high the tide of a moon stands on a planet that is covered with water.
///
/// The planet attracts like a point at its centre, and falls freely in the attraction of the moon, which is a point
/// too. The water is at rest on the planet; the water's own attraction is left out, and the rotation of the planet
/// too. Heights are counted from the places a quarter round from the moon, at the angle π/2: there the water stands at
/// the distance radius from the centre. A distant moon makes two equal high waters, on the side of the moon and on the
/// opposite one; a nearer moon makes that on its own side higher.
///
/// @param mass_ratio  mass of the moon by that of the planet
/// @param radius      distance of the water from the centre a quarter round from the moon, m
/// @param distance    from the centre of the planet to the moon, m
/// @param angle       at the centre, between the direction of the place and that of the moon, rad: 0 below the moon
/// @return            height of the water at this place, m; negative where it stands lower than a quarter round from
/// the moon
/// @pre mass_ratio > 0 and 0 ≤ angle ≤ π
/// @pre 2·10⁻⁵ ≤ radius/distance ≤ 0.3; mass_ratio times its cube is from 10⁻⁹ to 0.005
/// @par Source
/// a moving origin in S0 s8, S2 s7, S3 p. 6, S4 p. 7; Isaac Newton 1687
double tide(double mass_ratio, double radius, double distance, double angle);

/// Stable equilibrium of a bead on a rotating hoop, and its small oscillations.
///
/// A circular hoop stands upright and rotates at a constant rate about its vertical diameter. A bead slides on it
/// without friction.
///
/// @param radius  radius of the hoop, m
/// @param g       acceleration of free fall, m/s²
/// @param rate    angular velocity of the hoop, rad/s, of either sign; zero for a hoop at rest
/// @return        {angle of the stable position from the lowest point of the hoop, from 0 to π, rad;
///                angular frequency of small oscillations about it, rad/s}
/// @pre radius > 0 and g > 0
/// @pre |rate| differs by at least 1 % from the critical one, at which the frequency is zero
/// @par Source
/// the centrifugal term of S0 s8, S2 s7, S3 p. 6, S4 p. 7 on a curve
Vector2d bead_on_hoop(double radius, double g, double rate);

}  // namespace rigid
