#pragma once

#include "rigid/free_tops.hpp"
#include "solutions/judging/exact_top.hpp"
#include "solutions/judging/judging.hpp"

inline constexpr const char* space_notes = "free_tops_space";
inline constexpr const char* stability_notes = "free_tops_stability";

/// Moments I1 = I2 and I3 of a real body, flattened or long, away from the sphere and from the flat plate.
inline tuple<double, double> symmetric_moments(Random& random) {
  const double I1 = random.uniform(0.5, 3);
  const double ratio = random.sign() > 0 ? random.uniform(1.2, 1.8) : random.uniform(0.25, 0.8);
  return {I1, ratio * I1};
}

/// The lecture's top: I1 = 1, I3 = 1.8, amplitude 0.4, phase 0.3, ω3 = 2.
inline const Vector3d lecture_omega(0.4 * cos(0.3), 0.4 * sin(0.3), 2);

/// L of a symmetric top.
inline Vector3d L_of(double I1, double I3, const Vector3d& w) { return {I1 * w[0], I1 * w[1], I3 * w[2]}; }

/// The axis in question becomes axis 3.
inline Vector3d turned_round(const Vector3d& I, int axis) { return {I[(axis + 1) % 3], I[(axis + 2) % 3], I[axis]}; }

/// The frequency of a small wobble about an axis; the growth rate of a disturbance where it is unstable.
inline double wobble_about(const Vector3d& I, double spin, int axis) {
  return sqrt(abs(linearized_rates(turned_round(I, axis), spin).prod()));
}

/// A time that belongs to a rate; 0 where there is none.
inline double over(double numerator, double rate) { return rate == 0 ? 0.0 : numerator / rate; }
