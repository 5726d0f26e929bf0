#include "solutions/06_free_tops/shared.hpp"

namespace {

struct Wobble {
  Wobble(const Vector3d& I, double omega3) : spin(omega3), rates(linearized_rates(I, omega3)) {}
  double spin;
  Vector2d rates;
  double frequency = sqrt(rates.prod()), ratio = sqrt(rates[1] / rates[0]), sign = rates[0] < 0 ? -1 : 1;
  double factor = sign * ratio;
};

/// A cos x and factor · A sin x with x = frequency · t + phase, for a frequency and a factor of one's own.
template <class Frequency, class Factor>
auto with(const Frequency& frequency, const Factor& factor) {
  return [=](auto& I, auto omega3, auto A, auto phase, auto t) {
    const Wobble wobble(I, omega3);
    const double x = std::invoke(frequency, wobble) * t + phase;
    return A * Vector2d(cos(x), std::invoke(factor, wobble) * sin(x));
  };
}

/// A wobble with Ω1 and Ω2 of the given sign, away from the angles at which sine or cosine vanish.
auto wobbles(double sign_of_rates) {
  return [sign_of_rates](Random& random) {
    const bool largest = random.sign() > 0;
    Vector3d I = random.ascending_moments();
    if (!largest) swap(I[0], I[2]);
    if (random.sign() > 0) swap(I[0], I[1]);
    const double omega3 = (largest ? 1 : -1) * sign_of_rates * random.uniform(1, 5);
    const double phase = random.sign() * random.uniform(0.3, 0.6);
    const double angle = random.uniform(0.8, 1.2) + pi * random.whole(-1, 1);  // where the wobble has got to
    return tuple{I, omega3, random.uniform(0.01, 0.05), phase, (angle - phase) / Wobble(I, omega3).frequency};
  };
}

}  // namespace

static void add_routes_of_linearized_top(auto& e) {
  e.route("sign and ratio apart", with(&Wobble::frequency, [](auto& p) { return copysign(p.ratio, p.rates[1]); }));
  e.route("turning an initial vector", [](auto& I, auto spin, auto A, auto phase, auto t) {
    const Wobble p(I, spin);  // x and y/ratio turn like the hand of a clock, in the sense of Ω1
    const auto hand = polar(A, p.sign * phase) * polar(1.0, p.sign * p.frequency * t);
    return Vector2d(hand.real(), p.ratio * hand.imag());
  });
  e.route("step by step", [](auto& I, auto spin, auto A, auto phase, auto t) {
    const Vector2d rates = linearized_rates(I, spin), start = linearized_top(I, spin, A, phase, 0);
    return followed(start, t, 4000, [&](const Vector2d& w) { return Vector2d(-rates[0] * w[1], rates[1] * w[0]); });
  });
  e.route("frequency from the moments", [](auto& I, auto spin, auto A, auto phase, auto t) {
    const double a = I[2] - I[1], b = I[2] - I[0], side = spin * a > 0 ? 1 : -1;
    const double angle = abs(spin) * sqrt(a * b / (I[0] * I[1])) * t + phase;
    return A * Vector2d(cos(angle), side * sqrt(b * I[0] / (a * I[1])) * sin(angle));
  });
}

