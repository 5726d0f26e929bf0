// The mistakes in students' files, by name and place; the sentences are in golden/compile_findings.txt.
#include "checker/compile/compile.hpp"
#include "tests/running/student.hpp"
#include "tests/support/golden.hpp"

#include "checker/base/files.hpp"
#include "checker/base/text.hpp"
#include "checker/explain/explain.hpp"
#include "checker/judging/judge.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <atomic>
#include <thread>

namespace workbook::testing {
namespace fs = std::filesystem;
namespace {

/// The body of `double twice(double x)`, from line 3 on.
std::string body(const std::string& text) {
  return "namespace rigid {\ndouble twice(double x) {\n" + text + "\n}\n}\n";
}

struct Result {
  bool compiles = false;
  std::vector<Reason> findings;
};

Result findings_in(const Snippet& snippet) {
  const std::string exercise = snippet.exercise();
  const Submission submission = submit(snippet.text, exercise);
  const CompileTask task{submission, exercise, signature(exercise)};
  const Compilation compilation = compile(task, toolchain(), shared_cache());
  const bool compiles = compilation.executable.has_value();
  return {compiles, compiles ? source_findings(task, compilation, toolchain(), shared_cache()) : compilation.errors};
}

void on_all_processors(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i)
    threads.emplace_back([&] {
      for (std::size_t k = next++; k < count; k = next++) work(k);
    });
}

std::string names_of(const std::vector<Reason>& findings) {
  std::string names;
  for (const Reason& one : findings)
    names += fmt::format("{}{} {}:{}", names.empty() ? "" : "; ", one.name, one.line, one.column);
  return names;
}

/// 2x and factor · A, at a few inputs.
ExerciseReference reference_of(const std::string& exercise) {
  ExerciseReference reference;
  reference.name = exercise;
  reference.signature = signature(exercise);
  const bool is_number = exercise == "twice";
  if (!is_number) reference.arguments.push_back({"A", Kind::matrix3, {}});
  reference.arguments.push_back({is_number ? "x" : "factor", Kind::number, {}});
  reference.result_kind = is_number ? Kind::number : Kind::matrix3;
  reference.result_units = {units::none};
  for (const double x : {1.0, 2.0, -0.5, 7.25, 0.0, -3.0}) {
    Case one = twice_case(x);
    one.name = "made up";
    one.tolerance = 1e-12;
    if (!is_number) {
      one.inputs = {Value{3, 3, {1, 2, 3, 4, 5, 6, 7, 8, 10}}, Value{1, 1, {x}}};
      one.expected = one.inputs.front();
      for (double& number : one.expected.numbers) number *= x;
    }
    one.scale.assign(one.expected.numbers.size(), 1.0);
    reference.cases.push_back(one);
  }
  return reference;
}

/// What a student reads of the file.
struct Told {
  Verdict verdict = Verdict::passed;
  std::string sentences;
  std::vector<Reason> physics;
};

Told told(const Snippet& snippet) {
  const std::string exercise = snippet.exercise();
  const Submission submission = submit(snippet.text, exercise);
  const ExerciseReference reference = reference_of(exercise);
  const CompileTask task{submission, exercise, reference.signature};
  const Compilation compilation = compile(task, toolchain(), shared_cache());
  std::optional<ExerciseRunner> runner;
  if (compilation.executable) runner.emplace(compilation.program(), short_limits());
  const Observation observation =
      runner ? runner->observe(plan_calls(reference.cases), plan_repeats(reference)) : refused(compilation);
  const Judgement judgement = judge(reference, observation);
  std::vector<Reason> reasons = observation.errors;
  const Ask ask = [&](const std::vector<PlannedCall>& calls) { return runner->evaluate(calls); };
  if (runner && !judgement.passed())
    reasons =
        explain({{submission, reference, observation, judgement}, task, compilation, ask, toolchain(), shared_cache()});
  Told told{judgement.verdict, "", {}};
  for (const Reason& reason : reasons)
    if (reason.is_in_code())
      told.sentences += fmt::format("{} {}:{} {}\n", reason.name, reason.line, reason.column, reason.sentence);
    else
      told.physics.push_back(reason);
  if (told.sentences.empty()) told.sentences = judgement.message + "\n";
  return told;
}

}  // namespace

TEST_CASE("mistakes have a name, a place and a sentence" * doctest::test_suite("thorough")) {
  std::vector<Snippet> files = snippets_in("mistakes.txt");
  // Without a last line end, and with those of another system.
  for (const auto& [place, text] :
       {std::pair{"1:51", "namespace rigid { double twice(double x) { return y; } }"},
        {"3:10", "namespace rigid {\r\ndouble twice(double x) {\r\n  return y;\r\n}\r\n}\r\n"}})
    files.push_back({"refused", std::string("undeclared_name ") + place, "file", text});
  std::vector<Result> results(files.size());
  on_all_processors(files.size(), [&](std::size_t k) { results[k] = findings_in(files[k]); });
  std::string sentences;
  for (std::size_t k = 0; k < files.size(); ++k) {
    CAPTURE(files[k].text);
    CHECK(results[k].compiles == files[k].title.starts_with("compiles"));
    const std::string names = names_of(results[k].findings);
    CHECK((names.empty() ? "nothing" : names) == files[k].said);
    for (const Reason& finding : results[k].findings) {
      CHECK(finding.sentence.size() <= 200);
      CHECK((finding.excerpt.empty() || finding.excerpt.ends_with("^")));
      const std::string sentence = finding.name + ": " + finding.sentence + "\n";
      if (!has(sentences, sentence)) sentences += sentence;
    }
  }
  compare_with_golden(golden("compile_findings.txt"), sentences);
}

