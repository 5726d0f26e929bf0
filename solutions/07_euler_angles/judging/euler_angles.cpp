#include "solutions/07_euler_angles/shared.hpp"

static void add_routes_of_euler_angles(auto& e) {
  e.route("Eigen's angles of the transpose, with θ brought into its range", [](auto& R) {
    const Vector3d q = R.transpose().eulerAngles(2, 1, 2);
    return q[1] < 0 ? Vector3d(q[0] + pi, -q[1], q[2] + pi) : q;
  });
  e.route("arccosine, and φ = 0 where sin θ vanishes", [](auto& R) {
    const double theta = acos(clamp(R(2, 2), -1.0, 1.0));
    if (hypot(R(2, 0), R(2, 1)) < 1e-12) return Vector3d(0, theta, atan2(R(0, 1), R(1, 1)));
    return Vector3d(atan2(R(2, 1), R(2, 0)), theta, atan2(R(1, 2), -R(0, 2)));
  });
  e.route("half angles of the quaternion", [](auto& R) {
    const Quaterniond q(Matrix3d(R.transpose()));
    const double half_sum = atan2(q.z(), q.w()), half_difference = atan2(q.x(), q.y());  // of ψ and φ
    const double theta = 2 * atan2(hypot(q.x(), q.y()), hypot(q.z(), q.w()));
    return Vector3d(half_sum - half_difference, theta, half_sum + half_difference);
  });
  e.route("with full turns more", [](auto& R) {
    const Vector3d q = euler_angles(R);
    return Vector3d(q[0] - 2 * pi, q[1], q[2] + 4 * pi);
  });
  e.survivor("& R = ", "Angles follow from ratios of the entries.");
  e.survivor("std::hypot(", "hypot depends on no sign.");
  e.survivor("nodes = ", "Only its direction counts.");
}

