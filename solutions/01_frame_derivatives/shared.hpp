#pragma once

#include "rigid/frame_derivatives.hpp"
#include "solutions/judging/judging.hpp"

/// The basis of the running example: turned from the inertial one by the rotation vector (0.2, 0.5, −0.3).
inline const Matrix3d example_basis = turn({0.2, 0.5, -0.3}, sqrt(0.38));
