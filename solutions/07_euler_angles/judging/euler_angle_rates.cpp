#include "solutions/07_euler_angles/shared.hpp"

void judge_euler_angle_rates(Lecture& lecture) {
  auto& e = lecture.exercise(&euler_angle_rates, {{"angles", angles_off_gimbal_lock}, {"omega_body", rad_per_s}},
                             {"rates", rad_per_s});
  const Vector3d omega0(0.7, -1.1, 0.4);
  e.worked("angles and rates of the lecture", example_angles, angular_velocity_body(example_angles, example_rates));
  e.special("at rest", example_angles, zero);
  e.special("θ = π/2", {0.4, pi / 2, 0.9}, omega0);
  e.special("θ negative", {0.4, -0.8, 0.9}, omega0);
  e.special("ψ = 0", {0.4, 0.8, 0}, omega0);
  e.special("a spin about ê₃ only", example_angles, {0, 0, 2});
  e.special("close to gimbal lock, θ = 0.001", {0.3, 1e-3, 1.1}, omega0);
  e.special("close to gimbal lock, θ = π − 0.001", {0.3, pi - 1e-3, 1.1}, omega0);
  e.random("any attitude and angular velocity", 8, &Random::euler_angles, any::vector(3));
  e.scale([](auto& q, auto& w) { return max(w.norm(), 1e-3) / abs(sin(q[1])); });
  e.sweep(
      {"Rates that one and the same ω demands: φ̇ and ψ̇ grow without bound at θ = 0 and π", "θ (rad)", "rate (rad/s)"},
      {"dφ/dt", "dθ/dt", "dψ/dt"}, {0.05, pi - 0.05},
      [](auto theta) { return tuple(Vector3d(0.3, theta, 1.1), Vector3d(-0.3, 0.2, 1.3)); });

  // The part of ω across the line of nodes, in the plane of ê₁ and ê₂: φ̇ sin θ.
  const auto across = [](const Vector3d& q, const Vector3d& w) { return -w[0] * cos(q[2]) + w[1] * sin(q[2]); };
  e.term("(−ω₁ cos ψ + ω₂ sin ψ)/sin θ in φ̇", 1, [=](auto& q, auto& w) { return across(q, w) / sin(q[1]) * x_axis; });
  e.term("ω₁ sin ψ + ω₂ cos ψ in θ̇", 1, [](auto& q, auto& w) { return w.dot(line_of_nodes(q[2])) * y_axis; });
  e.term("ω₃ in ψ̇", 1, [](auto&, auto& w) { return w[2] * z_axis; });
  e.term("cot θ (ω₁ cos ψ − ω₂ sin ψ) in ψ̇", 1, [=](auto& q, auto& w) { return -across(q, w) / tan(q[1]) * z_axis; });
  e.wrong("The transpose of the rate matrix stands for its inverse; its columns are not orthogonal.", "transposed",
          [](auto& q, auto& w) { return rates_to_omega(q).transpose() * w; });
  e.wrong("This is ω for rates that have the numbers of ω; asked for is the way back, from ω to the rates.",
          "not_inverted", angular_velocity_body);
  e.wrong_input<1>({"These are the rates of z–x–z angles; on the slides the line of nodes is the y′ axis.", zxz_notes},
                   "z_x_z", [](auto& w) { return turn(z_axis, pi / 2) * w; });
  e.wrong_terms("Your ψ̇ is ω₃, in which the turn about the vertical has a share: ψ̇ = ω₃ − φ̇ cos θ.",
                "spin_is_third_component", {1, 1, 1, 0});
  e.wrong_terms("In ψ̇ the term with cos θ has the wrong sign: ψ̇ = ω₃ − φ̇ cos θ.", "spin_plus", {1, 1, 1, -1});
  e.wrong_output("All of φ̇ is subtracted from ω₃ here; only its share along ê₃ counts: ψ̇ = ω₃ − φ̇ cos θ.",
                 "spin_without_cosine", [](auto& v, auto&, auto& w) { v[2] = w[2] - v[0]; });
  e.wrong_output("In ψ̇ stands tan θ where cot θ belongs.", "tangent",
                 [=](auto& v, auto& q, auto& w) { v[2] = w[2] - tan(q[1]) * across(q, w); });
  e.wrong_output("φ̇ is not divided by sin θ: only φ̇ sin θ shows across the line of nodes.", "sine_not_divided",
                 [=](auto& v, auto& q, auto& w) { v[0] = across(q, w); });
  e.wrong_output("φ̇ is not divided by sin θ, nor is its share in ψ̇.", "sine_not_divided_twice",
                 [=](auto& v, auto& q, auto& w) { v = Vector3d(across(q, w), v[1], w[2] - across(q, w) * cos(q[1])); });
  e.wrong_output("In φ̇ sin θ multiplies where it should divide.", "sine_multiplied",
                 [=](auto& v, auto& q, auto& w) { v[0] = across(q, w) * sin(q[1]); });
  e.wrong_output({"φ̇ has the wrong sign: ê₃⁰ has −sin θ cos ψ on ê₁.", vertical_notes}, "phi_rate_negated", negate(0));
  e.wrong_terms({"φ̇ has the wrong sign, and ψ̇ inherits it: the vertical has −sin θ cos ψ on ê₁.", vertical_notes},
                "phi_rate_negated_twice", {-1, 1, 1, -1});
  e.wrong_input<0>({"sin ψ and cos ψ are exchanged: at ψ = 0 θ̇ is ω₂.", nodes_notes}, "sine_and_cosine_of_psi",
                   complement_of(2));
  e.wrong_input<0>({"ψ enters with the wrong sign: the line of nodes is (sin ψ, cos ψ, 0).", nodes_notes},
                   "psi_backwards", negate(2));
  e.wrong_input<0>("φ stands where ψ belongs: the rates never depend on φ.", "phi_for_psi", exchange(0, 2));
  e.wrong_inputs({"ω counts as inertial components here; it comes on the body axes.", inertial_notes}, "inertial_omega",
                 [](auto& q, auto& w) { w = rotation_matrix(q) * w; });
  e.wrong({"This is ω itself; the rates belong to three other axes than the body's.", omega_notes}, "omega_unchanged",
          [](auto&, auto& w) { return w; });
  e.angles_read_as_degrees(turns_notes);
  e.route("solving B (rates) = ω", [](auto& q, auto& w) -> Vector3d { return solution_of(rates_to_omega(q), w); });
  e.route("the reciprocal triad", [](auto& q, auto& w) {
    const Matrix3d E = rates_to_omega(q);
    const Vector3d a = E.col(0), b = E.col(1), c = E.col(2);
    return columns(cross(b, c), cross(c, a), cross(a, b)).transpose() * w / a.dot(cross(b, c));
  });
  e.route("through inertial components", [](auto& q, auto& omega_body) {
    const Vector3d w = turned_triad(q) * omega_body;
    const double psi_rate = (w[0] * cos(q[0]) + w[1] * sin(q[0])) / sin(q[1]);
    return Vector3d(w[2] - psi_rate * cos(q[1]), -w[0] * sin(q[0]) + w[1] * cos(q[0]), psi_rate);
  });
}
