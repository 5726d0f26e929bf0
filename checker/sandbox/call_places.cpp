#include "checker/sandbox/call_places.hpp"

#include "checker/base/child_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace workbook {
namespace {

/// The line of "/where/shown/NAME:12 (discriminator 3)", 0 for any other file. The compiler ran in a folder "shown".
int line_in(const std::string& place, const std::string& file_name) {
  const std::string mark = "/shown/" + file_name + ":";
  const std::size_t at = place.rfind(mark);
  if (at == std::string::npos) return 0;
  int line = 0;
  std::from_chars(place.data() + at + mark.size(), place.data() + place.size(), line);
  return std::max(line, 0);
}

}  // namespace

CallPlaces find_places(const std::filesystem::path& addr2line, const std::filesystem::path& program,
                       const std::vector<std::uint64_t>& addresses, const std::string& file_name) {
  CallPlaces places;
  if (addr2line.empty() || addresses.empty()) return places;
  const std::string tool = addr2line.string();
  Launch launch;
  launch.program = tool.c_str();
  launch.arguments = {"--addresses", "--functions", "--demangle", "--inlines", "--exe=" + program.string()};
  for (const std::uint64_t address : addresses) launch.arguments.push_back(fmt::format("{:#x}", address));
  launch.environment = {"LC_ALL=C"};
  FinishedProgram listing;
  try {
    listing = run_program(launch, std::chrono::seconds(3), std::size_t{4} << 20);
  } catch (const LaunchError&) {
    return places;
  }
  std::istringstream lines(listing.output);
  std::vector<CallPlace>* at = nullptr;
  for (std::string line, place; std::getline(lines, line);) {
    if (line.starts_with("0x")) {
      std::uint64_t address = 0;
      std::from_chars(line.data() + 2, line.data() + line.size(), address, 16);
      at = &places[address];
    } else if (at != nullptr && std::getline(lines, place)) {
      at->push_back({line, line_in(place, file_name)});
    }
  }
  return places;
}

}  // namespace workbook
