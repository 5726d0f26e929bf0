// The commands examples, figures and live: what a lecture shows, on the student's own functions.
#include "checker/commands/commands.hpp"
#include "checker/compile/compile.hpp"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cstring>
#include <set>
#include <sstream>

namespace workbook {

namespace {

namespace tree = boost::property_tree;

/// What the student's functions are called by.
struct Caller {
  std::string target;              ///< the program
  fs::path source;                 ///< its text names the functions
  std::vector<std::string> parts;  ///< targets that it is linked from, besides the student's objects
  std::string what;                ///< in words
};

/// The student's objects that the caller needs, as the build names them. @throws RejectedFile
std::vector<std::string> objects_for(const Course& course, const Caller& caller) {
  const fs::path& build = course.build().directory;
  std::set<fs::path> needed;
  const auto file_of = [&](const Exercise& exercise) { return course.student_file(exercise); };
  for (const Submission& file : own_functions(read_file(caller.source).value_or(""), course.exercises(), file_of))
    needed.insert(file.path.filename());
  std::vector<std::string> objects;
  for (const fs::path object : lines_of(read_file(build / "student/objects").value_or("")))
    if (needed.contains(object.stem())) objects.push_back(object.lexically_relative(build).string());
  return objects;
}

/// Builds a program on the student's functions and returns its path. Where files of the student cannot be used, names
/// them and returns "". @throws std::runtime_error if it cannot be built for another reason
std::string student_program(const Course& course, const Caller& caller) {
  std::vector<std::string> objects;
  try {
    objects = objects_for(course, caller);
  } catch (const RejectedFile& reason) {
    say("{}", reason.what());
    return "";
  }
  write_or_throw(course.build().directory / "student" / (caller.target + ".objects"),
                 fmt::format("{}\n", fmt::join(objects, "\n")));
  objects.insert(objects.begin(), caller.parts.begin(), caller.parts.end());
  FinishedProgram built = make(course.build(), objects);
  if (built.succeeded()) built = make(course.build(), {caller.target});
  if (built.succeeded()) return (course.build().directory / "lectures" / caller.target).string();
  std::set<std::string> exercises;
  for (const Match& error : search_all(built.output, R"(lectures/\w+/exercises/(\w+)\.cpp:\d+:\d+: error)"))
    exercises.insert(error[1]);
  if (exercises.empty())
    throw std::runtime_error(fmt::format("{}\nThe {} could not be built.", built.output, caller.what));
  fmt::print("The {} need files of yours that do not compile:\n", caller.what);
  for (const std::string& exercise : exercises) fmt::print("  {}\n", command("check " + exercise));
  return "";
}

/// What became of a worked example or a figure.
struct Outcome {
  std::string trouble;  ///< empty: none
  bool is_not_started = false;
};

void print_outcome(const std::string& name, const Outcome& outcome) {
  const Console console = Console::of_standard_output();
  const bool is_good = outcome.trouble.empty();
  const std::string mark = is_good                  ? console.mark("✓", Style::good)
                           : outcome.is_not_started ? console.mark("·", Style::quiet)
                                                    : console.mark("✗", Style::bad);
  const std::size_t indent = mark.empty() ? 0 : 2;
  const std::string text = is_good ? name : name + ": " + outcome.trouble;
  fmt::print("{}{}\n", mark, console.wrapped(text, indent).substr(indent));
  std::fflush(stdout);
}

// --- worked examples

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

// --- figures

constexpr int status_of_not_started = 3;  // as lectures/support/figure.hpp has it

Outcome draw_figure(const std::string& program, const fs::path& directory, const std::string& name, double seconds) {
  const fs::path picture = directory / (name + ".svg");
  std::error_code ignored;
  fs::remove(picture, ignored);
  const FinishedProgram finished =
      run_with_path(program, {directory.string(), name}, std::chrono::duration<double>(seconds));
  if (finished.out_of_time) return {fmt::format("not finished after {:g} s; perhaps a loop never ends", seconds)};
  if (finished.end.signal != 0)
    return {fmt::format("a function of yours crashed ({})", strsignal(finished.end.signal))};
  if (finished.succeeded())
    return {fs::exists(picture, ignored) ? "" : "a function of yours ended the program; remove calls of exit()"};
  // The last line says "NAME: why".
  const std::vector<std::string> lines = lines_of(finished.output);
  const bool has_reason = !lines.empty() && lines.back().starts_with(name + ": ");
  return {has_reason ? shortened(printable(lines.back().substr(name.size() + 2)), 300) : "failed without a reason",
          finished.end.exit_status == status_of_not_started};
}

}  // namespace

int examples(const Course& course, const Options& options) {
  const std::string lecture = options.name;
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

int figures(const Course& course, const Options& options) {
  const std::string lecture = options.name;
  const fs::path directory = options.out.value_or(course.scratch() / "figures_of_the_student" / lecture);
  require_pictures(directory);
  const std::string program = student_program(course, {"draw_of_the_student_" + lecture,
                                                       course.lectures() / lecture / "figures.cpp",
                                                       {"figures_objects_" + lecture, "workbook_figure"},
                                                       "figures of " + lecture});
  if (program.empty()) return something_failed;

  const FinishedProgram listed = run_with_path(program, {"--list"}, std::chrono::seconds(10));
  const std::vector<std::string> names = lines_of(listed.output);
  if (!listed.succeeded() || names.empty())
    return stop(
        "The program of the figures ends before it draws anything, because "
        "code of yours runs before main(); `{}` finds it.",
        command("check " + lecture));
  std::size_t drawn = 0;
  ProgressBar progress_bar;
  for (std::size_t i = 0; i < names.size(); ++i) {
    progress_bar.show(i, names.size(), names[i]);
    const Outcome outcome = draw_figure(program, directory, names[i], options.seconds_per_figure);
    progress_bar.clear();
    drawn += outcome.trouble.empty() ? 1 : 0;
    print_outcome(names[i], outcome);
  }
  fmt::print("\n{} of {} figures of {} are drawn with your functions.\n  {}\n", drawn, names.size(), lecture,
             shown_path(directory));
  return drawn == names.size() ? all_passed : something_failed;
}

int live(const Course& course, const Options& options) {
  const std::string lecture = options.name;
  // What the figures take, as lectures/live/live.js has it.
  const std::string script = read_file(course.lectures() / lecture / "live.js").value_or("");
  std::set<std::string> called;
  for (const Match& call : search_all(script, R"(yours\.(\w+))")) called.insert(call[1]);
  if (called.empty()) return stop("{} has no live figures.", lecture);

  const ProgressSummary summary = summary_of(course, Progress(course.progress_file()));
  std::string includes, entries, files;
  std::vector<std::string> own;
  for (std::size_t i = 0; i < summary.exercises.size(); ++i) {
    const Exercise& exercise = summary.exercises[i];
    if (!summary.passed[i] || called.erase(exercise.name()) == 0) continue;
    own.push_back(exercise.name());
    includes += fmt::format("#include <rigid/{}.hpp>\n", exercise.card->contract);
    entries += fmt::format("    {{\"{0}\", [](const double* numbers) {{ return call(&rigid::{0}, numbers); }}}},\n",
                           exercise.name());
  }
  if (own.empty())
    return stop("The live figures of {} take {}; none of these passes yet.", lecture, fmt::join(called, ", "));
  // With what they call in turn.
  const auto file_of = [&](const Exercise& exercise) { return course.student_file(exercise); };
  const fs::path folder = course.build().directory / "live/student";
  for (const Submission& file : own_functions(fmt::format("{}", fmt::join(own, " ")), course.exercises(), file_of)) {
    fs::path compiled = file.path;
    if (!file.own_names.empty()) {
      std::string before;
      for (const Card& card : course.cards()) before += fmt::format("#include <rigid/{}.hpp>\n", card.contract);
      compiled = folder / file.path.filename();
      write_or_throw(compiled, before + renaming(file) + file.text);
    }
    files += fmt::format("\"{}\"\n", compiled.string());
  }
  const std::string list = "#include \"lectures/live/functions.hpp\"\n" + includes +
                           "void workbook::throw_eigen_error(const char*) { __builtin_trap(); }\n"
                           "const std::vector<workbook::live::Function> workbook::live::functions{\n" +
                           entries + "};\n";
  for (const auto& [name, text] : {std::pair{"functions.cpp", list}, {"files.rsp", files}})
    write_or_throw(folder / name, text);
  const FinishedProgram built = make(course.build(), {"notes", "live_of_the_student"});
  if (!built.succeeded())
    throw std::runtime_error(fmt::format("{}\nThe live figures could not be built on your functions.", built.output));
  std::string pages;
  for (const auto& page : fs::directory_iterator(course.notes_folder()))
    if (read_file(page.path()).value_or("").find(fmt::format("data-lecture=\"{}\"", lecture)) != std::string::npos)
      pages += fmt::format("  {}?yours\n", file_address(page.path()));
  say("Computed with your {}:", fmt::join(own, ", "));
  fmt::print("{}", pages);
  if (!called.empty()) say("The figures also take these, once they pass: {}.", fmt::join(called, ", "));
  return all_passed;
}

}  // namespace workbook
