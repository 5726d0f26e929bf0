#include "solutions/08_kinetic_energy/shared.hpp"

namespace {

Matrix3d mass_matrix_derivative(const Vector3d& I, const Vector3d& q, const Vector3d& v) {
  return derivative_along(q, v, [&](auto&& angles) { return mass_matrix(I, angles); });
}

Vector3d omega_rate(const Vector3d& I, const Vector3d& q, const Vector3d& v) {
  return cross(L_body(I, q, v), omega_body(q, v)).cwiseQuotient(I);
}

/// B⁻¹ (ω̇ − Ḃ q̇) with ω̇ and Ḃ made from rates of one's own.
Vector3d solve(const Vector3d& q, const Vector3d& rate_of_omega, const Vector3d& rates_of_axes, const Vector3d& v) {
  return rate_axes(q).inverse() * (rate_of_omega - derivative_along(q, rates_of_axes, rate_axes<Complex>) * v);
}

/// M⁻¹ (∂T/∂q − Ṁ q̇) with factors of one's own.
auto lagrange(const Vector3d& gradient_factors, double rate_factor) {
  return [=](const Vector3d& I, const Vector3d& q, const Vector3d& v) {
    Vector3d gradient;
    for (int i = 0; i < 3; ++i) gradient[i] = 0.5 * v.dot(mass_matrix_derivative(I, q, Vector3d::Unit(i)) * v);
    return mass_matrix(I, q).inverse() *
           (gradient_factors.cwiseProduct(gradient) - rate_factor * mass_matrix_derivative(I, q, v) * v);
  };
}

}  // namespace

