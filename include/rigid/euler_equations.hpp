/// @file
/// Contract of lecture 05: the rate of angular momentum, Euler's equations and the free rotation that follows from
/// them.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// Euler's equations, solved for the angular acceleration.
///
/// <!-- I₁ ω̇₁ + ω₂ ω₃ (I₃ - I₂) = τ₁ and cyclically -->
/// \f[ I_1 \dot{\tilde\omega}_1 + \tilde\omega_2 \tilde\omega_3 (I_3 - I_2) = \tau_1 \quad\text{and cyclically} \f]
///
/// @param I       principal moments about the fixed point or the centre of mass, in any order, kg m²
/// @param omega   angular velocity, components on the principal axes, rad/s
/// @param torque  torque about the same point, components on the principal axes, N m
/// @return        rates of change of the components of omega, rad/s²
/// @pre each moment > 0
/// @par Source
/// S0 s19–20, S1 s7–8, S2 s17–18, S3 p. 16–17, S4 p. 18–19
Vector3d euler_equations(const Vector3d& I, const Vector3d& omega, const Vector3d& torque);

/// Euler's equations on any axes fixed in the body, principal or not.
///
/// <!-- I · ω̇ + ω × (I · ω) = τ -->
/// \f[ \Inertia \cdot \dot{\vec\omega} + \vec\omega \times (\Inertia \cdot \vec\omega) = \vec\tau \f]
///
/// @param I       inertia tensor about the fixed point or the centre of mass, on body axes, kg m²
/// @param omega   angular velocity on the same axes, rad/s
/// @param torque  torque about the same point on the same axes, N m
/// @return        angular acceleration on the same axes, rad/s²; it is the same vector in the inertial frame
/// @pre I is an inertia tensor and positive definite: a body on one straight line is excluded
/// @par Source
/// the torque equation of S0 s19, S1 s7, S2 s17, S3 p. 16, S4 p. 18, before the choice of axes
Vector3d euler_equations_general(const Matrix3d& I, const Vector3d& omega, const Vector3d& torque);

/// The torque that must act on a body for its angular velocity to stay as it is.
///
/// <!-- τ = ω × (I · ω) -->
/// \f[ \vec\tau = \vec\omega \times (\Inertia \cdot \vec\omega) \f]
///
/// It is at right angles to omega, so it does no work, and it rotates with the body.
///
/// @param I      inertia tensor on axes fixed in the body, kg m²
/// @param omega  angular velocity on the same axes, constant, rad/s
/// @return       torque on the body, same axes, N m; zero when omega lies along a principal axis
/// @pre I is an inertia tensor and positive definite: a body on one straight line is excluded
/// @par Source
/// S0 s19, S1 s7, S2 s17, S3 p. 16, S4 p. 18 with \f$\dot{\vec\omega} = 0\f$
Vector3d torque_to_hold_rotation(const Matrix3d& I, const Vector3d& omega);

/// The rate of change of the angular momentum in the inertial frame.
///
/// <!-- (dL/dt)_inertial = I · ω̇ + ω × (I · ω) -->
/// \f[ \ratein{\vec L}{\inertialframe} = \Inertia \cdot \dot{\vec\omega}
///     + \vec\omega \times (\Inertia \cdot \vec\omega) \f]
///
/// @param I           inertia tensor on axes fixed in the body, kg m²
/// @param omega       angular velocity on these axes, rad/s
/// @param omega_rate  rates of change of the components of omega, rad/s²
/// @return            the vector dL/dt as seen from the inertial frame, its components taken on the body axes, N m
/// @pre I is an inertia tensor and positive definite: a body on one straight line is excluded
/// @par Source
/// S0 s17–18, S1 s6, S2 s16, S3 p. 15, S4 p. 17
Vector3d angular_momentum_rate(const Matrix3d& I, const Vector3d& omega, const Vector3d& omega_rate);

/// What a free rotation conserves: the kinetic energy and the square of the angular momentum.
///
/// <!-- T = ½ Σ_i I_i ω_i², L² = Σ_i I_i² ω_i² -->
/// \f[ T = \tfrac12 \sum_i I_i\, \tilde\omega_i^2, \qquad L^2 = \sum_i I_i^2\, \tilde\omega_i^2 \f]
///
/// @param I      principal moments, kg m²
/// @param omega  angular velocity, components on the principal axes, rad/s
/// @return       {T in J, L² in (kg m²/s)²}
/// @pre each moment > 0
/// @par Source
/// S0 s17, S1 s4 and s6, S2 s16, S3 p. 14, S4 p. 16
Vector2d rotation_invariants(const Vector3d& I, const Vector3d& omega);

