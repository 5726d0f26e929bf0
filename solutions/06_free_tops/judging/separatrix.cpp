#include "solutions/06_free_tops/shared.hpp"

namespace {

/// ω at t = 0 from T and L² of the start: two linear equations for the squares of the first and the third component.
Vector3d half_way(const Vector3d& I, double spin) {
  const Eigen::Matrix2d sums{{I[0], I[2]}, {I[0] * I[0], I[2] * I[2]}};
  const Vector2d squares = sums.inverse() * Vector2d(I[1], I[1] * I[1]);
  return spin * Vector3d(sqrt(squares[0]), 0, sqrt(squares[1]));
}

/// The motion with other functions in place of sech and tanh.
template <class Even, class Odd>
auto with_functions(const Even& even, const Odd& odd) {
  return [=](auto& I, auto spin, auto t) {
    const double angle = growth_rate(I, spin) * t;
    return even(angle) * half_way(I, spin) + spin * odd(angle) * y_axis;
  };
}

}  // namespace

void judge_separatrix(Lecture& lecture) {
  auto& e = lecture.exercise(&separatrix, {{"I", ascending_moments}, {"spin", positive(rad_per_s)}, {"t", second}},
                             {"omega", rad_per_s});
  e.domain([](auto& I, auto, auto) { return min(I[1] - I[0], I[2] - I[1]) >= 1e-3 * I[2]; });
  // In between, where tanh is almost 1, an answer that takes sech as the root of 1 − tanh² has lost half its digits.
  e.generated([](auto& I, auto spin, auto t) { return abs(growth_rate(I, spin) * abs(t) - 18) > 7; });
  e.worked("moments 1.2, 1.7, 2.6 shortly after", {1.2, 1.7, 2.6}, 1.5, 0.8);
  e.worked("the same before", {1.2, 1.7, 2.6}, 1.5, -3);
  e.special("half way", {1.2, 1.7, 2.6}, 1.5, 0);
  e.special("long after", {1.2, 1.7, 2.6}, 2, 3000);
  e.special("long before", {1.2, 1.7, 2.6}, 2, -1000);
  e.special("a flat body", {1, 2, 3}, 1, 1);
  e.special("moments close together", {1, 1.002, 1.005}, 1, 100);
  e.limit("long after", {0, 2, 0}, "It ends as a spin about the intermediate axis.");
  e.limit("long before", {0, -2, 0}, "It begins as the opposite spin about this axis.");
  e.random("a random body", 10, [](Random& random) {
    const Vector3d I = random.ascending_moments();
    const double spin = random.uniform(0.4, 3), angle = random.sign() * random.uniform(0.4, 2);
    return tuple{I, spin, angle / growth_rate(I, spin)};
  });
  e.scale([](auto&, auto spin, auto) { return spin; });
  e.sweep<2>({"The turning over: I = (1.2, 1.7, 2.6) kg m², spin 1.5 rad/s", "time (s)", "body component of ω (rad/s)"},
             {"omega_1", "omega_2", "omega_3"}, {-8, 8});

  e.wrong_output("Your ω₂ falls; Euler's second equation makes it grow where ω₁ and ω₃ are positive.", "time_reversed",
                 negate(1));
  e.wrong_output("The amplitudes of ω₁ and ω₃ are exchanged.", "amplitudes_exchanged", exchange(0, 2));
  e.wrong({"Your rate of turning over does not contain the spin; twice as fast, the body turns over in half the time.",
           "free_tops_growth"},
          "rate_without_spin", [](auto& I, auto spin, auto t) { return spin * separatrix(I, 1, t); });
  e.wrong({"Your growth rate divides by I₂; below the root stand the moments of the two other axes, I₁I₃.",
           "free_tops_growth"},
          "rate_over_I2", [](auto& I, auto spin, auto t) { return separatrix(I, spin, t * sqrt(I[0] * I[2]) / I[1]); });
  e.wrong("Your ω₁ and ω₃ fade twice as fast as they should; with that T and the length of L are not constant.",
          "sech_squared",
          with_functions([](double x) { return pow(std::cosh(x), -2); }, [](double x) { return std::tanh(x); }));
  e.wrong("These are sine and cosine, and the body would turn over again and again; on the separatrix it does so once.",
          "circle", with_functions([](double x) { return cos(x); }, [](double x) { return sin(x); }));
  const char* const energy = "free_tops_energy";
  e.conserves({"T keeps its value from the infinite past.", energy}, [](auto& I, auto...) { return I; });
  e.conserves({"L keeps its length from the infinite past.", energy},
              [](auto& I, auto...) { return Vector3d(I.cwiseAbs2()); });
  e.route("decaying exponentials", with_functions([](double x) { return 2 / (std::exp(-x) + std::exp(x)); },
                                                  [](double x) {
                                                    const double decayed = std::exp(-2 * abs(x));
                                                    return copysign((1 - decayed) / (1 + decayed), x);
                                                  }));
  e.route("ω₁ and ω₃ from T and L²", [](auto& I, auto spin, auto t) {
    const double share = std::tanh(growth_rate(I, spin) * t);
    return sqrt(1 - share * share) * half_way(I, spin) + spin * share * y_axis;
  });
  e.route("the direction on the separatrix, integrated", [](auto& I, auto spin, auto t) {
    // ω = half_way cos χ + spin ê₂ sin χ, and Euler's second equation is dχ/dt = σ cos χ.
    const double angle = clamp(growth_rate(I, spin) * t, -40.0, 40.0);
    const double chi = followed(0.0, angle, 8000, [](double now) { return cos(now); });
    return cos(chi) * half_way(I, spin) + spin * sin(chi) * y_axis;
  });
}
