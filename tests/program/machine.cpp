// What doctor says of the machine.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <filesystem>

using namespace workbook::testing;

TEST_CASE("doctor names each thing that the checker needs, and how it stands, in words where marks would not be read") {
  const CourseCopy course;
  const Outcome outcome = course.run("doctor", "COLUMNS=90 PATH=/nowhere");
  CHECK(outcome.status == 0);
  for (const char* line :
       {"✓ compiler ", "✓ reference ", " sandbox ", "✗ gnuplot ", "✗ gdb ", "✗ em++ ", " folder ", "✗ notes ", "✓ terminal "})
    CHECK_MESSAGE(has(outcome.out, line), outcome.out);
  const std::string in_words = course.run("doctor", "WORKBOOK_PLAIN=1 PATH=/nowhere").out;
  for (const char* line : {"\ngood: reference", "\nnot good: gnuplot"}) CHECK_MESSAGE(has(in_words, line), in_words);
}

TEST_CASE("doctor tells programs what the sandbox can do") {
  const CourseCopy course;
  const auto sandbox = course.run("doctor --json", "PATH=/nowhere").json().at("sandbox");
  CHECK(sandbox.at("tier") == (sandbox.at("landlock") > 0 ? "reduced" : "minimal"));
  CHECK(sandbox.at("namespaces") == false);
  CHECK(has(sandbox.at("detail"), "apt-get install bubblewrap"));
}

TEST_CASE(
    "that a sandbox holds is remembered for this kernel and this user, and tried again where the record does not fit") {
  const CourseCopy course;
  course.solve("spring_energy");
  const auto record = std::filesystem::path(WORKBOOK_TEST_SCRATCH) / "shared/sandbox";
  REQUIRE(course.run("check spring_energy").status == 0);
  const std::string right = read(record);
  write(record, "another kernel\n");
  CHECK_FALSE(course.run("check spring_energy --json").result().contains("sandbox"));
  CHECK(read(record) == right);
}
