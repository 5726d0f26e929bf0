/// @file
/// How a body rotates, integrated from the laws of motion without any function of the course: the second route of
/// worked examples, and what figures are drawn from.
#pragma once

#include <Eigen/Dense>

#include <functional>
#include <vector>

namespace workbook {

/// A rotating body at one moment.
struct Motion {
  Eigen::Vector3d omega;                            ///< angular velocity on the principal axes, rad/s
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();  ///< attitude, V_inertial = A V_body
};

/// The torque on the principal axes, N m, for a motion; without one the body is free.
using Torque = std::function<Eigen::Vector3d(const Motion&)>;

/// The motion after a time, which may be negative, of a body with the principal moments I: Euler's equations and
/// dA/dt = A [ω]×, to about 13 digits.
Motion integrated(const Eigen::Vector3d& I, const Motion& start, double time, const Torque& torque = {});

/// The motion at `count` equally spaced moments, the first at 0 and the last at `duration`.
std::vector<Motion> history(const Eigen::Vector3d& I, const Motion& start, double duration, int count);

}  // namespace workbook
