#include "solutions/09_heavy_top/shared.hpp"

namespace {

/// The body components of L at ψ = 0 and p_θ = 0.
Vector3d L_at_limit(double p_phi, double p_psi, double theta) {
  return L_of_momenta<double>(Vector3d(0, theta, 0), Vector3d(p_phi, 0, p_psi));
}

}  // namespace

static void add_routes_of_effective_potential(auto& e) {
  e.route("rates from the momenta, then the energy",
          [](auto I1, auto I3, auto mgl, auto p_phi, auto p_psi, auto theta) {
            const Vector3d q(0, theta, 0), I(I1, I1, I3);
            const Vector3d rates = solution_of(mass_matrix<double>(I, q), Vector3d(p_phi, 0, p_psi));
            return 0.5 * rates.dot(mass_matrix<double>(I, q) * rates) + mgl * cos(theta);
          });
  e.route("L² over the moments", [](auto I1, auto I3, auto mgl, auto p_phi, auto p_psi, auto theta) {
    return 0.5 * L_at_limit(p_phi, p_psi, theta).cwiseAbs2().cwiseQuotient(Vector3d(I1, I1, I3)).sum() +
           mgl * cos(theta);
  });
  e.route("the length of L, and what the axis has more",
          [](auto I1, auto I3, auto mgl, auto p_phi, auto p_psi, auto theta) {
            const double L2 = L_at_limit(p_phi, p_psi, theta).squaredNorm();
            return L2 / (2 * I1) + p_psi * p_psi * (1 / I3 - 1 / I1) / 2 + mgl * cos(theta);
          });
}

void judge_effective_potential(Lecture& lecture) {
  auto& e = lecture.exercise(&effective_potential,
                             {{"I1", positive(kg_m2)},
                              {"I3", positive(kg_m2)},
                              {"mgl", positive(joule)},
                              {"p_phi", kg_m2_per_s},
                              {"p_psi", kg_m2_per_s},
                              {"theta", positive(rad)}},
                             {"U", joule});
  e.domain([](auto I1, auto I3, auto, auto, auto, auto theta) { return is_top(I1, I3) && theta < pi - 1e-9; });
  e.worked("a small top", top_I1, top_I3, top_mgl, 0.012, 0.0137, 0.6);
  e.special("nearly upright", top_I1, top_I3, top_mgl, 0.0137, 0.0137, 1e-3);
  e.special("without momenta: a pendulum at rest", top_I1, top_I3, top_mgl, 0, 0, 2);
  e.special("without spin", top_I1, top_I3, top_mgl, 0.01, 0, 1.2);
  e.special("axis horizontal", top_I1, top_I3, top_mgl, -0.002, 0.0137, pi / 2);
  e.special("released with the axis at rest", top_I1, top_I3, top_mgl, 0.0137 * cos(0.6), 0.0137, 0.6);
  e.random("any top", 10, [](Random& random) {
    const double I1 = random.uniform(1e-4, 6e-4), mgl = random.uniform(0.02, 0.1), size = sqrt(I1 * mgl);
    const double theta = random.uniform(0.3, 1.2) + (random.sign() > 0 ? 0 : 1.6);
    return tuple{I1,
                 I1 * random.uniform(0.3, 1.5),
                 mgl,
                 random.sign() * size * random.uniform(0.5, 2),
                 random.sign() * size * random.uniform(0.5, 2),
                 theta};
  });
  e.scale([](auto I1, auto I3, auto mgl, auto p_phi, auto p_psi, auto theta) {
    return pow(abs(p_phi) + abs(p_psi), 2) / (2 * I1 * pow(sin(theta), 2)) + p_psi * p_psi / (2 * I3) + mgl;
  });
  e.sweep<5>({"A small top with p_φ = 0.012 and p_ψ = 0.0137 kg m²/s", "θ (rad)", "U (J)"}, {"U"}, {0.3, 1.2});

  e.term("(p_φ − p_ψ cos θ)²/(I₁ sin²θ)", 0.5, [](auto I1, auto, auto, auto p_phi, auto p_psi, auto theta) {
    return pow((p_phi - p_psi * cos(theta)) / sin(theta), 2) / I1;
  });
  e.term("p_ψ²/I₃", 0.5, [](auto, auto I3, auto, auto, auto p_psi, auto) { return p_psi * p_psi / I3; });
  e.term("mgl cos θ", 1, [](auto, auto, auto mgl, auto, auto, auto theta) { return mgl * cos(theta); });
  e.wrong_terms("The energy p_ψ²/(2I₃) of the spin is missing; all of the kinetic energy is asked for.",
                "no_spin_energy", {0.5, 0, 1});
  e.wrong_terms("The potential energy has the wrong sign: it is largest where the axis points upwards.", "weight_sign",
                {0.5, 0.5, -1});
  e.wrong_terms("This is the kinetic energy alone; the top has a weight too.", "no_weight", {0.5, 0.5, 0});
  e.wrong_terms("The factor ½ of the kinetic energy is missing.", "no_half", {1, 1, 1});
  e.wrong_inputs({"p_φ and p_ψ are exchanged.", "heavy_top_conserved"}, "momenta_exchanged",
                 [](auto&, auto&, auto&, auto& p_phi, auto& p_psi, auto&) { swap(p_phi, p_psi); });
  e.wrong({"p_ψ − p_φ cos θ stands where p_φ − p_ψ cos θ belongs.", "heavy_top_conserved"}, "exchanged_in_bracket",
          [](auto I1, auto I3, auto mgl, auto p_phi, auto p_psi, auto theta) {
            return effective_potential(I1, I3, mgl, p_psi, p_phi, theta) + (p_psi * p_psi - p_phi * p_phi) / (2 * I3);
          });
  e.wrong({"p_φ stands alone over sin θ; its part p_ψ cos θ belongs to the spin.", "heavy_top_conserved"},
          "no_coupling", [](auto I1, auto I3, auto mgl, auto p_phi, auto p_psi, auto theta) {
            return effective_potential(I1, I3, mgl, p_phi + p_psi * cos(theta), p_psi, theta);
          });
  e.wrong_input<3>("The part p_ψ cos θ of p_φ is added; it must be subtracted, or a momentum has the wrong sign.",
                   "coupling_sign", negated);
  e.wrong("The energy across the axis is divided by sin θ here; it is sin²θ.", "sine_not_squared",
          [](auto I1, auto I3, auto mgl, auto p_phi, auto p_psi, auto theta) {
            return effective_potential(I1 / sin(theta), I3, mgl, p_phi, p_psi, theta);
          });
  e.wrong_inputs("I₁ and I₃ are exchanged.", "moments_exchanged", first_two_exchanged);
  const char* const close =
      "A linear system for the rates, a right way to them, has no digits left so close to the vertical.";
  for (const char* bug : {"|theta| below 1e-06 taken for zero", "|theta| below 1e-09 taken for zero"})
    e.survivor(bug, close);
  e.survivor("std::sin( -theta)", "The quotient is squared.");
  e.angles_read_as_degrees();
  add_routes_of_effective_potential(e);
}
