#include "solutions/08_kinetic_energy/shared.hpp"

void judge_kinetic_energy_euler(Lecture& lecture) {
  auto& e = lecture.exercise(&kinetic_energy_euler, {{"I", positive(kg_m2)}, {"angles", rad}, {"rates", rad_per_s}},
                             {"T", joule});
  e.worked("moments 1, 2, 3 and the angles of the lecture", {1, 2, 3}, lecture_angles, lecture_rates);
  e.special("a symmetric top", {1, 1, 3}, lecture_angles, lecture_rates);
  e.special("no nutation", {1, 2, 3}, lecture_angles, {0.5, 0, 0.9});
  e.special("upright, θ = 0", {1, 2, 2.5}, {0.4, 0, 1.1}, lecture_rates);
  e.special("upside down, θ = π", {1, 2, 2.5}, {0.4, pi, 1.1}, lecture_rates);
  e.special("spin about the vertical undone, φ̇ = −ψ̇ at θ = 0", {1, 2, 2.5}, {0.4, 0, 1.1}, {0.5, 0, -0.5});
  e.special("at rest", {1, 2, 3}, lecture_angles, zero);
  e.random("a random body and motion", 16, &Random::principal_moments, &Random::euler_angles, any::vector(2));
  e.scale([](auto& I, auto&, auto& v) { return 0.5 * I.maxCoeff() * max(v.squaredNorm(), 1e-3); });
  e.sweep({"The body of moments 1, 2, 3 kg m² turns about its own axis by ψ, at constant rates", "ψ (rad)", "T (J)"},
          {"T"}, {0, 2 * pi}, turned_by_psi);

  // ω̃ᵢ is the sum of a part with φ̇ and another one; the terms are the squares and products of both, without signs.
  const auto part = [](int i, int power) {
    return [i, power](auto& I, auto& q, auto& v) {
      const double a = (i == 0 ? -1 : 1) * rate_axes(q)(i, 0) * v[0], b = omega_body(q, {0, v[1], v[2]})[i];
      return I[i] * pow(a, power) * pow(b, 2 - power);
    };
  };
  e.term("I₁ φ̇² sin²θ cos²ψ", 0.5, part(0, 2));
  e.term("I₁ φ̇ θ̇ sin θ sin ψ cos ψ", -1, part(0, 1));
  e.term("I₁ θ̇² sin²ψ", 0.5, part(0, 0));
  e.term("I₂ φ̇² sin²θ sin²ψ", 0.5, part(1, 2));
  e.term("I₂ φ̇ θ̇ sin θ sin ψ cos ψ", 1, part(1, 1));
  e.term("I₂ θ̇² cos²ψ", 0.5, part(1, 0));
  e.term("I₃ φ̇² cos²θ", 0.5, part(2, 2));
  e.term("I₃ φ̇ ψ̇ cos θ", 1, part(2, 1));
  e.term("I₃ ψ̇²", 0.5, part(2, 0));
  e.wrong_output("The factor ½ is missing: T = ½ Σ Iᵢ ω̃ᵢ².", "no_half", times(2));
  e.wrong_input<0>(exchanged_moments, "zxz_angles", exchange(0, 1));
  e.wrong(rates_as_components, "rates_as_components", [](auto& I, auto&, auto& v) { return energy(I, v); });
  e.wrong_terms(apart, "spin_and_precession_apart", {0.5, -1, 0.5, 0.5, 1, 0.5, 0.5, 0, 0.5});
  e.wrong_terms("Your third component is ψ̇ alone; the precession adds φ̇ cos θ to it.", "spin_only",
                {0.5, -1, 0.5, 0.5, 1, 0.5, 0, 0, 0.5});
  e.wrong_terms("The mixed terms in φ̇ θ̇ are missing: (a + b)² is more than a² + b².", "nutation_and_precession_apart",
                {0.5, 0, 0.5, 0.5, 0, 0.5, 0.5, 1, 0.5});
  e.wrong_terms("All products of two different rates are missing: (a + b)² is more than a² + b².", "no_mixed_terms",
                {0.5, 0, 0.5, 0.5, 0, 0.5, 0.5, 0, 0.5});
  e.wrong_input<0>(one_for_two, "symmetric_formula", first_for_second);
  e.wrong_terms("The two summands of your ω̃₁ have the wrong relative sign: it is −φ̇ sin θ cos ψ + θ̇ sin ψ.",
                "first_sign", {0.5, 1, 0.5, 0.5, 1, 0.5, 0.5, 1, 0.5});
  e.wrong_terms("The two summands of your ω̃₂ have the wrong relative sign: it is φ̇ sin θ sin ψ + θ̇ cos ψ.",
                "second_sign", {0.5, -1, 0.5, 0.5, -1, 0.5, 0.5, 1, 0.5});
  e.wrong_input<1>(mixed_signs, "mixed_signs", negate(1));
  e.wrong_input<1>("sin ψ and cos ψ are exchanged in your ω̃₁ and ω̃₂.", "sine_and_cosine_of_psi", complement_of(2));
  e.wrong("φ and ψ are exchanged in your ω, as in inertial components; the moments take the body's.",
          "inertial_components", [](auto& I, auto& q, auto& v) { return energy(I, attitude(q) * omega_body(q, v)); });
  e.wrong_input<1>(phi_for_psi, "phi_for_psi", exchange(0, 2));
  e.wrong_input<2>(rates_exchanged, "rates_exchanged", exchange(0, 2));
  e.wrong("φ̇ enters ω̃₁ and ω̃₂ without sin θ: only φ̇ sin θ lies across the body's axis.", "sine_of_theta_lost",
          [](auto& I, auto& q, auto& v) {
            return energy(I, omega_body(Vector3d(0, pi / 2, q[2]), v) + v[0] * cos(q[1]) * z_axis);
          });
  e.wrong_input<1>("sin θ and cos θ are exchanged in your ω.", "sine_and_cosine_of_theta", complement_of(1));
  e.angles_read_as_degrees();
  e.property(Is::nonnegative, "A kinetic energy is never negative.");
  e.route("half of p·q̇", [](auto& I, auto& q, auto& v) { return canonical_momenta(I, q, v).dot(v) / 2; });
  e.route("on inertial axes", [](auto& I, auto& q, auto& v) {
    const Matrix3d A = attitude(q);
    const Vector3d omega = v[0] * z_axis + v[1] * Vector3d(-sin(q[0]), cos(q[0]), 0) + v[2] * A.col(2);
    return 0.5 * omega.dot(A * I.asDiagonal() * A.transpose() * omega);
  });
  e.route("from the turning matrix", [](auto& I, auto& q, auto& v) {
    // Aᵀ dA/dt is the cross matrix of ω̃; each factor of A is differentiated in its turn.
    const Matrix3d first = turn(z_axis, q[0]), middle = turn(y_axis, q[1]), last = turn(z_axis, q[2]);
    const Matrix3d A_rate =
        first * (v[0] * skew(z_axis) * middle + v[1] * middle * skew(y_axis) + v[2] * middle * skew(z_axis)) * last;
    return energy(I, axial((first * middle * last).transpose() * A_rate));
  });
  e.route("by way of z–x–z angles", [](auto& I, auto& q, auto& v) {
    // There the line of nodes is the new x axis.
    const Vector3d omega = omega_body(Vector3d(q[0] + pi / 2, q[1], q[2] - pi / 2), v);
    return energy(I, Vector3d(omega[1], -omega[0], omega[2]));
  });
}
