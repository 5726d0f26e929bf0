#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <utility>
#include <rigid/attitude_of_a_free_body.hpp>
Matrix3d exact_attitude(const Vector3d& I, const Vector3d& omega0, double t) {
//! right: turn about L for the whole periods, the remainder integrated
static double period(const Vector3d& I, const Vector3d& w) {
  double a = I[0], b = I[1], c = I[2], x = w[0], y = w[1], z = w[2];
  if (a * (b - a) * x * x > c * (c - b) * z * z) {
    std::swap(a, c);
    std::swap(x, z);
  }
  const double below = a * (c - a) * x * x + b * (c - b) * y * y;
  const double above = b * (b - a) * y * y + c * (c - a) * z * z;
  return 4 * std::comp_ellint_1(std::sqrt(below * (b - a) / (above * (c - b)))) /
         std::sqrt(above * (c - b) / (a * b * c));
}
static void follow(const Vector3d& I, Vector3d& w, Eigen::Quaterniond& q, double time) {
  const auto rate = [&](const Vector3d& v) {
    return Vector3d(Vector3d((I[1] - I[2]) * v[1] * v[2], (I[2] - I[0]) * v[2] * v[0], (I[0] - I[1]) * v[0] * v[1])
                        .cwiseQuotient(I));
  };
  const auto turn = [](const Eigen::Quaterniond& r, const Vector3d& v) {
    return Eigen::Vector4d((r * Eigen::Quaterniond(0, v[0], v[1], v[2])).coeffs() / 2);
  };
  const int n = 4000;
  const double h = time / n;
  for (int i = 0; i < n; ++i) {
    const Vector3d a = rate(w), b = rate(w + h / 2 * a), c = rate(w + h / 2 * b), d = rate(w + h * c);
    const Eigen::Vector4d A = turn(q, w),
                          B = turn(Eigen::Quaterniond(Eigen::Vector4d(q.coeffs() + h / 2 * A)), w + h / 2 * a),
                          C = turn(Eigen::Quaterniond(Eigen::Vector4d(q.coeffs() + h / 2 * B)), w + h / 2 * b),
                          D = turn(Eigen::Quaterniond(Eigen::Vector4d(q.coeffs() + h * C)), w + h * c);
    w += h / 6 * (a + 2 * b + 2 * c + d);
    q.coeffs() += h / 6 * (A + 2 * B + 2 * C + D);
    q.normalize();
  }
}
static double turn_about_L(const Vector3d& I, const Vector3d& omega0) {
  const double L2 = I.cwiseProduct(omega0).squaredNorm(), x = I.dot(omega0.cwiseAbs2()), L = std::sqrt(L2);
  int a = 0, c = 2;
  const double E = x / L2;
  if (E * I[1] > 1) std::swap(a, c);
  const int n = 4000;
  double area = 0;
  for (int i = 0; i < n; ++i) {
    const double p = std::cos(2 * M_PI * i / n), q = std::sin(2 * M_PI * i / n);
    area += (1 - std::sqrt(1 - (E - 1 / I[c]) / (p * p / I[a] + q * q / I[1] - 1 / I[c]))) * 2 * M_PI / n;
  }
  return x / L * period(I, omega0) + (c == 0 ? area : -area);
}
Matrix3d exact_attitude(const Vector3d& I, const Vector3d& omega0, double t) {
  const double P = period(I, omega0), n = std::round(t / P);
  Vector3d w = omega0;
  Eigen::Quaterniond q(1, 0, 0, 0);
  follow(I, w, q, t - n * P);
  const Eigen::AngleAxisd turns(n * turn_about_L(I, omega0), I.cwiseProduct(omega0).normalized());
  return (turns * q).toRotationMatrix();
}
//! wrong: turns about omega0
-  const Eigen::AngleAxisd turns(n * turn_about_L(I, omega0), I.cwiseProduct(omega0).normalized());
+  const Eigen::AngleAxisd turns(n * turn_about_L(I, omega0), omega0.normalized());
//! wrong: periods truncated, remainder from the floor
-  const double P = period(I, omega0), n = std::round(t / P);
+  const double P = period(I, omega0), n = std::trunc(t / P);
@@
-  follow(I, w, q, t - n * P);
+  follow(I, w, q, t - std::floor(t / P) * P);
//! wrong: turns on the right-hand side
-  return (turns * q).toRotationMatrix();
+  return (q * turns).toRotationMatrix();
//! wrong: rows in place of columns
-  return (turns * q).toRotationMatrix();
+  return (turns * q).inverse().toRotationMatrix();
//! wrong: sense of the turn
-  const Eigen::AngleAxisd turns(n * turn_about_L(I, omega0), I.cwiseProduct(omega0).normalized());
+  const Eigen::AngleAxisd turns(-n * turn_about_L(I, omega0), I.cwiseProduct(omega0).normalized());
//! wrong: solid angle with the sign of motion round axis 3
-  return x / L * period(I, omega0) + (c == 0 ? area : -area);
+  return x / L * period(I, omega0) + -area;
//! wrong: number of periods in a whole number of 16 bits
-  const double P = period(I, omega0), n = std::round(t / P);
+  const double P = period(I, omega0), whole = std::round(t / P);
+  const short n = static_cast<short>(whole);
@@
-  follow(I, w, q, t - n * P);
+  follow(I, w, q, t - whole * P);
//! right: closed form with L upright
  const double I1 = I[0], I2 = I[1], I3 = I[2];
  Vector3d J = I, w = omega0;
  const bool other = I1 * (I2 - I1) * w[0] * w[0] > I3 * (I3 - I2) * w[2] * w[2];
  if (other) std::swap(J[0], J[2]), std::swap(w[0], w[2]);
  const double below = J[0] * (J[2] - J[0]) * w[0] * w[0] + J[1] * (J[2] - J[1]) * w[1] * w[1];
  const double above = J[1] * (J[1] - J[0]) * w[1] * w[1] + J[2] * (J[2] - J[0]) * w[2] * w[2];
  const double a1 = std::sqrt(below / (J[0] * (J[2] - J[0]))), a2 = std::sqrt(below / (J[1] * (J[2] - J[1])));
  const double a3 = std::sqrt(above / (J[2] * (J[2] - J[0]))), s = std::copysign(1.0, w[2]);
  const double nu = std::sqrt(above * (J[2] - J[1]) / (J[0] * J[1] * J[2]));
  const double k = std::sqrt(below * (J[1] - J[0]) / (above * (J[2] - J[1])));
  const double start = std::atan2(s * w[1] / a2, w[0] / a1), u0 = boost::math::ellint_1(k, start), u = nu * t + u0;
  double cn, dn;
  const double sn = boost::math::jacobi_elliptic(k, u, &cn, &dn);
  Vector3d now(a1 * cn, s * a2 * sn, s * a3 * dn);
  if (other) std::swap(now[0], now[2]);
  // amplitude with its whole turns
  double am = std::atan2(sn, cn);
  am += 2 * M_PI * std::round((M_PI * u / (2 * boost::math::ellint_1(k)) - am) / (2 * M_PI));
  const Vector3d L0 = I.cwiseProduct(omega0), L1 = I.cwiseProduct(now);
  const double L = L0.norm();
  const double T3 = I1 * (I3 - I1) * omega0[0] * omega0[0] + I2 * (I3 - I2) * omega0[1] * omega0[1];
  const double T1 = I2 * (I2 - I1) * omega0[1] * omega0[1] + I3 * (I3 - I1) * omega0[2] * omega0[2];
  const double cot2 = I3 * T1 / (I1 * T3), n = other ? -cot2 : -k * k * cot2;
  const double phi = L * t / I3 + L * (I3 - I1) / (I1 * I3 * nu) *
                                      (boost::math::ellint_3(k, n, am) - boost::math::ellint_3(k, n, start));
  const auto upright = [&](const Vector3d& v, double azimuth) {
    return Matrix3d(Eigen::AngleAxisd(azimuth, Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(std::atan2(std::hypot(v[0], v[1]), v[2]), Vector3d::UnitY()) *
                    Eigen::AngleAxisd(std::atan2(v[1], -v[0]), Vector3d::UnitZ()));
  };
  return upright(L0, 0).transpose() * upright(L1, phi);
//! wrong: omega0 kept constant on the axes of the body
Matrix3d exact_attitude(const Vector3d&, const Vector3d& omega0, double t) {
  return Eigen::AngleAxisd(omega0.norm() * t, omega0.normalized()).toRotationMatrix();
}
//! wrong: a steady turn about L
  const Vector3d L = I.cwiseProduct(omega0);
  const double rate = omega0.dot(L) / L.norm();
  return Eigen::AngleAxisd(rate * t, L.normalized()).toRotationMatrix();
