#include "checker/commands/on_demand/student_programs.hpp"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <set>
#include <sstream>

namespace workbook {

namespace {

namespace tree = boost::property_tree;

struct Example {
  std::string title;
  bool passed = false;
  std::set<std::string> missing;    ///< functions that are not started
  std::vector<std::string> failed;  ///< one text per failed check: place, check, numbers
};

std::string on_one_line(const std::string& text) {
  return fmt::format("{}", fmt::join(wrapped_lines(printable(text), std::string::npos), " "));
}

/// A check, or the example as a whole, that threw or failed.
void add_failure(Example& example, const tree::ptree& failure) {
  const std::string thrown = on_one_line(failure.get("Exception", failure.data()));
  if (const Match found = search(thrown, "not started: (\\w+)")) {  // as lectures/support/not_started.cpp has it
    example.missing.insert(found[1]);
    return;
  }
  const std::string file = failure.get("<xmlattr>.filename", "");
  const std::size_t lectures = file.rfind("lectures/");
  const std::string place = file.empty()
                                ? ""
                                : fmt::format("{}:{}: ", file.substr(lectures == std::string::npos ? 0 : lectures),
                                              failure.get("<xmlattr>.line", ""));
  const std::string values = on_one_line(failure.get("Expanded", ""));
  example.failed.push_back(place + on_one_line(failure.get("Original", "an exception ended it")) + "\n" +
                           (values.empty() ? "threw an exception: " + thrown : values));
}

/// doctest's report in XML. @throws boost::property_tree::ptree_error if the program did not run to its end
std::vector<Example> read_report(const std::string& xml) {
  std::istringstream in(xml);
  tree::ptree document;
  tree::read_xml(in, document);
  std::vector<Example> examples;
  for (const auto& [suite, cases] : document.get_child("doctest")) {
    if (suite != "TestSuite") continue;
    for (const auto& [kind, content] : cases) {
      if (kind != "TestCase") continue;
      Example& example = examples.emplace_back();
      example.title = content.get<std::string>("<xmlattr>.name");
      example.passed = content.get("OverallResultsAsserts.<xmlattr>.test_case_success", false);
      for (const auto& [part, failure] : content)
        if (part == "Expression" || part == "Exception") add_failure(example, failure);
    }
  }
  return examples;
}

/// Why the examples left no report.
std::string without_report(const FinishedProgram& finished, const std::string& lecture) {
  const std::string finds = fmt::format("`{}` finds it.", command("check " + lecture));
  if (finished.out_of_time)
    return "The examples ran out of time: a function of yours is slow or never returns; " + finds;
  if (finished.too_much_output) return "The examples print too much: remove the output of your functions.";
  if (finished.end.signal != 0)
    return fmt::format("The examples crashed (signal {}): a function of yours crashes or uses up the memory; {}",
                       finished.end.signal, finds);
  return fmt::format(
      "The examples left no readable report (exit status {}): a function of yours prints something or "
      "ends the program.",
      finished.end.exit_status);
}

}  // namespace

int examples(const Course& course, const std::string& lecture) {
  const Console console = Console::of_standard_output();
  const std::string program = student_program(
      course, {"worked_examples_of_the_student_" + lecture,
               course.lectures() / lecture / "worked_examples.cpp",
               {"worked_examples_objects_" + lecture, "workbook_printed", "workbook_doctest_main", "not_started"},
               "worked examples of " + lecture});
  if (program.empty()) return something_failed;
  const FinishedProgram finished = run_with_path(program, {"--reporters=xml"}, std::chrono::minutes(2));
  std::vector<Example> all;
  try {
    all = read_report(finished.output);
  } catch (const tree::ptree_error&) {
    return stop("{}", without_report(finished, lecture));
  }
  std::size_t passed = 0;
  for (const Example& example : all) {
    passed += example.passed ? 1 : 0;
    const bool is_not_started = !example.missing.empty();
    const std::string trouble = example.passed ? ""
                                : is_not_started
                                    ? fmt::format("needs {} (not started)", fmt::join(example.missing, ", "))
                                    : plural(example.failed.size(), "check") + " failed";
    print_outcome(example.title, {trouble, is_not_started});
    for (const std::string& check : example.failed) fmt::print("{}\n", console.wrapped(check, 4));
  }
  fmt::print("\n{} of {} worked examples of {} hold with your functions.\n", passed, all.size(), lecture);
  return passed == all.size() ? all_passed : something_failed;
}

}  // namespace workbook
