/// @file
/// The ways in which editors save a file.
#pragma once

#include "tests/support/files.hpp"

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

namespace workbook::testing {

using Pause = std::function<void()>;  ///< between two steps of a slow way

struct Way {
  const char* name;
  void (*save)(const std::filesystem::path& file, const std::string& text, const Pause& pause);
};

inline std::filesystem::path beside(const std::filesystem::path& file, const std::string& name) {
  return file.parent_path() / name;
}

inline const std::array<Way, 5> ways = {{
    {"directly", [](const auto& file, const auto& text, const Pause&) { write(file, text); }},
    {"in pieces",
     [](const auto& file, const auto& text, const Pause& pause) {
       std::ofstream out(file, std::ios::binary | std::ios::trunc);
       for (std::size_t at = 0, piece = text.size() / 3 + 1; at < text.size(); at += piece) {
         out << text.substr(at, piece) << std::flush;
         pause();
       }
     }},
    {"opened and closed for every piece",
     [](const auto& file, const auto& text, const Pause& pause) {
       std::filesystem::resize_file(file, 0);
       for (std::size_t at = 0, piece = text.size() / 3 + 1; at < text.size(); at += piece) {
         std::ofstream(file, std::ios::binary | std::ios::app) << text.substr(at, piece);
         pause();
       }
     }},
    {"under another name, then renamed",
     [](const auto& file, const auto& text, const Pause& pause) {
       write(beside(file, ".unfinished"), text);
       pause();
       std::filesystem::rename(beside(file, ".unfinished"), file);
     }},
    {"with a backup",
     [](const auto& file, const auto& text, const Pause& pause) {
       write(beside(file, "4913"), "");  // an editor asks whether it may write here
       std::filesystem::remove(beside(file, "4913"));
       std::filesystem::rename(file, file.string() + "~");
       pause();
       write(file, text);
       std::filesystem::remove(file.string() + "~");
     }},
}};

inline void save(const std::filesystem::path& file, const std::string& text, const Way& way = ways[0]) {
  way.save(file, text, [] { std::this_thread::sleep_for(std::chrono::milliseconds(3)); });
}

}  // namespace workbook::testing