void judge_euler_angle_accelerations(Lecture& lecture) {
  auto& e = lecture.exercise(&euler_angle_accelerations,
                             {{"I", positive(kg_m2)}, {"angles", angles_off_gimbal_lock}, {"rates", rad_per_s}},
                             {"accelerations", rad_per_s2});
  e.worked("moments 1, 2, 3 and the angles of the lecture", {1, 2, 3}, lecture_angles, lecture_rates);
  e.special("a symmetric top", {2, 2, 3}, lecture_angles, lecture_rates);
  e.special("a sphere: ω stays, the angles do not", {2, 2, 2}, lecture_angles, lecture_rates);
  const double spin = 2 * cos(0.6) * (1 - 1.8) / 1.8;  // I₁ φ̇ cos θ = I₃ (φ̇ cos θ + ψ̇)
  e.special("steady precession of a symmetric top", {1, 1, 1.8}, {0.3, 0.6, 1.1}, {2, 0, spin});
  e.special("spin about a principal axis", {1, 2, 2.5}, {0.3, pi / 2, 0}, {-2, 0, 0});
  e.special("all angles small", {1, 2, 2.5}, {3e-4, 8e-4, 2e-4}, lecture_rates);
  e.special("near the singular direction", {1, 2, 2.5}, {0.3, 0.02, 1.1}, lecture_rates);
  e.random("a random body and motion", 10, &Random::principal_moments, &Random::euler_angles, any::vector(2));
  // φ̈ and ψ̈ grow as 1/sin θ towards the singular direction, and may cancel there.
  e.scale([](auto&, auto& q, auto& v) { return v.squaredNorm() / abs(sin(q[1])); });
  e.sweep({"The free body of moments 1, 2, 3 kg m² at every inclination, at the same rates", "θ (rad)",
           "acceleration (rad/s²)"},
          {"φ̈", "θ̈", "ψ̈"}, {0.3, pi - 0.3},
          [](auto theta) { return tuple(Vector3d(1, 2, 3), Vector3d(0.3, theta, 1.1), lecture_rates); });

  const char* const notes = "kinetic_energy_lagrange";
  e.term("B⁻¹ ω̇", 1, [](auto& I, auto& q, auto& v) { return solve(q, omega_rate(I, q, v), zero, v); });
  e.term("B⁻¹ Ḃ q̇", -1, [](auto&, auto& q, auto& v) { return -solve(q, zero, v, v); });
  e.wrong_terms("This solves ω̇ = B q̈; B depends on the angles: ω̇ = B q̈ + Ḃ q̇.", "turning_axes_lost", {1, 0});
  e.wrong_terms("Ḃ q̇ enters with the wrong sign: B q̈ = ω̇ − Ḃ q̇.", "turning_axes_added", {1, 1});
  e.wrong_terms("ω is held constant in the body here; without torque it still changes, by Euler's equations.",
                "omega_held", {0, -1});
  e.wrong_terms("Your accelerations vanish; no torque keeps L constant, not the rates of the angles.", "zero", {0, 0});
  e.wrong("This is ω̇ on the body's axes, not the second derivatives of the angles.", "omega_rate", omega_rate);
  e.wrong_terms("Your ω̇ has the wrong sign: without torque I·ω̇ = −ω × (I·ω).", "gyroscopic_sign", {-1, -1});
  e.wrong("−ω × L stands here for ω̇; each component must still be divided by its moment.", "not_divided_by_moments",
          [](auto& I, auto& q, auto& v) { return solve(q, I.cwiseProduct(omega_rate(I, q, v)), v, v); });
  e.wrong_output("Bᵀ stands here for the inverse of B, whose columns are not orthogonal.", "transpose_for_inverse",
                 [](auto& a, auto&, auto& q, auto&) { a = rate_axes(q).transpose() * (rate_axes(q) * a); });
  e.wrong_input<0>(exchanged_moments, "zxz_angles", exchange(0, 1));
  e.wrong_input<1>(phi_for_psi, "phi_for_psi", exchange(0, 2));
  e.wrong_input<0>(one_for_two, "symmetric_formula", first_for_second);
  e.wrong({"The term Ṁ q̇ is missing: p = M(q) q̇, so ṗ = M q̈ + Ṁ q̇.", notes}, "mass_matrix_held",
          lagrange({1, 1, 1}, 0));
  e.wrong({"∂T/∂q is missing, as if all angles were cyclic; only φ is.", notes}, "all_angles_cyclic",
          lagrange(zero, 1));
  e.wrong({"∂T/∂ψ is missing; ψ is cyclic only where I₁ = I₂.", notes}, "psi_cyclic", lagrange({1, 1, 0}, 1));
  e.wrong({"∂T/∂q enters with the wrong sign: ṗ = +∂T/∂q.", notes}, "gradient_sign", lagrange({-1, -1, -1}, 1));
  e.wrong("In Ḃ only ψ changes; its entries depend on θ too.", "nutation_of_axes_lost",
          [](auto& I, auto& q, auto& v) { return solve(q, omega_rate(I, q, v), v[2] * z_axis, v); });
  e.wrong("In Ḃ only θ changes; its entries depend on ψ too.", "spin_of_axes_lost",
          [](auto& I, auto& q, auto& v) { return solve(q, omega_rate(I, q, v), v[1] * y_axis, v); });
  e.survivor("angles[2] taken modulo π",
             "Half a turn about axis 3 changes no moment: at thousands of turns, digits alone.");
  e.angles_read_as_degrees("kinetic_energy_angles");
  e.route("Lagrange's equations", lagrange({1, 1, 1}, 1));
  e.route("L stays in space", [](auto& I, auto& q, auto& v) {
    // q̇ = B⁻¹ I⁻¹ Aᵀ L with constant L, differentiated along the motion by a complex step.
    const Vector3d L = attitude(q) * L_body(I, q, v);
    return derivative_along(q, v, [&](const Eigen::Vector3cd& ahead) {
      const Complex s = sin(ahead[1]), c = cos(ahead[1]), sp = sin(ahead[2]), cp = cos(ahead[2]);
      const Complex along = cos(ahead[0]) * L.x() + sin(ahead[0]) * L.y();
      const Complex across = -sin(ahead[0]) * L.x() + cos(ahead[0]) * L.y();
      const Complex first = c * along - s * L.z();  // L on the axes before ψ turns them
      const Eigen::Vector3cd on_body(cp * first + sp * across, -sp * first + cp * across, s * along + c * L.z());
      return rate_axes(ahead).inverse() * on_body.cwiseQuotient(I.template cast<Complex>());
    });
  });
  e.route("B and its derivative as matrices",
          [](auto& I, auto& q, auto& v) { return solve(q, omega_rate(I, q, v), v, v); });
}
