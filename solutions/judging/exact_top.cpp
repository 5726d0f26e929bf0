#include "solutions/judging/exact_top.hpp"

#include <boost/math/special_functions/ellint_rf.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace workbook::judging {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

double square(double x) { return x * x; }

double sign(double x) { return x < 0 ? -1.0 : 1.0; }

/// K, the quarter period of the elliptic functions.
double quarter_period(double complement) { return boost::math::ellint_rf(0.0, complement, 1.0); }

/// ω stays as it is when L = Iω is parallel to it. On principal axes that needs no tolerance: two axes between which
/// ω has a share must have the same moment.
bool rotates_steadily(const Vector3d& moments, const Vector3d& omega) {
  const auto parallel = [&](int i, int j) { return omega[i] == 0 || omega[j] == 0 || moments[i] == moments[j]; };
  return parallel(0, 1) && parallel(1, 2) && parallel(2, 0);
}

}  // namespace

double jacobi_amplitude(double u, double complementary_parameter) {
  if (complementary_parameter == 0)
    return 2 * std::atan(std::tanh(u / 2));  // the Gudermannian: the mean below would be 0
  // Gauss's arithmetic-geometric mean (Abramowitz and Stegun 16.4). Boost has these functions too, but takes the
  // modulus k, and next to the separatrix 1 − k² has lost the digits that decide when the body turns over.
  constexpr int most = 60;
  std::array<double, most> eccentricity{};  // cₙ/aₙ
  double arithmetic = 1.0;
  double geometric = std::sqrt(complementary_parameter);
  int steps = 0;
  while (steps < most && std::abs(arithmetic - geometric) > std::numeric_limits<double>::epsilon() * arithmetic) {
    eccentricity[steps++] = (arithmetic - geometric) / (arithmetic + geometric);
    const double mean = (arithmetic + geometric) / 2;
    geometric = std::sqrt(arithmetic * geometric);
    arithmetic = mean;
  }
  double amplitude = std::ldexp(arithmetic * u, steps);
  while (steps > 0) amplitude = (amplitude + std::asin(eccentricity[--steps] * std::sin(amplitude))) / 2;
  return amplitude;
}

ExactTop::ExactTop(const Vector3d& I, const Vector3d& omega0) : omega0_(omega0), steady_(rotates_steadily(I, omega0)) {
  if (steady_) return;

  // Name the axes: b in the middle, c the one that L circles.
  std::array<int, 3> ascending = {0, 1, 2};
  std::sort(ascending.begin(), ascending.end(), [&](int i, int j) { return I[i] < I[j]; });
  const auto [smallest, middle, largest] = ascending;
  const double excess = I[largest] * (I[largest] - I[middle]) * square(omega0[largest]) -
                        I[smallest] * (I[middle] - I[smallest]) * square(omega0[smallest]);  // L² − 2T I_b
  b_ = middle;
  c_ = excess >= 0 ? largest : smallest;
  a_ = excess >= 0 ? smallest : largest;

  // The amplitudes. Every difference of moments is taken together with another of the same sign.
  const double Ia = I[a_], Ib = I[b_], Ic = I[c_];
  const double wa = omega0[a_], wb = omega0[b_], wc = omega0[c_];
  const double ratio = Ib * (Ic - Ib) / (Ia * (Ic - Ia));
  const double A = std::sqrt(square(wa) + ratio * square(wb));
  const double B = std::sqrt(square(wb) + square(wa) / ratio);
  const double C = std::sqrt(square(wc) + Ib * (Ib - Ia) / (Ic * (Ic - Ia)) * square(wb));
  rate_ = C * std::sqrt((Ic - Ia) * (Ic - Ib) / (Ia * Ib));
  complement_ = std::min(1.0, excess / (square(C) * Ic * (Ic - Ib)));

  const double parity = (b_ - a_ + 3) % 3 == 1 ? 1.0 : -1.0;
  const double alpha = sign(wa), gamma = sign(wc);
  const double beta = parity * sign(Ic - Ib) * alpha * gamma;
  amplitude_ = Vector3d(alpha * A, beta * B, gamma * C);

  // The phase, in Carlson's form of the integral of the first kind: from cn, sn and dn rather than from an angle.
  // The sign α keeps cn u₀ ≥ 0, so that u₀ lies within a quarter period of 0.
  start_ = beta * wb / B * boost::math::ellint_rf(square(wa / A), square(wc / C), 1.0);
}

Vector3d ExactTop::omega(double t) const {
  if (steady_) return omega0_;
  const double u = rate_ * t + start_;
  double sn, cn, dn;
  if (complement_ == 0) {
    sn = std::tanh(u);
    cn = dn = 1 / std::cosh(u);
  } else {
    const double angle = jacobi_amplitude(u, complement_);
    sn = std::sin(angle);
    cn = std::cos(angle);
    dn = std::sqrt(complement_ + (1 - complement_) * square(cn));  // both summands positive
  }
  Vector3d result;
  result[a_] = amplitude_[0] * cn;
  result[b_] = amplitude_[1] * sn;
  result[c_] = amplitude_[2] * dn;
  return result;
}

double ExactTop::period() const {
  if (steady_) return 0.0;
  if (complement_ == 0) return std::numeric_limits<double>::infinity();
  return 4 * quarter_period(complement_) / rate_;
}

Matrix3Xd exact_free_rotation(const Vector3d& moments, const Vector3d& omega0, const VectorXd& times) {
  const ExactTop top(moments, omega0);
  Matrix3Xd omega(3, times.size());
  for (Eigen::Index k = 0; k < times.size(); ++k) omega.col(k) = top.omega(times[k]);
  return omega;
}

}  // namespace workbook::judging