void judge_euler_angles(Lecture& lecture) {
  auto& e = lecture.exercise(&euler_angles, {{"R_body_from_inertial", rotation}}, {"angles", rad});
  e.compare(attitude_by_angles);
  e.worked("θ beyond a right angle", rotation_matrix({0.3, 2.4, 1.1}));
  e.worked("φ beyond a right angle", rotation_matrix({2, 0.7, 1.1}));
  e.worked("ψ beyond a right angle", rotation_matrix({0.4, 0.9, -2.5}));
  e.special("no turn at all", Matrix3d::Identity());
  e.special("θ = 0: a turn about the vertical, only φ + ψ counts", about_z(0.9));
  e.special("θ = 0: nearly a quarter turn about the vertical", about_z(pi / 2 - 4e-7));
  e.special("θ = π: upside down, only ψ − φ counts", about_z(0.4) * Vector3d(-1, 1, -1).asDiagonal());
  e.special("R₁₁ nearly 0", rotation_matrix({0.7, 1.2, atan(cos(1.2) / tan(0.7)) - 5e-7}));
  e.special("θ = π/2", rotation_matrix({0.4, pi / 2, -2.9}));
  e.special("φ = ψ = 0", rotation_matrix({0, 1.2, 0}));
  e.special("a tiny φ", rotation_matrix({1e-7, 1.2, 0.4}));
  e.special("θ = 1e-8", rotation_matrix({0.3, 1e-8, 1.1}));
  e.tolerance_of_last_case(1e-7, "At θ within 1e-8 of 0 or π an arccosine loses half of its digits.");
  e.special("θ = π − 1e-8", rotation_matrix({0.3, pi - 1e-8, 1.1}));
  e.tolerance_of_last_case(1e-7);
  e.special("θ = 0 up to rounding", about_z(0.9) + Matrix3d{{0, 0, -4e-17}, {0, 0, -1e-17}, {3e-17, -2e-17, 0}});
  e.tolerance_of_last_case(1e-7);
  e.special("R₃₃ larger than 1 by rounding", about_z(0.9) + Matrix3d{{0, 0, 0}, {0, 0, 0}, {0, 0, 2.3e-16}});
  e.tolerance_of_last_case(1e-7);
  e.random("any attitude", 8, [](auto& random) { return rotation_matrix(random.euler_angles()); });
  e.scale(1);
  e.sweep({"A steady turn about an axis almost level: φ and ψ leap where θ is nearly 0 or π", "angle turned (rad)",
           "Euler angle (rad)"},
          {"φ", "θ", "ψ"}, {-1, 4}, [](auto angle) { return turn(Vector3d(0.4, 1, 0.06), -angle); });

  // All wrong answers but one start from the right angles and spoil them, so they are defined at θ = 0 too.
  const Sentence corner = "θ is taken from R₁₃ here, which is −sin θ cos ψ; only R₃₃ = cos θ holds θ alone.";
  const Sentence exchanged = "φ and ψ are exchanged: φ stands in the third row of R, ψ in the third column.";
  const Sentence phi_from_column = "φ is taken from the third column of R, which holds ψ; φ stands in the third row.";
  const auto arcsine = [](auto x) { return asin(clamp(x, -1.0, 1.0)); };
  e.wrong_output("An arcsine finds θ up to π/2; θ runs to π, and its cosine R₃₃ decides.", "theta_by_arcsine",
                 [](auto& q, auto& R) { q[1] = asin(min(1.0, hypot(R(2, 0), R(2, 1)))); });
  e.wrong_output(corner, "theta_from_corner", [=](auto& q, auto& R) { q[1] = arcsine(R(0, 2)); });
  e.wrong_output(corner, "theta_from_corner_negated", [=](auto& q, auto& R) { q[1] = -arcsine(R(0, 2)); });
  e.wrong({"These are yaw, pitch and roll (z–y–x); on the slides the last turn is about z again.", zxz_notes},
          "yaw_pitch_roll",
          [=](auto& R) { return Vector3d(atan2(R(0, 1), R(0, 0)), -arcsine(R(0, 2)), atan2(R(1, 2), R(2, 2))); });
  e.wrong_output(exchanged, "exchanged", exchange(0, 2));
  e.wrong_output(exchanged, "exchanged_sign_lost", [](auto& q) { q = Vector3d(pi - q[2], q[1], q[0]); });
  e.wrong_output(phi_from_column, "phi_from_column", [](auto& q) { q[0] = q[2]; });
  e.wrong_output(phi_from_column, "phi_from_column_sign_lost", [](auto& q) { q[0] = pi - q[2]; });
  e.wrong_output("ψ is taken from the third row of R here, which holds φ; ψ stands in the third column.",
                 "psi_from_row", [](auto& q) { q[2] = q[0]; });
  e.wrong_output("These are the angles of Rᵀ, as if R led from body to inertial components.", "transposed",
                 [](auto& q) { q = -q.reverse().eval(); });
  e.wrong_output("All angles have the wrong sign: the slides' turns are passive, Eigen's active.", "negated", negated);
  e.wrong_output("Your ψ is π minus the right one: R₁₃ is −sin θ cos ψ, so ψ = atan2(R₂₃, −R₁₃).", "psi_sign_lost",
                 [](auto& q) { q[2] = pi - q[2]; });
  e.wrong_output("Your ψ has the wrong sign: R₂₃ is +sin θ sin ψ.", "psi_negated", negate(2));
  e.wrong_output("Your φ has the wrong sign: R₃₂ is +sin θ sin φ.", "phi_negated", negate(0));
  e.wrong_output("Your angles give R with sin θ negated: φ = atan2(R₃₂, R₃₁), ψ = atan2(R₂₃, −R₁₃).",
                 "sine_of_theta_negated", negate(1));
  e.wrong_output("The sine comes first in atan2(y, x): yours gives π/2 − φ and π/2 − ψ.", "atan2_arguments",
                 [](auto& q) { q = Vector3d(pi / 2 - q[0], q[1], pi / 2 - q[2]); });
  e.wrong_output(quadrant, "arctangent_for_phi", [](auto& q) { q[0] = folded(q[0]); });
  e.wrong_output(quadrant, "arctangent_for_psi", [](auto& q) { q[2] = folded(q[2]); });
  e.wrong_output(quadrant, "arctangent_for_both", [](auto& q) { q = Vector3d(folded(q[0]), q[1], folded(q[2])); });
  e.wrong_output({"These are z–x–z angles; on the slides the middle turn is about y′.", zxz_notes}, "z_x_z",
                 [](auto& q) { q += Vector3d(pi / 2, 0, -pi / 2); });
  e.wrong_output({"Your angles come in degrees; radians are asked for.", turns_notes}, "in_degrees", times(1 / degree));
  add_routes_of_euler_angles(e);
}
