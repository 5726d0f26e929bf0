#include "solutions/07_euler_angles/shared.hpp"

namespace {

VectorXd scalar_first(const Quaterniond& q) { return VectorXd{{q.w(), q.x(), q.y(), q.z()}}; }

}  // namespace

void judge_attitude_quaternion(Lecture& lecture) {
  auto& e = lecture.exercise(&attitude_quaternion, {{"angles", rad}}, {"(w, x, y, z)", none});
  e.compare(up_to_sign);
  e.worked("the angles of the lecture", example_angles);
  e.worked("w < 0", {2.8, -0.4, 5.1});
  e.special("half a turn about ê₂", {0, pi, 0});
  e.special("w = 0 at θ = 0.7", {0.5, 0.7, pi - 0.5});
  e.special("no turn at all", zero);
  e.special("θ = 0: the turns φ and ψ add up", {0.3, 0, 1.1});
  e.special("θ = π: upside down", {0.4, pi, 0.9});
  e.special("φ = ψ: x vanishes", {0.6, 1.2, 0.6});
  e.special("a tiny θ", {-2.5, 1e-8, 0.3});
  e.special("more than a full turn", {7.5, 0.7, -8.2});
  e.limit("no turn at all", Eigen::Vector4d(1, 0, 0, 0), "The cosine of half of no angle is 1.");
  e.limit("half a turn about ê₂", Eigen::Vector4d(0, 0, 1, 0),
          "Half of the angle is a right angle: its cosine is 0, and its sine stands on axis 2.");
  e.random("any attitude", 8, &Random::euler_angles);
  e.scale(1);
  e.sweep({"The quaternion while θ grows, φ = 0.3, ψ = 1.1", "θ (rad)", "part of the quaternion"}, {"w", "x", "y"},
          {0, 2 * pi}, [](auto theta) { return Vector3d(0.3, theta, 1.1); });

  const auto conjugated = [](auto& q) { q.template tail<3>() *= -1; };
  e.wrong_output("This is the conjugate: it carries the body axes back into the inertial ones.", "conjugate",
                 conjugated);
  e.wrong_output("The scalar part w comes last here, as in Eigen's coeffs(); asked for is (w, x, y, z).", "scalar_last",
                 [](auto& q) {
                   q = VectorXd{{q[1], q[2], q[3], q[0]}};
                 });
  e.wrong_input<0>("φ and ψ are exchanged: the turn φ, the first, stands on the left of the product.", "order_reversed",
                   exchange(0, 2));
  e.wrong_input<0>("Whole angles stand in the cosines and sines; a quaternion has half of each angle.", "whole_angles",
                   times(2));
  e.wrong_input<0>("Your angles are halved twice.", "quarter_angles", times(0.5));
  e.wrong_inputs(turned_about_x, "zxz", [](auto& q) { q += Vector3d(-pi / 2, 0, pi / 2); });
  e.wrong_input<0>("The middle turn goes backwards: x and y have the wrong sign.", "theta_negated", negate(1));
  e.wrong(turned_about_x_last, "zyx", [](auto& q) {
    return scalar_first(Quaterniond(turn(z_axis, q[0]) * turn(y_axis, q[1]) * turn(x_axis, q[2])));
  });
  e.angles_read_as_degrees(turns_notes);
  e.property(Is::unit_norm, "The quaternion of a rotation has length 1.");
  e.route("product of three quaternions", [](auto& q) {
    const auto about = [](const Vector3d& axis, double angle) { return Quaterniond(Eigen::AngleAxisd(angle, axis)); };
    return scalar_first(about(z_axis, q[0]) * about(y_axis, q[1]) * about(z_axis, q[2]));
  });
  e.route("Euler's theorem: axis and angle of the matrix", [](auto& q) {
    const Eigen::AngleAxisd one(turned_triad(q));
    const Vector3d part = sin(one.angle() / 2) * one.axis();
    return VectorXd{{cos(one.angle() / 2), part.x(), part.y(), part.z()}};
  });
  e.route("longest column of Davenport's matrix, which is 4 q qᵀ − 1", [](auto& q) -> VectorXd {
    const Matrix3d A = rotation_matrix(q).transpose();
    Eigen::Matrix4d K;
    K << A.trace(), 2 * axial((A - A.transpose()) / 2).transpose(), 2 * axial((A - A.transpose()) / 2),
        A + A.transpose() - A.trace() * Matrix3d::Identity();
    Eigen::Index longest = 0;
    K.diagonal().maxCoeff(&longest);
    return (K.col(longest) + Eigen::Vector4d::Unit(longest)).normalized();
  });
  e.survivor("c = std::cos(", "The cosine is even.");
  e.survivor("return - VectorXd", "q and −q are one attitude.");
}
