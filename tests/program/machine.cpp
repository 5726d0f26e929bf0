// What doctor says of the machine.
#include "tests/program/program.hpp"
#include "tests/support/system_calls.hpp"

#include <doctest/doctest.h>

#include <cerrno>
#include <thread>

using namespace workbook::testing;

TEST_CASE("doctor names each thing that the checker needs, and how it stands") {
  const CourseCopy course;
  const Outcome outcome = course.run("doctor", "COLUMNS=90 PATH=/nowhere");
  CHECK(outcome.status == 0);
  for (const char* line :
       {"✓ compiler ", "✓ reference ", " sandbox ", "✗ gnuplot ", " folder ", "✗ notes ", "✓ terminal "})
    CHECK_MESSAGE(has(outcome.out, line), outcome.out);
}

TEST_CASE("doctor tells programs what the sandbox can do") {
  const CourseCopy course;
  const auto sandbox = course.run("doctor --json", "PATH=/nowhere").json().at("sandbox");
  CHECK(sandbox.at("tier") == (sandbox.at("landlock") > 0 ? "reduced" : "minimal"));
  CHECK(sandbox.at("namespaces") == false);
  CHECK(has(sandbox.at("detail"), "apt-get install bubblewrap"));
}

TEST_CASE("where nothing holds a function back, every result says so") {
  const CourseCopy course;
  course.solve("spring_energy");
  // The filter of system calls belongs to a thread and what it starts: here it makes a kernel without such filters.
  std::thread([&] {
    CHECK(refuse_system_call(SYS_prctl, EINVAL, PR_GET_SECCOMP));
    const std::string said = "none: limits on time, memory and output only; a function can";
    CHECK(has(course.run("check spring_energy", "COLUMNS=200").out, said));
    const auto result = course.run("check spring_energy --json").result();
    CHECK(result.at("verdict") == "passed");
    CHECK(has(result.at("sandbox"), said));
    const std::string page = (course.root() / "page.html").string();
    CHECK(course.run("report --html " + page).status == 0);
    CHECK(has(read(page), said));
  }).join();
  CHECK_FALSE(course.run("check spring_energy --json").result().contains("sandbox"));
}

TEST_CASE("doctor says in words what is well where marks would not be read") {
  const CourseCopy course;
  const Outcome outcome = course.run("doctor", "WORKBOOK_PLAIN=1 PATH=/nowhere");
  CHECK_MESSAGE(has(outcome.out, "\ngood: reference"), outcome.out);
  CHECK_MESSAGE(has(outcome.out, "\nnot good: gnuplot"), outcome.out);
}
