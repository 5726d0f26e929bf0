#include "solutions/06_free_tops/shared.hpp"

#include <boost/math/special_functions/ellint_1.hpp>

namespace {

/// The textbook's constants of the motion, from T and L².
struct Flipping {
  Flipping(const Vector3d& I, const Vector3d& w) {
    const double twice_energy = I.dot(w.cwiseAbs2()), L2 = I.cwiseProduct(w).squaredNorm();
    const bool about_3 = L2 > twice_energy * I[1];
    const double I1 = about_3 ? I[0] : I[2], I2 = I[1], I3 = about_3 ? I[2] : I[0];
    const double below = twice_energy * I3 - L2, above = L2 - twice_energy * I1;
    rate = sqrt(above * (I3 - I2) / (I1 * I2 * I3));
    m = below * (I2 - I1) / (above * (I3 - I2));
    const double first = about_3 ? w[0] : w[2];
    // sin and cos of the phase, up to a common factor
    phase = atan2(abs(w[1]) * sqrt(I2 * abs(I3 - I2)), abs(first) * sqrt(I1 * abs(I3 - I1)));
    away = w.prod() > 0;
  }
  double rate, m, phase;
  bool away;  // from zero at first
};

/// Where a function that has another sign at `to` than at `from` vanishes between the two.
template <class Function>
double zero_between(double from, double to, const Function& f) {
  const bool sign = f(from) > 0;
  for (int i = 0; i < 100; ++i) {
    const double middle = (from + to) / 2;
    ((f(middle) > 0) == sign ? from : to) = middle;
  }
  return (from + to) / 2;
}

double integrated_flip(const Vector3d& I, const Vector3d& start) {
  const auto stepped = [&](const Vector3d& w, double h) {
    return one_step_on(w, h, [&](const Vector3d& now) { return free_rate(I, now); });
  };
  const double h = 2e-3 / start.norm();
  Vector3d w = start;
  for (int k = 0; k < 2'000'000; ++k) {
    const Vector3d next = stepped(w, h);
    if (next[1] * start[1] <= 0) return k * h + zero_between(0, h, [&](double part) { return stepped(w, part)[1]; });
    w = next;
  }
  return 0;
}

}  // namespace

