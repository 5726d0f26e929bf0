// What a diagnostic run finds: the line in the student's file, the kind, and a sentence that is true. The sentences
// stand in golden/findings.txt.
#include "tests/running/student.hpp"
#include "tests/support/golden.hpp"

#include "checker/explain/diagnostic_run.hpp"
#include "checker/judging/judge.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

namespace workbook::testing {
namespace {

/// One file for most of the tests: every x fails in its own way.
const char* const many_failures = R"code(
#include <fixture/contract.hpp>
#include <cassert>
#include <csignal>
#include <unistd.h>

using namespace Eigen;

namespace {

double for_ever(double x) {
  return 1 + for_ever(x + 1);  // endless_recursion
}
double deep_array(double x) {  // stack_overflow
  volatile double a[4000000];
  a[0] = x;
  return a[0];
}
double forgets(double x) {  // missing_return
  if (x < 0) return x;
}
double nothing = 0;
struct Late { ~Late() { throw std::runtime_error("too late"); } };  // exception_not_caught
void careless() {
  Late late;
}
double other_exception(double x) {
  try {
    VectorXd v(2);
    v[2] = x;
  } catch (const std::exception&) {}
  throw std::logic_error("the second one");  // exception
}

double behave(double x) {
  VectorXd three = VectorXd::Ones(3), four = VectorXd::Ones(4);
  MatrixXd A = MatrixXd::Ones(3, 4);
  std::vector<double> list(3);
  switch (int(x)) {
    case 100: return three(3);  // index_out_of_range
    case 101: return three[-1];  // index_out_of_range
    case 102: return A(1, 4);  // index_out_of_range
    case 103: A(3, 0) = x; return 0;  // index_out_of_range
    case 104: return A.col(4).sum();  // index_out_of_range
    case 105: return A.row(-1).sum();  // index_out_of_range
    case 106: return A.block(1, 2, 2, 3).sum();  // index_out_of_range
    case 107: return four.segment(2, 3).sum();  // index_out_of_range
    case 108: return four.head(5).sum();  // index_out_of_range
    case 109: return four.tail<6>().sum();  // index_out_of_range
    case 110: return (three + four).sum();  // size_mismatch
    case 111: three += four; return 0;  // size_mismatch
    case 112: return (A * three).sum();  // size_mismatch
    case 113: return three.dot(four);  // size_mismatch
    case 114: { Vector3d v; v << 1, x; return v[0]; }  // comma_initializer
    case 115: { Vector3d v; v << 1, 2, 3, x; return v[0]; }  // comma_initializer
    case 116: { Vector3d v; v = four; return v[0]; }  // size_mismatch
    case 117: { MatrixXd B(2, 2); B << A; return 0; }  // comma_initializer
    case 118: return A.diagonal(7).sum();  // index_out_of_range
    case 119: { VectorXd empty; return empty[0]; }  // index_out_of_range
    case 120: return list[3];  // index_out_of_range
    case 121: { std::array<double, 2> a{}; return a[int(x) - 119]; }  // index_out_of_range
    case 122: return list.at(9);  // index_out_of_range
    case 123: { double a[3] = {}; return a[int(x) - 120]; }  // index_out_of_range
    case 124: list.clear(); return list.back();  // empty_container
    case 130: throw std::runtime_error("the moon \x1b[31m is in the way");  // exception
    case 131: throw 42;  // exception
    case 132: return other_exception(x);
    case 133: { int zero = int(x) - 133; return 5 / zero; }  // integer_division_by_zero
    case 134: { volatile double* p = nullptr; *p = x; return 0; }  // null_pointer
    case 135: return for_ever(x);
    case 136: return deep_array(x);
    case 137: std::abort();  // aborted
    case 138: assert(x < 0); return x;  // assertion_failed
    case 139: careless(); return x;
    case 140: std::exit(0);  // exit
    case 141: { std::vector<std::vector<double>> all; for (;;) all.emplace_back(1 << 20, 1.0); }  // out_of_memory
    case 142: return fork();  // forbidden_operation
    case 143: { double* p = new double[3]; delete[] p; delete[] p; return x; }  // freed_wrongly
    case 144: { double* p = new double[3]; p[3] = x; delete[] p; return p[1]; }  // memory_out_of_bounds
    case 145: { auto sum = VectorXd(three) + VectorXd(2 * three); return sum.sum(); }  // use_after_end
    case 146: return x * (1 << (int(x) - 100));  // invalid_shift
    case 150:
      while (true) {
        nothing += 1e-9 * x;  // endless_loop
        nothing = std::sqrt(nothing);  // endless_loop
      }
    case 151: for (;;) usleep(1000);  // endless_loop
    case 152: nothing = 0;  // endless_printing
      for (;;) std::cout << "again and again\n";  // endless_printing
    case 160: return x / nothing;  // division_by_zero
    case 161: return nothing / nothing;  // division_by_zero
    case 162: return std::sqrt(-x);  // outside_domain
    case 163: return std::acos(x);  // outside_domain
    case 164: return std::log(nothing);  // outside_domain
    case 165: return std::exp(1000 * x);  // outside_domain
    case 166: return std::pow(-x, 0.5);  // outside_domain
    case 167: return x * 1e200 * 1e200;  // non_finite
    case 168: return Vector3d(x, 0, 0).cross(Vector3d(1, 0, 0)).normalized()[0] / nothing;  // division_by_zero
    case 169: return NAN;
    case 170: { double sum; for (int i = 0; i < 2; ++i) sum += x; return sum; }  // never_set
    case 171: { Matrix3d B; B(0, 0) = x; return B.trace(); }  // never_set
    case 172: { int n; for (int i = 0; i < n % 7; ++i) x += 1; return x; }
    case 173: { double unset; return unset; }
    case 174: return forgets(x);
    case 175: { int big = 100000; return big * big * x; }  // integer_overflow
    case 176: return int(x * 1e30);  // conversion_out_of_range
    case 177: ::_exit(3);  // exit
    case 178: std::quick_exit(0);  // exit
    case 180: return 3 * x;
    case 181: { static int calls = 0; return x + ++calls; }
    case 182: { std::random_device device; return device(); }
    case 183: std::cerr << "twice.cpp:3:1: runtime error: division by zero\n"; return 3 * x;
    case 184: std::signal(SIGFPE, [](int) { _exit(3); }); return nothing / nothing;
  }
  return 2 * x;
}

}  // namespace

double rigid::twice(double x) { return behave(x); }
)code";

/// A file, judged at one case.
struct Judged {
  Submission submission;
  ExerciseReference reference;
  Observation observation;
  Judgement judgement;

