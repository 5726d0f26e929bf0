#include "solutions/07_euler_angles/shared.hpp"

void judge_rotation_matrix(Lecture& lecture) {
  auto& e = lecture.exercise(&rotation_matrix, {{"angles", rad}}, {"R", none});
  e.worked("the angles of the lecture", example_angles);
  e.special("no turn at all", zero);
  e.special("θ = 0: the turns φ and ψ add up", {0.4, 0, 0.9});
  e.special("θ = π: upside down", {0.4, pi, 0.9});
  e.special("a quarter turn of each", Vector3d::Constant(pi / 2));
  e.special("a tiny θ", {-2.5, 1e-8, 0.3});
  e.special("more than a full turn", {7.5, 0.7, -8.2});
  e.random("any attitude", 8, &Random::euler_angles);
  e.scale(1);
  e.sweep({"R while θ grows, φ = 0.3, ψ = 1.1", "θ (rad)", "entry of R"}, {{"R_13", 0, 2}, {"R_31", 2}, {"R_33", 2, 2}},
          {-pi, 2 * pi}, [](auto theta) { return Vector3d(0.3, theta, 1.1); });

  e.wrong_input<0>("Your matrix is R_φ R_θ R_ψ; the first turn stands on the right: R_ψ R_θ R_φ.", "order_reversed",
                   exchange(0, 2));
  e.wrong_output("This is Rᵀ, from body to inertial components; V_body = R V_inertial.", "transposed", transposed);
  e.wrong_input<0>("All three turns go backwards: the slides' matrices are passive.", "active_turns", negated);
  e.wrong_input<0>("The middle turn goes backwards: R_θ has −sin θ at the upper right, sin θ at the lower left.",
                   "theta_negated", negate(1));
  e.wrong_input<0>("The turns φ and ψ go backwards: in R_φ and R_ψ the sine has a plus above the diagonal.",
                   "only_theta_right", [](auto& angles) { angles = Vector3d(-angles[0], angles[1], -angles[2]); });
  e.wrong(turned_about_x, "z_x_z", zxz);
  e.wrong(turned_about_x_last, "yaw_pitch_roll", zyx);
  e.wrong({"Your turns go about x, y and z; on the slides they go about z, y′ and z.", zxz_notes}, "space_fixed_x_y_z",
          [](auto& angles) { return about_z(angles[2]) * about_y(angles[1]) * about_x(angles[0]); });
  e.wrong_input<0>("φ does not enter: the first turn is missing.", "phi_left_out", zeroed(0));
  e.wrong_input<0>("ψ does not enter: the last turn is missing.", "psi_left_out", zeroed(2));
  e.angles_read_as_degrees(turns_notes);
  e.property(Is::rotation_matrix, "A rotation matrix has orthonormal columns and determinant +1.");
  e.route("a triad turned about its own axes", [](auto& q) -> Matrix3d { return turned_triad(q).transpose(); });
  e.route("a quaternion", [](auto& angles) { return body_to_inertial(angles).conjugate().toRotationMatrix(); });
  e.route("entry by entry", [](auto& angles) {
    const double cf = cos(angles[0]), ct = cos(angles[1]), cp = cos(angles[2]);
    const double sf = sin(angles[0]), st = sin(angles[1]), sp = sin(angles[2]);
    return Matrix3d{{cp * ct * cf - sp * sf, cp * ct * sf + sp * cf, -cp * st},
                    {-sp * ct * cf - cp * sf, -sp * ct * sf + cp * cf, sp * st},
                    {st * cf, st * sf, ct}};
  });
  e.route("z–x–z with its own angles", [](auto& angles) { return zxz(angles + Vector3d(pi / 2, 0, -pi / 2)); });
  e.survivor("return - Matrix3d", "This matrix is a factor twice.");
}
