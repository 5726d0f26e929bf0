#include "solutions/07_euler_angles/shared.hpp"

void judge_angle_between_attitudes(Lecture& lecture) {
  auto& e = lecture.exercise(&angle_between_attitudes, {{"angles1", rad}, {"angles2", rad}}, {"angle", rad});
  e.worked("from the attitude of the lecture", example_angles, {-0.4, 1.2, 2});
  e.worked("turns of 3 + 3: the short way back is 2π − 6", zero, {3, 0, 3});
  e.worked("1e-8 apart", example_angles, example_angles + Vector3d(1e-8, 0, 0));
  e.special("the same attitude with other angles", example_angles, {0.3 + pi, -0.7, 1.1 + pi});
  e.special("equal angles", example_angles, example_angles);
  e.special("half a turn", zero, {0, pi, 0.4});
  e.special("nearly half a turn", zero, {0, pi - 1e-8, 0.4});
  e.special("full turns more", example_angles, {7.5, 0.7, -8.2});
  e.special("only ψ differs", example_angles, {0.3, 0.7, 2.5});
  e.special("θ differs by 1e-7", example_angles, example_angles + Vector3d(0, 1e-7, 0));
  e.limit("equal angles", 0, "It is there already.");
  e.limit("half a turn", pi,
          "After a turn by π about axis 2 the last turn about axis 3 only chooses the axis of another half turn.");
  e.random("any two attitudes", 10, &Random::euler_angles, &Random::euler_angles);
  e.scale(1);
  e.sweep({"From no turn to (φ, 0.7, φ)", "φ (rad)", "angle (rad)"}, {"angle"}, {0, 2 * pi},
          [](auto angle) { return tuple(zero, Vector3d(angle, 0.7, angle)); });

  const auto of_trace = [](double trace) { return acos(clamp((trace - 1) / 2, -1.0, 1.0)); };
  e.wrong("This is the length of the difference of the angles; they turn about axes that are not at right angles.",
          "length_of_difference", [](auto& a, auto& b) { return (b - a).norm(); });
  e.wrong("This is the length of the difference of the angles; they turn about axes that are not at right angles.",
          "length_of_shortest_difference", [](auto& a, auto& b) {
            const auto wrapped = [](double angle) { return std::remainder(angle, 2 * pi); };
            return min((b - a).unaryExpr(wrapped).norm(), pi);
          });
  e.wrong("This is the angle between the two directions of axis 3; a turn about that axis counts too.", "axis_3_only",
          [](auto& a, auto& b) {
            const Vector3d one = turned_triad(a).col(2), other = turned_triad(b).col(2);
            return atan2(cross(one, other).norm(), one.dot(other));
          });
  e.wrong(
      "This is the largest angle through which one of the three axes turns; an axis that is not across that of the "
      "rotation turns through less than the rotation itself.",
      "largest_of_axes", [](auto& a, auto& b) {
        const Matrix3d one = turned_triad(a), other = turned_triad(b);
        double largest = 0;
        for (int i = 0; i < 3; ++i)
          largest = max(
              largest, atan2(cross(Vector3d(one.col(i)), Vector3d(other.col(i))).norm(), one.col(i).dot(other.col(i))));
        return largest;
      });
  e.wrong("This is the angle of one turn after the other; asked for is that between the two.", "not_transposed",
          [=](auto& a, auto& b) { return of_trace((rotation_matrix(b) * rotation_matrix(a)).trace()); });
  e.wrong_output("This is half of the angle: a quaternion holds cosine and sine of the half.", "half_angle",
                 times(0.5));
  e.wrong("Where your angle is larger than π, the rotation the other way round is shorter: q and −q are one attitude.",
          "long_way", [](auto& a, auto& b) {
            const Quaterniond q = body_to_inertial(b) * body_to_inertial(a).conjugate();
            return 2 * atan2(q.vec().norm(), q.w());
          });
  e.wrong("This is the sum of the turns in φ, θ and ψ; a single rotation is shorter.", "sum_of_turns",
          [](auto& a, auto& b) { return (b - a).cwiseAbs().sum(); });
  e.wrong_output("This is the cosine of the angle.", "cosine", [](auto& angle) { angle = cos(angle); });
  e.wrong_output("The angle comes in degrees; radians are asked for.", "in_degrees", times(1 / degree));
  e.angles_read_as_degrees(turns_notes);
  e.property(Is::nonnegative, "The smallest angle of a rotation lies between 0 and π.");
  e.route("quaternion from one attitude to the other", [](auto& a, auto& b) {
    const Quaterniond q = body_to_inertial(a).conjugate() * body_to_inertial(b);
    return 2 * atan2(q.vec().norm(), abs(q.w()));
  });
  e.route("half sum and half difference of two quaternions", [](auto& a, auto& b) {
    const Eigen::Vector4d p = body_to_inertial(a).coeffs(), q = body_to_inertial(b).coeffs();
    return 4 * atan2(min((p - q).norm(), (p + q).norm()), max((p - q).norm(), (p + q).norm()));
  });
  e.route("sine from the antisymmetric part, cosine from the trace", [](auto& a, auto& b) {
    const Matrix3d D = rotation_matrix(b).transpose() * rotation_matrix(a);
    return atan2(axial(D - D.transpose()).norm(), D.trace() - 1);
  });
  e.survivor("AngleAxisd( -q[1]", "Both attitudes are mirrored, and the angle between them stays.");
  e.survivor("- Vector3d::UnitY()", "Both attitudes are mirrored, and the angle between them stays.");
}
