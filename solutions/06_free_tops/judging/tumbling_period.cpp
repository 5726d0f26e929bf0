#include "solutions/06_free_tops/shared.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

using boost::math::ellint_1, boost::math::ellint_rf;

/// ν and m of the exact solution, by differences that do not cancel.
struct EllipticMotion {
  EllipticMotion(const Vector3d& I, const Vector3d& omega) {
    const Vector3d squares = omega.cwiseAbs2();
    // L² − 2T I_k, each as a sum over the two other axes.
    const double above_first = I[1] * (I[1] - I[0]) * squares[1] + I[2] * (I[2] - I[0]) * squares[2];
    const double above_second = I[0] * (I[0] - I[1]) * squares[0] + I[2] * (I[2] - I[1]) * squares[2];
    const double below_third = I[0] * (I[2] - I[0]) * squares[0] + I[1] * (I[2] - I[1]) * squares[1];
    const double third = above_first * (I[2] - I[1]), first = below_third * (I[1] - I[0]), steady = max(third, first);
    lambda = sqrt(steady / I.prod());
    m = min(third, first) / steady;
    complement = (I[2] - I[0]) * abs(above_second) / steady;
  }
  double lambda, m, complement;  // complement: 1 − m
};

/// 4K/ν for a K of one's own.
template <class Integral>
static auto with_K(const Integral& K) {
  return [K](auto& I, auto& w) {
    const EllipticMotion motion(I, w);
    return 4 * K(motion) / motion.lambda;
  };
}