TEST_CASE("what clang says has the names that GCC's messages have") {
  struct Said {
    std::string message;  // at line 1, column 20
    std::string name;
    std::string code = "                   x";
  };
  const Said all[] = {
      {"error: use of undeclared identifier 'cso'", "undeclared_name"},
      {"error: use of undeclared identifier 'pi'", "undeclared_name"},
      {"error: use of undeclared identifier 'omeg'; did you mean 'omega'?", "undeclared_name"},
      {"error: unknown type name 'Vektor3d'; did you mean 'Vector3d'?", "undeclared_name"},
      {"error: no member named 'transposed' in 'Eigen::Matrix<double, 3, 3>'", "undeclared_member"},
      {"error: no member named 'sine' in namespace 'std'", "undeclared_member"},
      {"error: reference to non-static member function must be called; did you mean to call it with no arguments?",
       "missing_call", "double z =      a.z;"},
      {"error: expected ';' after expression", "missing_semicolon", "Matrix3d R = A + B "},
      {"error: expected '}'", "missing_brace", "}"},
      {"error: extraneous closing brace ('}')", "surplus_brace"},
      {"error: expected ')'", "missing_parenthesis", "double z = 2*(a + 1;"},
      {"error: expected '}'", "missing_comma", "return {a+b+a+b+a+b; b};"},
      {"error: invalid operands to binary expression ('RealScalar' (aka 'double') and 'Eigen::Matrix<double, 3, 3>')",
       "number_plus_matrix", "Matrix3d R = a*a*a - B;"},
      {"error: no viable overloaded '+='", "compiler_error"},
      {"error: called object type 'double' is not a function or function pointer", "call_of_value"},
      {"error: no matching function for call to 'square'", "argument_kinds"},
      {"error: no matching constructor for initialization of 'Eigen::AngleAxisd' (aka 'AngleAxis<double>')",
       "axis_and_angle"},
      {"error: no viable constructor or deduction guide for deduction of template arguments of 'Matrix'",
       "incomplete_type_name", "          Matrix A(a);"},
      {"error: cannot initialize return object of type 'int' with an lvalue of type 'const char[7]'",
       "text_for_number"},
      {"error: assigning to 'double' from incompatible type 'const std::complex<double>'", "complex_number"},
      {"error: non-const lvalue reference to type 'Vector3d' (aka 'Matrix<double, 3, 1>') cannot bind to a temporary "
       "of "
       "type 'double'",
       "reference_to_temporary"},
      {"error: 'rigid/nothing.hpp' file not found", "missing_header"},
      {"error: expected expression", "else_without_if", "                   else"},
      {"error: no viable conversion from returned value of type 'double' to function return type "
       "'rigid::Matrix3d' (aka 'Matrix<double, 3, 3>')",
       "wrong_kind", "            return x;"},
      {"warning: non-void function does not return a value in all control paths [-Wreturn-type]", "missing_return"},
      {"warning: variable 's' is uninitialized when used here [-Wuninitialized]", "uninitialized_variable"},
      {"warning: implicit conversion turns floating-point number into integer: 'double' to 'int' [-Wfloat-conversion]",
       "narrowing"},
      {"warning: using the result of an assignment as a condition without parentheses [-Wparentheses]",
       "assignment_in_condition"},
      {"warning: left operand of comma operator has no effect [-Wunused-value]", "unused_value"},
      {"warning: unused variable 's' [-Wunused-variable]", "never_used"}};
  for (const Said& one : all) {
    CAPTURE(one.message);
    const CompilerOutput output = read_compiler_output(unit_name + ":1:20: " + one.message + "\n", "a.cpp",
                                                       [](const std::string&) { return false; });
    REQUIRE(output.diagnostics.size() == 1);
    const std::string text = one.code + "\n";
    const SourceText source(text);
    const std::optional<Reason> error = first_error(output.diagnostics, source, "");
    const std::vector<Reason> warned = warned_mistakes(output.diagnostics, source);
    CHECK((error ? error->name : warned.empty() ? std::string() : warned[0].name) == one.name);
  }
}

