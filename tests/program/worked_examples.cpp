// What is said of the worked examples on a student's functions. A stand-in builds nothing, and a script is what would
// have been built.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

void write_program(const fs::path& file, const std::string& commands) {
  fs::create_directories(file.parent_path());
  write(file, "#!/bin/sh\n" + commands + "\n");
  fs::permissions(file, fs::perms::owner_all);
}

/// `checker examples springs`, where building does the first and running the second.
Outcome examples(const CourseCopy& course, const std::string& build, const std::string& run) {
  write_program(course.root() / "bin/cmake", build);
  write_program(course.root() / "build/lectures/worked_examples_of_the_student_01_springs", run);
  return course.run("examples springs", "PATH=\"$PWD/bin:$PATH\"");
}

std::string example(const std::string& name, const std::string& content) {
  return "<TestCase name=\"" + name + "\">" + content + "</TestCase>";
}

const std::string success = "<OverallResultsAsserts test_case_success=\"true\"/>";
const std::string failure = "<OverallResultsAsserts test_case_success=\"false\"/>";

std::string report(const std::string& cases) {
  return "cat <<'END'\n<?xml version=\"1.0\"?><doctest><TestSuite>" + cases + "</TestSuite></doctest>\nEND";
}

}  // namespace

TEST_CASE("each worked example says how it comes out") {
  const CourseCopy course;
  const Outcome some = examples(course, "true",
                                report(example("A spring stores energy", success) +
                                       example("A spring pulls back", "<Exception>not started</Exception>" + failure) +
                                       example("A spring swings", failure)));
  CHECK(some.status == 1);
  CHECK_MESSAGE(has(some.out, "✓ A spring stores energy\n"), some.out);
  CHECK_MESSAGE(has(some.out, "· A spring pulls back (needs a function that is not started)\n"), some.out);
  CHECK_MESSAGE(has(some.out, "✗ A spring swings (comes out otherwise)\n"), some.out);
  CHECK_MESSAGE(has(some.out, "\n1 of 3 worked examples of 01_springs come out with your functions.\n"), some.out);

  const Outcome all = examples(course, "true", report(example("A spring stores energy", success)));
  CHECK(all.status == 0);
  CHECK_MESSAGE(has(all.out, "The one worked example of 01_springs comes out with your functions."), all.out);
}

TEST_CASE("worked examples that cannot be built for a student's file name the file") {
  const CourseCopy course;
  const Outcome outcome =
      examples(course, "echo /home/lectures/01_springs/exercises/spring_energy.cpp:3:1: error: no; exit 1", "true");
  CHECK(outcome.status == 1);
  CHECK(outcome.out ==
        "These files do not compile, so the examples cannot run; `checker check` on each says why:\n"
        "  lectures/01_springs/exercises/spring_energy.cpp\n");
}

TEST_CASE("worked examples that end before their end say why, as far as it can be known") {
  const CourseCopy course;
  const struct {
    std::string run;
    std::string sentence;
  } all[] = {
      {"kill -SEGV $$",
       "The examples ended before their end (signal 11): a function of yours crashes or uses up the memory; `checker "
       "check 01_springs` finds it.\n"},
      {"echo '<mine'; exit 4",
       "The examples left no report that can be read (exit status 4): a function of yours prints something or ends the "
       "program; remove that, and try again.\n"},
      {"true",
       "The examples left no report that can be read (exit status 0): a function of yours prints something or ends the "
       "program; remove that, and try again.\n"},
      {"head -c 9000000 /dev/zero",
       "The examples printed more than is read: a function of yours prints; remove that, or keep it out of the "
       "loop.\n"},
  };
  for (const auto& each : all) {
    CAPTURE(each.run);
    const Outcome outcome = examples(course, "true", each.run);
    CHECK(outcome.status == 1);
    CHECK(outcome.out == each.sentence);
  }
}
