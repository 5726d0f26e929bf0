/// @file
/// Contract of lecture 09: bodies that rotate about a fixed point under their weight, above all the heavy symmetric
/// top, and the precession of a planet's axis.
///
/// Moments are those about the fixed point, the tip. mgl is the weight times the distance of the centre of mass from
/// the tip. The centre of mass lies on the positive axis 3; θ is the angle between this axis and the upward vertical,
/// and \f$(\phi, \theta, \psi)\f$ are the z–y–z angles of lecture 07. A symmetric top has the moment I1 about every
/// axis across its own, and I3 ≤ 2 I1, as every body has about a point of its axis.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// Second derivatives of the Euler angles of a body that rotates about a fixed point under its weight.
///
/// Its three moments are in general different.
///
/// @param I       principal moments about the fixed point, kg m²
/// @param mgl     weight times the distance of the centre of mass, which lies on the positive axis 3, from the fixed
///                point, J; zero is legal: no torque acts
/// @param angles  \f$(\phi, \theta, \psi)\f$, any real numbers, rad
/// @param rates   \f$(\dot\phi, \dot\theta, \dot\psi)\f$, rad/s; zero is legal
/// @return        \f$(\ddot\phi, \ddot\theta, \ddot\psi)\f$, rad/s²
/// @pre each moment > 0, mgl ≥ 0
/// @pre |sin θ| ≥ 0.05; at sin θ = 0 the angles are singular
/// @par Source
/// not on the slides; Landau and Lifshitz, §35
Vector3d heavy_top_accelerations(const Vector3d& I, double mgl, const Vector3d& angles, const Vector3d& rates);

/// The energy of a heavy symmetric top at an inclination at which its nutation turns round.
///
/// It is the energy, kinetic and potential, of the top that passes the inclination theta with \f$\dot\theta = 0\f$ and
/// has the momenta p_phi and p_psi. The potential energy is zero where the axis is horizontal.
///
/// @param I1     moment about the tip, across the axis, kg m²
/// @param I3     moment along the axis, kg m²
/// @param mgl    weight times the distance of the centre of mass from the tip, J
/// @param p_phi  angular momentum about the vertical, kg m²/s; either sign, zero is legal
/// @param p_psi  angular momentum along the axis, kg m²/s; either sign, zero is legal: a pendulum
/// @param theta  inclination of the axis to the upward vertical, rad
/// @return       energy, J
/// @pre I1 > 0, I3 > 0, I3 ≤ 2 I1, mgl > 0 and 0 < theta < π
/// @par Source
/// not on the slides; Goldstein, §5.7, and Landau and Lifshitz, §35, without the energy of the spin
double effective_potential(double I1, double I3, double mgl, double p_phi, double p_psi, double theta);

/// The two rates at which a heavy symmetric top can precess without nutation.
///
/// Each is asked for to nine of its own digits, also where one is a billion times the other.
///
/// @param I1      moment about the tip, across the axis, kg m²
/// @param I3      moment along the axis, kg m²
/// @param mgl     weight times the distance of the centre of mass from the tip, J
/// @param omega3  component of the angular velocity along the axis, rad/s; either sign
/// @param theta   inclination of the axis to the upward vertical, rad; beyond π/2 the top hangs below its support
/// @return        the two values of \f$\dot\phi\f$ with their signs, that of smaller magnitude first, rad/s
/// @pre I1 > 0, I3 > 0, I3 ≤ 2 I1, mgl > 0, 0 < theta < π and |cos θ| ≥ 0.01
/// @pre |omega3| > 0, and at least 0.1 % above the least spin at which such a precession exists
/// @par Source
/// not on the slides; Goldstein, §5.7
Vector2d steady_precession(double I1, double I3, double mgl, double omega3, double theta);

/// The spin at which a heavy symmetric top that spins upright begins to wobble, as friction slows it down.
///
/// @param I1   moment about the tip, across the axis, kg m²
/// @param I3   moment along the axis, kg m²
/// @param mgl  weight times the distance of the centre of mass from the tip, J
/// @return     the least angular velocity at which it stands upright, or sleeps, rad/s, positive
/// @pre I1 > 0, I3 > 0, I3 ≤ 2 I1 and mgl > 0
/// @par Source
/// not on the slides; Landau and Lifshitz, §35, problem 2; Goldstein, §5.7
double sleeping_spin(double I1, double I3, double mgl);

