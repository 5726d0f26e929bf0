/// @file
/// Makes the reference results of one lecture from its solutions, or proves which typical bugs the cases of one
/// exercise find.
#include "solutions/judging/exercise.hpp"

#include <cstdio>
#include <exception>
#include <map>
#include <string>

namespace {

constexpr const char* usage =
    "usage: %s --lecture FOLDER --out FILE --seed N --adequacy RECORD                     reference results\n"
    "       %s --lecture FOLDER --out FILE --seed N --cases random                        at the random cases alone\n"
    "       %s --lecture FOLDER --out FILE --seeds N --adequacy RECORD --prove EXERCISE   a record of one exercise\n"
    "A RECORD that does not exist is empty.\n";

}  // namespace

int main(int argc, char** argv) {
  using namespace workbook;
  std::map<std::string, std::string> options;
  for (int i = 1; i + 1 < argc; i += 2) options[argv[i]] = argv[i + 1];
  const auto has = [&](const char* option) { return options.contains(option); };
  const bool is_proof = has("--prove") && has("--seeds") && has("--adequacy");
  const bool at_random = has("--seed") && has("--cases") && options["--cases"] == "random";
  const bool is_whole = has("--seed") && has("--adequacy");
  if (argc % 2 == 0 || options.size() != (is_proof ? 5U : 4U) || !has("--lecture") || !has("--out") ||
      !(is_proof || at_random || is_whole)) {
    std::fprintf(stderr, usage, argv[0], argv[0], argv[0]);
    return 2;
  }
  try {
    judging::Lecture lecture;
    judging::describe(lecture);
    const std::string& name = options["--lecture"];
    const auto number = [&](const char* option) { return std::stoull(options[option]); };
    const std::string& exercise = options["--prove"];
    if (is_proof)
      write_adequacy({{exercise, lecture.prove(exercise, number("--seeds"), read_adequacy(options["--adequacy"]))}},
                     options["--out"]);
    else if (at_random)
      write_reference_results(lecture.random_cases(name, number("--seed")), options["--out"]);
    else
      write_reference_results(lecture.evaluate(name, number("--seed"), read_adequacy(options["--adequacy"])),
                              options["--out"]);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s: the reference results could not be made: %s\n", options["--lecture"].c_str(),
                 problem.what());
    return 3;
  }
  return 0;
}
