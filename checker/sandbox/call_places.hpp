/// @file
/// From addresses in a program to lines in the student's file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace workbook {

/// One call in a chain of calls.
struct CallPlace {
  std::string function;
  int line = 0;  ///< in the student's file; 0: the call is elsewhere
};

using CallPlaces = std::map<std::uint64_t, std::vector<CallPlace>>;

/// Where the addresses are, innermost first where functions were inlined. Nothing for what addr2line does not know; it
/// is asked once for all.
/// @param file_name  under which the student's file was compiled
CallPlaces find_places(const std::filesystem::path& addr2line, const std::filesystem::path& program,
                       const std::vector<std::uint64_t>& addresses, const std::string& file_name);

}  // namespace workbook
