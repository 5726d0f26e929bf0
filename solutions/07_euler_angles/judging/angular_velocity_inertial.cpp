#include "solutions/07_euler_angles/shared.hpp"

void judge_angular_velocity_inertial(Lecture& lecture) {
  auto& e = lecture.exercise(&angular_velocity_inertial, {{"angles", rad}, {"rates", rad_per_s}}, {"omega", rad_per_s});
  add_angles_and_rates(e);
  e.sweep<0>({"ω seen from the inertial frame while the body goes round: θ = 0.7, rates 0.5, −0.2 and 0.9 rad/s",
              "φ (rad)", "inertial component of ω (rad/s)"},
             {"ω_x", "ω_y", "ω_z"}, {0, 2 * pi}, [](auto phi) { return Vector3d(phi, 0.7, 1.1); });

  const char* const shares[] = {"φ̇ ê₃⁰", "θ̇ ê₂′", "ψ̇ ê₃"};
  for (int i = 0; i < 3; ++i)
    e.term(shares[i], 1, [i](auto& q, auto& v) { return angular_velocity_inertial(q, v[i] * Vector3d::Unit(i)); });
  e.wrong("These are the body components of ω, not the inertial ones.", "body", angular_velocity_body);
  e.wrong("R is applied to the body components, but it leads to them; the way back is Rᵀ.", "not_transposed",
          [](auto& q, auto& v) { return rotation_matrix(q) * angular_velocity_body(q, v); });
  e.wrong("This is the body formula with φ and ψ exchanged; the first component changes its sign too.",
          "body_formula_exchanged", [](auto& q, auto& v) { return angular_velocity_body(q.reverse(), v.reverse()); });
  e.wrong_output("ω points the opposite way: Rᵀ (dR/dt) is the cross matrix of −ω.", "negated", negated);
  e.wrong("These are body components of −ω, as if R led from body to inertial components.", "negated_body",
          [](auto& q, auto& v) { return -angular_velocity_body(q, v); });
  e.wrong_output(omega_of_zxz, "z_x_z", quarter_turn);
  e.wrong_input<0>("ψ stands where φ belongs: inertial components never depend on ψ.", "psi_for_phi", exchange(0, 2));
  e.wrong_output("In the first component the term with θ̇ has the wrong sign: ê₂′ is (−sin φ, cos φ, 0).",
                 "nodes_first_sign", [](auto& w, auto& q, auto& v) { w[0] += 2 * v[1] * sin(q[0]); });
  e.wrong_input<0>("sin φ and cos φ are exchanged: at φ = 0 the line of nodes is the y axis.", "sine_and_cosine_of_phi",
                   complement_of(0));
  e.wrong_input<0>("The tilt goes the wrong way: ê₃ is (sin θ cos φ, sin θ sin φ, cos θ).", "theta_negated", negate(1));
  e.wrong_output("θ̇ goes along the fixed y axis, but its axis, the line of nodes, has turned by φ.",
                 "theta_rate_along_fixed_axis",
                 [](auto& w, auto& q, auto& v) { w += v[1] * Vector3d(sin(q[0]), 1 - cos(q[0]), 0); });
  e.wrong_input<1>("ψ̇ goes along the vertical, but its axis is the body's ê₃, which leans by θ.", "spin_along_vertical",
                   [](auto& v) { v = Vector3d(v[0] + v[2], v[1], 0); });
  e.wrong_output("In ω_z the factor cos θ stands at φ̇; the vertical is φ̇'s own axis, so cos θ belongs to ψ̇.",
                 "cosine_at_wrong_rate", [](auto& w, auto& q, auto& v) { w[2] = v[0] * cos(q[1]) + v[2]; });
  e.wrong({"These are the rates themselves, about three axes that are not the inertial ones.", omega_notes},
          "rates_unchanged", [](auto&, auto& v) { return v; });
  e.angles_read_as_degrees(turns_notes);
  e.route("from dA/dt Aᵀ by differences",
          [](auto& q, auto& v) { return axial(rate_along(q, v, turned_triad) * rotation_matrix(q)); });
  e.route("Rᵀ times the body components",
          [](auto& q, auto& v) { return rotation_matrix(q).transpose() * angular_velocity_body(q, v); });
  e.route("the axes of the turned triad", [](auto& q, auto& v) {
    return v[0] * z_axis + v[1] * turned_triad(Vector3d(q[0], 0, 0)).col(1) + v[2] * turned_triad(q).col(2);
  });
}
