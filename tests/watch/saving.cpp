#include "tests/watch/saving.hpp"

#include "tests/program/program.hpp"

#include <chrono>
#include <fstream>
#include <thread>

namespace workbook::testing {

namespace fs = std::filesystem;

const char* to_string(Way way) {
  switch (way) {
    case Way::directly:
      return "directly";
    case Way::in_pieces:
      return "in pieces";
    case Way::in_many_writes:
      return "in many writes";
    case Way::by_renaming:
      return "by renaming";
    case Way::with_backup:
      return "with a backup";
  }
  return "";
}

void save(const fs::path& file, const std::string& text, Way way, const std::function<void()>& pause) {
  const std::size_t piece = text.size() / 3 + 1;
  const fs::path beside = file.parent_path();
  const std::string name = file.filename().string();
  switch (way) {
    case Way::directly:
      write(file, text);
      return;
    case Way::in_pieces: {
      std::ofstream out(file, std::ios::binary | std::ios::trunc);
      for (std::size_t at = 0; at < text.size(); at += piece) {
        out << text.substr(at, piece) << std::flush;
        pause();
      }
      return;
    }
    case Way::in_many_writes:
      fs::resize_file(file, 0);
      for (std::size_t at = 0; at < text.size(); at += piece) {
        std::ofstream(file, std::ios::binary | std::ios::app) << text.substr(at, piece);
        pause();
      }
      return;
    case Way::by_renaming:
      write(beside / ("." + name + ".tmp"), text);
      pause();
      fs::rename(beside / ("." + name + ".tmp"), file);
      return;
    case Way::with_backup:
      write(beside / "4913", "");  // an editor asks whether it may write here
      fs::remove(beside / "4913");
      fs::rename(file, beside / (name + "~"));
      pause();
      write(file, text);
      fs::remove(beside / (name + "~"));
      return;
  }
}

void save(const fs::path& file, const std::string& text, Way way) {
  save(file, text, way, [] { std::this_thread::sleep_for(std::chrono::milliseconds(3)); });
}

}  // namespace workbook::testing