void judge_linearized_top(Lecture& lecture) {
  auto& e = lecture.exercise(
      &linearized_top,
      {{"I", positive(kg_m2)}, {"omega3", rad_per_s}, {"amplitude", rad_per_s}, {"phase", rad}, {"t", second}},
      {"omega", rad_per_s});
  e.domain([](auto& I, auto spin, auto...) { return linearized_rates(I, spin).prod() > 0; });
  e.worked("the smallest moment about axis 3 (both rates negative)", {2, 3, 1}, 5, 0.01, 0.3, 0.2);
  e.worked("the largest moment about axis 3 (both rates positive)", {1, 2, 3}, 2, 0.02, -0.4, 0.7);
  e.special("time 0", {2, 3, 1}, 5, 0.01, 0.3, 0);
  e.special("phase 0", {2, 3, 1}, 5, 1e-5, 0, 0.2);
  e.special("no wobble", {2, 3, 1}, 5, 0, 0.3, 0.2);
  e.special("a flattened symmetric top", {1, 1, 1.8}, 2, 0.01, 0.3, 0.7);
  e.special("a long symmetric top", {2, 2, 0.5}, 2, 0.01, 0.3, 0.7);
  e.special("moments that differ by a millionth", {1, 1 + 1e-6, 1.8}, 2, 0.01, 0.3, 0.7);
  e.random("both rates negative", 6, wobbles(-1));
  e.random("both rates positive", 4, wobbles(1));
  e.scale([](auto& I, auto spin, auto A, auto, auto) { return or_one(abs(A)) * Vector2d(1, Wobble(I, spin).ratio); });
  e.sweep<4>({"I = (2, 3, 1) kg m², ω₃ = 5 rad/s, A = 0.01 rad/s, φ = 0.3: both rates are negative", "time (s)",
              "body component of ω (rad/s)"},
             {"omega_1", "omega_2"}, {0, 3});

  const char* const linear = "free_tops_linear";
  e.wrong("This is the formula printed on the slides, which slip: if Ω₁ and Ω₂ are negative, ω₂ has the opposite sign.",
          "formula_of_the_slides", with(&Wobble::frequency, &Wobble::ratio));
  e.wrong("Your ω₂ has the wrong sign where Ω₁ and Ω₂ are positive; its sign is that of Ω₁, not always minus.",
          "sign_always_reversed", with(&Wobble::frequency, [](auto& p) { return -p.ratio; }));
  e.wrong("Your motion starts with ω₂ = A sin φ; its amplitude is another one, also at the start.",
          "start_without_ratio", [](auto& I, auto omega3, auto A, auto phase, auto t) {
            const Wobble p(I, omega3);
            const double x = p.frequency * t, from = 1 / p.factor;
            return A * Vector2d(cos(phase) * cos(x) - from * sin(phase) * sin(x),
                                p.factor * cos(phase) * sin(x) + sin(phase) * cos(x));
          });
  e.wrong_output("Your ω₂ has the wrong sign everywhere: dω₁/dt = −Ω₁ω₂ shows it.", "sign_reversed", negate(1));
  e.wrong("The motion is right, but with another phase: the sign of Ω₁ belongs to ω₂, not to the frequency.",
          "sign_in_frequency", with([](auto& p) { return p.sign * p.frequency; }, &Wobble::ratio));
  e.wrong("Your ω₂ has the sign of ω₃; it is the sign of Ω₁, which also changes with I₃ − I₂.", "sign_of_spin",
          with(&Wobble::frequency, [](auto& p) { return copysign(p.ratio, p.spin); }));
  e.wrong(
      "Your amplitudes are in the ratio I₁ to I₂, as if the part of L across axis 3 kept its length; a change of ω₃ of "
      "second order changes that as well.",
      "momentum_ellipse", [](auto& I, auto omega3, auto A, auto phase, auto t) {
        Vector2d omega = linearized_top(I, omega3, A, phase, t);
        omega[1] *= I[0] / I[1] / Wobble(I, omega3).ratio;
        return omega;
      });
  const Sentence inverted{"Your ratio of amplitudes is inverted: ω₂ has √(Ω₂/Ω₁) times the amplitude of ω₁.", linear};
  const Sentence equal{"Both components have one amplitude, as in a symmetric top; ω₂ has √(Ω₂/Ω₁) times that of ω₁.",
                       linear};
  e.wrong(inverted, "ratio_inverted", with(&Wobble::frequency, [](auto& p) { return p.sign / p.ratio; }));
  e.wrong(inverted, "ratio_inverted_and_unsigned", with(&Wobble::frequency, [](auto& p) { return 1 / p.ratio; }));
  e.wrong(equal, "equal_amplitudes", with(&Wobble::frequency, &Wobble::sign));
  e.wrong(equal, "equal_amplitudes_unsigned", with(&Wobble::frequency, [](auto&) { return 1; }));
  e.wrong({"The root is missing in the ratio of amplitudes: it is √(Ω₂/Ω₁).", linear}, "ratio_without_root",
          with(&Wobble::frequency, [](auto& p) { return p.sign * p.ratio * p.ratio; }));
  e.wrong({"The root is missing in your frequency: it is √(Ω₁Ω₂).", linear}, "frequency_without_root",
          with([](auto& p) { return p.rates.prod(); }, &Wobble::factor));
  e.wrong({"Your wobble has the frequency |Ω₁|; it is √(Ω₁Ω₂), between |Ω₁| and |Ω₂|.", linear}, "frequency_first",
          with([](auto& p) { return abs(p.rates[0]); }, &Wobble::factor));
  e.wrong({"Your frequency is the mean of |Ω₁| and |Ω₂|; it is the root of their product.", linear}, "frequency_mean",
          with([](auto& p) { return abs(p.rates.sum()) / 2; }, &Wobble::factor));
  e.wrong_input<3>({"The phase does not enter: at t = 0 ω₁ is A cos φ.", linear}, "phase_lost", fixed(0.0));
  e.wrong_input<3>({"The phase is subtracted here; the slides add it.", linear}, "phase_subtracted", negated);
  e.wrong_input<4>({"Your result does not depend on time.", linear}, "time_lost", fixed(0.0));
  e.wrong_inputs({"Sine and cosine are exchanged: ω₁ takes the cosine, ω₂ the sine.", linear},
                 "sine_and_cosine_exchanged", [](auto&, auto, auto, auto& phase, auto& t) {
                   phase = pi / 2 - phase;
                   t = -t;
                 });
  e.wrong_input<2>({"The amplitude does not enter; both components contain it.", linear}, "amplitude_lost", fixed(1.0));
  e.wrong({"This comes out with cosh and sinh; about a stable axis Ω₁Ω₂ > 0, and the wobble swings.", stability_notes},
          "hyperbolic", [](auto& I, auto spin, auto A, auto phase, auto t) {
            const Wobble p(I, spin);
            const double x = p.frequency * t + phase;
            return A * Vector2d(std::cosh(x), p.factor * std::sinh(x));
          });
  e.angles_read_as_degrees(linear);
  add_routes_of_linearized_top(e);
}
