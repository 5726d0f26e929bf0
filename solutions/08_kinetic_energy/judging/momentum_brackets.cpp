#include "solutions/08_kinetic_energy/shared.hpp"

namespace {

/// Columns Xᵢ(q) with L̃ᵢ = Xᵢ·p: the rates of the angles in a rotation about body axis i.
template <class Number>
Eigen::Matrix<Number, 3, 3> unit_rotations(const Eigen::Matrix<Number, 3, 1>& q) {
  return rate_axes(q).inverse();
}

/// ∂L̃/∂q by a complex step.
Matrix3d gradient_of_L(const Vector3d& q, const Vector3d& p) {
  const auto L = [&](const Eigen::Vector3cd& angles) { return L_of_momenta<Complex>(angles, p.cast<Complex>()); };
  return columns(derivative_along(q, x_axis, L), derivative_along(q, y_axis, L), derivative_along(q, z_axis, L));
}

}  // namespace

void judge_momentum_brackets(Lecture& lecture) {
  auto& e =
      lecture.exercise(&momentum_brackets, {{"angles", rad}, {"momenta", kg_m2_per_s}}, {"brackets", kg_m2_per_s});
  e.domain([](auto& q, auto&) { return abs(sin(q[1])) >= 0.05; });
  e.worked("the angles of the lecture", lecture_angles, {1.3, -0.4, 0.8});
  e.worked("θ < 0", {2, -1.2, 4}, {0.2, 0.5, -1});
  e.special("L = 0", lecture_angles, zero);
  e.special("L along ê₃", lecture_angles, {0.8 * cos(0.7), 0, 0.8});
  e.special("L along the line of nodes", lecture_angles, {0, 1.5, 0});
  e.special("sin θ = 0.1", {0.3, asin(0.1), 1.1}, {1.3, -0.4, 0.8});
  e.special("θ = π/2", {0.3, pi / 2, 1.1}, {1.3, -0.4, 0.8});
  e.limit("L = 0", Matrix3d::Zero(), "Each bracket is a component of L.");
  e.limit("L along ê₃", Matrix3d{{0, -0.8, 0}, {0.8, 0, 0}, {0, 0, 0}},
          "Only the bracket of the first two components is not zero, and on body axes it has the minus sign.");
  e.random("any attitude and momenta", 10, &Random::euler_angles, any::vector(2));
  e.scale([](auto& q, auto& p) { return or_one(L_of_momenta<double>(q, p).norm()); });
  e.tolerance(1e-8, "Derivatives by differences lose some digits.");
  e.sweep({"Brackets of the momenta (1.3, −0.4, 0.8) kg m²/s at every inclination", "θ (rad)", "bracket (kg m²/s)"},
          {{"{L̃₁, L̃₂}", 0, 1}, {"{L̃₂, L̃₃}", 1, 2}, {"{L̃₃, L̃₁}", 2, 0}}, {0.3, pi - 0.3},
          [](auto theta) { return tuple(Vector3d(0.3, theta, 1.1), Vector3d(1.3, -0.4, 0.8)); });

  e.wrong_output("The sign is that of the inertial components of L; on axes that turn with the body it is opposite.",
                 "inertial_sign", negated);
  e.wrong("These are brackets of the inertial components of L; asked for are those on the body's axes.",
          "inertial_components", [](auto& q, auto& p) -> Matrix3d { return -skew(L_inertial_of_momenta(q, p)); });
  e.wrong("The sign is right, and the components of L are the inertial ones; asked for are those on the body's axes.",
          "inertial_L", [](auto& q, auto& p) { return skew(L_inertial_of_momenta(q, p)); });
  e.wrong("The momenta stand where components of L belong; they are its projections on ê3⁰, ê2' and ê3.",
          "momenta_for_L", [](auto&, auto& p) { return skew(p); });
  e.wrong("All brackets are zero, as between two momenta; L̃ depends on the angles too.", "zero",
          [](auto&, auto&) -> Matrix3d { return Matrix3d::Zero(); });
  e.wrong(
      {"These are the brackets for z–x–z angles; here the line of nodes is the y' axis.", "kinetic_energy_conventions"},
      "zxz", [](auto& q, auto& p) {
        const Vector3d L = L_of_momenta<double>(q, p);
        return skew({L[1], -L[0], L[2]});
      });
  e.wrong("Only the first half of the bracket is there; the other is subtracted from it.", "first_half",
          [](auto& q, auto& p) { return gradient_of_L(q, p) * unit_rotations<double>(q); });
  e.wrong("The two halves of the bracket are added; the second is subtracted.", "halves_added", [](auto& q, auto& p) {
    const Matrix3d half = gradient_of_L(q, p) * unit_rotations<double>(q);
    return half + half.transpose();
  });
  e.wrong(
      "L̃ comes from the momenta as ω̃ comes from the rates; momenta belong to L̃ by another relation, to be solved for "
      "it.",
      "B_itself", [](auto& q, auto& p) { return skew(rate_axes(q) * p); });
  e.wrong_input<0>(phi_for_psi, "phi_for_psi", exchange(0, 2));
  e.angles_read_as_degrees("kinetic_energy_angles");
  const char* const far = "At thousands of radians a derivative by differences has too few digits left.";
  for (const char* bug : {"angles[1] limited to 1000", "angles[2] limited to 1000"}) e.survivor(bug, far);
  e.property(Is::antisymmetric,
             "A bracket changes its sign when its functions are exchanged: the matrix of brackets is antisymmetric.");
  e.route("derivatives by a complex step", [](auto& q, auto& p) {
    const Matrix3d half = gradient_of_L(q, p) * unit_rotations<double>(q);
    return half - half.transpose();
  });
  e.route("derivatives by differences", [](auto& q, auto& p) {
    constexpr double h = 1e-6;
    Matrix3d gradient, by_momenta;  // L̃ is linear in p
    for (int k = 0; k < 3; ++k) {
      const Vector3d ahead = q + h * Vector3d::Unit(k), behind = q - h * Vector3d::Unit(k);
      gradient.col(k) = (L_of_momenta<double>(ahead, p) - L_of_momenta<double>(behind, p)) / (2 * h);
      by_momenta.col(k) = L_of_momenta<double>(q, Vector3d::Unit(k));
    }
    const Matrix3d half = gradient * by_momenta.transpose();
    return half - half.transpose();
  });
  e.route("commutators of the rotations about the body axes", [](auto& q, auto& p) {
    Matrix3d brackets;
    for (int j = 0; j < 3; ++j) {
      const Vector3d along = unit_rotations<double>(q).col(j);
      brackets.col(j) = derivative_along(q, along, unit_rotations<Complex>).transpose() * p;
    }
    return brackets - brackets.transpose();
  });
  e.route("L in space, seen from the body",
          [](auto& q, auto& p) { return attitude(q).transpose() * skew(L_inertial_of_momenta(q, p)) * attitude(q); });
}
