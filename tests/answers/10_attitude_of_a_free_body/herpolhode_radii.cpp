#include <algorithm>
#include <cmath>
#include <rigid/attitude_of_a_free_body.hpp>
Vector2d herpolhode_radii(const Vector3d& I, const Vector3d& omega0) {
//! right: product formula at both ends
  const Vector3d L = I.cwiseProduct(omega0);
  const double L2 = L.squaredNorm();
  // 2T I_i − L² as a sum of differences of moments
  const auto above = [&](int i) {
    double sum = 0;
    for (int j = 0; j < 3; ++j) sum += I[j] * (I[i] - I[j]) * omega0[j] * omega0[j];
    return sum;
  };
  const auto radius = [&](int j, int k) { return std::sqrt(std::max(0.0, -above(k) * above(j) / (I[j] * I[k] * L2))); };
  const double a = radius(0, 2), b = above(1) < 0 ? radius(1, 2) : radius(0, 1);
  return {std::min(a, b), std::max(a, b)};
//! right: components at the two ends, then the cross product
  const Vector3d w2 = omega0.cwiseAbs2();
  // along the line of constant T and L² the squares change in proportion to this
  const Vector3d step((I[2] - I[1]) * I[1] * I[2], (I[0] - I[2]) * I[0] * I[2], (I[1] - I[0]) * I[0] * I[1]);
  double forward = INFINITY, back = -INFINITY;
  for (int i = 0; i < 3; ++i) {
    if (step[i] < 0) forward = std::min(forward, -w2[i] / step[i]);
    if (step[i] > 0) back = std::max(back, -w2[i] / step[i]);
  }
  const auto radius = [&](double s) {
    const Vector3d w = (w2 + s * step).cwiseMax(0).cwiseSqrt(), L = I.cwiseProduct(w);
    // only one component of the cross product is left; the two others are rounding
    return w.cross(L).cwiseAbs().maxCoeff() / L.norm();
  };
  const double a = radius(forward), b = radius(back);
  return {std::min(a, b), std::max(a, b)};
//! wrong: round axis 3, whatever the motion
static double radius(double T2, double L2, double Ij, double Ik) {
  return std::sqrt(std::abs((T2 * Ik - L2) * (L2 - T2 * Ij)) / (Ij * Ik * L2));
}
Vector2d herpolhode_radii(const Vector3d& I, const Vector3d& omega0) {
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  const double a = radius(T2, L2, I[0], I[2]), b = radius(T2, L2, I[1], I[2]);
  return {std::min(a, b), std::max(a, b)};
}
//! wrong: extremes of omega itself
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  const auto length = [&](int j, int k) { return std::sqrt((T2 * (I[j] + I[k]) - L2) / (I[j] * I[k])); };
  const double a = length(0, 2), b = L2 > T2 * I[1] ? length(1, 2) : length(0, 1);
  return {std::min(a, b), std::max(a, b)};
//! wrong: squares of the radii
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  const auto radius = [&](int j, int k) {
    return std::max(0.0, (T2 * I[k] - L2) * (L2 - T2 * I[j]) / (I[j] * I[k] * L2));
  };
  const double a = radius(0, 2), b = L2 > T2 * I[1] ? radius(1, 2) : radius(0, 1);
  return {std::min(a, b), std::max(a, b)};
//! wrong: as if the polhode went through the ends of the half-axes
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm(), h2 = T2 * T2 / L2;
  const Vector3d squares = (T2 * I.cwiseInverse() - Vector3d::Constant(h2)).cwiseMax(0).cwiseSqrt();
  return {squares.minCoeff(), squares.maxCoeff()};
//! wrong: both radii are those of the start
  const Vector3d L = I.cwiseProduct(omega0);
  return Vector2d::Constant(omega0.cross(L).norm() / L.norm());
//! wrong: the ring is not sorted
  const double T2 = I.dot(omega0.cwiseAbs2()), L2 = I.cwiseProduct(omega0).squaredNorm();
  const auto radius = [&](int j, int k) {
    return std::sqrt(std::max(0.0, (T2 * I[k] - L2) * (L2 - T2 * I[j]) / (I[j] * I[k] * L2)));
  };
  return {radius(0, 2), L2 > T2 * I[1] ? radius(1, 2) : radius(0, 1)};
//! wrong: the planes of the first and the third component, never of the second
-  return {radius(0, 2), L2 > T2 * I[1] ? radius(1, 2) : radius(0, 1)};
+  const double a = radius(1, 2), b = radius(0, 1);
+  return {std::min(a, b), std::max(a, b)};
//! wrong: not divided by L
  const double A = I[0], B = I[1], C = I[2];
  const Vector3d s = omega0.cwiseAbs2();
  const double p = A * (C - A) * s[0] + B * (C - B) * s[1], q = C * (C - A) * s[2] + B * (B - A) * s[1];
  const double T2 = I.dot(s), L2 = I.cwiseAbs2().dot(s);
  const double outer = std::sqrt(p * q / (A * C));
  const bool third = L2 > T2 * B;
  const double D = third ? p * (q * (C - B) - p * (B - A)) / (B * C * (C - A)) : q * (p * (B - A) - q * (C - B)) / (B * A * (C - A));
  return {std::sqrt(std::max(0.0, D)), outer};
