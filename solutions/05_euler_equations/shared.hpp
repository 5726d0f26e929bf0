#pragma once

#include "rigid/euler_equations.hpp"
#include "solutions/judging/exact_top.hpp"
#include "solutions/judging/judging.hpp"

inline const Vector3d example_moments(1, 2, 3), example_torque(0.2, -0.1, 0.3);
inline const Matrix3d tensor_of_example = example_moments.asDiagonal(), tensor_of_sphere = 2 * Matrix3d::Identity();

// One mistake, one sentence: these serve several exercises.
inline constexpr const char* rate_notes = "euler_equations_rate";
inline constexpr const char* gyration_sign =
    "The sign of ω × (Iω) is wrong: it has + beside I dω/dt, and so − on the side of the torque.";
inline constexpr const char* gyration_missing =
    "This solves I dω/dt = τ; the term ω × (Iω), which the turning of the body's axes adds, is missing.";
inline constexpr const char* torque_missing =
    "The torque does not enter your rates; it drives them: I dω/dt = τ − ω × (Iω).";
inline constexpr const char* torque_sign = "The sign of the torque is wrong: I dω/dt = τ − ω × (Iω).";
inline constexpr const char* inertia_not_divided =
    "This is τ − ω × (Iω), the rate of L seen from the body; it is still to be divided by the inertia.";
inline constexpr const char* products_missing =
    "The products of inertia do not enter: this comes out as if these were principal axes.";
inline constexpr const char* products_sign =
    "The products of inertia enter with the opposite sign; the tensor already carries their minus.";
inline constexpr const char* indices_shifted =
    "The differences of moments are shifted by one place: I₃ − I₂ goes with ω₂ω₃, which has its indices.";

/// ω × L as a difference of two products: (ω₂L₃, ω₃L₁, ω₁L₂) less (ω₃L₂, ω₁L₃, ω₂L₁).
inline Vector3d first_products(const Vector3d& w, const Vector3d& L) { return {w[1] * L[2], w[2] * L[0], w[0] * L[1]}; }
inline Vector3d second_products(const Vector3d& w, const Vector3d& L) {
  return {w[2] * L[1], w[0] * L[2], w[1] * L[0]};
}

/// The components moved on by one place: (a₂, a₃, a₁).
inline Vector3d shifted(const Vector3d& a) { return {a[1], a[2], a[0]}; }

/// The differences of moments and the products of ω, as the slides write ω × L on principal axes.
inline Vector3d differences(const Vector3d& I) { return {I[2] - I[1], I[0] - I[2], I[1] - I[0]}; }
inline Vector3d products(const Vector3d& w) { return {w[1] * w[2], w[2] * w[0], w[0] * w[1]}; }
