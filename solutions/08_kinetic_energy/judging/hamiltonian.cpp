#include "solutions/08_kinetic_energy/shared.hpp"

namespace {

double energy_of_L(const Vector3d& I, const Vector3d& L) { return 0.5 * L.cwiseAbs2().cwiseQuotient(I).sum(); }

/// The energy of these body components of L.
template <class Function>
auto with_L(const Function& L) {
  return [L](const Vector3d& I, const Vector3d& q, const Vector3d& p) { return energy_of_L(I, L(q, p)); };
}

}  // namespace

void judge_hamiltonian(Lecture& lecture) {
  auto& e =
      lecture.exercise(&hamiltonian, {{"I", positive(kg_m2)}, {"angles", rad}, {"momenta", kg_m2_per_s}}, {"H", joule});
  e.domain([](auto&, auto& q, auto&) { return abs(sin(q[1])) >= 0.05; });
  e.worked("moments 1, 2, 3 and the angles of the lecture", {1, 2, 3}, lecture_angles, {1.3, -0.4, 0.8});
  e.special("a symmetric top", {2, 2, 3}, lecture_angles, {1.3, -0.4, 0.8});
  e.special("L along ê₃", {1, 2, 3}, lecture_angles, {0.8 * cos(0.7), 0, 0.8});
  e.special("θ = −2.9", {1, 2, 3}, {0.3, -2.9, 1.1}, {1.3, -0.4, 0.8});
  e.special("sin θ = 0.05", {1, 2, 2.7}, {0.3, asin(0.05) + 1e-12, 1.1}, {1.3, -0.4, 0.8});
  e.special("θ = π/2", {1, 2, 3}, {0.3, pi / 2, 1.1}, {1.3, -0.4, 0.8});
  e.special("only p_θ", {1, 2, 3}, lecture_angles, {0, -0.4, 0});
  e.special("at rest", {1, 2, 3}, lecture_angles, zero);
  e.limit("at rest", 0, "Without momenta nothing moves.");
  e.limit("L along ê₃", 0.8 * 0.8 / (2 * 3), "All of L lies on axis 3: the energy is L²/2I₃.");
  e.random("a random body and motion", 10, &Random::principal_moments, &Random::euler_angles, any::vector(2));
  e.scale([](auto& I, auto&, auto& p) { return or_one(0.5 * p.squaredNorm() / I.minCoeff()); });
  e.sweep({"H of given momenta (1.3, −0.4, 0.8) kg m²/s at every inclination", "θ (rad)", "H (J)"}, {"H"},
          {0.3, pi - 0.3},
          [](auto theta) { return tuple(Vector3d(1, 2, 3), Vector3d(0.3, theta, 1.1), Vector3d(1.3, -0.4, 0.8)); });

  const auto part = [](int i) {
    return [i](auto& I, auto& q, auto& p) { return pow(L_of_momenta<double>(q, p)[i], 2) / I[i]; };
  };
  e.term("the energy of the rotation about axis 1", 0.5, part(0));
  e.term("the energy of the rotation about axis 2", 0.5, part(1));
  e.term("the energy of the rotation about axis 3", 0.5, part(2));
  const char* const notes = "kinetic_energy_momenta";
  e.wrong("The momenta stand for components of L on the body's axes; they are its projections on ê3⁰, ê2' and ê3.",
          "momenta_as_body", with_L([](auto&, auto& p) { return p; }));
  e.wrong(
      {"L̃ comes from the momenta here as the rates come from ω̃; the matrix that takes momenta to L̃ is its transpose.",
       notes},
      "B_inverse", with_L([](auto& q, auto& p) { return rate_axes(q).inverse() * p; }));
  e.wrong({"L̃ comes from the momenta as ω̃ comes from the rates; momenta belong to L̃ by another relation, to be solved "
           "for it.",
           notes},
          "B_itself", with_L([](auto& q, auto& p) { return rate_axes(q) * p; }));
  e.wrong({"The relation that gives the momenta from L̃ is applied to the momenta; it must be solved for L̃.", notes},
          "B_transposed", with_L([](auto& q, auto& p) { return rate_axes(q).transpose() * p; }));
  e.wrong_input<0>(exchanged_moments, "zxz", exchange(0, 1));
  e.wrong("The mean of I₁ and I₂ stands for both; the energy depends on how they lie across the axis, by ψ.",
          "mean_moment", [](auto& I, auto& q, auto& p) {
            const double mean = (I[0] + I[1]) / 2;
            return hamiltonian(Vector3d(mean, mean, I[2]), q, p);
          });
  e.wrong("The whole of p_φ counts as momentum across the axis; a part of it belongs to L̃₃.", "no_coupling",
          with_L([](auto& q, auto& p) { return L_of_momenta<double>(q, p + p[2] * cos(q[1]) * x_axis); }));
  e.wrong("The part of p_φ that L̃₃ makes is added; it must be taken away.", "coupling_sign",
          with_L([](auto& q, auto& p) { return L_of_momenta<double>(q, p + 2 * p[2] * cos(q[1]) * x_axis); }));
  e.wrong("The sine of θ divides the part of L along ê₁′ once too often.", "sine_twice", with_L([](auto& q, auto& p) {
            const double across = (p[2] * cos(q[1]) - p[0]) / pow(sin(q[1]), 2);
            return Vector3d(across * cos(q[2]) + p[1] * sin(q[2]), -across * sin(q[2]) + p[1] * cos(q[2]), p[2]);
          }));
  e.wrong("Each momentum is divided by its own entry of the matrix of the energy; the whole matrix is to be inverted.",
          "diagonal_inverted", [](auto& I, auto& q, auto& p) {
            const Matrix3d B = rate_axes(q), M = B.transpose() * I.asDiagonal() * B;
            return 0.5 * p.cwiseAbs2().cwiseQuotient(M.diagonal()).sum();
          });
  e.wrong_terms("The factor one half is missing.", "no_half", {1, 1, 1});
  e.wrong("The moments multiply here, as they do with ω̃; these are squares of momenta.", "moments_multiply",
          [](auto& I, auto& q, auto& p) { return energy(I, L_of_momenta<double>(q, p)); });
  e.wrong({"Your energy is that of the rates (p_φ, p_θ, p_ψ); p are momenta.", notes}, "momenta_as_rates",
          [](auto& I, auto& q, auto& p) { return kinetic_energy_euler(I, q, p); });
  e.wrong_input<0>(one_for_two, "symmetric_formula", first_for_second);
  e.wrong(
      "The rates are those of the body, but the energy subtracted from momenta times rates is that of a symmetric one.",
      "symmetric_energy_subtracted", [](auto& I, auto& q, auto& p) {
        const Matrix3d B = rate_axes(q);
        const Vector3d rates = Matrix3d(B.transpose() * I.asDiagonal() * B).inverse() * p;
        return p.dot(rates) - kinetic_energy_euler({I[0], I[0], I[2]}, q, rates);
      });
  e.wrong_input<1>(phi_for_psi, "phi_for_psi", exchange(0, 2));
  e.angles_read_as_degrees("kinetic_energy_angles");
  e.property(Is::nonnegative, "A kinetic energy is never negative.");
  e.route("Legendre transformation with the matrix of the energy by differences", [](auto& I, auto& q, auto& p) {
    const auto T = [&](const Vector3d& rates) { return kinetic_energy_euler(I, q, rates); };
    const Vector3d rates = solution_of(2 * from_quadratic_form(T), p);
    return p.dot(rates) - T(rates);
  });
  e.route("L in space, seen from the body", [](auto& I, auto& q, auto& p) {
    return energy_of_L(I, attitude(q).transpose() * L_inertial_of_momenta(q, p));
  });
  e.route("the inverse of the matrix of the energy, entry by entry", [](auto& I, auto& q, auto& p) {
    // The inverse tensor on the axes ê1', ê2', ê3.
    const double s = sin(q[1]), across = (p[0] - p[2] * cos(q[1])) / s, sp = sin(q[2]), cp = cos(q[2]);
    const double along_first = cp * cp / I[0] + sp * sp / I[1], along_nodes = sp * sp / I[0] + cp * cp / I[1];
    const double mixed = sp * cp * (1 / I[1] - 1 / I[0]);
    return (across * across * along_first + p[1] * p[1] * along_nodes + p[2] * p[2] / I[2]) / 2 + across * p[1] * mixed;
  });
  e.survivor("- p_psi)", "L₃ is squared.");
}
