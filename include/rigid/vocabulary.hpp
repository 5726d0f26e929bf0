/// @file
/// The few words that all contracts share.
#pragma once

#include <Eigen/Dense>

#include <vector>

/// The functions of the course: each is an exercise, and together they are a small library of rigid-body mechanics.
///
/// SI units and radians everywhere. A vector named `I` holds principal moments; an `omega` beside it then has its
/// components on the principal axes. A name says its frame: `_body` components turn with the body, `_inertial` do not.
namespace rigid {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// What the body of an exercise throws until a student has written it.
struct NotStarted {};

}  // namespace rigid
