#include "solutions/09_heavy_top/shared.hpp"

namespace {

/// φ after one period, in steps that become small near the vertical, where φ̇ is large.
double integrated_advance(double I1, double I3, double mgl, double theta, const Vector3d& rates) {
  const double b = I3 / I1 * (rates[0] * cos(theta) + rates[2]);
  const double a = rates[0] * pow(sin(theta), 2) + b * cos(theta), period = nutation_period(I1, I3, mgl, theta, rates);
  const auto rate = [&](const Vector3d& state) {  // of θ, θ̇ and φ
    const double s = sin(state[0]), c = cos(state[0]), phi_rate = (a - b * c) / (s * s);
    return Vector3d(state[1], s * (c * phi_rate * phi_rate - b * phi_rate + mgl / I1), phi_rate);
  };
  Vector3d state(theta, rates[1], 0);
  const double h = 4e-3 / sqrt(b * b + 2 * mgl / I1 + rates.head<2>().squaredNorm());
  for (double time = 0; time < period;) {
    const double next = min(h * min(1.0, 3 * sin(state[0])), period - time);
    state = one_step_on(state, next, rate);
    time += next;
  }
  return state[2];
}

/// ∫ f dt over one nutation, for an f of the cubic and u = cos θ.
template <class Function>
auto integral_of(const Function& f) {
  return [f](auto... inputs) {
    const Cubic cubic{Start(inputs...)};
    return cubic.over_one_nutation([&](double u) { return f(cubic, u); });
  };
}

/// The wrong answers that are known.
template <class Exercise>
void mistakes_of_precession_per_nutation(Exercise& e) {
  e.wrong("This is the mean rate of a fast top times the period.", "slow_precession",
          [](auto I1, auto I3, auto mgl, auto theta, auto& rates) {
            return mgl / (I3 * (rates[0] * cos(theta) + rates[2])) * nutation_period(I1, I3, mgl, theta, rates);
          });
  e.wrong("Rate and period are both those of a fast top, which yours is not.", "fast_top",
          [](auto I1, auto I3, auto mgl, auto theta, auto& rates) {
            const double spin = I3 * (rates[0] * cos(theta) + rates[2]);
            return mgl / spin * 2 * pi * I1 / abs(spin);
          });
  e.wrong_output("This is the angle from one limit to the other; on the way back it is as large.", "half", times(0.5));
  e.wrong("The rate of the steady precession at the inclination of the start stands for φ̇ here; φ̇ changes with θ.",
          "steady_rate", [](auto I1, auto I3, auto mgl, auto theta, auto& rates) {
            const double a = I1 * cos(theta), b = I3 * (rates[0] * cos(theta) + rates[2]);
            const double root = sqrt(max(b * b - 4 * a * mgl, 0.0));
            return 2 * mgl / (b + copysign(root, b)) * nutation_period(I1, I3, mgl, theta, rates);
          });
  e.wrong("φ̇ keeps its value from the start here; it changes with θ.", "start_rate",
          [](auto I1, auto I3, auto mgl, auto theta, auto& rates) {
            return rates[0] * nutation_period(I1, I3, mgl, theta, rates);
          });
  e.wrong("The parts of the loops that run backwards are counted forwards.", "absolute_rate",
          integral_of([](auto& cubic, double u) { return abs(cubic.phi_rate(u)); }));
  e.wrong_output("The angle has the wrong sign.", "sense", negated);
  e.wrong_inputs(spin_as_psi_rate, "psi_rate_as_omega3", spin_confused);
  e.template wrong_input<2>(weight_sign, "hanging", negated);
  e.wrong_output("This is the number of turns; the angle is asked for.", "turns", times(0.5 / pi));
  e.wrong("You integrate as if the whole of p_φ turned the axis round the vertical; the spin takes its part of it.",
          "no_coupling", integral_of([](auto& cubic, double u) { return cubic.a / (1 - u * u); }));
  e.wrong("The sine of θ enters your φ̇ with the wrong power.", "sine_not_squared",
          integral_of([](auto& cubic, double u) { return cubic.phi_rate(u) * sqrt(1 - u * u); }));
  e.wrong({"The two momenta are exchanged: this integrates the rate of another angle.", "heavy_top_conserved"},
          "momenta_exchanged",
          integral_of([](auto& cubic, double u) { return (cubic.b - cubic.a * u) / (1 - u * u); }));
  e.wrong({"This is the change of ψ, the turn of the body about its own axis; asked for is φ.", "heavy_top_conserved"},
          "psi_advance", [](auto I1, auto I3, auto mgl, auto theta, auto& rates) {
            const Cubic cubic{Start(I1, I3, mgl, theta, rates)};
            return cubic.over_one_nutation([&](double u) { return I1 / I3 * cubic.b - u * cubic.phi_rate(u); });
          });
  e.wrong("This is the mean of φ̇ at both limits times the period; between them it changes in another way.",
          "mean_of_limits", [](auto I1, auto I3, auto mgl, auto theta, auto& rates) {
            const Cubic cubic{Start(I1, I3, mgl, theta, rates)};
            return (cubic.phi_rate(cubic.low) + cubic.phi_rate(cubic.high)) / 2 *
                   nutation_period(I1, I3, mgl, theta, rates);
          });
  e.wrong("The rate in the middle between the two limits is taken for all of the period here; it changes on the way.",
          "rate_in_the_middle", [](auto I1, auto I3, auto mgl, auto theta, auto& rates) {
            const Cubic cubic{Start(I1, I3, mgl, theta, rates)};
            return cubic.phi_rate((cubic.low + cubic.high) / 2) * nutation_period(I1, I3, mgl, theta, rates);
          });
  const char* const modulo = "Whole turns are missing: this is the angle modulo 2π.";
  e.wrong_output(modulo, "modulo_nearest", [](auto& angle) { angle = std::remainder(angle, 2 * pi); });
  e.wrong_output(modulo, "modulo", [](auto& angle) { angle -= 2 * pi * std::floor(angle / (2 * pi)); });
}

}  // namespace

