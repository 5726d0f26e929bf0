/// @file
/// Makes the reference results of one lecture from its solutions.
#include "solutions/judging/lecture.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>

int main(int argc, char** argv) {
  CLI::App app{"Makes the reference results of one lecture from its solutions."};
  std::uint64_t seed = 1;
  std::string lecture_name;
  std::string file;
  app.add_option("--seed", seed, "draws the random cases")->capture_default_str();
  app.add_option("--lecture", lecture_name, "the lecture's folder name, written into the file")->required();
  app.add_option("--out", file, "the JSON file to write")->required();
  CLI11_PARSE(app, argc, argv);

  try {
    workbook::judging::Lecture lecture;
    workbook::judging::describe(lecture);
    workbook::write_reference_results(lecture.evaluate(lecture_name, seed), file);
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}: the reference results could not be made: {}\n", lecture_name, problem.what());
    return 3;
  }
  return 0;
}
