#pragma once

#include "rigid/attitude_of_a_free_body.hpp"
#include "solutions/judging/exact_top.hpp"
#include "solutions/judging/judging.hpp"

#include <boost/numeric/odeint.hpp>

inline const Vector3d lecture_body(1.2, 2, 2.7), round_3(0.4, -0.9, 0.6), round_1(0.9, -0.5, 0.2);

inline bool is_round_3(const Vector3d& I, const Vector3d& w) { return side_of_separatrix(I, w) > 0; }

/// The domain of the motions with three different moments: how far, at least, from the separatrix and from a pure spin.
inline bool tumbles(const Vector3d& I, const Vector3d& w, double off_separatrix, double across = 0.05) {
  return is_inertia_tensor(I.asDiagonal()) && min(I[1] - I[0], I[2] - I[1]) >= 0.05 * I[2] && w.norm() >= 0.1 &&
         w.norm() <= 2 && abs(side_of_separatrix(I, w)) >= off_separatrix &&
         min(hypot(w[0], w[1]), hypot(w[1], w[2])) >= across * w.norm();
}

/// A real body and a motion of either kind, off the separatrix.
inline auto round_axis(int axis) {
  return [axis](Random& random) {
    while (true) {
      const Vector3d I = random.ascending_moments(), w = random.vector(1.1);
      const double side = side_of_separatrix(I, w);
      if ((axis == 3 ? side : -side) > 0.05) return tuple{I, w};
    }
  };
}

/// What is asked of a whole period: bodies that tumble round axis 1 or 3.
template <class Asked>
void cases_of_a_period(Asked& e) {
  e.domain([](auto& I, auto& w) { return tumbles(I, w, 1e-3); });
  e.worked("round axis 3", lecture_body, round_3);
  e.worked("round axis 1", lecture_body, round_1);
  e.worked("close to the middle axis", {1, 2, 3}, {0.1, 1, 0.1});
  e.special("starting with ω₂ = 0", lecture_body, {0.5, 0, -0.8});
  e.special("starting with ω₃ = 0", lecture_body, {0.9, 0.3, 0});
  e.special("a small wobble about axis 3", lecture_body, {0.05, 0.03, -1});
  e.special("a small wobble about axis 1", lecture_body, {1, 0.03, 0.05});
  e.special("moments close together", {1, 1.07, 1.15}, {0.3, -0.2, 0.5});
  e.random("round axis 3", 6, round_axis(3));
  e.random("round axis 1", 6, round_axis(1));
}

/// A moving body: ω and the attitude that it had reached from the unit matrix.
struct Moved {
  Vector3d omega;
  Matrix3d A;
};

/// Euler's equations and dA/dt = A [ω]×, integrated by Fehlberg's method of eighth order.
inline Moved integrated(const Vector3d& I, const Vector3d& start, double t) {
  namespace odeint = boost::numeric::odeint;
  using State = std::vector<double>;  // ω, then the columns of A
  State state = {start[0], start[1], start[2], 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto rate = [&](const State& now, State& rates, double) {
    const Vector3d w(now[0], now[1], now[2]);
    Vector3d::Map(rates.data()) = free_rate(I, w);
    Matrix3d::Map(rates.data() + 3) = Matrix3d::Map(now.data() + 3) * skew(w);
  };
  const auto stepper = odeint::make_controlled(1e-15, 1e-15, odeint::runge_kutta_fehlberg78<State>());
  if (t != 0) odeint::integrate_adaptive(stepper, rate, state, 0.0, t, t / 50);
  return {Vector3d::Map(state.data()), Matrix3d::Map(state.data() + 3)};
}

/// ∫ f(ω) dt over one period. Equal steps over a period converge faster than any power of the step.
template <class Integrand>
double over_a_period(const Vector3d& I, const Vector3d& w, const Integrand& f) {
  const ExactTop top(I, w);
  constexpr int steps = 1500;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += f(top.omega(i * top.period() / steps));
  return sum * top.period() / steps;
}

/// The rate at which an axis of the body (3, or another one) goes round L.
inline double rate_about_L(const Vector3d& I, const Vector3d& w, int axis = 2) {
  const Vector3d L = L_of(I, w);
  const double across = L.squaredNorm() - L[axis] * L[axis];
  return L.norm() * (twice_T(I, w) - L[axis] * w[axis]) / across;
}

/// 2T P/L.
inline double dynamical_phase(const Vector3d& I, const Vector3d& w) {
  return twice_T(I, w) / L_of(I, w).norm() * ExactTop(I, w).period();
}

inline double modulo(double x, double whole) { return x - whole * std::floor(x / whole); }
