#include "checker/commands/built_programs.hpp"
#include "checker/commands/commands.hpp"
#include "checker/messages/worked_examples.hpp"
#include "checker/report/console.hpp"

#include <fmt/format.h>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <chrono>
#include <sstream>

namespace workbook {

namespace {

/// How one worked example came out.
struct Example {
  std::string title;
  bool passed = false;
  bool not_started = false;
};

/// doctest's report in XML. @throws boost::property_tree::xml_parser_error if the program died before its end.
std::vector<Example> read_report(const std::string& xml) {
  namespace tree = boost::property_tree;
  std::istringstream in(xml);
  tree::ptree document;
  tree::read_xml(in, document);
  std::vector<Example> examples;
  for (const auto& [suite, cases] : document.get_child("doctest")) {
    if (suite != "TestSuite") continue;
    for (const auto& [kind, example] : cases) {
      if (kind != "TestCase") continue;
      Example found;
      found.title = example.get<std::string>("<xmlattr>.name");
      found.passed = example.get("OverallResultsAsserts.<xmlattr>.test_case_success", false);
      found.not_started = example.get("Exception", std::string()).find("not started") != std::string::npos;
      examples.push_back(found);
    }
  }
  return examples;
}

/// The example's title, and what is amiss with it.
std::string in_words(const Example& example) {
  if (example.passed) return example.title;
  return example.not_started ? messages::example_is_not_started(example.title)
                             : messages::example_comes_out_otherwise(example.title);
}

/// Why the examples left no report.
std::string without_report(const FinishedProgram& finished, const std::string& lecture) {
  if (finished.out_of_time) return messages::examples_took_too_long(lecture);
  if (finished.too_much_output) return messages::examples_printed_too_much();
  if (finished.end.signal != 0) return messages::examples_crashed(finished.end.signal, lecture);
  return messages::examples_left_no_report(finished.end.exit_status);
}

}  // namespace

int examples(const Course& course, const std::string& name) {
  const std::string lecture = course.find(name).front().lecture();
  const Console console = Console::of_standard_output();
  const std::string target = "worked_examples_of_the_student_" + lecture;

  const FinishedProgram built = build_target(course, target);
  if (!built.succeeded()) {
    const std::vector<std::string> files = files_with_errors(built.output);
    if (!files.empty()) {
      fmt::print("{}\n", messages::examples_need_files_that_compile());
      for (const std::string& file : files) fmt::print("  {}\n", file);
      return something_failed;
    }
    fmt::print(stderr, "{}\n{}\n", built.output, messages::examples_could_not_be_built(lecture));
    return checker_failed;
  }

  const FinishedProgram finished =
      run_with_path(lecture_program(course, target).string(), {"--reporters=xml"}, std::chrono::minutes(2));
  std::vector<Example> found;
  try {
    found = read_report(finished.output);
  } catch (const boost::property_tree::ptree_error&) {
    fmt::print("{}\n", without_report(finished, lecture));
    return something_failed;
  }
  std::size_t passed = 0;
  for (const Example& example : found) {
    passed += example.passed ? 1 : 0;
    const std::string mark = example.passed ? "✓" : example.not_started ? "·" : "✗";
    const Style style = example.passed ? Style::good : example.not_started ? Style::quiet : Style::bad;
    const std::string text = console.wrapped(in_words(example), 2);
    fmt::print("{}{}\n", console.mark(mark, style), text.substr(2));
  }
  fmt::print("\n{}\n", messages::examples_come_out(passed, found.size(), lecture));
  return passed == found.size() ? all_passed : something_failed;
}

}  // namespace workbook
