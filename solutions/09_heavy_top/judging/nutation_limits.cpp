#include "solutions/09_heavy_top/shared.hpp"

namespace {

/// Where effective_potential equals the energy, on both sides of its minimum.
Vector2d turning_points(double I1, double I3, double mgl, double theta, const Vector3d& rates) {
  const Vector3d p = mass_matrix<double>({I1, I1, I3}, {0, theta, 0}) * rates;
  const auto potential = [&](double at) {  // without the energy of the spin, which would swallow digits
    return effective_potential(I1, I3, mgl, p[0], p[2], at) - p[2] * p[2] / (2 * I3);
  };
  const double energy = 0.5 * I1 * (pow(rates[0] * sin(theta), 2) + pow(rates[1], 2)) + mgl * cos(theta);
  double low = 1e-3, high = pi - 1e-3;
  while (high - low > 1e-6) {
    const double third = (high - low) / 3;
    if (potential(low + third) > potential(high - third)) {
      low += third;
    } else {
      high -= third;
    }
  }
  const auto crossing = [&](double outside) {
    double inside = (low + high) / 2;
    for (int i = 0; i < 100; ++i) {
      const double middle = (inside + outside) / 2;
      (potential(middle) < energy ? inside : outside) = middle;
    }
    return inside;
  };
  return {crossing(1e-3), crossing(pi - 1e-3)};
}

}  // namespace

void judge_nutation_limits(Lecture& lecture) {
  auto& e = lecture.exercise(&nutation_limits, arguments_of_nutation, {"limits", rad});
  describe_starts(e);
  e.limit("a fast top, with a nutation of 0.0045", {0.5, 0.5 + 2 * top_I1 * top_mgl * sin(0.5) / pow(top_I3 * 800, 2)},
          "Let go at rest, the axis starts at its smallest inclination and falls by twice the distance to where it "
          "would precess steadily.");
  e.limit("a conical pendulum, tapped", {2.2 - tapped_by, 2.2 + tapped_by},
          "It swings harmonically, and equally far to both sides.");
  e.tolerance(1e-8, "Close to the vertical, an angle that is taken from its cosine loses digits.");
  e.sweep<4>({"A small top, let go at rest at θ = 0.5", "spin (rad/s)", "θ (rad)"}, {{"smallest", 0}, {"largest", 1}},
             {20, 250}, [](auto spin) { return spin * z_axis; });

  e.wrong_inputs("These are the limits of an axis let go from rest; it starts with rates of its own.", "from_rest",
                 let_go_from_rest);
  e.wrong_inputs(spin_as_psi_rate, "psi_rate_as_omega3", spin_confused);
  e.wrong_output("These are the cosines of the limits.", "cosines",
                 [](auto& limits) { limits = Vector2d(cos(limits[0]), cos(limits[1])); });
  e.wrong_output("The largest inclination stands first; the smallest is asked for first.", "order", reversed);
  e.wrong_input<2>(weight_sign, "hanging", negated);
  e.wrong_input<4>("θ̇ does not enter your limits; it is part of the energy.", "theta_rate_lost", zeroed(1));
  e.wrong_input<2>("The weight does not enter your limits: these are those of the free precession about L.",
                   "weightless", times(1e-9));
  e.wrong_inputs({"The energy of the spin is counted as if the nutation could use it; it is constant.",
                  "heavy_top_effective_potential"},
                 "spin_energy", [](auto I1, auto I3, auto, auto theta, Vector3d& rates) {
                   rates[1] = hypot(rates[1], sqrt(I3 / I1) * (rates[0] * cos(theta) + rates[2]));
                 });
  e.wrong_output("These angles are counted from the downward vertical.", "from_below",
                 [](auto& limits) { limits = Vector2d(pi - limits[1], pi - limits[0]); });
  e.wrong_output("These are in degrees.", "in_degrees", times(1 / degree));
  e.angles_read_as_degrees();
  e.property(Is::ascending, "The smallest inclination stands before the largest.");
  e.route("the axis and L followed in space", [](auto... inputs) {
    const Vector3d theta = Followed(Start(inputs...)).theta_at;
    return Vector2d(theta.minCoeff(), theta.maxCoeff());
  });
  e.route("the effective potential against the energy", turning_points);
  e.route("the closed formula for a cubic", [](auto... inputs) {
    const Cubic cubic{Start(inputs...)};
    return Vector2d(acos(cubic.high), acos(cubic.low));
  });
}
