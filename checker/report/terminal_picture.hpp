/// @file
/// A plot on the terminal itself.
#pragma once

#include "checker/report/overlay.hpp"
#include "checker/report/terminal_graphics.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace workbook {

/// What makes a terminal of kitty's kind show a PNG, that many columns wide.
std::string kitty_picture(std::string_view png, std::size_t columns);

/// What to print for the plot to be seen: pictures, or letters and a line that says what they mean; "" for `none`.
/// @param drawn  what draw_overlay() has left
/// @param directory  for files on the way
/// @throws PlotError
std::string terminal_picture(PictureKind kind, const Overlay& overlay, const std::vector<std::filesystem::path>& drawn,
                             const std::filesystem::path& directory, const Console& console, const PictureSpace& space);

}  // namespace workbook
