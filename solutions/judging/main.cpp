/// @file
/// Makes the reference results of one lecture from its solutions.
#include "solutions/judging/exercise.hpp"

#include <cstdio>
#include <exception>
#include <map>
#include <string>

int main(int argc, char** argv) {
  std::map<std::string, std::string> options{{"--seed", "1"}, {"--cases", "all"}};
  for (int i = 1; i + 1 < argc; i += 2) options[argv[i]] = argv[i + 1];
  const std::string cases = options["--cases"];
  if (argc % 2 == 0 || options.size() != 4 || (cases != "all" && cases != "random") || !options.contains("--lecture") ||
      !options.contains("--out")) {
    std::fprintf(stderr, "usage: %s --lecture FOLDER --out FILE [--seed N] [--cases random]\n", argv[0]);
    return 2;
  }
  try {
    workbook::judging::Lecture lecture;
    workbook::judging::describe(lecture);
    const std::uint64_t seed = std::stoull(options["--seed"]);
    workbook::write_reference_results(lecture.evaluate(options["--lecture"], seed, cases == "random"),
                                      options["--out"]);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s: the reference results could not be made: %s\n", options["--lecture"].c_str(),
                 problem.what());
    return 3;
  }
  return 0;
}
