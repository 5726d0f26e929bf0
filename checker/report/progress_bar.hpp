/// @file
/// How far a long piece of work has come.
#pragma once

#include <cstddef>
#include <string>

namespace workbook {

/// One line on standard error that is written over and over, and gone at the end. It shows on a terminal only, and not
/// in the plain mode: a screen reader would read every state of it aloud.
class ProgressBar {
 public:
  /// @param wanted  false: nothing is ever shown
  explicit ProgressBar(bool wanted = true);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `done` of `total` pieces are done, and `what` is being done now.
  void show(std::size_t done, std::size_t total, const std::string& what);

  /// Takes the line away, so that something else can be printed.
  void clear();

 private:
  bool wanted_;
  bool shown_ = false;
};

}  // namespace workbook