  DiagnosticTask task() const { return {submission, reference, observation, judgement}; }
};

ExerciseReference reference_of(const std::string& exercise, const Case& one, Kind kind) {
  ExerciseReference reference;
  reference.name = exercise;
  reference.signature = exercise;
  reference.result_kind = kind;
  reference.cases = {one};
  reference.cases[0].name = "made up";
  reference.cases[0].scale = {1.0};
  return reference;
}

Judged judged(const std::string& text, const ExerciseReference& reference) {
  Judged result{submit(text, reference.name), reference, {}, {}};
  ExerciseRunner runner(executable(text, reference.name), short_limits());
  result.observation = runner.observe(plan_calls(reference.cases), {0});
  result.judgement = judge(reference, result.observation);
  return result;
}

Judged judged(const std::string& text, double x) {
  return judged(text, reference_of("twice", twice_case(x), Kind::number));
}

/// A file, compiled for diagnostic runs.
std::filesystem::path diagnostic_program(const std::string& text) {
  const Compilation compilation =
      compile({.submission = submit(text, "twice"), .exercise = "twice", .signature = "twice"},
              read_toolchain(toolchain().diagnostic), shared_cache());
  INFO(compilation.message << "\n" << compilation.details);
  REQUIRE(compilation.executable.has_value());
  return *compilation.executable;
}

std::vector<Reason> findings_at(double x) {
  const Judged failed = judged(many_failures, x);
  REQUIRE(can_be_explained_by_a_run(failed.judgement));
  return diagnostic_run_of(diagnostic_program(many_failures), failed.task(), toolchain());
}

std::vector<Reason> full_run(const std::string& text, double x) {
  return diagnostic_run(judged(text, x).task(), toolchain(), shared_cache());
}

std::string line_of_failures(int line) {
  const std::string text = many_failures;
  std::size_t begin = 0;
  for (int at = 1; at < line; ++at) begin = text.find('\n', begin) + 1;
  return text.substr(begin, text.find('\n', begin) - begin);
}

std::string only_in_diagnostic_runs(const std::string& code, const std::string& always) {
  return "#include <fixture/contract.hpp>\n#include <unistd.h>\n#include <sys/socket.h>\n#include <fstream>\n"
         "double rigid::twice(double x) {\n#ifndef __OPTIMIZE__\n" +
         code + "\n#endif\n" + always + "\nreturn x;\n}\n";
}

}  // namespace

