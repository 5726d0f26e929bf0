#include "solutions/09_heavy_top/shared.hpp"

namespace {

/// The spin up to which a condition holds that fails at great spins.
template <class Condition>
double largest_spin(double I1, double I3, double mgl, const Condition& wobbles) {
  double below = 0, above = 100 * sqrt(I1 * mgl) / I3;
  for (int i = 0; i < 100; ++i) {
    const double spin = (below + above) / 2;
    (wobbles(spin) ? below : above) = spin;
  }
  return below;
}

}  // namespace

void judge_sleeping_spin(Lecture& lecture) {
  auto& e =
      lecture.exercise(&sleeping_spin, {{"I1", positive(kg_m2)}, {"I3", positive(kg_m2)}, {"mgl", positive(joule)}},
                       {"omega", rad_per_s});
  e.domain([](auto I1, auto I3, auto) { return is_top(I1, I3); });
  e.worked("a small top", top_I1, top_I3, top_mgl);
  e.worked("the toy top of the lecture", 3.28e-4, 6.6e-5, 0.0456);
  e.special("a pencil on its tip", 1.2e-4, 5e-8, 0.006);
  e.special("a flat top", 2e-4, 3e-4, 0.03);
  e.special("equal moments", 3e-4, 3e-4, 0.05);
  e.random("any top", 8, [](Random& random) {
    const double I1 = random.uniform(1e-4, 6e-4), share = random.uniform(0.15, 0.8);
    return tuple{I1, I1 * (random.sign() > 0 ? share : 1.2 + share / 2), random.uniform(0.02, 0.1)};
  });
  e.sweep<1>({"Tops of 4·10⁻⁴ kg m² across the axis, mgl = 0.06 J", "I₃ (kg m²)", "spin (rad/s)"}, {"omega"},
             {4e-5, 8e-4});

  e.wrong_output("This is half of the spin: with it small tilts still grow.", "no_two", times(0.5));
  e.wrong("This is the rate √(mgl/I₁) at which a top without spin begins to fall, or swings when it hangs.", "pendulum",
          [](auto I1, auto, auto mgl) { return sqrt(mgl / I1); });
  e.wrong_inputs("I₁ and I₃ are exchanged.", "moments_exchanged", first_two_exchanged);
  e.wrong("½ I₃ω² = mgl stands here; no energy decides, but the curvature of the effective potential at θ = 0.",
          "energy_argument", [](auto, auto I3, auto mgl) { return sqrt(2 * mgl / I3); });
  e.wrong("The difference of I₁ and I₃ stands where I₁ belongs, as when ψ̇ is taken for the spin.", "psi_rate",
          [](auto I1, auto I3, auto mgl) { return 2 * sqrt(abs(I1 - I3) * mgl) / I3; });
  e.wrong_output("This is the square of the spin.", "squared", [](auto& spin) { spin *= spin; });
  e.wrong_output("This is in turns per second; radians per second are asked for.", "turns", times(0.5 / pi));
  e.wrong("This is the angular momentum of the spin, not the spin.", "momentum",
          [](auto I1, auto, auto mgl) { return 2 * sqrt(I1 * mgl); });
  e.property(Is::nonnegative, "The spin is asked for with the positive sign.");
  e.route("curvature of the effective potential", [](auto I1, auto I3, auto mgl) {
    return largest_spin(I1, I3, mgl, [&](double spin) {
      const double p = I3 * spin, tilt = 1e-6;  // cos θ by half angles: nothing cancels
      const double rise = pow(p * tan(tilt / 2), 2) / (2 * I1), fall = 2 * mgl * pow(sin(tilt / 2), 2);
      return rise < fall;
    });
  });
  e.route("growth of a small tilt", [](auto I1, auto I3, auto mgl) {
    // z = θ e^{iφ} obeys z̈ = i (I₃ω/I₁) ż + (mgl/I₁) z.
    const double rate = sqrt(mgl / I1);
    return largest_spin(I1, I3, mgl, [&](double spin) {
      const double turning = I3 * spin / (2 * I1);  // e^{λt} with λ = i·turning ± root
      return sqrt(max(rate * rate - turning * turning, 0.0)) > 1e-6 * rate;
    });
  });
  e.route("the least spin of all steady precessions", [](auto I1, auto I3, auto mgl) {
    // The spin that a precession at the rate Ω needs is (I₁Ω + mgl/Ω)/I₃ for a small tilt.
    const auto needed = [&](double log_rate) {
      const double rate = sqrt(mgl / I1) * std::exp(log_rate);
      return (I1 * rate + mgl / rate) / I3;
    };
    double slow = -1.1, fast = 1.3;
    for (int i = 0; i < 100; ++i) {
      const double third = (fast - slow) / 3;
      if (needed(slow + third) > needed(fast - third)) {
        slow += third;
      } else {
        fast -= third;
      }
    }
    return needed((slow + fast) / 2);
  });
}
