// The watch where nothing can be drawn: verdicts come one below the other.
#include "checker/base/child_process.hpp"
#include "tests/program/program.hpp"
#include "tests/watch/saving.hpp"

#include <doctest/doctest.h>

#include <poll.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>

using namespace workbook;
using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

/// `checker watch` with empty input, whose output is a pipe.
class PipedWatch {
 public:
  explicit PipedWatch(const CourseCopy& course, const std::vector<std::string>& environment = {})
      : process_(launch(course, environment)) {}

  bool says(const std::string& part) {
    const auto end = Clock::now() + std::chrono::seconds(20);
    while (!has(output, part) && Clock::now() < end) {
      pollfd source{process_.output(), POLLIN, 0};
      ::poll(&source, 1, 50);
      std::array<char, 4096> buffer;
      const ssize_t got = ::read(process_.output(), buffer.data(), buffer.size());
      if (got > 0) output.append(buffer.data(), static_cast<std::size_t>(got));
    }
    return has(output, part);
  }

  /// Tells it to end; its exit status.
  int end() {
    process_.ask_to_end();
    const auto ended = process_.wait_until(Clock::now() + std::chrono::seconds(5));
    return ended && ended->signal == 0 ? ended->exit_status : -1;
  }

  std::string output;

 private:
  static Launch launch(const CourseCopy& course, const std::vector<std::string>& environment) {
    Launch launch;
    launch.program = WORKBOOK_TEST_CHECKER;
    launch.arguments = {"--course", (course.root() / "course.json").string(), "watch"};
    launch.environment = environment;
    const char* path = std::getenv("PATH");
    launch.environment.push_back(std::string("PATH=") + (path == nullptr ? "/usr/bin:/bin" : path));
    launch.directory = course.root();
    return launch;
  }

  ChildProcess process_;
};

}  // namespace

TEST_CASE("without a terminal every verdict is printed below the other, without control codes") {
  const CourseCopy course;
  PipedWatch watch(course);
  CHECK(watch.says("Next: spring_energy"));
  course.answer_energy("return k * x.squaredNorm();");
  CHECK(watch.says("The factor ½ is missing."));
  save(course.exercise("spring_energy"), read(course.solution("spring_energy")), Way::by_renaming);
  CHECK(watch.says("✓ spring_energy  passed"));
  CHECK(watch.says("Next: spring_force"));
  save(course.exercise("spring_force"), read(course.solution("spring_force")));
  CHECK(watch.says("All 2 exercises of the course pass."));
  CHECK(watch.output.find('\033') == std::string::npos);
  CHECK(watch.end() == 0);
  CHECK(watch.says("All 2 exercises pass."));
}

TEST_CASE("in the plain mode there are no marks, and a variable asks for looking instead of events") {
  const CourseCopy course;
  PipedWatch watch(course, {"WORKBOOK_PLAIN=1", "WORKBOOK_POLL=1"});
  CHECK(watch.says("WORKBOOK_POLL is set, so the files are looked at four times a second."));
  save(course.exercise("spring_energy"), read(course.solution("spring_energy")));
  CHECK(watch.says("spring_energy  passed"));
  CHECK_FALSE(has(watch.output, "✓"));
  CHECK(watch.end() == 0);
  CHECK(watch.says("1 of 2 exercises pass; next is spring_force."));
}

TEST_CASE("several files saved at once are all checked") {
  const CourseCopy course;
  PipedWatch watch(course);
  CHECK(watch.says("Next: spring_energy"));
  for (const char* name : {"spring_force", "spring_energy"}) save(course.exercise(name), read(course.solution(name)));
  CHECK(watch.says("✓ spring_force  passed"));
  CHECK(watch.says("✓ spring_energy  passed"));
  CHECK(watch.says("All 2 exercises of the course pass."));
}

TEST_CASE("the end of the reader is the end of the watch") {
  const CourseCopy course;
  const Outcome outcome = course.run("watch </dev/null 2>&1 | head -n 1 >/dev/null; true");
  CHECK(outcome.status == 0);
}

TEST_CASE("a name that means nothing, and a course without exercises") {
  const CourseCopy course;
  const Outcome unknown = course.run("watch spring_enrgy");
  CHECK(unknown.status == 2);
  CHECK(has(unknown.err, "Did you mean 'spring_energy'?"));
  replace_in(course.root() / "course.json", "\"01_springs\"", "");
  const Outcome empty = course.run("watch");
  CHECK(empty.status == 3);
  CHECK(empty.err == "This course has no exercises, so there is nothing to watch.\n");
}
