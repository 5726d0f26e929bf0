#pragma once

#include "lectures/11_measured/throws.hpp"
#include "rigid/measured.hpp"
#include "solutions/judging/exact_top.hpp"
#include "solutions/judging/judging.hpp"

/// Every seventh sample of a thrown racket: times in s, ω in rad/s.
inline const VectorXd racket_times{{0.01, 0.08, 0.15, 0.22, 0.29, 0.36, 0.43, 0.50, 0.57, 0.64, 0.71, 0.78, 0.85}};
inline const Matrix3Xd racket_rates{
    {16.2, 8.5, -8.3, -15.3, -16.0, -14.2, -4.9, 9.4, 14.3, 14.8, 13.7, 8.1, -4.1},
    {-7.6, -15.3, -14.9, -7.3, -5.3, -8.7, -15.3, -12.6, -6.3, -4.4, -6.8, -12.4, -13.8},
    {-4.7, -13.2, -13.1, -5.1, 0.4, 6.4, 13.8, 11.4, 4.5, 0.0, -4.5, -10.7, -12.2}};

/// Of the twelve measured throws, whose samples no case holds: what a function that passes is shown on.
inline const std::vector<measured::Flight> throws = measured::racket_throws();
inline const measured::Flight& throw_3 = throws.at(2);

/// The errors that the noise of the samples gives its coefficients.
inline Vector3d errors_of_throw_3() { return measured::changes_by_noise(throw_3).rowwise().norm(); }

/// The samples of a flight of a body, at uneven times and with the noise of a gyroscope.
inline auto noisy_flight(int fewest, int most) {
  return [=](Random& random) {
    const ExactTop top(random.principal_moments(), random.vector(5));
    const int count = random.whole(fewest, most);
    VectorXd times(count);
    Matrix3Xd rates(3, count);
    double now = random.uniform(-1, 1);
    const double start = now;
    for (int k = 0; k < count; ++k) {
      times[k] = now;
      rates.col(k) = top.omega(now - start);
      for (int axis = 0; axis < 3; ++axis) rates(axis, k) += random.uniform(-0.1, 0.1);
      now += random.uniform(0.03, 0.15);
    }
    return tuple(times, rates);
  };
}

inline bool ascends(const VectorXd& t) {
  for (Eigen::Index k = 1; k < t.size(); ++k)
    if (t[k] <= t[k - 1]) return false;
  return true;
}
