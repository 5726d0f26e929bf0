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

/// The shortest rotation that brings one direction into another, which is not the opposite one. (Eigen's FromTwoVectors
/// holds a singular value decomposition for opposite ones, which takes the compiler ten seconds in each file.)
Eigen::Matrix3d shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Euler angles and their rates at one moment.
struct AngleMotion {
  Eigen::Vector3d angles, rates;
};

/// The second derivatives of the angles.
using Accelerations = std::function<Eigen::Vector3d(const Eigen::Vector3d& angles, const Eigen::Vector3d& rates)>;

/// The angles after a time under accelerations that a function of the course gives, to about 13 digits.
AngleMotion integrated(const AngleMotion& start, double time, const Accelerations& accelerations);

/// The same at equally spaced moments, from 0 to `duration`.
std::vector<AngleMotion> history(const AngleMotion& start, double duration, int count,
                                 const Accelerations& accelerations);

/// The motion at `count` equally spaced moments, the first at 0 and the last at `duration`.
std::vector<Motion> history(const Eigen::Vector3d& I, const Motion& start, double duration, int count);

}  // namespace workbook
