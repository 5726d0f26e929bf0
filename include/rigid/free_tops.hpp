/// @file
/// Contract of lecture 06: bodies that rotate free of torque, the symmetric top, the asymmetric top and its unstable
/// axis.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// The rate at which a free symmetric top's angular velocity runs round the symmetry axis, seen from the body.
///
/// <!-- Ω = ω₃ (I₃ - I₁) / I₁ -->
/// \f[ \Omega = \tilde\omega_3\, \frac{I_3 - I_1}{I_1} \f]
///
/// The rate has a sign: positive means from axis 1 towards axis 2.
///
/// @param I1      moment about each of the two equal axes (\f$I_2 = I_1\f$), kg m²
/// @param I3      moment about the symmetry axis, kg m²
/// @param omega3  body component of the angular velocity along the symmetry axis, rad/s, of either sign
/// @return        Ω of the slides, rad/s; zero for a sphere
/// @pre I1 > 0 and I3 > 0: a thin rod, I3 = 0, is excluded; a sphere, I3 = I1, is legal
/// @par Source
/// S0 s20, S1 s8, S2 s18, S3 p. 17, S4 p. 19
double body_precession_rate(double I1, double I3, double omega3);

/// The angular velocity of a free symmetric top, in body components, at time t.
///
/// <!-- ω₁ = ω_⊥ cos(Ωt + δ), ω₂ = ω_⊥ sin(Ωt + δ), ω₃ constant -->
/// \f[ \tilde\omega_1 = \omega_\perp \cos(\Omega t + \delta), \qquad
///     \tilde\omega_2 = \omega_\perp \sin(\Omega t + \delta), \qquad \tilde\omega_3 = \text{const} \f]
///
/// ω⊥ and δ follow from omega0; the slides call them A and φ.
///
/// @param I1      moment about each of the two equal axes, kg m²
/// @param I3      moment about the symmetry axis (axis 3), kg m²
/// @param omega0  angular velocity at time 0, body components, rad/s
/// @param t       time, s; may be negative
/// @return        angular velocity at time t, body components, rad/s
/// @pre I1 > 0 and I3 > 0: a thin rod, I3 = 0, is excluded; a sphere, I3 = I1, is legal
/// @par Source
/// S0 s20–21, S1 s8–9, S2 s18–19, S3 p. 17–18, S4 p. 19–20
Vector3d symmetric_top(double I1, double I3, const Vector3d& omega0, double t);

/// The rate at which the symmetry axis of a free symmetric top runs round the angular momentum, seen from the inertial
/// frame.
///
/// <!-- φ̇ = L / I₁, L = |I₁ ω₁ e₁ + I₁ ω₂ e₂ + I₃ ω₃ e₃| -->
/// \f[ \dot\phi = \frac{L}{I_1}, \qquad L = \left| I_1 \tilde\omega_1 \unit e_1 + I_1 \tilde\omega_2 \unit e_2
///     + I_3 \tilde\omega_3 \unit e_3 \right| \f]
///
/// The rotation is right-handed about L, so the rate is never negative.
///
/// @param I1     moment about each of the two equal axes, kg m²
/// @param I3     moment about the symmetry axis, kg m²
/// @param omega  angular velocity at any one time, body components, rad/s
/// @return       rate of precession about the angular momentum, rad/s
/// @pre I1 > 0 and I3 > 0: a thin rod, I3 = 0, is excluded; a sphere, I3 = I1, is legal
/// @par Source
/// not on the slides; follows from L of S0 s21, S1 s9, S2 s19
double space_precession_rate(double I1, double I3, const Vector3d& omega);

/// The two rates that govern a small wobble of an asymmetric top about axis 3.
///
/// <!-- Ω₁ = ω₃ (I₃ - I₂)/I₁, Ω₂ = ω₃ (I₃ - I₁)/I₂ -->
/// \f[ \Omega_1 = \tilde\omega_3\, \frac{I_3 - I_2}{I_1}, \qquad \Omega_2 = \tilde\omega_3\, \frac{I_3 - I_1}{I_2} \f]
///
/// With them \f$\dot{\tilde\omega}_1 = -\Omega_1 \tilde\omega_2\f$ and
/// \f$\dot{\tilde\omega}_2 = \Omega_2 \tilde\omega_1\f$. The subscript names the denominator.
///
/// @param I       principal moments in any order, kg m²
/// @param omega3  spin about axis 3, rad/s, of either sign
/// @return        {Ω1, Ω2}, rad/s
/// @pre each moment > 0; equal moments are legal
/// @par Source
/// S0 s22, S1 s10–11, S2 s20–22, S3 p. 19–21, S4 p. 21–23
Vector2d linearized_rates(const Vector3d& I, double omega3);

