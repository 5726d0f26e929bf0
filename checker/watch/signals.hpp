/// @file
/// Signals as something to read, so that one loop waits for everything.
#pragma once

#include "checker/base/descriptor.hpp"

#include <signal.h>

#include <vector>

namespace workbook {

/// While this lives, the signals that end, stop, continue or resize a program on a terminal are read, not delivered.
class Signals {
 public:
  Signals();
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  /// Becomes readable when a signal has come.
  int descriptor() const { return arrived_.number(); }

  /// Those that have come since the last call.
  std::vector<int> take();

  /// Does what Ctrl-Z usually does; returns when the program is continued.
  static void stop_as_usual();

 private:
  sigset_t before_{};
  Descriptor arrived_;
};

}  // namespace workbook
