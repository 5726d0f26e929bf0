#include "solutions/07_euler_angles/shared.hpp"

void judge_angular_velocity_body(Lecture& lecture) {
  auto& e = lecture.exercise(&angular_velocity_body, {{"angles", rad}, {"rates", rad_per_s}}, {"omega", rad_per_s});
  add_angles_and_rates(e);
  e.sweep<0>({"ω seen from a body that spins about ê₃: θ = 0.7, rates 0.5, −0.2 and 0.9 rad/s", "ψ (rad)",
              "body component of ω (rad/s)"},
             {"ω_1", "ω_2", "ω_3"}, {0, 2 * pi}, [](auto psi) { return Vector3d(0.3, 0.7, psi); });

  e.term("φ̇ ê₃⁰", 1, [](auto& q, auto& v) { return v[0] * vertical_in_body(q[1], q[2]); });
  e.term("θ̇ ê₂′", 1, [](auto& q, auto& v) { return v[1] * line_of_nodes(q[2]); });
  e.term("ψ̇ ê₃", 1, [](auto&, auto& v) { return v[2] * z_axis; });
  e.wrong_output(omega_of_zxz, "z_x_z", quarter_turn);
  e.wrong({"This is ω for yaw, pitch and roll (z–y–x); on the slides the last turn is about z again.", zxz_notes},
          "yaw_pitch_roll", [](auto& q, auto& v) {
            return about_x(q[2]) * (v[0] * (about_y(q[1]) * z_axis) + v[1] * y_axis) + v[2] * x_axis;
          });
  e.wrong_inputs("φ and ψ are exchanged, as for turns in the order ψ, θ, φ; the turn φ comes first.", "order_reversed",
                 [](auto& q, auto& v) { q.reverseInPlace(), v.reverseInPlace(); });
  e.wrong_input<0>("φ stands where ψ belongs: body components never depend on φ.", "phi_for_psi", exchange(0, 2));
  e.wrong_output("Your third component is the inertial one, φ̇ + ψ̇ cos θ; on the body's axis it is φ̇ cos θ + ψ̇.",
                 "third_inertial", [](auto& omega, auto& q, auto& v) { omega[2] = v[0] + v[2] * cos(q[1]); });
  e.wrong({"These are the inertial components of ω; asked for are those on the body axes.", inertial_notes}, "inertial",
          angular_velocity_inertial);
  e.wrong_output("ω points the opposite way: (dR/dt) Rᵀ is the cross matrix of −ω.", "negated", negated);
  e.wrong("These are inertial components of −ω, as if R led from body to inertial components.", "negated_inertial",
          [](auto& q, auto& v) { return -angular_velocity_inertial(q, v); });
  e.wrong_output({"In ω₁ the term with φ̇ has the wrong sign: the vertical has −sin θ cos ψ on ê₁.", vertical_notes},
                 "first_sign", [](auto& w, auto& q, auto& v) { w[0] += 2 * v[0] * sin(q[1]) * cos(q[2]); });
  e.wrong_output({"In ω₁ the term with θ̇ has the wrong sign: the line of nodes has +sin ψ on ê₁.", nodes_notes},
                 "nodes_first_sign", [](auto& w, auto& q, auto& v) { w[0] -= 2 * v[1] * sin(q[2]); });
  e.wrong_input<0>({"sin ψ and cos ψ are exchanged: at ψ = 0 θ̇ stands in ω₂.", nodes_notes}, "sine_and_cosine_of_psi",
                   complement_of(2));
  e.wrong_input<0>({"sin θ and cos θ are exchanged: at θ = 0 φ̇ goes into ω₃.", vertical_notes},
                   "sine_and_cosine_of_theta", complement_of(1));
  e.wrong_output({"θ̇ goes along ê₂; its axis is ê₂′, before the turn ψ.", nodes_notes}, "theta_rate_along_body_axis",
                 [](auto& w, auto& q, auto& v) { w += v[1] * (y_axis - line_of_nodes(q[2])); });
  e.wrong_input<1>({"φ̇ goes along ê₃, but its axis is the vertical ê₃⁰.", vertical_notes}, "vertical_along_body_axis",
                   [](auto& v) { v = Vector3d(0, v[1], v[0] + v[2]); });
  e.wrong_input<0>({"ψ does not enter: this is before the last turn.", vertical_notes}, "psi_left_out", zeroed(2));
  e.wrong({"The vertical is written with ê₁ for ê₁′, which is cos ψ ê₁ − sin ψ ê₂.", vertical_notes},
          "vertical_with_unturned_axis", [](auto& q, auto& v) {
            return angular_velocity_body(q, v - v[0] * x_axis) + v[0] * vertical_in_body(q[1], 0);
          });
  e.wrong("These are the rates themselves, about three axes that are not the body's.", "rates_unchanged",
          [](auto&, auto& v) { return v; });
  e.angles_read_as_degrees(turns_notes);
  e.route("from Aᵀ dA/dt by differences",
          [](auto& q, auto& v) { return axial(rotation_matrix(q) * rate_along(q, v, turned_triad)); });
  e.route("from the rate of a quaternion", [](auto& q, auto& v) -> Vector3d {
    const Quaterniond rate(rate_along(q, v, [](const Vector3d& angles) { return body_to_inertial(angles).coeffs(); }));
    return 2 * (body_to_inertial(q).conjugate() * rate).vec();
  });
  e.route("the matrix of the three axes times the rates", [](auto& q, auto& v) { return rates_to_omega(q) * v; });
  e.route("R times the inertial components",
          [](auto& q, auto& v) { return rotation_matrix(q) * angular_velocity_inertial(q, v); });
}