void judge_first_flip(Lecture& lecture) {
  auto& e = lecture.exercise(&first_flip, {{"I", ascending_moments}, {"omega0", rad_per_s}}, {"time", second});
  either_side_of_separatrix(e);
  e.domain([](auto& I, auto& w) {
    const double excess = I[0] * (I[0] - I[1]) * w[0] * w[0] + I[2] * (I[2] - I[1]) * w[2] * w[2];
    return min(I[1] - I[0], I[2] - I[1]) >= 0.05 * I[2] && w[1] != 0 && hypot(w[0], w[2]) > 0 &&
           abs(excess) >= 1e-5 * I.cwiseProduct(w).squaredNorm();
  });
  e.worked("thrown about the middle axis, growing at first", {1, 2, 3}, {0.01, 1, 0.02});
  e.worked("shrinking at first", {1, 2, 3}, {-0.01, 1, 0.02});
  e.worked("round axis 1", {1.2, 1.7, 2.6}, {-0.3, -1.5, 0.05});
  e.special("at the largest value at the start", {1, 2, 3}, {0, 1, 0.1});
  e.special("the same round axis 1", {1, 2, 3}, {0.1, -1, 0});
  e.special("just thrown through zero", {1, 2, 3}, {0.5, 1e-3, 0.4});
  e.special("just before zero", {1, 2, 3}, {0.5, -1e-3, 0.4});
  e.special("a small wobble about axis 3", {1, 2, 3}, {0, 0.01, 1});
  e.limit("just before zero", 1e-3 / (0.4 * 0.5),
          "It crosses zero at the rate that Euler's equations give at the start.");
  e.limit("a small wobble about axis 3", pi / 2,
          "It wobbles harmonically about axis 3, here at 1 rad/s, and zero is a quarter of a period from the largest "
          "value.");
  const auto thrown = [](double sign_of_product) {
    return [=](Random& random) {
      while (true) {
        const Vector3d I = random.ascending_moments(), across = random.vector(0.5);
        Vector3d w(across[0], random.uniform(0.7, 2), across[2]);
        if (w.prod() * sign_of_product < 0) w[1] = -w[1];
        const ExactTop top(I, w);
        // Where the zero before the start is as far as the one after it, two wrong answers are right.
        const double share = first_flip(I, w) / top.period();
        if (top.complementary_parameter() > 0.01 && abs(share - 0.25) > 0.02) return tuple{I, w};
      }
    };
  };
  e.random("growing at first", 5, thrown(1));
  e.random("shrinking at first", 5, thrown(-1));
  e.tolerance(1e-8,
              "Close to the separatrix the time hangs on the small difference of L² and 2TI₂, which rounding and every "
              "integration change a little.");
  e.sweep<1>({"I = (1, 2, 3) kg m², ω = (ω₁, 1, 0.1) rad/s at t = 0: growing at first on the right, where ω₁ > 0",
              "ω₁ at the start (rad/s)", "time of the first flip (s)"},
             {"time"}, {-0.4, 0.4, 81}, [](auto w1) { return Vector3d(w1, 1, 0.1); });

  e.wrong("This is half the tumbling period, from one flip to the next; the start lies in between.", "half_period",
          [](auto& I, auto& w) { return ExactTop(I, w).period() / 2; });
  e.wrong("This is a quarter of the period, as if ω₂ were at its largest at the start.", "quarter_period",
          [](auto& I, auto& w) { return ExactTop(I, w).period() / 4; });
  e.wrong(
      "This is the time since the last zero of ω₂, or the flip of a motion run backwards: does ω₂ grow or shrink at "
      "first?",
      "last_zero", [](auto& I, auto& w) { return ExactTop(I, w).period() / 2 - first_flip(I, w); });
  e.wrong(
      "This is the interval between flips close to the separatrix; where in it the start lies counts too.", "log_law",
      [](auto& I, auto& w) { return std::log(16 / ExactTop(I, w).complementary_parameter()) / growth_rate(I, w[1]); });
  e.wrong({"The parameter stands where the modulus of the elliptic integrals belongs; the library says which it takes.",
           "free_tops_modulus"},
          "parameter_as_modulus", [](auto& I, auto& w) {
            const Flipping motion(I, w);
            const double from_zero = boost::math::ellint_1(motion.m, motion.phase);
            return (motion.away ? 2 * boost::math::ellint_1(motion.m) - from_zero : from_zero) / motion.rate;
          });
  e.wrong({"This is how long the disturbance takes to grow as large as ω₂ at the rate σ; that law holds only while it "
           "is small.",
           "free_tops_growth"},
          "growth_time",
          [](auto& I, auto& w) { return std::log(abs(w[1]) / hypot(w[0], w[2])) / growth_rate(I, w[1]); });
  e.property(Is::nonnegative, "The flip comes after the start: its time is positive.");
  e.route("the motion integrated to the zero", integrated_flip);
  e.route("a root of the exact motion", [](auto& I, auto& w) {
    const ExactTop top(I, w);
    const auto omega_2 = [&](double t) { return top.omega(t)[1]; };
    const double step = top.period() / 1000;
    double t = 0;
    while (omega_2(t + step) * w[1] > 0) t += step;
    return zero_between(t, t + step, omega_2);
  });
  e.route("the incomplete elliptic integral of Boost", [](auto& I, auto& w) {
    const Flipping motion(I, w);
    const double k = sqrt(motion.m), from_zero = boost::math::ellint_1(k, motion.phase);
    return (motion.away ? 2 * boost::math::ellint_1(k) - from_zero : from_zero) / motion.rate;
  });
  e.survivor("excess <= 0", "On the separatrix there is no flip.");
  e.survivor("0 ? zero_to_zero - from_zero",
             "Only the sign counts; where a component vanishes the motion turns round, and both times are equal.");
}
