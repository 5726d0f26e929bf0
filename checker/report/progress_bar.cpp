#include "checker/report/progress_bar.hpp"

#include "checker/base/console.hpp"
#include "checker/base/text.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace workbook {

ProgressBar::ProgressBar(bool wanted)
    : wanted_(wanted && isatty(STDERR_FILENO) != 0 && !Console::of_standard_error().plain()) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::show(std::size_t done, std::size_t total, const std::string& what) {
  if (!wanted_) return;
  const Console console = Console::of_standard_error();
  const std::string count = fmt::format(" {} of {}  ", done, total);
  const std::size_t bar_width = std::clamp<std::size_t>(console.width() / 4, 5, 24);
  // A line that is wider than the terminal would break and could not be written over.
  const std::size_t left = console.width() - std::min(console.width(), bar_width + display_width(count) + 1);
  fmt::print(stderr, "\r\033[K{}{}{}", console.bar(done, total, bar_width), count, shortened(what, left));
  std::fflush(stderr);
  shown_ = true;
}

void ProgressBar::clear() {
  if (!shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace workbook