/// The shape of the path on which the axis of a heavy symmetric top moves.
///
/// The axis of a spinning top is held at the inclination theta and released with a push: it goes round the vertical at
/// phi_rate, and \f$\dot\theta = 0\f$. Its path is a *wave*, if the axis goes round in one sense always (a circle counts
/// as a wave), it has *loops*, if the sense changes in every nutation, and *cusps*, if the axis stops in every nutation.
///
/// @param I1        moment about the tip, across the axis, kg m²
/// @param I3        moment along the axis, kg m²
/// @param mgl       weight times the distance of the centre of mass from the tip, J
/// @param theta     inclination at the release, rad
/// @param phi_rate  \f$\dot\phi\f$ at the release, rad/s; zero is legal: released at rest
/// @param omega3    component of the angular velocity along the axis, rad/s; either sign
/// @return          1 for a wave, −1 for loops, 0 for cusps
/// @pre I1 > 0, I3 > 0, I3 ≤ 2 I1, mgl > 0, 0 < theta < π and omega3 ≠ 0
/// @pre phi_rate is zero, or at least a thousandth away from each rate at which the shape changes; so the axis does not
///      pass through the vertical
/// @par Source
/// not on the slides; Goldstein, §5.7
int path_type(double I1, double I3, double mgl, double theta, double phi_rate, double omega3);

/// How often a top that precesses steadily nods when it is touched.
///
/// A toy gyroscope precesses on its support, and you have timed it. Tap it: the axis nods up and down, with small
/// amplitude, while it goes on round. Neither its spin nor its moment along the axis need be known.
///
/// A top that precesses very slowly nods very fast. One that precesses very fast hardly notices its weight: it nods once
/// in a round.
///
/// @param I1     moment about the tip, across the axis, kg m²
/// @param mgl    weight times the distance of the centre of mass from the tip, J
/// @param theta  inclination of the axis to the upward vertical, rad
/// @param rate   \f$\dot\phi\f$ of the steady precession, rad/s; either sign, slow or fast
/// @return       angular frequency of small nutations about the steady precession, rad/s, positive
/// @pre I1 > 0, mgl > 0, 0 < theta < π, sin θ ≥ 0.01 and rate ≠ 0
/// @par Source
/// not on the slides; Goldstein, §5.7
double nutation_frequency(double I1, double mgl, double theta, double rate);

/// The inclinations between which the axis of a heavy symmetric top nutates.
///
/// @param I1     moment about the tip, across the axis, kg m²
/// @param I3     moment along the axis, kg m²
/// @param mgl    weight times the distance of the centre of mass from the tip, J
/// @param theta  inclination at the start, rad
/// @param rates  \f$(\dot\phi, \dot\theta, \dot\psi)\f$ at the start, rad/s; zero is legal: a top without spin, let go
/// @return       the smallest and the largest θ of the motion, in this order, rad
/// @pre I1 > 0, I3 > 0, I3 ≤ 2 I1, mgl > 0 and 0 < theta < π
/// @pre no steady precession: the limits differ by at least 10⁻³ rad
/// @pre not through the vertical or close to it: sin θ ≥ 0.01 at both limits
/// @par Source
/// not on the slides; Goldstein, §5.7
Vector2d nutation_limits(double I1, double I3, double mgl, double theta, const Vector3d& rates);

/// The period of the nutation of a heavy symmetric top: the time from one largest inclination to the next.
///
/// @param I1     moment about the tip, across the axis, kg m²
/// @param I3     moment along the axis, kg m²
/// @param mgl    weight times the distance of the centre of mass from the tip, J
/// @param theta  inclination at the start, rad
/// @param rates  \f$(\dot\phi, \dot\theta, \dot\psi)\f$ at the start, rad/s
/// @return       period, s
/// @pre I1 > 0, I3 > 0, I3 ≤ 2 I1, mgl > 0 and 0 < theta < π
/// @pre no steady precession: the limits differ by at least 10⁻³ rad
/// @pre not through the vertical or close to it: sin θ ≥ 0.01 at both limits
/// @par Source
/// not on the slides; Landau and Lifshitz, §35, problem 1
double nutation_period(double I1, double I3, double mgl, double theta, const Vector3d& rates);

/// The angle through which the axis of a heavy symmetric top goes round the vertical during one nutation.
///
/// It is asked for to 10⁻⁸ of itself, or of 0.01 rad where it is smaller than that.
///
/// @param I1     moment about the tip, across the axis, kg m²
/// @param I3     moment along the axis, kg m²
/// @param mgl    weight times the distance of the centre of mass from the tip, J
/// @param theta  inclination at the start, rad
/// @param rates  \f$(\dot\phi, \dot\theta, \dot\psi)\f$ at the start, rad/s
/// @return       change of φ in one period of the nutation, rad; positive anticlockwise as seen from above; the
///               parts of a loop that run backwards count as negative
/// @pre I1 > 0, I3 > 0, I3 ≤ 2 I1, mgl > 0 and 0 < theta < π
/// @pre no steady precession: the limits differ by at least 10⁻³ rad
/// @pre not through the vertical or close to it: sin θ ≥ 0.01 at both limits
/// @par Source
/// not on the slides; Landau and Lifshitz, §35, problem 1
double precession_per_nutation(double I1, double I3, double mgl, double theta, const Vector3d& rates);