void judge_tumbling_period(Lecture& lecture) {
  auto& e = lecture.exercise(&tumbling_period, {{"I", ascending_moments}, {"omega0", rad_per_s}}, {"period", second});
  either_side_of_separatrix(e);
  e.domain([](auto& I, auto& w) { return EllipticMotion(I, w).complement > 1e-9; });
  e.worked("a flip: moments 1, 2, 3, spin about axis 2, disturbed", {1, 2, 3}, {0.1, 1, 0.1});
  e.worked("round axis 1", {1, 2, 3}, {1, 0.5, 0.25});
  e.special("a spin about axis 3 alone", {1, 2, 3}, {0, 0, 2});
  e.special("a spin about axis 1 alone", {1, 2, 3}, {-2, 0, 0});
  e.special("a flattened symmetric top", {1, 1, 1.5}, {0.5, 0.25, 2});
  e.special("a long symmetric top", {0.5, 1, 1}, {2, 0.5, 0.25});
  e.special("close to the separatrix, on the side of axis 3", {1, 2, 3}, {0, 1, 1e-3});
  e.special("close to the separatrix, on the side of axis 1", {1, 2, 3}, {1e-3, -1, 0});
  e.random("a random motion", 10, [](Random& random) {
    while (true) {  // where m is small K(m) hardly depends on it; where it is close to 1 a right answer loses digits
      const Vector3d I = random.ascending_moments(), omega = random.vector(3);
      if (abs(EllipticMotion(I, omega).m - 0.575) < 0.375) return tuple{I, omega};
    }
  });
  e.sweep<1>({"I = (1, 2, 3) kg m², ω₁ = 1, ω₂ = 0.5 rad/s: from axis 1 across the separatrix to axis 3", "ω₃ (rad/s)",
              "period (s)"},
             {"period"}, {0.1 / sqrt(3), 2.6 / sqrt(3), 51}, [](auto omega3) { return Vector3d(1, 0.5, omega3); });

  const char *const modulus = "free_tops_modulus", *const flip = "free_tops_flip";
  e.wrong_output("This is half the period, 2K/ν: two components have changed their signs by then.", "half", times(0.5));
  e.wrong_output("This is K/ν, a quarter of the period.", "quarter", times(0.25));
  e.wrong({"This comes out with the parameter m where the library expects the modulus k = √m.", modulus},
          "parameter_as_modulus", with_K([](auto& motion) { return ellint_1(motion.m); }));
  e.wrong({"The root of m is taken twice here: K gets the modulus k = √m, once.", modulus}, "root_taken_twice",
          with_K([](auto& motion) { return ellint_1(pow(motion.m, 0.25)); }));
  e.wrong({"This comes out with 1 − m where m belongs; check with m → 0, where K → π/2.", modulus},
          "complementary_parameter", with_K([](auto& motion) { return ellint_rf(0.0, max(motion.m, 1e-300), 1.0); }));
  e.wrong("This is 2π/ν, as if K were π/2; that holds only in the limit m → 0.", "no_elliptic_integral",
          with_K([](auto&) { return pi / 2; }));
  const Sentence cut_series = {
      "This is a series of K cut after a few terms; towards the separatrix it hardly converges.", modulus};
  for (int terms = 2; terms <= 10; ++terms)
    e.wrong(cut_series, "series_of_" + std::to_string(terms) + "_terms", with_K([=](auto& motion) {
              double sum = 0, coefficient = 1;
              for (int n = 1; n <= terms; ++n) {
                sum += coefficient * coefficient * pow(motion.m, n - 1);
                coefficient *= (2 * n - 1) / (2.0 * n);
              }
              return pi / 2 * sum;
            }));
  e.wrong("This is 2π/√(Ω₁Ω₂), the period of a small wobble about axis 3; the motion here is not small.",
          "small_wobble_about_3", [](auto& I, auto& w) { return over(2 * pi, wobble_about(I, w[2], 2)); });
  e.wrong("This is the period of a small wobble about axis 1; the motion here is not small.", "small_wobble_about_1",
          [](auto& I, auto& w) { return over(2 * pi, wobble_about(I, w[0], 0)); });
  e.wrong({"This is 2π/σ with the growth rate of the unstable axis; the time between flips is no such period.", flip},
          "growth_as_frequency", [](auto& I, auto& w) { return over(2 * pi, growth_rate(I, w[1])); });
  e.wrong("This is 2π/|ω|, about one turn of the body in space; in the body ω repeats after another time.",
          "turn_of_the_body", [](auto&, auto& w) { return 2 * pi / w.norm(); });
  e.wrong_output("This is 4K(m), a pure number; dividing by ν makes it a time.", "lambda_dropped",
                 [](auto& P, auto& I, auto& w) { P *= EllipticMotion(I, w).lambda; });
  e.wrong_output("This is divided by ν²; its root is missing.", "lambda_squared",
                 [](auto& P, auto& I, auto& w) { P /= EllipticMotion(I, w).lambda; });
  e.wrong({"This is the law ln(16/(1 − m)) that holds close to the separatrix; here it is not exact.", flip},
          "logarithm", with_K([](auto& motion) { return std::log(16 / motion.complement) / 2; }));
  e.route("arithmetic-geometric mean", with_K([](auto& motion) {
            double a = 1, b = sqrt(motion.complement);
            for (int i = 0; i < 60; ++i) std::tie(a, b) = tuple{(a + b) / 2, sqrt(a * b)};
            return pi / (2 * a);
          }));
  e.route("the textbook formula", [](auto& I, auto& w) {
    const double twice_energy = I.dot(w.cwiseAbs2()), L2 = I.cwiseProduct(w).squaredNorm();
    const bool about_3 = L2 > twice_energy * I[1];
    const double I1 = about_3 ? I[0] : I[2], I2 = I[1], I3 = about_3 ? I[2] : I[0];
    const double above = (L2 - twice_energy * I1) * (I3 - I2), m = (twice_energy * I3 - L2) * (I2 - I1) / above;
    return 4 * std::comp_ellint_1(sqrt(m)) / sqrt(above / (I1 * I2 * I3));
  });
  e.route("quadrature of the elliptic integral", with_K([](auto& motion) {
            // Periodic, so the trapezoidal rule converges exponentially; near m = 1 it needs many nodes.
            double sum = 0;
            constexpr int nodes = 30000;
            for (int k = 0; k < nodes; ++k) {
              const double alpha = (k + 0.5) * pi / nodes;
              sum += 1 / sqrt(pow(cos(alpha), 2) + motion.complement * pow(sin(alpha), 2));
            }
            return pi / 2 / nodes * sum;
          }));
  e.route("the exact motion's own period", [](auto& I, auto& w) {
    const ExactTop top(I, w);  // a steady rotation has no period: there the limit of small wobbles is asked for
    return top.rate() > 0 ? top.period() : 2 * pi / EllipticMotion(I, w).lambda;
  });
  e.route("Boost's complete integral", with_K([](auto& motion) { return ellint_1(sqrt(motion.m)); }));
  e.survivor("excess <= 0", "Zero is the separatrix, on which there is no period.");
}
