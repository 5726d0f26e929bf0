#pragma once

#include "rigid/rotating_frames.hpp"
#include "solutions/judging/judging.hpp"

inline constexpr double our_earth_rate = 7.292115e-5;  // rad/s, against the stars
inline constexpr double our_sidereal_day = 86164.0905;
inline constexpr Sort earth_rate = positive(rad_per_s);

// The vectors of the running example.
inline const Vector3d example_a(0.1, 0.2, 0.3), example_v(0.4, -0.3, 0.6), example_r(1, 2, -1),
    example_alpha(0.05, 0.1, -0.04);

/// A latitude of either hemisphere, away from the equator, from 45° and from the poles.
inline double generic_latitude(Random& random) {
  const double latitude = random.whole(0, 1) == 0 ? random.uniform(0.2, 0.6) : random.uniform(0.95, 1.35);
  return random.sign() * latitude;
}

inline constexpr const char* brackets = "rotating_frames_brackets";
