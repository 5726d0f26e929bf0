#include "checker/commands/built_programs.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <regex>

namespace workbook {

FinishedProgram run_with_path(const std::string& program, const std::vector<std::string>& arguments,
                              std::chrono::duration<double> limit) {
  Launch launch;
  launch.program = program.c_str();
  launch.arguments = arguments;
  const char* path = std::getenv("PATH");
  launch.environment = {std::string("PATH=") + (path == nullptr ? "/usr/bin:/bin" : path)};
  return run_program(launch, limit, std::size_t{4} << 20);
}

FinishedProgram build_target(const Course& course, const std::string& target) {
  return run_with_path("/usr/bin/env", {"cmake", "--build", course.build().string(), "--target", target},
                       std::chrono::minutes(10));
}

bool succeeded(const FinishedProgram& finished) {
  return !finished.out_of_time && !finished.too_much_output && finished.end.signal == 0 &&
         finished.end.exit_status == 0;
}

std::vector<std::string> files_with_errors(const std::string& output) {
  std::vector<std::string> files;
  const std::regex pattern(R"(lectures/\w+/exercises/\w+\.cpp(?=:\d+:\d+: error))");
  for (std::sregex_iterator match(output.begin(), output.end(), pattern), end; match != end; ++match) {
    if (std::find(files.begin(), files.end(), match->str()) == files.end()) files.push_back(match->str());
  }
  return files;
}

std::filesystem::path lecture_program(const Course& course, const std::string& target) {
  return course.build() / "lectures" / target;
}

}  // namespace workbook
