/// @file
/// Contract of lecture 11: what a gyroscope on a thrown body tells about the body, with error bars.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// The three coefficients of Euler's equations from a measured flight.
///
/// <!-- ω̇_x = a ω_y ω_z, ω̇_y = b ω_z ω_x, ω̇_z = c ω_x ω_y -->
/// \f[ \dot{\tilde\omega}_x = a\,\tilde\omega_y\tilde\omega_z , \qquad
///     \dot{\tilde\omega}_y = b\,\tilde\omega_z\tilde\omega_x , \qquad
///     \dot{\tilde\omega}_z = c\,\tilde\omega_x\tilde\omega_y \f]
///
/// Integrated from the first sample on, by the trapezoidal rule between neighbouring samples,
///
/// <!-- S_0 = 0, S_k = S_(k-1) + ½ (t_k - t_(k-1)) [(ω_y ω_z)_(k-1) + (ω_y ω_z)_k] -->
/// \f[ S_0 = 0 , \qquad S_k = S_{k-1} + \frac{t_k - t_{k-1}}2\,
///     \bigl[(\tilde\omega_y\tilde\omega_z)_{k-1} + (\tilde\omega_y\tilde\omega_z)_k\bigr] , \f]
///
/// and a is the slope of the straight line with a free intercept that fits the points \f$(S_k, \tilde\omega_x(t_k))\f$
/// with the least sum of squared deviations in \f$\tilde\omega_x\f$; b and c likewise, the axes in cyclic order.
///
/// @param t      times of the samples, s
/// @param omega  one column per sample: body components of the angular velocity, rad/s
/// @return       {a, b, c}
/// @pre three samples at least, one column of omega for each; t ascends strictly, in steps of any size
/// @pre for no axis are all \f$S_k\f$ equal
/// @par Source
/// not on the slides; Euler's equations are S0 s17, S1 s4–5
Vector3d euler_coefficients(const VectorXd& t, const Matrix3Xd& omega);

/// Whether three measured coefficients can belong to a rigid body.
///
/// <!-- D = a + b + c + abc -->
/// \f[ D = a + b + c + abc \f]
///
/// vanishes for every rigid body that is free of torque. For small independent errors
///
/// <!-- (ΔD)² = (1 + bc)² (Δa)² + (1 + ca)² (Δb)² + (1 + ab)² (Δc)² -->
/// \f[ (\Delta D)^2 = (1 + bc)^2(\Delta a)^2 + (1 + ca)^2(\Delta b)^2 + (1 + ab)^2(\Delta c)^2 . \f]
///
/// @param coefficients  {a, b, c} of euler_coefficients
/// @param errors        their standard errors
/// @return              {D, its standard error}
/// @pre no error is negative; any may be zero
/// @par Source
/// not on the slides; follows from Euler's equations
Vector2d rigidity_defect(const Vector3d& coefficients, const Vector3d& errors);

/// How a body is turned at the end of a recording of its angular velocity.
///
/// Between two neighbouring samples the body rotates about an axis fixed in it, with the mean of the two angular
/// velocities. With \f$\mat A_0 = \One\f$
///
/// <!-- A_k = A_(k-1) exp [Θ_k]×, Θ_k = ½ (t_k - t_(k-1)) (ω_(k-1) + ω_k), body components -->
/// \f[ \mat A_k = \mat A_{k-1}\,e^{[\vec\Theta_k]_\times} , \qquad
///     \vec\Theta_k = \frac{t_k - t_{k-1}}2\,(\vec\omega_{k-1} + \vec\omega_k)_\bodyframe , \f]
///
/// where \f$e^{[\vec\Theta]_\times}\f$ is the rotation through the angle \f$\Theta\f$ about the direction of
/// \f$\vec\Theta\f$.
///
/// @param t      times of the samples, s
/// @param omega  one column per sample: body components of the angular velocity, rad/s
/// @return       A at the last sample, V_inertial = A V_body, where the body axes at the first sample are the inertial
///               ones
/// @pre one sample at least, one column of omega for each; t ascends strictly, in steps of any size
/// @par Source
/// not on the slides
Matrix3d attitude_from_rates(const VectorXd& t, const Matrix3Xd& omega);

/// What two of the coefficients tell about the moments of the body.
///
/// Of the three coefficients a and c are those that a throw about the x axis gives best; b is not used.
///
/// @param a  coefficient in \f$\dot{\tilde\omega}_x = a\,\tilde\omega_y\tilde\omega_z\f$
/// @param c  coefficient in \f$\dot{\tilde\omega}_z = c\,\tilde\omega_x\tilde\omega_y\f$
/// @return   {I_y/I_x, I_z/I_x}
/// @pre −1 ≤ a ≤ 1 and −1 < c ≤ 1
/// @par Source
/// not on the slides; follows from Euler's equations
Vector2d moment_ratios(double a, double c);

/// The moment of inertia about the centre of mass from the swing of a body hung up by one end, with its error.
///
/// The body swings with a small amplitude about a fixed horizontal axis, without friction. Its mass and g are known
/// well; the distance and the period have independent standard errors, which are small.
///
/// @param M        mass, kg
/// @param g        gravity, m/s²
/// @param d        distance of the centre of mass from the axis, m
/// @param P        period of a full swing to and fro, s
/// @param d_error  standard error of d, m
/// @param P_error  standard error of P, s
/// @return         {moment about the parallel axis through the centre of mass, its standard error}, kg m²
/// @pre M, g, d, P > 0; no error is negative; the moment is not negative
/// @par Source
/// not on the slides; parallel axes: S0 s13
Vector2d moment_from_pendulum(double M, double g, double d, double P, double d_error, double P_error);

/// A body that rotates in air.
///
/// The torque of the air about the centre of mass is opposite to the angular momentum and proportional to it, −γ L.
///
/// @param I       principal moments in any order, kg m²
/// @param omega0  angular velocity at t = 0, body components, rad/s
/// @param gamma   γ, 1/s
/// @param t       time, s
/// @return        angular velocity at time t, body components, rad/s, to six digits of the size of omega0
/// @pre each moment > 0; equal ones are legal
/// @pre γ ≥ 0 and t ≥ 0
/// @par Source
/// not on the slides
Vector3d damped_rotation(const Vector3d& I, const Vector3d& omega0, double gamma, double t);

}  // namespace rigid
