/// @file
/// How the choices of the reference results are written in JSON.
#pragma once

#include "checker/data/reference_results.hpp"

#include <array>
#include <string>
#include <utility>

namespace workbook {

template <class Choice, std::size_t count>
using Names = std::array<std::pair<Choice, const char*>, count>;

inline constexpr Names<Group, 3> group_names = {
    {{Group::worked, "worked"}, {Group::special, "special"}, {Group::random, "random"}}};

inline constexpr Names<Comparison, 4> comparison_names = {{{Comparison::plain, "plain"},
                                                           {Comparison::up_to_sign, "up_to_sign"},
                                                           {Comparison::eigenvectors, "eigenvectors"},
                                                           {Comparison::attitude_by_angles, "attitude_by_angles"}}};

inline constexpr Names<PropertyKind, 9> property_names = {
    {{PropertyKind::symmetric, "symmetric"},
     {PropertyKind::antisymmetric, "antisymmetric"},
     {PropertyKind::positive_semidefinite, "positive_semidefinite"},
     {PropertyKind::rotation_matrix, "rotation_matrix"},
     {PropertyKind::unit_norm, "unit_norm"},
     {PropertyKind::ascending, "ascending"},
     {PropertyKind::nonnegative, "nonnegative"},
     {PropertyKind::orthogonal_to_argument, "orthogonal_to_argument"},
     {PropertyKind::constant_weighted_square, "constant_weighted_square"}}};

template <class Choice, std::size_t count>
std::string name_of(Choice choice, const Names<Choice, count>& names) {
  for (const auto& [known, name] : names) {
    if (known == choice) return name;
  }
  return "?";
}

}  // namespace workbook
