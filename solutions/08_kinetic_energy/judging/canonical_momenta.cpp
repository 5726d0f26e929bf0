#include "solutions/08_kinetic_energy/shared.hpp"

void judge_canonical_momenta(Lecture& lecture) {
  auto& e = lecture.exercise(&canonical_momenta, {{"I", positive(kg_m2)}, {"angles", rad}, {"rates", rad_per_s}},
                             {"p", kg_m2_per_s});
  e.worked("moments 1, 2, 3 and the angles of the lecture", {1, 2, 3}, lecture_angles, lecture_rates);
  e.special("a symmetric top", {1, 1, 3}, lecture_angles, lecture_rates);
  e.special("no nutation", {1, 2, 3}, lecture_angles, {0.5, 0, 0.9});
  e.special("upright, θ = 0: p_φ and p_ψ are one", {1, 2, 2.5}, {0.4, 0, 1.1}, lecture_rates);
  e.special("upside down, θ = π: p_φ = −p_ψ", {1, 2, 2.5}, {0.4, pi, 1.1}, lecture_rates);
  e.special("at rest", {1, 2, 3}, lecture_angles, zero);
  e.random("a random body and motion", 10, &Random::principal_moments, &Random::euler_angles, any::vector(2));
  e.scale([](auto& I, auto&, auto& v) { return I.maxCoeff() * max(v.norm(), 1e-3); });
  e.sweep({"Momenta while the body of moments 1, 2, 3 kg m² turns by ψ, at constant rates", "ψ (rad)",
           "momentum (kg m²/s)"},
          {"p_φ", "p_θ", "p_ψ"}, {0, 2 * pi}, turned_by_psi);

  const auto part = [](int i, int j) {
    return [i, j](auto& I, auto& q, auto& v) { return rate_axes(q)(i, j) * L_body(I, q, v)[i] * Vector3d::Unit(j); };
  };
  e.term("−L̃₁ sin θ cos ψ in p_φ", 1, part(0, 0));
  e.term("L̃₂ sin θ sin ψ in p_φ", 1, part(1, 0));
  e.term("L̃₃ cos θ in p_φ", 1, part(2, 0));
  e.term("L̃₁ sin ψ in p_θ", 1, part(0, 1));
  e.term("L̃₂ cos ψ in p_θ", 1, part(1, 1));
  e.term("L̃₃ in p_ψ", 1, part(2, 2));
  e.wrong("These are the components of L on the body's axes; the momenta are its components along ê3⁰, ê2' and ê3.",
          "body_components", L_body);
  e.wrong("These are the inertial components of L; the momenta are its components along ê3⁰, ê2' and ê3.",
          "inertial_components", [](auto& I, auto& q, auto& v) { return attitude(q) * L_body(I, q, v); });
  e.wrong("This is B⁻¹ L, which takes components apart along ê3⁰, ê2', ê3; p = Bᵀ L projects onto them.",
          "inverse_for_transpose", [](auto& I, auto& q, auto& v) {
            return abs(sin(q[1])) > 1e-9 ? rate_axes(q).inverse() * L_body(I, q, v) : zero;
          });
  e.wrong("This is B L; by the chain rule it is the transposed matrix, p = Bᵀ L.", "not_transposed",
          [](auto& I, auto& q, auto& v) { return rate_axes(q) * L_body(I, q, v); });
  e.wrong_input<0>(exchanged_moments, "zxz_angles", exchange(0, 1));
  e.wrong("Each moment multiplies one rate here; the momenta are derivatives of T, in which the rates mix.",
          "moment_times_rate", [](auto& I, auto&, auto& v) -> Vector3d { return I.cwiseProduct(v); });
  e.wrong_output(
      "This is half of each momentum, as when the factor ½ of T is still there; the derivative of a square brings a 2.",
      "half", times(0.5));
  e.wrong("Each of your momenta depends on its own rate only; the mixed terms of T add the others.", "diagonal_only",
          [](auto& I, auto& q, auto& v) -> Vector3d { return mass_matrix(I, q).diagonal().cwiseProduct(v); });
  e.wrong("Your ω̃₃ is ψ̇ alone; the precession adds φ̇ cos θ to it.", "spin_only", [](auto& I, auto& q, auto& v) {
    return rate_axes(q).transpose() * (L_body(I, q, v) - I[2] * v[0] * cos(q[1]) * z_axis);
  });
  e.wrong_terms("Your p_φ is L̃₃ cos θ alone; L across the body's axis has a vertical part as well.",
                "vertical_from_spin_only", {0, 0, 1, 1, 1, 1});
  e.wrong_input<0>(one_for_two, "symmetric_formula", first_for_second);
  e.wrong_output("The momenta come in the order ψ, θ, φ; asked for is (p_φ, p_θ, p_ψ).", "reversed_order", reversed);
  e.wrong_input<1>(phi_for_psi, "phi_for_psi", exchange(0, 2));
  e.wrong_input<1>(mixed_signs, "mixed_signs", negate(1));
  e.angles_read_as_degrees("kinetic_energy_angles");
  e.route("components of L in space", [](auto& I, auto& q, auto& v) {
    const Vector3d L = attitude(q) * L_body(I, q, v);
    return Vector3d(L.z(), -L.x() * sin(q[0]) + L.y() * cos(q[0]), L.dot(attitude(q).col(2)));
  });
  e.route("differences of the energy", [](auto& I, auto& q, auto& v) {
    return 2 * from_quadratic_form([&](const Vector3d& rates) { return kinetic_energy_euler(I, q, rates); }) * v;
  });
  e.route("matrix of the energy, entry by entry", [](auto& I, auto& q, auto& v) {
    const double s = sin(q[1]), c = cos(q[1]), sp = sin(q[2]), cp = cos(q[2]);
    const double mixed = (I[1] - I[0]) * s * sp * cp, nutation = I[0] * sp * sp + I[1] * cp * cp;
    const double precession = s * s * (I[0] + I[1] - nutation) + I[2] * c * c;
    const Matrix3d M{{precession, mixed, I[2] * c}, {mixed, nutation, 0}, {I[2] * c, 0, I[2]}};
    return M * v;
  });
}