/// The angular velocity of a symmetric satellite while a thruster acts about its axis.
///
/// <!-- ω₃ = ω₃(0) + τ t / I₃, α = (I₃ - I₁)/I₁ ∫₀ᵗ ω₃ dt' -->
/// \f[ \tilde\omega_3 = \tilde\omega_3(0) + \frac{\tau t}{I_3}, \qquad
///     \alpha = \frac{I_3 - I_1}{I_1} \int_0^t \tilde\omega_3\,\dd t' , \f]
///
/// and \f$(\tilde\omega_1, \tilde\omega_2)\f$ has turned through the angle α since t = 0, positive from axis 1 towards
/// axis 2. Axis 3 is that of the satellite. The torque is constant on the axes of the body.
///
/// @param I1      moment about axes 1 and 2, kg m²
/// @param I3      moment about axis 3, kg m²
/// @param omega0  angular velocity at t = 0, body components, rad/s
/// @param torque  component of the torque about axis 3, N m; the others are zero. Negative: it brakes
/// @param t       time, s; negative times lie before t = 0, the thruster acting
/// @return        angular velocity at time t, body components, rad/s
/// @pre I1 > 0 and I3 > 0
/// @par Source
/// S0 s20, S1 s8, S2 s18, S3 p. 17, S4 p. 19 with this torque
Vector3d spin_up(double I1, double I3, const Vector3d& omega0, double torque, double t);

/// The angular velocity of a body on which no torque acts, as time goes by.
///
/// Integrates Euler's equations with \f$\vec\tau = 0\f$ from omega0 at t = 0 to each of the given times. The times are
/// moments, not steps: choose the steps of the integration by yourself.
///
/// @param I       principal moments in any order, kg m²
/// @param omega0  angular velocity at t = 0, components on the principal axes, rad/s
/// @param times   moments at which it is asked for, s: in any order, negative, zero or repeated, perhaps none
/// @return        3×n, rad/s: column k holds the components on the principal axes at times[k]
/// @pre each moment > 0
/// @par Source
/// S0 s20, S1 s7–8, S2 s18, S3 p. 17, S4 p. 19
Matrix3Xd free_rotation(const Vector3d& I, const Vector3d& omega0, const VectorXd& times);

/// Where a free body is: its attitude at time t.
///
/// At t = 0 the principal axes of the body coincide with the axes of an inertial frame; from then on no torque acts.
/// The angular momentum stands still in the inertial frame, whatever the body does: a test that needs no answer.
///
/// @param I       principal moments, kg m²
/// @param omega0  angular velocity at t = 0, rad/s
/// @param t       time, s; negative times lie before t = 0
/// @return        the matrix whose columns are the principal axes at time t, in inertial components
/// @pre moments of a real body in any order: each > 0, none larger than the sum of the two others; equal ones are legal
/// @pre |omega0| ≤ 2 rad/s and |t| ≤ 30 s: a rule of fourth order with steps of 0.01 s is good to a millionth
/// @par Source
/// not on the slides; L. D. Landau and E. M. Lifshitz, Mechanics, §37
Matrix3d free_attitude(const Vector3d& I, const Vector3d& omega0, double t);

/// How a satellite has turned when its two wheels have gone through a path.
///
/// The satellite is free and at rest, its body axes are the inertial ones, and its wheels stand still: no angular
/// momentum at all. Then motors turn the wheels against the body, one about body axis 1 and the other about body axis
/// 2. From each corner of the path to the next both run at once, so that their angles keep a fixed proportion. How fast
/// they run makes no difference. A cat that is dropped upside down does the same with the two halves of its body.
///
/// @param I       inertia tensor of the whole satellite about its centre of mass, its wheels included, body axes, kg m²
/// @param J       moments of the two wheels about their axes, kg m²
/// @param wheel1  angle of the first wheel against the body at each corner of the path, rad, positive about axis 1
/// @param wheel2  likewise of the second wheel, about axis 2; as many
/// @return        the matrix whose columns are the body axes at the last corner, in inertial components
/// @pre I is an inertia tensor; without J it is still positive definite; J > 0
/// @pre at least one corner; none of the wheels alone would turn the body by more than 8 rad on the whole path
/// @par Source
/// not on the slides; R. Montgomery, Gauge theory of the falling cat, 1993
Matrix3d reorientation(const Matrix3d& I, const Vector2d& J, const VectorXd& wheel1, const VectorXd& wheel2);

/// One step of an integrator of free rotation that is put together from exact motions.
///
/// The kinetic energy of a free body, as a function of the body components of L, is a sum of three terms, each with one
/// component only. If the energy were one of the terms alone, the motion of L on the body axes could be written down
/// exactly. Let L move according to
///
/// 1. the first term alone, for the time h/2,
/// 2. the second term alone, for h/2,
/// 3. the third term alone, for h,
/// 4. the second term alone, for h/2,
/// 5. the first term alone, for h/2,
///
/// each stage starting where the one before it ended.
///
/// @param I      principal moments, kg m²
/// @param omega  angular velocity at the start, components on the principal axes, rad/s
/// @param h      the step, s; may be negative or zero
/// @return       angular velocity after the five stages, components on the principal axes, rad/s
/// @pre each moment > 0, in any order
/// @par Source
/// not on the slides; R. I. McLachlan 1993; J. Touma and J. Wisdom 1994; E. Hairer, C. Lubich and G. Wanner, Geometric
/// Numerical Integration, section VII.5
Vector3d splitting_step(const Vector3d& I, const Vector3d& omega, double h);

