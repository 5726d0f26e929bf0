#include "solutions/01_frame_derivatives/shared.hpp"

void judge_angular_velocity_of_basis(Lecture& lecture) {
  auto& e = lecture.exercise(&angular_velocity_of_basis, {{"E", rotation}, {"E_rate", per_s}}, {"omega", rad_per_s});
  e.domain([](auto& E, auto& rate) {
    const Matrix3d W = rate * E.transpose();
    return (W + W.transpose()).norm() <= 1e-9 * W.norm();
  });
  const char* const notes = "frame_derivatives_cross";
  const auto turning = [](const Matrix3d& E, const Vector3d& omega) { return tuple{E, skew(omega) * E}; };
  const Matrix3d E0 = example_basis, half_turn = turn(y_axis, pi);
  e.worked("the basis of the lecture", E0, skew(example_omega) * E0);
  e.special("the basis stands along the inertial axes", Matrix3d::Identity(), skew(example_omega));
  e.special("no rotation", E0, Matrix3d::Zero());
  e.special("the basis turns about its own first vector", E0, skew(2 * E0.col(0)) * E0);
  e.special("after half a turn about y", half_turn, skew(example_omega) * half_turn);
  e.random("a random basis and angular velocity", 8, [turning](auto& random) {
    const Matrix3d basis = random.rotation();
    return turning(basis, random.vector(3.0));
  });
  e.scale([](auto&, auto& rate) { return or_one(rate.norm()); });
  e.sweep(
      {"A basis that turns about ever other axes: ω = (cos α, sin α, 0.5) rad/s", "α (rad)", "component of ω (rad/s)"},
      {"ω_x", "ω_y", "ω_z"}, {0, 2 * pi},
      [turning](auto angle) { return turning(turn(Vector3d::Ones(), 1), Vector3d(cos(angle), sin(angle), 0.5)); });

  const char* const products[] = {"e₁ × ė₁", "e₂ × ė₂", "e₃ × ė₃"};
  for (int i = 0; i < 3; ++i)
    e.term(products[i], 0.5, [i](auto& E, auto& rate) { return cross(E.col(i), rate.col(i)); });
  e.wrong("These are the components of ω on the basis E itself; asked for are the inertial ones.", "body_components",
          [](auto& E, auto& rate) { return axial(E.transpose() * rate); });
  e.wrong_output("Your ω has the wrong sign: it is Ė Eᵀ (not E Ėᵀ), and e × ė (not ė × e).", "sign", negated);
  e.wrong_terms("Your ω is twice too large: the sum counts each component twice, it lies across two of the vectors.",
                "no_half", {1, 1, 1});
  e.wrong_output("Your ω is half of what it should be; a single entry of Ė Eᵀ already is a whole component of ω.",
                 "half_too_much", times(0.5));
  e.wrong("These are the components of −ω on the basis E itself; asked for are the inertial ones of ω.",
          "body_components_backwards", [](auto& E, auto& rate) { return -axial(E.transpose() * rate); });
  e.wrong_terms("This is e₁ × ė₁ alone, which lacks the turning about e₁ itself.", "first_column_only", {1, 0, 0});
  e.wrong_output({"ω_y has the wrong sign: row x, column z of Ė Eᵀ holds +ω_y.", notes}, "omega_y_sign", negate(1));
  e.wrong_output({"ω_x and ω_z are exchanged: in Ė Eᵀ rows and columns x and y hold ω_z.", notes},
                 "order_of_components", reversed);
  e.wrong("This is read off Ė E; the inverse of E is needed there, which is its transpose.", "no_transpose",
          [](auto& E, auto& rate) { return axial(rate * E); });
  e.wrong("This is read off Ė itself, which is [ω]× only if the basis stands along the inertial axes.",
          "rate_as_matrix", [](auto&, auto& rate) { return axial(rate); });
  e.wrong("These are the speeds of the tips of the three basis vectors; they are no components of ω.",
          "speed_of_columns", [](auto&, auto& rate) -> Vector3d { return rate.colwise().norm().transpose(); });
  e.route("read off Ė Eᵀ", [](auto& E, auto& rate) { return axial(rate * E.transpose()); });
  e.route("least squares", [](auto& E, auto& rate) {
    // ė = ω × e = −[e]× ω: nine equations for three unknowns, and so −Σ [e]² ω = Σ e × ė.
    return tensor_of_moment(E * E.transpose()).inverse() * (2 * axial_part(rate * E.transpose()));
  });
  e.route("components on the basis first", [](auto& E, auto& rate) {
    return E * Vector3d(rate.col(1).dot(E.col(2)), rate.col(2).dot(E.col(0)), rate.col(0).dot(E.col(1)));
  });
  e.route("with the inverse", [](auto& E, auto& rate) { return axial_part(rate * E.inverse()); });
}
