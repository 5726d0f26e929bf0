#include "solutions/07_euler_angles/shared.hpp"

namespace {

/// Entry by entry from R (inertial to body components); where ê₁ is vertical, the roll is put to zero.
Vector3d yaw_pitch_roll_of(const Matrix3d& R) {
  const double pitch = asin(clamp(-R(0, 2), -1.0, 1.0));
  if (hypot(R(0, 0), R(0, 1)) < 1e-8) return {atan2(-R(1, 0), R(1, 1)), pitch, 0};
  return {atan2(R(0, 1), R(0, 0)), pitch, atan2(R(1, 2), R(2, 2))};
}

double cosine_of_pitch(const Vector3d& q) { return hypot(cos(q[1]), sin(q[1]) * sin(q[2])); }

}  // namespace

void judge_yaw_pitch_roll(Lecture& lecture) {
  auto& e = lecture.exercise(&yaw_pitch_roll, {{"angles", rad}}, {"(yaw, pitch, roll)", rad});
  e.compare(attitude_by_yaw_pitch_roll);
  e.worked("the angles of the lecture", example_angles);
  e.worked("nose backwards", {2.8, -0.4, 5.1});
  e.special("θ = 0: all of it is yaw", {0.3, 0, 1.1});
  e.special("θ = π: upside down", {0.4, pi, 0.9});
  e.special("φ = ψ = 0: the pitch is θ", {0, 0.7, 0});
  e.special("no turn at all", zero);
  e.special("full turns more", {7.5, 0.7, -8.2});
  e.special("pitch −π/2", {0.3, pi / 2, pi});
  e.tolerance_of_last_case(1e-7, "At a pitch within 1e-3 of ±π/2 an arcsine loses up to half of its digits.");
  e.special("pitch +π/2", {0.3, pi / 2, 0});
  e.tolerance_of_last_case(1e-7);
  e.special("pitch nearly −π/2", {0.3, pi / 2 - 2e-5, pi});
  e.limit("θ = 0: all of it is yaw", {1.4, 0, 0}, "Both turns are about axis 3 and add up.");
  e.limit("φ = ψ = 0: the pitch is θ", {0, 0.7, 0}, "Both sequences have the turn about axis 2 in the middle.");
  e.tolerance_of_last_case(1e-7);
  e.random("any attitude", 8, [](Random& random) {
    Vector3d angles = random.euler_angles();
    while (cosine_of_pitch(angles) < 0.1) angles = random.euler_angles();
    return angles;
  });
  e.scale(1);
  e.sweep({"The nose rises with θ, φ = 0.3, ψ = 1.1", "θ (rad)", "angle (rad)"}, {"yaw", "pitch", "roll"}, {-pi, pi},
          [](auto theta) { return Vector3d(0.3, theta, 1.1); });

  e.wrong("These are the z–y–z angles themselves; yaw, pitch and roll are three other turns to the same attitude.",
          "unchanged", [](auto& q) { return q; });
  e.wrong("These are yaw, pitch and roll of the inverse rotation.", "transposed",
          [](auto& q) { return yaw_pitch_roll_of(turned_triad(q)); });
  e.wrong("These are roll first, then pitch, then yaw: turns about axes 1, 2 and 3; the yaw comes first.", "roll_first",
          [](auto& q) { return -yaw_pitch_roll_of(turned_triad(q)); });
  e.wrong_output("Your pitch has the wrong sign: a positive turn about axis 2 takes axis 1 towards −ê₃⁰.", "pitch_sign",
                 negate(1));
  e.wrong_output("Your pitch is never negative: an arccosine does not tell its sign, an arcsine does.", "pitch_size",
                 [](auto& a) { a[1] = abs(a[1]); });
  e.wrong_output("Your yaw has the wrong sign: a positive yaw takes axis 1 towards ê₂⁰.", "yaw_sign", negate(0));
  e.wrong_output("Your roll has the wrong sign: a positive roll takes axis 2 towards axis 3.", "roll_sign", negate(2));
  e.wrong_output("The angles come as (roll, pitch, yaw); asked for is (yaw, pitch, roll).", "order_of_result",
                 reversed);
  e.wrong_output(quadrant, "arctangent_for_yaw", [](auto& a) { a[0] = folded(a[0]); });
  e.wrong_output(quadrant, "arctangent_for_roll", [](auto& a) { a[2] = folded(a[2]); });
  e.wrong_output(quadrant, "arctangent_for_both", [](auto& a) { a = Vector3d(folded(a[0]), a[1], folded(a[2])); });
  e.wrong_inputs(turned_about_x, "zxz", [](auto& q) { q += Vector3d(-pi / 2, 0, pi / 2); });
  e.angles_read_as_degrees(turns_notes);
  e.route("arcsine and arctangents of entries of R", [](auto& q) { return yaw_pitch_roll_of(rotation_matrix(q)); });
  e.route("directions of nose and wing", [](auto& q) {
    const Matrix3d axes = turned_triad(q);
    const Vector3d nose = axes.col(0), wing = axes.col(1);
    const double yaw = atan2(nose.y(), nose.x());
    const Vector3d level(-sin(yaw), cos(yaw), 0);  // the wing before the roll
    return Vector3d(yaw, atan2(-nose.z(), hypot(nose.x(), nose.y())),
                    atan2(cross(level, wing).dot(nose), level.dot(wing)));
  });
  e.route("half angles of the quaternion", [](auto& angles) {
    const Quaterniond q = body_to_inertial(angles);
    const double half_sum = atan2(q.x() + q.z(), q.w() - q.y());  // of yaw and roll
    const double half_difference = atan2(q.z() - q.x(), q.w() + q.y());
    const double pitch = 2 * atan2(hypot(q.w() + q.y(), q.z() - q.x()), hypot(q.w() - q.y(), q.x() + q.z())) - pi / 2;
    return Vector3d(half_sum + half_difference, pitch, half_sum - half_difference);
  });
  e.route("Eigen's angles, with the pitch brought into its range", [](auto& q) {
    const Vector3d found = rotation_matrix(q).transpose().eulerAngles(2, 1, 0);
    const bool beyond = cos(found[1]) < 0;
    return beyond ? Vector3d(found[0] + pi, std::remainder(pi - found[1], 2 * pi), found[2] + pi) : found;
  });
  e.survivor("return - Matrix3d", "Two factors turn about z, so that the sign drops out.");
  e.survivor("return 2.0 * Matrix3d", "atan2 takes numbers of any common factor.");
  e.survivor("return 0.5 * Matrix3d", "atan2 takes numbers of any common factor.");
  e.survivor("about_y{{", "The last entry reaches the third row only, which is not used.");
  e.survivor("R = 2.0", "atan2 takes numbers of any common factor.");
  e.survivor("R = 0.5", "atan2 takes numbers of any common factor.");
  e.survivor("pitch = ", "Only the squares enter the root.");
  e.survivor("pitch_axis = ", "atan2 takes numbers of any common factor.");
}