TEST_CASE("each failure is traced to its line and its kind, which the line names in a comment" *
          doctest::test_suite("thorough")) {
  std::string sentences;
  for (int x = 100; x < 180; ++x) {
    if (std::string(many_failures).find("case " + std::to_string(x) + ":") == std::string::npos || x == 169) continue;
    CAPTURE(x);
    const std::vector<Reason> findings = findings_at(x);
    REQUIRE(findings.size() == 1);
    const Reason& finding = findings.front();
    const std::string line = line_of_failures(finding.line);
    CAPTURE(line);
    CAPTURE(finding.name);
    if (finding.line > 0) {
      CHECK(line.ends_with("  // " + finding.name));
      CHECK(line.find(finding.excerpt.substr(0, 90)) != std::string::npos);
    } else {
      CHECK(finding.name == "never_set");
    }
    if (x != 150) sentences += std::to_string(x) + ": " + finding.sentence + "\n";
  }
  compare_with_golden(golden("findings.txt"), sentences);
  CHECK(nothing_left_running());
}

TEST_CASE("a result that is not filled is found, on the heap and on the stack") {
  Case five;
  five.inputs = {Value{1, 1, {5.0}}};
  five.expected = Value{5, 1, {0, 1, 2, 3, 4}};
  const Judged counted = judged(
      "#include <fixture/contract.hpp>\nrigid::VectorXd rigid::counted(int n) {\n  VectorXd v(n);\n"
      "  for (int i = 1; i < n; ++i) v[i] = i;\n  return v;\n}\n",
      reference_of("counted", five, Kind::vector));
  Case twice_a_matrix;
  twice_a_matrix.inputs = {Value{3, 3, {1, 2, 3, 4, 5, 6, 7, 8, 9}}, Value{1, 1, {2.0}}};
  twice_a_matrix.expected = Value{3, 3, {2, 4, 6, 8, 10, 12, 14, 16, 18}};
  const Judged scaled = judged(
      "#include <fixture/contract.hpp>\nrigid::Matrix3d rigid::scaled(const Matrix3d& A, double k) {\n  Matrix3d B;\n"
      "  B.topRows(2) = k * A.topRows(2);\n  return B;\n}\n",
      reference_of("scaled", twice_a_matrix, Kind::matrix3));
  for (const Judged* failed : {&counted, &scaled}) {
    const std::vector<Reason> findings = diagnostic_run(failed->task(), toolchain(), shared_cache());
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].name == "never_set");
    CHECK(findings[0].line == 3);  // where it is declared
  }
}

TEST_CASE("where nothing certain can be said nothing is said") {
  for (const double x : {169.0, 180.0, 181.0, 182.0, 183.0, 184.0}) {
    CAPTURE(x);
    CHECK(findings_at(x).empty());
  }
}

