#include "solutions/09_heavy_top/shared.hpp"

namespace {

/// p_ψ/I₁ of the top that precesses steadily at this rate, and p_φ/I₁.
double p_psi_of(double I1, double mgl, double theta, double rate) { return rate * cos(theta) + mgl / (I1 * rate); }
double p_phi_of(double I1, double mgl, double theta, double rate) {
  return rate * pow(sin(theta), 2) + p_psi_of(I1, mgl, theta, rate) * cos(theta);
}

/// θ̈ of a top with constant momenta, for real and for complex inclinations.
template <class Number>
Number theta_acceleration(double I1, double mgl, Number theta, double a, double b) {
  const Number rate = (a - b * cos(theta)) / (sin(theta) * sin(theta));
  return sin(theta) * (cos(theta) * rate * rate - b * rate + mgl / I1);
}

}  // namespace

void judge_nutation_frequency(Lecture& lecture) {
  auto& e = lecture.exercise(
      &nutation_frequency,
      {{"I1", positive(kg_m2)}, {"mgl", positive(joule)}, {"theta", positive(rad)}, {"rate", nonzero(rad_per_s)}},
      {"frequency", rad_per_s});
  e.domain([](auto, auto, auto theta, auto) { return theta < pi && sin(theta) >= 0.01; });
  e.generated([](auto I1, auto mgl, auto theta, auto rate) {
    const double size = abs(rate) / sqrt(mgl / I1);
    return sin(theta) > 0.05 && size > 1e-3 && size < 1e3;
  });
  e.worked("the toy top of the lecture, slow", 3.28e-4, 0.0456, 30 * degree, 3.7585425938);
  e.worked("the toy top of the lecture, fast", 3.28e-4, 0.0456, 30 * degree, 42.711113219);
  e.special("hanging, with the fast rate backwards", 3.28e-4, 0.0456, 150 * degree, -49.7);
  e.special("horizontal", 3.28e-4, 0.0456, pi / 2, 4);
  e.special("where both rates meet", 2, 2, 1, 1 / sqrt(cos(1)));
  e.special("without spin: a pendulum on a cone", 1, 2, 2, sqrt(2 / -cos(2)));
  e.special("very slow", 3.28e-4, 0.0456, 0.5, 0.05);
  e.limit("very slow", 0.0456 / (3.28e-4 * 0.05),
          "A very slow precession belongs to a fast spin, and a fast top nods as a free one: at p_ψ/I₁.");
  e.limit("without spin: a pendulum on a cone", sqrt(2 / -cos(2)) * sqrt(1 + 3 * pow(cos(2), 2)),
          "This is the conical pendulum of particle mechanics, L about the vertical being constant.");
  e.random("any top", 8, [](Random& random) {
    const double I1 = random.uniform(2e-4, 6e-4), mgl = random.uniform(0.02, 0.1);
    const double theta = random.uniform(0.4, 1.2) + (random.sign() > 0 ? 0 : 1.4);
    const double size = random.sign() > 0 ? random.uniform(0.3, 0.8) : random.uniform(1.25, 3);
    return tuple{I1, mgl, theta, random.sign() * sqrt(mgl / I1) * size};
  });
  e.sweep<3>({"The toy top at 30°", "rate of the steady precession (rad/s)", "frequency of the nutation (rad/s)"},
             {"ν"}, {2, 60, 117});

  e.wrong({"The rate of the precession is held constant while the axis nods; constant are the momenta.",
           "heavy_top_conserved"},
          "rate_kept", [](auto, auto, auto theta, auto rate) { return abs(rate) * sin(theta); });
  e.wrong("In p_φ only the inclination in its last term changes here; the sine squared before φ̇ changes as well.",
          "sine_kept", [](auto I1, auto mgl, auto theta, auto rate) {
            const double b = p_psi_of(I1, mgl, theta, rate);
            return sqrt(max(0.0, pow(rate * sin(theta), 2) + (b - 2 * rate * cos(theta)) * b));
          });
  e.wrong({"This is the frequency of a fast top, the momentum along the axis over the moment across it, at any rate.",
           "heavy_top_advance"},
          "fast_top", [](auto I1, auto mgl, auto theta, auto rate) { return abs(p_psi_of(I1, mgl, theta, rate)); });
  e.wrong("This is right for a very slow precession only: the weight alone, over the rate.", "slow_only",
          [](auto I1, auto mgl, auto, auto rate) { return mgl / (I1 * abs(rate)); });
  e.wrong("This is the rate of the precession: a free top nods once in a round, one with weight does not.", "free",
          [](auto, auto, auto, auto rate) { return abs(rate); });
  e.wrong_input<1>(weight_sign, "hanging", negated);
  e.wrong_output("This is the square of the frequency.", "squared", [](auto& frequency) { frequency *= frequency; });
  e.wrong_output("This is in nods per second; radians per second are asked for.", "per_second", times(0.5 / pi));
  e.wrong("The inclination does not enter your frequency.", "no_cosine",
          [](auto I1, auto mgl, auto, auto rate) { return hypot(rate, mgl / (I1 * rate)); });
  e.property(Is::nonnegative, "The frequency is asked for with the positive sign.");
  e.route("curvature of the effective potential", [](auto I1, auto mgl, auto theta, auto rate) {
    const double p_psi = I1 * p_psi_of(I1, mgl, theta, rate), p_phi = I1 * p_phi_of(I1, mgl, theta, rate);
    const double h = 0.01 * sin(theta);
    const auto potential = [&](double k) {
      return effective_potential(I1, I1, mgl, p_phi, p_psi, theta + k * h) - p_psi * p_psi / (2 * I1);
    };
    const double second = 270 * (potential(1) + potential(-1)) - 27 * (potential(2) + potential(-2)) +
                          2 * (potential(3) + potential(-3)) - 490 * potential(0);
    return sqrt(second / (180 * h * h * I1));
  });
  e.route("the slope of θ̈, with a complex step", [](auto I1, auto mgl, auto theta, auto rate) {
    const double a = p_phi_of(I1, mgl, theta, rate), b = p_psi_of(I1, mgl, theta, rate);
    const std::complex<double> aside(theta, 1e-20 * sin(theta));
    return sqrt(-theta_acceleration(I1, mgl, aside, a, b).imag() / aside.imag());
  });
  e.route("the double root of the cubic", [](auto I1, auto mgl, auto theta, auto rate) {
    const double w = 2 * mgl / I1, b = p_psi_of(I1, mgl, theta, rate), u = cos(theta);
    const double alpha = pow(rate * sin(theta), 2) + w * u;  // f = (1 − u²)(α − w u) − (a − b u)²
    return sqrt(alpha - 3 * w * u + b * b);
  });
  e.survivor("std::abs(rate)", "The two absolute values change their signs together, and the square has none.");
}
