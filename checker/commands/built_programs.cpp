#include "checker/commands/built_programs.hpp"

#include "checker/messages/reporting.hpp"
#include "checker/report/progress_bar.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <regex>
#include <string_view>

namespace workbook {

namespace {

constexpr std::chrono::minutes longest_build{30};
constexpr std::size_t most_output = std::size_t{4} << 20;

Launch launch_of(const std::string& program, const std::vector<std::string>& arguments) {
  Launch launch;
  launch.program = program.c_str();
  launch.arguments = arguments;
  const char* path = std::getenv("PATH");
  launch.environment = {std::string("PATH=") + (path == nullptr ? "/usr/bin:/bin" : path)};
  return launch;
}

/// Shows how far the build is, from the "[12/40] …" at the beginning of its lines.
class BuildProgress {
 public:
  void hear(std::string_view piece) {
    unread_ += piece;
    static const std::regex step(R"(\[(\d{1,6})/(\d{1,6})\] )");
    for (std::size_t end = 0; (end = unread_.find('\n')) != std::string::npos; unread_.erase(0, end + 1)) {
      const std::string line = unread_.substr(0, std::min<std::size_t>(end, 200));
      std::smatch found;
      if (std::regex_search(line, found, step, std::regex_constants::match_continuous))
        bar_.show(std::stoul(found[1]), std::stoul(found[2]), messages::building());
    }
  }

 private:
  ProgressBar bar_;
  std::string unread_;
};

}  // namespace

FinishedProgram run_with_path(const std::string& program, const std::vector<std::string>& arguments,
                              std::chrono::duration<double> limit) {
  return run_program(launch_of(program, arguments), limit, most_output);
}

FinishedProgram build_target(const Course& course, const std::string& target) {
  BuildProgress progress;
  const std::string program = "/usr/bin/env";
  return run_program(launch_of(program, {"cmake", "--build", course.build().string(), "--target", target}),
                     longest_build, most_output, [&](std::string_view piece) { progress.hear(piece); });
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
