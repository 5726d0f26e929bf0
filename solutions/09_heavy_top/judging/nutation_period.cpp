#include "solutions/09_heavy_top/shared.hpp"

namespace {

/// 4K/√(w (third − low)) with a parameter of one's own, from that of the motion.
template <class Parameter>
auto with_modulus(const Parameter& modulus) {
  return [modulus](auto... inputs) {
    const Cubic cubic{Start(inputs...)};
    return 4 * std::comp_ellint_1(modulus(cubic.m())) / sqrt(cubic.beta * (cubic.third - cubic.low));
  };
}

/// The period of a small nutation about the bottom of the effective potential.
double small_nutation(double I1, double I3, double mgl, double theta, const Vector3d& rates) {
  const Cubic cubic{Start(I1, I3, mgl, theta, rates)};
  double low = 0, high = pi;
  for (int i = 0; i < 100; ++i) {
    const double at = (low + high) / 2, c = cos(at), rate = cubic.phi_rate(c);
    (I1 * c * rate * rate - I1 * cubic.b * rate + mgl > 0 ? low : high) = at;  // where θ̈ > 0, the bottom lies beyond
  }
  const double rate = cubic.phi_rate(cos(low));
  return 2 * pi / hypot(rate * sin(low), cubic.b - 2 * rate * cos(low));
}

double spin_of(double theta, const Vector3d& rates) { return abs(rates[0] * cos(theta) + rates[2]); }

}  // namespace

void judge_nutation_period(Lecture& lecture) {
  auto& e = lecture.exercise(&nutation_period, arguments_of_nutation, {"period", second});
  describe_starts(e);
  e.limit("a fast top, with a nutation of 0.0045", 2 * pi / fast_nods,
          "A fast top nods as a free body does, at p_ψ/I₁, only a little slower by its precession.");
  e.limit("a conical pendulum, tapped", 2 * pi / frequency_on_cone,
          "Without spin it is the conical pendulum of particle mechanics.");
  e.sweep<4>({"A small top, let go at rest at θ = 0.5", "spin (rad/s)", "period (s)"}, {"period"}, {20, 250},
             [](auto spin) { return spin * z_axis; });

  e.wrong_output("This is the time from one limit to the other; back again it takes as long.", "half", times(0.5));
  e.wrong("This is the period of a fast top, which yours is not.", "fast_top",
          [](auto I1, auto I3, auto, auto theta, auto& rates) { return 2 * pi * I1 / (I3 * spin_of(theta, rates)); });
  e.wrong("The parameter stands where the modulus of the elliptic integral belongs; the library says which it takes.",
          "modulus", with_modulus([](double m) { return m; }));
  e.wrong("This holds for a small nutation; yours is not small.", "small_nutation",
          with_modulus([](double) { return 0; }));
  e.wrong({"This is the period of a small nutation at the bottom of the effective potential; that of this top is not "
           "small.",
           "heavy_top_effective_potential"},
          "bottom_of_the_well", small_nutation);
  e.wrong("Two of the three zeros are exchanged in the difference under the root.", "upper_limit", [](auto... inputs) {
    const Cubic cubic{Start(inputs...)};
    return 4 * std::comp_ellint_1(sqrt(cubic.m())) / sqrt(cubic.beta * (cubic.third - cubic.high));
  });
  e.wrong_inputs(spin_as_psi_rate, "psi_rate_as_omega3", spin_confused);
  e.wrong("This is the time of one turn of a fast top round the vertical.", "precession_time",
          [](auto, auto I3, auto mgl, auto theta, auto& rates) { return 2 * pi * I3 * spin_of(theta, rates) / mgl; });
  e.wrong_input<2>(weight_sign, "hanging", negated);
  e.wrong_inputs("This is the period of an axis let go from rest; it starts with rates of its own.", "from_rest",
                 let_go_from_rest);
  e.wrong_output("This is a frequency; the time of one nutation is asked for.", "frequency",
                 [](auto& period) { period = 1 / period; });
  e.wrong_output("This is a quarter of the period.", "quarter", times(0.25));
  e.angles_read_as_degrees();
  e.property(Is::nonnegative, "A period is positive.");
  e.route("the axis and L followed in space", [](auto... inputs) {
    const Vector3d times = Followed(Start(inputs...)).time_at;
    return times[2] - times[0];
  });
  e.route("the time as an integral without ends",
          [](auto... inputs) { return Cubic(Start(inputs...)).over_one_nutation([](double) { return 1; }); });
  e.route("the standard library's elliptic integral", with_modulus([](double m) { return sqrt(m); }));
}
