/// @file
/// What a worked example prints for its page of the notes.
#pragma once

#include <Eigen/Dense>

#include <fmt/format.h>

#include <string>
#include <utility>

namespace workbook {

/// Collects the lines that one worked example prints, under the name by which the notes quote them.
///
/// @code
/// Printed page("cube about its corner");
/// page.line("I / Ma² =");
/// page.matrix(I);
/// @endcode
/// On destruction the region is appended to the file named by the environment variable WORKBOOK_PRINTED, if it is set.
class Printed {
 public:
  explicit Printed(std::string region) : region_(std::move(region)) {}
  ~Printed();
  Printed(const Printed&) = delete;
  Printed& operator=(const Printed&) = delete;

  /// One line, formatted as by fmt::format.
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    text_ += fmt::format(format, std::forward<Arguments>(arguments)...) + "\n";
  }

  /// A matrix, row by row, in aligned columns; `format` is the fmt specification of one entry.
  void matrix(const Eigen::MatrixXd& matrix, const std::string& format = "{:10.6g}");

 private:
  std::string region_;
  std::string text_;
};

/// A vector as "(1, 2, 3)"; `format` is the fmt specification of one component.
std::string row(const Eigen::VectorXd& vector, const std::string& format = "{:.10g}");

}  // namespace workbook