TEST_CASE("only a function that ran and failed is run again") {
  CHECK_FALSE(can_be_explained_by_a_run(judged(many_failures, 1.0).judgement));
  for (const Verdict verdict : {Verdict::compile_error, Verdict::not_started, Verdict::checker_error,
                                Verdict::rejected_file, Verdict::missing_function, Verdict::protocol_violation}) {
    Judgement judgement;
    judgement.verdict = verdict;
    CHECK_FALSE(can_be_explained_by_a_run(judgement));
  }
}

TEST_CASE("a file that defeats the run only goes without an explanation" * doctest::test_suite("thorough")) {
  for (const std::string code :
       {"#error no", "return x;", "for (;;) {}", "close(3); for (;;) {}", "close(2); _exit(0);",
        "char noise[4000] = \"noise\"; (void)!write(3, noise, sizeof noise);",
        "for (;;) (void)!write(2, \"event exception\\n\", 16);",
        "char a[] = \"event thrown\\nframe 9|/shown/twice.cpp|f\\n\"; (void)!write(2, a, sizeof a); _exit(0);"}) {
    CAPTURE(code);
    CHECK(full_run(only_in_diagnostic_runs(code, "throw 1;"), 1).empty());
    CHECK(nothing_left_running());
  }
}

TEST_CASE("any report can be read, whatever its bytes") {
  CHECK(read_report("", "a.cpp").empty());
  for (const std::string text : {"frame 1|/shown/a.cpp|f", "event", "event ", "event x|", "event x\nframe",
                                 "event x\nframe |", "event x\nframe 1|", "==1==ERROR: AddressSanitizer:",
                                 "a:1:1: runtime error: ", "SUMMARY: UndefinedBehaviorSanitizer: x y"}) {
    CAPTURE(text);
    for (const DiagnosticEvent& event : read_report(text, "a.cpp")) CHECK(event.line() == 0);
  }
  const std::string far = std::string(100000, '|') + "\n" + std::string(100000, '(');
  CHECK(read_report("event x" + far, "a.cpp").size() == 1);
}

TEST_CASE("without its tools there is no diagnostic run, and no trouble either") {
  const Judged failed = judged("#include <fixture/contract.hpp>\ndouble rigid::twice(double) { throw 1; }\n", 1);
  CHECK(missing_for_diagnostic_runs(toolchain()) == "");
  CHECK(diagnostic_run(failed.task(), toolchain(), shared_cache()).size() == 1);
  Toolchain poor = toolchain();
  for (const std::filesystem::path& none : {std::filesystem::path(), std::filesystem::path("/nowhere/toolchain.json"),
                                            write(fresh_directory("damaged") / "toolchain.json", "{")}) {
    poor.diagnostic = none;
    if (none.empty()) CHECK(missing_for_diagnostic_runs(poor).find("sanitizers") != std::string::npos);
    CHECK(diagnostic_run(failed.task(), poor, shared_cache()).empty());
  }
  CHECK(diagnostic_run(failed.task(), toolchain(), "/nowhere/at/all").empty());
}

TEST_CASE("a diagnostic run leaves nothing behind, and an odd file name does not hide the line") {
  const std::filesystem::path scratch = fresh_directory("diagnostic_scratch");
  const std::string text = "#include <fixture/contract.hpp>\ndouble rigid::twice(double) { throw 1; }\n";
  Judged failed = judged(text, 1);
  failed.submission.path = "my \"own\" answer (2): new.cpp";
  const std::vector<Reason> findings = diagnostic_run(failed.task(), toolchain(), scratch);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].line == 2);
  CHECK(findings[0].excerpt == "double rigid::twice(double) { throw 1; }");
  CHECK(std::filesystem::is_empty(scratch));
  CHECK(nothing_left_running());
}

}  // namespace workbook::testing