/// The small wobble of an asymmetric top that spins about a stable axis 3.
///
/// <!-- ω₁ = ω_⊥ cos(√(Ω₁Ω₂) t + δ), ω₂ = sgn(Ω₁) ω_⊥ √(Ω₂/Ω₁) sin(√(Ω₁Ω₂) t + δ) -->
/// \f[ \tilde\omega_1 = \omega_\perp \cos(\sqrt{\Omega_1 \Omega_2}\, t + \delta), \qquad
///     \tilde\omega_2 = \operatorname{sgn}(\Omega_1)\, \omega_\perp \sqrt{\Omega_2 / \Omega_1}\,
///     \sin(\sqrt{\Omega_1 \Omega_2}\, t + \delta) \f]
///
/// The factor sgn(Ω1) is missing on the slides; the root of the product is the positive one.
///
/// @param I          principal moments, kg m²; I₃ is the largest or the smallest
/// @param omega3     spin about axis 3, rad/s, of either sign
/// @param amplitude  ω⊥, rad/s, of either sign: its size is the largest one of the first component; A on the slides
/// @param phase      δ, rad; at time 0 the first component is ω⊥ cos δ; φ on the slides
/// @param t          time, s; may be negative
/// @return           the first two body components of the angular velocity at time t, rad/s
/// @pre each moment > 0
/// @pre Ω1 Ω2 > 0: omega3 ≠ 0, and I₃ is larger than both other moments or smaller than both; these two may be equal
/// @par Source
/// S1 s11, S2 s22, S3 p. 21, S4 p. 23, with the sign corrected
Vector2d linearized_top(const Vector3d& I, double omega3, double amplitude, double phase, double t);

/// The rate at which a small disturbance of a spin about the intermediate axis grows.
///
/// <!-- σ = |ω₂| √((I₂ - I₁)(I₃ - I₂) / (I₁I₃)) -->
/// \f[ \sigma = |\tilde\omega_2| \sqrt{\frac{(I_2 - I_1)(I_3 - I_2)}{I_1 I_3}} \f]
///
/// The disturbance grows as \f$e^{\sigma t}\f$ as long as it is small.
///
/// @param I_ascending  principal moments in ascending order, kg m²
/// @param omega2       spin about the intermediate axis 2, rad/s, of either sign
/// @return             growth rate, 1/s, never negative; zero if I₂ equals another moment
/// @pre 0 < I₁ ≤ I₂ ≤ I₃; equal moments are legal
/// @par Source
/// not on the slides; follows from "opposite signs: unstable" of S1 s11, S2 s22, S3 p. 21, S4 p. 23
double growth_rate(const Vector3d& I_ascending, double omega2);

/// Whether a free spin about a principal axis is stable.
///
/// Stable about the axis of the largest and of the smallest moment, unstable about the intermediate one. An axis whose
/// moment equals another one is neutral, as every axis of a sphere is: a disturbance does not grow exponentially, but
/// nothing restores it either. The symmetry axis of a symmetric top is stable.
///
/// @param I     principal moments in any order, kg m²
/// @param axis  0, 1 or 2: the axis of I[axis]
/// @return      +1 stable, −1 unstable, 0 neutral
/// @pre each moment > 0
/// @pre axis is 0, 1 or 2
/// @par Source
/// the signs of Ω1 and Ω2 on S1 s11, S2 s22, S3 p. 21, S4 p. 23
int axis_stability(const Vector3d& I, int axis);