TEST_CASE("each of the beginners' mistakes is told in a tutor's words, and none as physics" *
          doctest::test_suite("thorough")) {
  const std::vector<Snippet> files = snippets_in("beginners.txt");
  CHECK(files.size() >= 200);
  std::vector<Told> all(files.size());
  on_all_processors(files.size(), [&](std::size_t k) { all[k] = told(files[k]); });
  std::string names;
  for (std::size_t k = 0; k < files.size(); ++k) {
    CAPTURE(files[k].title);
    CAPTURE(files[k].text);
    CAPTURE(to_string(all[k].verdict));
    CAPTURE(all[k].sentences);
    CHECK(all[k].verdict != Verdict::passed);
    std::vector<std::string> words;
    boost::iter_split(words, files[k].said, boost::first_finder(" / "));
    CHECK(std::ranges::any_of(words, [&](const std::string& said) { return has(all[k].sentences, said); }));
    for (const Reason& diagnosis : all[k].physics) CHECK(diagnosis.sentence == "");
    names += all[k].sentences;
  }
  CHECK(nothing_left_running());

  // Every mistake of the tables is in a file, or made by another compiler, and has a paragraph of the notes.
  for (const Snippet& file : snippets_in("mistakes.txt"))
    names += boost::replace_all_copy(file.said, "; ", "\n") + "\n";
  for (const auto* table : {&error_table, &warning_table})
    for (const MessageMistake& mistake : *table) {
      INFO(std::string(mistake.name));
      CHECK((*mistake.name == '\0' || has("\n" + names, fmt::format("\n{} ", mistake.name))));
    }
  const auto notes = read_file(WORKBOOK_TEST_SOURCES "/../../lectures/00_eigen/notes.md").value_or("");
  for (const Match& line : search_all("\n" + names, R"(\n([a-z]\w+) )"))
    CHECK_MESSAGE(search(notes, R"([ \n])" + line[1] + R"([ \n])"), line[1]);
}

TEST_CASE("what a text gives away by itself is told, and right lines that look like it are not") {
  for (const Snippet& each : snippets_in("text_mistakes.txt")) {
    CAPTURE(each.title);
    CAPTURE(each.text);
    std::string names;
    for (const Reason& found : text_mistakes(SourceText(each.text))) names += (names.empty() ? "" : " ") + found.name;
    CHECK((names.empty() ? "nothing" : names) == each.said);
  }
}

// Students' copies of the workbook have no solutions.
TEST_CASE("no solution of the course has a mistake in its text" * doctest::skip(!fs::exists(WORKBOOK_TEST_SOLUTIONS))) {
  std::size_t solutions = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(WORKBOOK_TEST_SOLUTIONS)) {
    const std::string name = entry.path().filename().string();
    const std::string text = entry.path().extension() == ".cpp" ? read_file(entry.path()).value_or("") : "";
    if (name == "main.cpp" || text.find("namespace rigid {") == std::string::npos) continue;
    CAPTURE(name);
    CHECK(names_of(text_mistakes(SourceText(text))) == "");
    ++solutions;
  }
  CHECK(solutions >= 48);
}

TEST_CASE("at most four mistakes are named, in the order of the lines") {
  CHECK(
      names_of(findings_in({.text = body("double a;\ndouble b = 1/2;\ndouble c = 1/3;\ndouble d = 1/4;\ndouble e = 1/5;"
                                         "\ndouble f = 1/6;\nreturn x;")})
                   .findings) ==
      "integer_division 4:12; integer_division 5:12; integer_division 6:12; integer_division 7:12");
}

TEST_CASE("a message of a template without end stays short") {
  const std::vector<Reason> found =
      findings_in(
          {.text =
               "template <int n, class T> struct Deep { using type = typename Deep<n - 1, std::vector<T>>::type; };\n"
               "template <class T> struct Deep<0, T> { using type = typename T::missing; };\n" +
               body("Deep<8, double>::type d; return x;")})
          .findings;
  REQUIRE(found.size() == 1);
  CHECK(found[0].line > 0);
  CHECK(found[0].sentence.size() <= 400);
}

TEST_CASE("a line that is too long, or holds control characters, is shown in part and safely") {
  for (const std::string& text :
       {body("/* " + std::string(2000, 'a') + " */ return y; // " + std::string(8000, 'b')),
        body("double z = 0" + std::string(20000, ' ') + "+ y; return z;"), body("/* \x1b[31m */ return y;")}) {
    const std::vector<Reason> found = findings_in({.text = text}).findings;
    REQUIRE(found.size() == 1);
    CHECK(found[0].line == 3);
    CHECK(found[0].excerpt.size() < 250);
    CHECK(found[0].excerpt.find('\x1b') == std::string::npos);
  }
}

TEST_CASE("where the search for mistakes itself fails, it finds nothing and says nothing") {
  const fs::path directory = fresh_directory("findings-trouble");
  const Submission submission = submit(body("Vector3d a;\nauto b = a + a; return x + b(0);"), "twice");
  const CompileTask task{submission, "twice", "double twice(double x)"};
  Toolchain broken = toolchain();
  broken.compiler = "/nowhere/c++";
  CHECK(source_findings(task, {}, broken, shared_cache()).empty());
  CHECK(source_findings(task, {}, toolchain(), write(directory / "in-the-way", "") / "cache").empty());
  CHECK(source_findings(task, {}, toolchain(), shared_cache(), {.time = std::chrono::milliseconds(1)}).empty());
  CHECK(nothing_left_running());
}

}  // namespace workbook::testing
