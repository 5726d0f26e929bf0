/// @file
/// Contract of lecture 05: the rate of angular momentum, Euler's equations and the free rotation that follows from
/// them.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// Euler's equations, solved for the angular acceleration.
///
/// \f[ I_1 \dot{\tilde\omega}_1 + \tilde\omega_2 \tilde\omega_3 (I_3 - I_2) = \tau_1 \quad\text{and cyclically} \f]
///
/// @param I       principal moments about the fixed point or the centre of mass, in any order, kg m²
/// @param omega   angular velocity, components on the principal axes, rad/s
/// @param torque  torque about the same point, components on the principal axes, N m
/// @return        rates of change of the components of omega, rad/s²
/// @pre each moment > 0
/// @par Source
/// S0 s19–20, S1 s7–8, S2 s17–18, S3 p~16–17, S4 p~18–19
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque);

/// Euler's equations on any axes fixed in the body, principal or not.
///
/// \f[ \mathsf I \cdot \dot\omega + \omega \times (\mathsf I \cdot \omega) = \tau \f]
///
/// @param I       inertia tensor about the fixed point or the centre of mass, on body axes, kg m²
/// @param omega   angular velocity on the same axes, rad/s
/// @param torque  torque about the same point on the same axes, N m
/// @return        angular acceleration on the same axes, rad/s²; it is the same vector in the inertial frame
/// @pre I is an inertia tensor and positive definite: a body on one straight line is excluded
/// @par Source
/// the torque equation of S0 s19, S1 s7, S2 s17, S3 p~16, S4 p~18, before the choice of axes
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque);

/// The torque that must act on a body for its angular velocity to stay as it is.
///
/// \f[ \tau = \omega \times (\mathsf I \cdot \omega) \f]
///
/// It is at right angles to omega, so it does no work, and it rotates with the body.
///
/// @param I      inertia tensor on axes fixed in the body, kg m²
/// @param omega  angular velocity on the same axes, constant, rad/s
/// @return       torque on the body, same axes, N m; zero when omega lies along a principal axis
/// @pre I is an inertia tensor and positive definite: a body on one straight line is excluded
/// @par Source
/// S0 s19, S1 s7, S2 s17, S3 p~16, S4 p~18 with \f$\dot\omega = 0\f$
Vector3d torque_to_hold_rotation(const Matrix3d& I, const Vector3d& omega);

/// The rate of change of the angular momentum in the inertial frame.
///
/// \f[ \left(\frac{dL}{dt}\right)_{in} = \mathsf I \cdot \dot\omega + \omega \times (\mathsf I \cdot \omega) \f]
///
/// @param I           inertia tensor on axes fixed in the body, kg m²
/// @param omega       angular velocity on these axes, rad/s
/// @param omega_rate  rates of change of the components of omega, rad/s²
/// @return            the vector dL/dt as seen from the inertial frame, its components taken on the body axes, N m
/// @pre I is an inertia tensor and positive definite: a body on one straight line is excluded
/// @par Source
/// S0 s17–18, S1 s6, S2 s16, S3 p~15, S4 p~17
Vector3d angular_momentum_rate(const Matrix3d& I, const Vector3d& omega, const Vector3d& omega_rate);

/// What a free rotation conserves: the kinetic energy and the square of the angular momentum.
///
/// \f[ T = \tfrac12 \sum_i I_i\, \tilde\omega_i^2, \qquad L^2 = \sum_i I_i^2\, \tilde\omega_i^2 \f]
///
/// @param I      principal moments, kg m²
/// @param omega  angular velocity, components on the principal axes, rad/s
/// @return       {T in J, L² in (kg m²/s)²}
/// @pre each moment > 0
/// @par Source
/// S0 s17, S1 s4 and s6, S2 s16, S3 p~14, S4 p~16
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega);

/// The angular velocity of a body on which no torque acts, as time goes by.
///
/// Integrates Euler's equations with \f$\tau = 0\f$ from omega0 at t = 0 to each of the given times. The times are
/// moments, not steps: choose the steps of the integration by yourself.
///
/// @param I       principal moments in any order, kg m²
/// @param omega0  angular velocity at t = 0, components on the principal axes, rad/s
/// @param times   moments at which it is asked for, s: in any order, negative, zero or repeated, perhaps none
/// @return        3×n, rad/s: column k holds the components on the principal axes at times[k]
/// @pre each moment > 0
/// @par Source
/// S0 s20, S1 s7–8, S2 s18, S3 p~17, S4 p~19
Matrix3Xd free_rotation(const Vector3d& I, const Vector3d& omega0, const VectorXd& times);

}  // namespace rigid
