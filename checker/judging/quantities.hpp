/// @file
/// The inputs of an exercise as named numbers: what formulas are made of.
#pragma once

#include "checker/data/reference_results.hpp"

#include <string>
#include <vector>

namespace workbook {

/// One number of the inputs, at every case.
struct Quantity {
  std::string name;  ///< "omega_2", "I_13", "theta"
  Unit unit;
  std::size_t argument = 0;
  std::size_t entry = 0;
  std::vector<double> values;  ///< per case

  bool is_angle() const { return unit == units::radian; }
};

/// All numbers of arguments of fixed size. Of matrices that are symmetric at every case the upper triangle stands for
/// both.
std::vector<Quantity> quantities_of(const ExerciseReference& exercise);

/// How the entry of a value of that kind is called behind its name: "_2", "_13", "".
std::string entry_suffix(Kind kind, std::size_t entry);

}  // namespace workbook
