/// @file
/// All that a description of an exercise is written with.
#pragma once

#include "solutions/judging/algebra.hpp"
#include "solutions/judging/changes.hpp"
#include "solutions/judging/exercise.hpp"
#include "solutions/judging/mechanics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace workbook::judging {

using std::abs, std::acos, std::asin, std::atan, std::atan2, std::copysign, std::cos, std::hypot, std::polar, std::pow,
    std::sin, std::sqrt, std::tan, std::clamp, std::max, std::min, std::swap, std::tuple;

// Eigen's classes behind the commonest formulas: naming them here, they are made once, in the precompiled header.
static_assert(sizeof(x_axis.dot(y_axis)) + sizeof(x_axis.cwiseProduct(y_axis)) + sizeof(x_axis.cwiseQuotient(y_axis)) +
                  sizeof(x_axis.cwiseAbs()) + sizeof(x_axis.cwiseAbs2()) + sizeof(x_axis.cwiseInverse()) +
                  sizeof(x_axis.array()) + sizeof(x_axis.asDiagonal()) + sizeof(x_axis.transpose()) +
                  sizeof(x_axis.head<2>()) + sizeof(x_axis.head<2>().cwiseAbs2()) + sizeof(x_axis.tail<2>()) +
                  sizeof(Vector3d::Unit(0)) + sizeof(Vector3d::Zero()) + sizeof(Matrix3d::Identity()) +
                  sizeof(Matrix3d::Zero()) + sizeof(Eigen::Matrix2d::Identity()) + sizeof(Vector2d().cwiseAbs2()) +
                  sizeof(Vector2d().dot(Vector2d())) + sizeof(VectorXd().cwiseAbs()) + sizeof(VectorXd().transpose()) +
                  sizeof(VectorXd::Zero(1)) + sizeof(tensor_of_four_masses.col(0)) +
                  sizeof(tensor_of_four_masses.row(0)) + sizeof(tensor_of_four_masses.row(0).transpose()) +
                  sizeof(tensor_of_four_masses.transpose()) + sizeof(tensor_of_four_masses.transpose().row(0)) +
                  sizeof(tensor_of_four_masses.diagonal()) + sizeof(tensor_of_four_masses.inverse()) +
                  sizeof(tensor_of_four_masses.cwiseAbs()) + sizeof(tensor_of_four_masses.cwiseAbs2()) +
                  sizeof(Matrix3d().col(0)) + sizeof(Matrix3d().row(0)) + sizeof(Matrix3d().row(0).transpose()) +
                  sizeof(Matrix3d().diagonal()) + sizeof(Matrix3d().transpose()) + sizeof(Matrix3Xd().col(0)) +
                  sizeof(Matrix3Xd().colwise()) + sizeof(Eigen::Vector4d().head<3>()) + sizeof(Eigen::Quaterniond) +
                  sizeof(Eigen::AngleAxisd) >
              0);

}  // namespace workbook::judging

// Only descriptions of exercises include this header, and all of each is about judging.
using namespace workbook::judging;