/// The time after which the angular velocity of a free top repeats itself in the body: exact, for any amplitude.
///
/// <!-- P = 4 K(m) / ν, K(m) = ∫ dα / √(1 - m sin²α) from 0 to π/2 -->
/// \f[ P = \frac{4 K(m)}{\nu}, \qquad K(m) = \int_0^{\pi/2} \frac{\dd\alpha}{\sqrt{1 - m \sin^2\alpha}} \f]
///
/// where, with the kinetic energy T and the angular momentum L, for \f$L^2 > 2TI_2\f$ (the angular velocity circles
/// axis 3)
///
/// <!-- ν² = (L² - 2TI₁)(I₃ - I₂) / (I₁I₂I₃), m = k² = (2TI₃ - L²)(I₂ - I₁) / ((L² - 2TI₁)(I₃ - I₂)) -->
/// \f[ \nu^2 = \frac{(L^2 - 2TI_1)(I_3 - I_2)}{I_1 I_2 I_3}, \qquad
///     m = k^2 = \frac{(2TI_3 - L^2)(I_2 - I_1)}{(L^2 - 2TI_1)(I_3 - I_2)} \f]
///
/// and for \f$L^2 < 2TI_2\f$ (it circles axis 1) the same with the subscripts 1 and 3 exchanged. For a spin about axis
/// 1 or 3 alone the formula gives the period of an infinitely small wobble. Between the two kinds of motion, at \f$L^2
/// = 2TI_2\f$, there is no period.
///
/// @param I       principal moments in ascending order, kg m²
/// @param omega0  angular velocity at any one time, body components, rad/s
/// @return        the full period P, s
/// @pre 0 < I₁ ≤ I₂ ≤ I₃, not all equal; a symmetric top is legal
/// @pre \f$L^2 \ne 2TI_2\f$: 1 − m > 10⁻⁹, which excludes rest and a spin about axis 2 alone
/// @par Source
/// not on the slides; the exact solution behind the approximation of S0 s22, S1 s10–11, S2 s20–22
double tumbling_period(const Vector3d& I, const Vector3d& omega0);

/// How large the three components of ω become while a free body tumbles.
///
/// @param I       principal moments in ascending order, kg m²
/// @param omega0  angular velocity at any one time, body components, rad/s
/// @return        the largest absolute values that the three components reach in the course of the motion, rad/s
/// @pre 0 < I₁ ≤ I₂ ≤ I₃ and I₁ < I₃; if two moments are equal, the components on their axes share their largest value
/// @pre \f$|L^2 - 2TI_2| \ge 10^{-3}L^2\f$ and omega0 ≠ 0; a spin about axis 1 or axis 3 alone is legal
/// @par Source
/// not on the slides; L. D. Landau and E. M. Lifshitz, Mechanics, §37
Vector3d largest_rates(const Vector3d& I, const Vector3d& omega0);

/// How a satellite with flexible aerials ends up.
///
/// The satellite is free. Its aerials are light, but they bend to and fro with the wobble and turn energy of rotation
/// into heat, until nothing changes any more.
///
/// @param I      principal moments, kg m²
/// @param omega  angular velocity at the start, body components, rad/s
/// @return       {heat that is produced in all, J; rate of rotation in the end, rad/s}
/// @pre moments of a real body in any order: each > 0, none larger than the sum of the two others; equal ones are legal
/// @pre any omega: zero is legal; exactly along the axis of an unstable spin the limit of a slight disturbance is meant
/// @par Source
/// not on the slides; R. N. Bracewell and O. K. Garriott, Nature 182 (1958) 760
Vector2d flat_spin(const Vector3d& I, const Vector3d& omega);

/// The motion that turns a body over once, and takes for ever.
///
/// In the infinite past a free body spun about its intermediate axis at the rate −spin. An infinitely small disturbance
/// turns it over, and in the infinite future it spins about the same axis at the rate +spin. At t = 0 it is half way;
/// there the components of ω on the axes 1 and 3 are positive.
///
/// @param I     principal moments in ascending order, kg m²
/// @param spin  the rate in the end, rad/s
/// @param t     time, s; of either sign and any size
/// @return      angular velocity at time t, body components, rad/s
/// @pre 0 < I₁ < I₂ < I₃, neighbours at least a thousandth of I₃ apart; spin > 0
/// @par Source
/// not on the slides; L. D. Landau and E. M. Lifshitz, Mechanics, §37; M. S. Ashbaugh, C. C. Chicone and R. H. Cushman
/// 1991
Vector3d separatrix(const Vector3d& I, double spin, double t);

/// When a body that was thrown about its intermediate axis turns over for the first time.
///
/// @param I       principal moments in ascending order, kg m²
/// @param omega0  angular velocity at t = 0, body components, rad/s
/// @return        the first time after t = 0 at which the second component of ω vanishes, s, to eight digits
/// @pre 0 < I₁ < I₂ < I₃, neighbours at least 5 % of I₃ apart
/// @pre omega0[1] ≠ 0, and omega0[0] and omega0[2] are not both zero; signs are arbitrary
/// @pre \f$|L^2 - 2TI_2| \ge 10^{-5}L^2\f$: closer to the separatrix the time depends on digits that omega0 has lost
/// @par Source
/// not on the slides; L. D. Landau and E. M. Lifshitz, Mechanics, §37
double first_flip(const Vector3d& I, const Vector3d& omega0);

}  // namespace rigid