/// The mean rate at which the axis of a planet goes round the normal of its orbit.
///
/// The planet is symmetric about its axis of rotation and moves round its sun on a circle; it has no moon. To lowest
/// order: its spin is much faster than its orbital motion, and this much faster than the precession.
///
/// @param I1            moment about an axis in the equator, kg m²; only the ratio of the moments matters
/// @param I3            moment about the axis of rotation, kg m²
/// @param spin          angular velocity of the rotation, rad/s
/// @param orbital_rate  angular velocity of the orbital motion, rad/s
/// @param obliquity     between the angular velocities of the rotation and of the orbital motion, rad; beyond π/2
///                      the planet rotates against its orbital motion
/// @return              rate, averaged over a year, rad/s, positive in the sense of the orbital motion
/// @pre 0 < I1 ≤ I3 ≤ 2 I1; equal moments are legal and give 0
/// @pre spin > 0, orbital_rate > 0 and 0 < obliquity < π
/// @par Source
/// not on the slides; Goldstein, §5.8
double planet_precession_rate(double I1, double I3, double spin, double orbital_rate, double obliquity);

/// The least speed at which a wheel rolls upright by itself.
///
/// Send a hoop, a coin or a wheel rolling along level ground and let it go. Fast enough, it leans a little, steers into
/// the lean and goes on; below some speed every lean grows, and it topples. It rolls on its sharp edge without
/// slipping. How heavy it is does not count.
///
/// A flat wheel with all of its mass at the rim may go slower than one with its mass near the hub, but not by much; a
/// wheel with a long heavy axle steers badly and must go very fast.
///
/// @param radius      of the edge, m
/// @param g           gravity, m/s²
/// @param axial       moment about the axle through the centre of mass over mass times radius squared
/// @param transverse  the same for a diameter
/// @return            speed of the centre above which a small lean does not grow, m/s
/// @pre all > 0 and axial ≤ 2 transverse, as for every body
/// @par Source
/// not on the slides; J. I. Neimark and N. A. Fufaev, Dynamics of Nonholonomic Systems
double least_rolling_speed(double radius, double g, double axial, double transverse);

/// How a satellite swings about its attitude in orbit, held by nothing but gravity.
///
/// A rigid satellite moves on a circle round the Earth at orbital_rate and always shows it the same side: axis 1 points
/// away from the Earth, axis 2 forwards, axis 3 along the normal of the orbit, in the sense of the orbital motion. Its
/// near end is pulled more than its far end. Disturbed a little it swings: in the plane of the orbit, and across it in
/// two ways.
///
/// For a long thin rod that stands upright the ratios to the orbital rate are those of small integers and their roots,
/// whatever its mass and length. A ball does not swing at all.
///
/// @param I             principal moments about the centre of mass: radial, forward, normal, kg m²
/// @param orbital_rate  angular velocity of the orbital motion, rad/s
/// @return              angular frequencies {in the plane of the orbit, the slower one across it, the faster one},
///                      rad/s
/// @pre a real body; orbital_rate > 0
/// @pre the attitude is stable: no small disturbance grows; the squares of all three frequencies are at least 10⁻⁷ of
///      the square of orbital_rate, and those of the last two as far apart
/// @par Source
/// not on the slides; J. L. Lagrange 1780; D. B. DeBra and R. H. Delp, J. Astronaut. Sci. 8 (1961) 14
Vector3d attitude_frequencies(const Vector3d& I, double orbital_rate);

/// Where a moon faces that its planet holds by the tide.
///
/// The Moon shows us the same side, and yet it swings to and fro: its orbit is an ellipse, and the Earth pulls at its long
/// axis. Mercury does not face the Sun at all; it turns three times in two orbits, held by the same torque. A moon moves
/// round its planet on an ellipse and rotates about the axis of its largest moment, which is the normal of the orbit.
/// At time 0 it is at its least distance. Theta is the angle of its long axis, that of its smallest moment, from the
/// direction in which it stood from its planet at time 0, in the sense of the orbital motion.
///
/// A moon whose equator is round rotates steadily. On a circle a small swing about the direction of the planet is that of
/// a pendulum.
///
/// @param asymmetry     difference of the two moments in the plane of the orbit over the moment about its normal
/// @param eccentricity  of the orbit
/// @param orbital_rate  2π over the time of an orbit, rad/s
/// @param theta0        at time 0, rad
/// @param rate0         its rate at time 0, rad/s; for the face that stays near the planet about orbital_rate
/// @param t             time, s
/// @return              {theta, its rate} at time t, whole turns counted, rad and rad/s, to 10⁻⁶
/// @pre 0 ≤ asymmetry ≤ 1, 0 ≤ eccentricity ≤ 0.6, orbital_rate > 0, |rate0| ≤ 5 orbital_rate and
///      0 ≤ t ≤ 40/orbital_rate
/// @par Source
/// not on the slides; G. J. Sussman and J. Wisdom, Structure and Interpretation of Classical Mechanics, chapter 2
Vector2d moon_libration(double asymmetry, double eccentricity, double orbital_rate, double theta0, double rate0,
                        double t);

}  // namespace rigid
