#include "solutions/05_euler_equations/shared.hpp"

void judge_euler_equations_general(Lecture& lecture) {
  auto& e = lecture.exercise(&euler_equations_general,
                             {{"I", regular_tensor}, {"omega", rad_per_s}, {"torque", newton_metre}},
                             {"omega_rate", rad_per_s2});
  e.worked("the four masses of lecture 03 under a torque", tensor_of_four_masses, example_omega, example_torque);
  e.special("principal axes", tensor_of_example, example_omega, example_torque);
  e.special("no torque", tensor_of_four_masses, example_omega, zero);
  e.special("a sphere", tensor_of_sphere, example_omega, example_torque);
  e.special("a body at rest, no torque", tensor_of_four_masses, zero, zero);
  e.special("just the torque that holds the rotation", tensor_of_four_masses, example_omega, {3.58, 3.42, -0.78});
  e.random("a random body", 10, &Random::inertia_tensor, any::vector(2), any::vector(4));
  e.scale([](auto& I, auto& w, auto& tau) {
    return max((tau.norm() + I.norm() * w.squaredNorm()) * Matrix3d(I.inverse()).norm(), 1e-3);
  });
  e.sweep({"The four masses, turning free of torque: ω goes round in the xy plane, |ω| = 1 rad/s",
           "angle of ω from the x axis (rad)", "rate of ω (rad/s²)"},
          {"dω_x/dt", "dω_y/dt", "dω_z/dt"}, {0, 6.3},
          [](auto angle) { return tuple(tensor_of_four_masses, in_xy_plane(angle), zero); });

  e.term("I⁻¹ τ", 1, [](auto& I, auto&, auto& tau) { return I.inverse() * tau; });
  e.term("I⁻¹ (ω × L)", -1, [](auto& I, auto& w, auto&) { return I.inverse() * cross(w, I * w); });
  e.wrong_terms({gyration_sign, rate_notes}, "sign_of_gyration", {1, 1});
  e.wrong_terms({gyration_missing, rate_notes}, "no_gyration", {1, 0});
  e.wrong(products_missing, "diagonal_formula",
          [](auto& I, auto& w, auto& tau) { return euler_equations(I.diagonal(), w, tau); });
  e.wrong_output(inertia_not_divided, "not_divided", [](auto& rate, auto& I, auto&, auto&) { return I * rate; });
  e.wrong("The inverse of I stands before the torque only; it belongs before all of τ − ω × (Iω).",
          "gyration_not_divided",
          [](auto& I, auto& w, auto& tau) -> Vector3d { return I.inverse() * tau - cross(w, I * w); });
  e.wrong_output("The diagonal entries of I divide here; with products of inertia the three equations are coupled.",
                 "divided_by_diagonal",
                 [](auto& rate, auto& I, auto&, auto&) -> Vector3d { return (I * rate).cwiseQuotient(I.diagonal()); });
  e.wrong("Your L in ω × L leaves out the products of inertia: L = Iω takes the whole tensor.", "diagonal_momentum",
          [](auto& I, auto& w, auto& tau) { return I.inverse() * (tau - cross(w, diagonal_part(I) * w)); });
  e.wrong("These are Euler's equations with principal moments; ω and τ come on other axes.", "moments_for_tensor",
          [](auto& I, auto& w, auto& tau) { return euler_equations(PrincipalFrame(I).moments, w, tau); });
  for (const bool right_handed : {false, true})
    e.wrong(
        "ω is put on the principal axes here and the torque is not; all vectors of Euler's equations are on these "
        "axes.",
        right_handed ? "torque_on_given_axes_right_handed" : "torque_on_given_axes",
        [=](auto& I, auto& w, auto& tau) -> Vector3d {
          const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(I);
          Matrix3d axes = solver.eigenvectors();
          if (right_handed) axes.col(2) = axes.col(0).cross(axes.col(1));
          const Vector3d on_axes = axes.transpose() * w;
          const Vector3d& moments = solver.eigenvalues();
          return axes * (tau - axes.determinant() * cross(on_axes, L_of(moments, on_axes))).cwiseQuotient(moments);
        });
  e.wrong_input<0>(products_sign, "products_flipped", products_flipped);
  e.wrong_terms(torque_missing, "no_torque", {0, -1});
  e.wrong_terms(torque_sign, "sign_of_torque", {-1, -1});
  e.wrong_output("I multiplies here where its inverse should: I stands before dω/dt in I dω/dt = τ − ω × (Iω).",
                 "multiplied", [](auto& rate, auto& I, auto&, auto&) { return I * (I * rate); });
  e.route("on principal axes and back", [](auto& I, auto& w, auto& tau) {
    const auto [moments, axes] = PrincipalFrame(I);
    return axes * euler_equations(moments, axes.transpose() * w, axes.transpose() * tau);
  });
  e.route("by the inverse matrix", [](auto& I, auto& w, auto& tau) { return I.inverse() * (tau + cross(I * w, w)); });
  e.route("by Cramer's rule", [](auto& I, auto& w, auto& tau) {
    Vector3d rate;
    for (int j = 0; j < 3; ++j) {
      Matrix3d replaced = I;
      replaced.col(j) = tau - cross(w, I * w);
      rate[j] = replaced.determinant() / I.determinant();
    }
    return rate;
  });
  e.route("by a pivoted decomposition", [](auto& I, auto& w, auto& tau) -> Vector3d {
    return solution_of(I, tau) - solution_of(I, cross(w, I * w));
  });
}