/// Where a ball is that rolls on a turntable.
///
/// A ball rolls without slipping on a level turntable that rotates at a constant rate about its middle, the origin. Its
/// mass is distributed alike in all directions. Position and velocity are those for somebody who stands beside the
/// table, on fixed axes; the table rotates anticlockwise if its rate is positive. On a table at rest the ball goes on
/// straight ahead.
///
/// @param k           I/(M a²): moment of the ball about its centre by its mass and the square of its radius
/// @param table_rate  angular velocity of the table, rad/s, of either sign or zero
/// @param start       where the ball is at t = 0, m
/// @param velocity    of its centre at t = 0, m/s; its spin is then such that it rolls
/// @param t           time, s; negative times lie before t = 0
/// @return            position at time t, m
/// @pre 0 < k ≤ 2/3 as for every ball: 2/5 for a solid one, 2/3 for a thin shell
/// @pre |table_rate t| ≤ 60 rad; the table is large enough
/// @par Source
/// not on the slides; E. J. Routh, Advanced Rigid Dynamics; D. Morin, Introduction to Classical Mechanics, chapter 9
Vector2d ball_on_turntable(double k, double table_rate, const Vector2d& start, const Vector2d& velocity, double t);

/// The forces with which two bearings hold an unbalanced rotor.
///
/// The rotor turns about the z axis of its body axes at a constant rate; the origin lies on the shaft. The two bearings
/// hold the shaft at two places, and neither takes a force along it. The forces that carry the weight are left out.
///
/// @param I_cm      inertia tensor about the centre of mass, on the body axes, kg m²
/// @param M         mass, kg
/// @param r_cm      centre of mass, body axes, m
/// @param rate      angular velocity about the z axis, rad/s, of either sign
/// @param bearings  z of the first and of the second bearing, m
/// @return          3×2, N: column k is the force of bearing k on the shaft, components on the body axes
/// @pre I_cm is an inertia tensor, M > 0
/// @pre the bearings are at different places; the centre of mass need not lie between them
/// @par Source
/// not on the slides; the torque is that of S0 s19, S1 s7 with \f$\dot{\vec\omega} = 0\f$
Matrix3Xd bearing_forces(const Matrix3d& I_cm, double M, const Vector3d& r_cm, double rate, const Vector2d& bearings);

/// The torque that a turning vehicle exerts on a rotor in it.
///
/// The rotor is symmetric. Its axis is mounted along axis 3 of the vehicle, and it rotates about it at a constant rate
/// relative to the vehicle. The vehicle itself rotates with a constant angular velocity: an aeroplane in a steady turn,
/// a ship that pitches, a platform with a wheel.
///
/// @param I1    moment of the rotor about each axis through its centre of mass across its axis, kg m²
/// @param I3    moment of the rotor about its axis, kg m²
/// @param spin  rate of the rotor relative to the vehicle, rad/s, positive about axis 3
/// @param turn  angular velocity of the vehicle in the inertial frame, components on the vehicle's axes, rad/s
/// @return      torque of the vehicle on the rotor about the rotor's centre of mass, vehicle's axes, N m
/// @pre I1 > 0 and I3 > 0; spin and turn may be zero and of either sign
/// @par Source
/// not on the slides; D. Kleppner and R. Kolenkow, An Introduction to Mechanics, chapter 7
Vector3d gyroscopic_torque(double I1, double I3, double spin, const Vector3d& turn);

/// Period of a gyrocompass about the direction in which it settles.
///
/// The axle of a symmetric rotor is kept level, and may turn freely about the vertical; no torque acts along the axle.
/// The ground rotates: the Earth, or a turntable for a demonstration. In some directions the axle can rest relative to
/// the ground; about the one that is stable it swings. Asked for is the period of small swings, without friction.
/// Towards a pole of the Earth it grows beyond all bounds.
///
/// @param I1           moment of the rotor about each axis through its centre of mass across its axle, kg m²
/// @param I3           moment of the rotor about its axle, kg m²
/// @param spin         rate of the rotor about its axle relative to its housing, rad/s, of either sign
/// @param latitude     angle of the axis of the ground's rotation with the level plane, rad
/// @param ground_rate  angular velocity of the ground, rad/s: 7.292115e-5 on the Earth, some rad/s on a turntable
/// @return             period of small swings, s; the moment of the housing is left out
/// @pre 0 < I3 ≤ 2 I1 as for every rotor, ground_rate > 0
/// @pre |latitude| ≤ 1.5 (at a pole every direction is alike)
/// @pre I3 |spin| > I1 ground_rate: only one direction is stable
/// @par Source
/// not on the slides; H. Goldstein, Classical Mechanics, chapter 5; L. Foucault 1852
double gyrocompass_period(double I1, double I3, double spin, double latitude, double ground_rate);

}  // namespace rigid
