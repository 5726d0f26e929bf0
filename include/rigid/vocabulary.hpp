/// @file
/// The few words that all contracts share.
#pragma once

#include <Eigen/Dense>

#include <vector>

/// The functions of the course: each is an exercise, and together they are a small library of rigid-body mechanics.
///
/// SI units and radians everywhere. A vector named `I` holds principal moments; an `omega` beside it then has its
/// components on the principal axes. A name says its frame: `_body` components turn with the body, `_inertial` do not.
/// `A_inertial_from_body` makes inertial components of body components,
/// \f$\vec V_\inertialframe = \mat A\,\vec V_\bodyframe\f$, and its transpose `R_body_from_inertial` goes back.
///
/// An inertia tensor is symmetric, and none of its principal moments is larger than the sum of the two others. Zero (a
/// point mass) and the tensor of a body on one straight line are legal where they are not excluded.
///
/// All numbers must be finite, and either zero or of a magnitude from 10⁻¹⁰⁰ to 10¹⁰⁰, so that no product of a few
/// overflows. What else must hold stands under "Precondition"; a function may return anything where it does not hold.
/// Conditions on the entries of a matrix (symmetric, rotation matrix) hold up to rounding. What is not excluded is
/// legal: zero vectors, zero angles, negative times, equal moments.
///
/// "Source" cites the five lecture decks S0 to S4 by slide (s8) or, where slides have no numbers, page (p. 8); the page
/// References of the notes names them. Above a formula in TeX stands the same in plain text, for readers of this file.
namespace rigid {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// What the body of an exercise throws until a student has written it.
struct NotStarted {
  const char* function = __builtin_FUNCTION();  ///< the one that throws it
};

}  // namespace rigid