void judge_precession_per_nutation(Lecture& lecture) {
  auto& e = lecture.exercise(&precession_per_nutation, arguments_of_nutation, {"advance", rad});
  describe_starts(e);
  e.limit("a fast top, with a nutation of 0.0045", 2 * pi * fast_precession / fast_nods,
          "The axis goes round at nearly mgl/p_ψ on the average, and nods at nearly p_ψ/I₁.");
  e.limit("a conical pendulum, tapped", 2 * pi * rate_on_cone / frequency_on_cone,
          "It goes round at the rate of the steady motion, for the time of one swing.");
  // Its axis goes round by more than half a turn, so that whole turns which are taken away show.
  e.random("without spin: a spherical pendulum", 2, [](Random& random) {
    while (true) {
      const double I1 = random.uniform(1e-4, 6e-4), mgl = random.uniform(0.02, 0.1), theta = random.uniform(1.9, 2.4);
      const double rate = sqrt(mgl / I1), phi_rate = random.sign() * rate * random.uniform(0.4, 0.8);
      const Vector3d rates(phi_rate, rate * random.uniform(0.1, 0.5), -phi_rate * cos(theta));
      Start start{I1, I1 * random.uniform(0.15, 1.5), mgl, theta, rates};
      if (nutates(start, 0.1, 0.1)) return start;
    }
  });
  e.scale([](auto... inputs) { return max(abs(precession_per_nutation(inputs...)), 1e-2); });
  e.tolerance(1e-8, "Loops may bring the angle near zero, and the integral has steep ends near the vertical.");
  e.sweep<4>({"A small top from θ = 0.5, with ω₃ = 150 rad/s", "φ̇ at the start (rad/s)", "advance (rad)"}, {"advance"},
             {-20, 28}, [](auto rate) { return Vector3d(rate, 0.3, 150 - rate * cos(0.5)); });

  mistakes_of_precession_per_nutation(e);
  const char* const weak =
      "Only a weight that is very weak beside the motion moves the axis so little, and there the closed formula for "
      "the roots of a cubic, a right way to them, has too few digits left.";
  for (const char* bug : {"0.001", "1e-06", "1e-09"})
    e.survivor("results below " + std::string(bug) + " replaced by zero", weak);
  e.angles_read_as_degrees();
  e.route("the axis and L followed in space", [](auto... inputs) {
    const Vector3d azimuth = Followed(Start(inputs...)).azimuth_at;
    return azimuth[2] - azimuth[0];
  });
  e.route("φ̇ as an integral without ends", integral_of([](auto& cubic, double u) { return cubic.phi_rate(u); }));
  e.route("the standard library's elliptic integrals of the third kind", [](auto... inputs) {
    const Cubic cubic{Start(inputs...)};
    const auto share = [&](double end) {
      const double distance = 1 - end * cubic.low, part = end * (cubic.high - cubic.low) / distance;
      return (cubic.a - end * cubic.b) / distance * std::comp_ellint_3(sqrt(cubic.m()), part);
    };
    return 2 / sqrt(cubic.beta * (cubic.third - cubic.low)) * (share(1) + share(-1));
  });
  e.route("θ and φ integrated over one period", integrated_advance);
}
