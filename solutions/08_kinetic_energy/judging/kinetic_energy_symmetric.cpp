#include "solutions/08_kinetic_energy/shared.hpp"

/// T from the components of ω across the symmetry axis, of the nutation, and along it.
template <class Components>
static auto of_components(const Components& components) {
  return [components](auto I1, auto I3, auto theta, auto& v) {
    return energy({I1, I1, I3}, components(sin(theta), cos(theta), v));
  };
}

void judge_kinetic_energy_symmetric(Lecture& lecture) {
  auto& e = lecture.exercise(&kinetic_energy_symmetric,
                             {{"I1", positive(kg_m2)}, {"I3", positive(kg_m2)}, {"theta", rad}, {"rates", rad_per_s}},
                             {"T", joule});
  e.worked("moments 2 and 3", 2, 3, 0.7, lecture_rates);
  e.special("a sphere", 2, 2, 0.7, lecture_rates);
  e.special("upright, θ = 0", 2, 3, 0, lecture_rates);
  e.special("upside down, θ = π", 2, 3, pi, lecture_rates);
  e.special("lying, θ = π/2", 2, 3, pi / 2, lecture_rates);
  e.special("a needle, I₃ = I₁/1000", 2, 0.002, 0.7, lecture_rates);
  e.special("at rest", 2, 3, 0.7, zero);
  e.random("a random top and motion", 10, [](Random& random) {
    const double I1 = random.uniform(1, 3);
    const double flatness = random.sign() > 0 ? random.uniform(1.2, 1.9) : random.uniform(0.3, 0.8);
    return tuple{I1, flatness * I1, random.euler_angles()[1], random.vector(2.0)};
  });
  e.scale([](auto I1, auto I3, auto, auto& v) { return 0.5 * max(I1, I3) * max(v.squaredNorm(), 1e-3); });
  e.sweep({"A top with I₁ = 2, I₃ = 3 kg m² at every inclination, at the same rates", "θ (rad)", "T (J)"}, {"T"},
          {0, pi}, [](auto theta) { return tuple(2, 3, theta, Vector3d(1.5, 0.8, 0.6)); });

  e.term("I₁ φ̇² sin²θ", 0.5, [](auto I1, auto, auto theta, auto& v) { return I1 * pow(v[0] * sin(theta), 2); });
  e.term("I₁ θ̇²", 0.5, [](auto I1, auto, auto, auto& v) { return I1 * v[1] * v[1]; });
  e.term("I₃ φ̇² cos²θ", 0.5, [](auto, auto I3, auto theta, auto& v) { return I3 * pow(v[0] * cos(theta), 2); });
  e.term("I₃ φ̇ ψ̇ cos θ", 1, [](auto, auto I3, auto theta, auto& v) { return I3 * v[0] * v[2] * cos(theta); });
  e.term("I₃ ψ̇²", 0.5, [](auto, auto I3, auto, auto& v) { return I3 * v[2] * v[2]; });
  e.wrong_output("The factor ½ is missing.", "no_half", times(2));
  e.wrong("φ̇² enters without sin²θ: only φ̇ sin θ lies across the symmetry axis.", "sine_forgotten",
          of_components([](auto, auto c, auto& v) { return Vector3d(v[0], v[1], v[0] * c + v[2]); }));
  e.wrong_output(
      "sin θ enters once; φ̇ sin θ is squared as a whole, so it is φ̇² sin²θ.", "sine_not_squared",
      [](auto& T, auto I1, auto, auto theta, auto& v) { T += 0.5 * I1 * v[0] * v[0] * sin(theta) * (1 - sin(theta)); });
  e.wrong_terms("Your third component is ψ̇; the precession adds φ̇ cos θ.", "spin_only", {0.5, 0.5, 0, 0, 0.5});
  e.wrong("cos²θ stands with φ̇² in the I₁ term; across the symmetry axis lies φ̇ sin θ.", "cosine_in_first_term",
          of_components([](auto, auto c, auto& v) { return Vector3d(v[0] * c, v[1], v[0] * c + v[2]); }));
  e.wrong_input<2>("sin θ and cos θ are exchanged.", "sine_and_cosine", complement);
  e.wrong("Your third component is φ̇ + ψ̇; only φ̇ cos θ of the precession lies along the symmetry axis.",
          "cosine_forgotten",
          of_components([](auto s, auto, auto& v) { return Vector3d(v[0] * s, v[1], v[0] + v[2]); }));
  e.wrong_terms(apart, "spin_and_precession_apart", {0.5, 0.5, 0.5, 0, 0.5});
  e.wrong_terms("φ̇ cos θ and ψ̇ are subtracted; both count in the same sense about the body's axis.",
                "spin_against_precession", {0.5, 0.5, 0.5, -1, 0.5});
  e.wrong_inputs("I₁ and I₃ are exchanged.", "moments_exchanged", first_two_exchanged);
  e.wrong_terms("The term ½ I₁ θ̇² is missing.", "nutation_lost", {0.5, 0, 0.5, 1, 0.5});
  e.wrong("sin²θ multiplies θ̇² too; it belongs to φ̇² only.", "sine_with_nutation",
          of_components([](auto s, auto c, auto& v) { return Vector3d(v[0] * s, v[1] * s, v[0] * c + v[2]); }));
  e.wrong(rates_as_components, "rates_as_components", of_components([](auto, auto, auto& v) { return v; }));
  e.wrong_input<3>(rates_exchanged, "rates_exchanged", exchange(0, 2));
  e.angles_read_as_degrees();
  e.property(Is::nonnegative, "A kinetic energy is never negative.");
  e.route("the general formula with some φ and ψ", [](auto I1, auto I3, auto theta, auto& v) {
    return kinetic_energy_euler(Vector3d(I1, I1, I3), Vector3d(0.4, theta, 2.3), v);
  });
  e.route("length of ω", [](auto I1, auto I3, auto theta, auto& v) {
    // |ω|² of any body needs no attitude but the angle between the axes of φ̇ and ψ̇.
    const double squared = v.squaredNorm() + 2 * v[0] * v[2] * cos(theta), along = v[0] * cos(theta) + v[2];
    return 0.5 * I1 * squared + 0.5 * (I3 - I1) * along * along;
  });
  e.route("half of p·q̇", [](auto I1, auto I3, auto theta, auto& v) {
    const double p_psi = I3 * (v[2] + v[0] * cos(theta));
    const double p_phi = I1 * pow(sin(theta), 2) * v[0] + p_psi * cos(theta);
    return (p_phi * v[0] + I1 * v[1] * v[1] + p_psi * v[2]) / 2;
  });
  e.survivor("theta_rate = - rates", "Only its square enters.");
  e.survivor("double across", "Only its square enters.");
}
