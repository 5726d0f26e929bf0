// What a closer look at a failure finds: the line in the student's file, and a sentence that is true.
#include "tests/running/student.hpp"

#include "checker/judging/judge.hpp"
#include "checker/sandbox/diagnostic_run.hpp"
#include "checker/worker/instrumented/sighting.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <fstream>
#include <optional>
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
  return 1 + for_ever(x + 1);
}
double deep_array(double x) {
  volatile double a[4000000];
  a[0] = x;
  return a[0];
}
double forgets(double x) {
  if (x < 0) return x;
}
double nothing = 0;
struct Late { ~Late() { throw std::runtime_error("too late"); } };
void careless() {
  Late late;
}
double other_exception(double x) {
  try {
    VectorXd v(2);
    v[2] = x;
  } catch (const std::exception&) {}
  throw std::logic_error("the second one");
}

double behave(double x) {
  VectorXd three = VectorXd::Ones(3), four = VectorXd::Ones(4);
  MatrixXd A = MatrixXd::Ones(3, 4);
  std::vector<double> list(3);
  switch (int(x)) {
    case 100: return three(3);
    case 101: return three[-1];
    case 102: return A(1, 4);
    case 103: A(3, 0) = x; return 0;
    case 104: return A.col(4).sum();
    case 105: return A.row(-1).sum();
    case 106: return A.block(1, 2, 2, 3).sum();
    case 107: return four.segment(2, 3).sum();
    case 108: return four.head(5).sum();
    case 109: return four.tail<6>().sum();
    case 110: return (three + four).sum();
    case 111: three += four; return 0;
    case 112: return (A * three).sum();
    case 113: return three.dot(four);
    case 114: { Vector3d v; v << 1, x; return v[0]; }
    case 115: { Vector3d v; v << 1, 2, 3, x; return v[0]; }
    case 116: { Vector3d v; v = four; return v[0]; }
    case 117: { MatrixXd B(2, 2); B << A; return 0; }
    case 118: return A.diagonal(7).sum();
    case 119: { VectorXd empty; return empty[0]; }
    case 120: return list[3];
    case 121: { std::array<double, 2> a{}; return a[int(x) - 119]; }
    case 122: return list.at(9);
    case 123: { double a[3] = {}; return a[int(x) - 120]; }
    case 124: list.clear(); return list.back();
    case 130: throw std::runtime_error("the moon \x1b[31m is in the way");
    case 131: throw 42;
    case 132: return other_exception(x);
    case 133: { int zero = int(x) - 133; return 5 / zero; }
    case 134: { volatile double* p = nullptr; *p = x; return 0; }
    case 135: return for_ever(x);
    case 136: return deep_array(x);
    case 137: std::abort();
    case 138: assert(x < 0); return x;
    case 139: careless(); return x;
    case 140: std::exit(0);
    case 141: { std::vector<std::vector<double>> all; for (;;) all.emplace_back(1 << 20, 1.0); }
    case 142: return fork();
    case 143: { double* p = new double[3]; delete[] p; delete[] p; return x; }
    case 150:
      while (true) {
        nothing += 1e-9 * x;
        nothing = std::sqrt(nothing);
      }
    case 151: for (;;) usleep(1000);
    case 152: for (;;) std::cout << "again and again\n";
    case 160: return x / nothing;
    case 161: return nothing / nothing;
    case 162: return std::sqrt(-x);
    case 163: return std::acos(x);
    case 164: return std::log(nothing);
    case 165: return std::exp(1000 * x);
    case 166: return std::pow(-x, 0.5);
    case 167: return x * 1e200 * 1e200;
    case 168: return Vector3d(x, 0, 0).cross(Vector3d(1, 0, 0)).normalized()[0] / nothing;
    case 169: return NAN;
    case 170: { double sum; for (int i = 0; i < 2; ++i) sum += x; return sum; }
    case 171: { Matrix3d B; B(0, 0) = x; return B.trace(); }
    case 172: { int n; for (int i = 0; i < n % 7; ++i) x += 1; return x; }
    case 173: { double unset; return unset; }
    case 174: return forgets(x);
    case 175: { int big = 100000; return big * big * x; }
    case 176: return int(x * 1e30);
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
  std::filesystem::path file;
  ExerciseReference reference;
  Observation observation;
  Judgement judgement;

  SecondLookTask task() const { return {file, reference, observation, judgement}; }
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
  Judged result{write(std::filesystem::path(WORKBOOK_TEST_SCRATCH) / "students" / (reference.name + ".cpp"), text),
                reference,
                {},
                {}};
  ExerciseRunner runner(executable(text, reference.name), short_limits());
  result.observation = runner.observe(reference.cases, {0});
  result.judgement = judge(reference, result.observation);
  return result;
}

Judged judged(const std::string& text, double x) {
  return judged(text, reference_of("twice", twice_case(x), Kind::number));
}

/// The file of many failures, compiled for looking once.
const std::filesystem::path& witness() {
  static const std::filesystem::path compiled = [] {
    const auto file = write(std::filesystem::path(WORKBOOK_TEST_SCRATCH) / "students" / "twice.cpp", many_failures);
    const Compilation compilation = compile({.file = file, .exercise = "twice", .signature = "twice"},
                                            read_toolchain(toolchain().second_look), shared_cache());
    INFO(compilation.message << "\n" << compilation.details);
    REQUIRE(compilation.executable.has_value());
    return *compilation.executable;
  }();
  return compiled;
}

std::vector<Finding> findings_at(double x) {
  const Judged failed = judged(many_failures, x);
  REQUIRE(deserves_second_look(failed.judgement));
  return second_look_with(witness(), failed.task(), toolchain());
}

/// "CODE -> SENTENCE" of the only finding; its line must be where the code stands.
std::string finding_at(double x) {
  const std::vector<Finding> findings = findings_at(x);
  if (findings.size() != 1) return std::to_string(findings.size()) + " findings";
  const Finding& finding = findings.front();
  if (finding.line == 0) return finding.sentence;
  const std::string text = many_failures;
  std::size_t begin = 0;
  for (int line = 1; line < finding.line; ++line) begin = text.find('\n', begin) + 1;
  const std::string line = text.substr(begin, text.find('\n', begin) - begin);
  CHECK(line.find(finding.excerpt) != std::string::npos);
  const std::size_t label = finding.excerpt.find(": ");
  return (label == std::string::npos ? finding.excerpt : finding.excerpt.substr(label + 2)) + " -> " + finding.sentence;
}

std::vector<Finding> full_look(const std::string& text, double x) {
  return second_look(judged(text, x).task(), toolchain(), shared_cache());
}

std::string only_when_looked_at(const std::string& code, const std::string& always) {
  return "#include <fixture/contract.hpp>\n#include <unistd.h>\ndouble rigid::twice(double x) {\n"
         "#ifndef __OPTIMIZE__\n" +
         code + "\n#endif\n" + always + "\nreturn x;\n}\n";
}

}  // namespace

TEST_CASE("an index outside a vector or matrix is named with the line and the size") {
  CHECK(finding_at(100) == "return three(3); -> index 3 is outside the vector of size 3 (indices 0 to 2).");
  CHECK(finding_at(101) == "return three[-1]; -> index -1 is outside the vector of size 3 (indices 0 to 2).");
  CHECK(finding_at(102) == "return A(1, 4); -> column 4 is outside the 3×4 matrix (columns 0 to 3).");
  CHECK(finding_at(103) == "A(3, 0) = x; return 0; -> row 3 is outside the 3×4 matrix (rows 0 to 2).");
  CHECK(finding_at(104) == "return A.col(4).sum(); -> column 4 is outside the 3×4 matrix (columns 0 to 3).");
  CHECK(finding_at(105) == "return A.row(-1).sum(); -> row -1 is outside the 3×4 matrix (rows 0 to 2).");
  CHECK(finding_at(119) == "{ VectorXd empty; return empty[0]; } -> there is no index 0 in an empty vector.");
  CHECK(finding_at(120) == "return list[3]; -> index 3 is outside the vector of size 3 (indices 0 to 2).");
  CHECK(finding_at(121) ==
        "{ std::array<double, 2> a{}; return a[int(x) - 119]; } -> "
        "index 2 is outside the array of size 2 (indices 0 to 1).");
  CHECK(finding_at(122) == "return list.at(9); -> index 9 is outside the vector of size 3 (indices 0 to 2).");
  CHECK(finding_at(123) ==
        "{ double a[3] = {}; return a[int(x) - 120]; } -> "
        "index 3 is outside the array of size 3 (indices 0 to 2).");
  CHECK(finding_at(124) ==
        "list.clear(); return list.back(); -> an empty container has no first or last element to give.");
}

TEST_CASE("parts that reach outside are named with their sizes") {
  CHECK(finding_at(106) ==
        "return A.block(1, 2, 2, 3).sum(); -> a 2×3 block that begins at (1, 2) reaches outside the 3×4 matrix.");
  CHECK(finding_at(107) ==
        "return four.segment(2, 3).sum(); -> 3 entries from index 2 reach outside the vector of "
        "size 4 (indices 0 to 3).");
  CHECK(finding_at(108) == "return four.head(5).sum(); -> 5 entries are asked for, but the vector has size 4.");
  CHECK(finding_at(109) == "return four.tail<6>().sum(); -> 6 entries are asked for, but the vector has size 4.");
  CHECK(finding_at(118) == "return A.diagonal(7).sum(); -> a 3×4 matrix has no diagonal(7).");
}

TEST_CASE("sizes that do not fit together are both named") {
  CHECK(finding_at(110) ==
        "return (three + four).sum(); -> a vector of size 3 and a vector of size 4 cannot be "
        "combined entry by entry: the sizes 3×1 and 4×1 differ.");
  CHECK(finding_at(111) ==
        "three += four; return 0; -> a vector of size 4 is put into, added to or taken from a vector "
        "of size 3: the sizes 4×1 and 3×1 differ.");
  CHECK(finding_at(112) ==
        "return (A * three).sum(); -> matrix product of a 3×4 by a 3×1: left columns (4) must equal "
        "right rows (3).");
  CHECK(finding_at(113) == "return three.dot(four); -> dot() needs two vectors of the same size; these have 3 and 4.");
  CHECK(finding_at(114) ==
        "{ Vector3d v; v << 1, x; return v[0]; } -> 2 numbers after << cannot fill a vector of size "
        "3: it has 3 entries.");
  CHECK(finding_at(115) ==
        "{ Vector3d v; v << 1, 2, 3, x; return v[0]; } -> too many numbers after << for a vector of "
        "size 3: it has 3 entries.");
  CHECK(finding_at(116) ==
        "{ Vector3d v; v = four; return v[0]; } -> a vector of size 4 does not fit into the fixed size 3×1.");
  CHECK(finding_at(117) ==
        "{ MatrixXd B(2, 2); B << A; return 0; } -> a 3×4 matrix after << is larger than a 2×2 "
        "matrix, which it shall fill.");
}

TEST_CASE("an exception is traced to the line that throws it") {
  CHECK(finding_at(130) ==
        "throw std::runtime_error(\"the moon \\x1b[31m is in the way\"); -> "
        "the exception “the moon ?[31m is in the way” is thrown here.");
  CHECK(finding_at(131) == "throw 42; -> the exception is thrown here.");
  CHECK(finding_at(132) ==
        "throw std::logic_error(\"the second one\"); -> "
        "the exception “the second one” is thrown here.");
}

TEST_CASE("a crash is traced to its line and its cause") {
  CHECK(finding_at(133) == "{ int zero = int(x) - 133; return 5 / zero; } -> a whole number is divided by zero.");
  CHECK(finding_at(134) ==
        "{ volatile double* p = nullptr; *p = x; return 0; } -> "
        "a pointer or reference to nothing is used here.");
  CHECK(finding_at(135) ==
        "return 1 + for_ever(x + 1); -> "
        "the function calls itself here again and again, until the stack is used up.");
  CHECK(finding_at(136) ==
        "double deep_array(double x) { -> the stack is used up here; a local array may be too large.");
  CHECK(finding_at(137) == "std::abort(); -> the program is aborted here.");
  CHECK(finding_at(138) == "assert(x < 0); return x; -> your assertion “x < 0” does not hold here.");
  CHECK(finding_at(139) ==
        "struct Late { ~Late() { throw std::runtime_error(\"too late\"); } }; -> the exception “too late” is thrown "
        "here and cannot be caught on its way out: it meets a destructor or noexcept.");
  CHECK(finding_at(143) ==
        "{ double* p = new double[3]; delete[] p; delete[] p; return x; } -> here memory is found to "
        "be damaged: something before wrote beyond its end, or was given back twice.");
}

TEST_CASE("what an exercise may not do is traced to its line") {
  CHECK(finding_at(140) == "std::exit(0); -> the program is ended here, before the function returns.");
  CHECK(finding_at(141) ==
        "{ std::vector<std::vector<double>> all; for (;;) all.emplace_back(1 << 20, 1.0); } -> "
        "more memory is asked for here than an exercise may use.");
  if (!sandbox_strength().filters_system_calls) return;
  CHECK(finding_at(142) == "return fork(); -> here the function tries to start a thread or another process (clone).");
}

TEST_CASE("a function that does not come to an end is asked where it is") {
  const std::vector<Finding> loop = findings_at(150);
  REQUIRE(loop.size() == 1);
  CHECK(loop[0].sentence.starts_with("the function was still at work"));
  CHECK(loop[0].excerpt.starts_with("nothing "));
  CHECK(finding_at(151) == "for (;;) usleep(1000); -> the function was still at work here when it was stopped.");
  CHECK(finding_at(152) ==
        "for (;;) std::cout << \"again and again\\n\"; -> "
        "the function was still printing here when it was stopped.");
}

TEST_CASE("the first value that is not finite is traced to its calculation") {
  CHECK(finding_at(160) == "return x / nothing; -> a division by zero gives an infinite value here.");
  CHECK(finding_at(161) ==
        "return nothing / nothing; -> 0/0 is not a number (NaN): numerator and denominator are both zero here.");
  CHECK(finding_at(162) == "return std::sqrt(-x); -> the root of a negative number is not a number (NaN).");
  CHECK(finding_at(163) ==
        "return std::acos(x); -> acos is only defined from −1 to 1: of a number beyond, even by "
        "rounding, it gives NaN.");
  CHECK(finding_at(164) ==
        "return std::log(nothing); -> the logarithm of 0 or of a negative number is infinite or not "
        "a number (NaN).");
  CHECK(finding_at(165) == "return std::exp(1000 * x); -> exp of so large a number is infinite.");
  CHECK(finding_at(166) ==
        "return std::pow(-x, 0.5); -> pow has no finite result here: look at a negative base with a "
        "broken exponent, and at 0 to a negative one.");
  CHECK(finding_at(167) == "return x * 1e200 * 1e200; -> a number becomes too large here and turns infinite.");
  CHECK(finding_at(168).ends_with("-> 0/0 is not a number (NaN): numerator and denominator are both zero here."));
}

TEST_CASE("what was never set is found by what it does to the result") {
  const std::string here =
      " -> something is used here that was never given a value: a variable, or an entry of a matrix or vector.";
  CHECK(finding_at(170) == "{ double sum; for (int i = 0; i < 2; ++i) sum += x; return sum; }" + here);
  CHECK(finding_at(171) == "{ Matrix3d B; B(0, 0) = x; return B.trace(); }" + here);
  CHECK(finding_at(172) ==
        "The result depends on something that was never given a value: a variable without = or {}, "
        "or a matrix or vector that is not filled.");
  CHECK(finding_at(173) == "The result is never given a value.");
}

TEST_CASE("entries of a result that were never set are named") {
  Case five;
  five.inputs = {Value{1, 1, {5.0}}};
  five.expected = Value{5, 1, {0, 1, 2, 3, 4}};
  const Judged counted = judged(
      "#include <fixture/contract.hpp>\nrigid::VectorXd rigid::counted(int n) {\n  VectorXd v(n);\n"
      "  for (int i = 1; i < n; ++i) v[i] = i;\n  return v;\n}\n",
      reference_of("counted", five, Kind::vector));
  const std::vector<Finding> one = second_look(counted.task(), toolchain(), shared_cache());
  REQUIRE(one.size() == 1);
  CHECK(one[0].sentence == "Component 1 of the result is never given a value.");

  Case twice_a_matrix;
  twice_a_matrix.inputs = {Value{3, 3, {1, 2, 3, 4, 5, 6, 7, 8, 9}}, Value{1, 1, {2.0}}};
  twice_a_matrix.expected = Value{3, 3, {2, 4, 6, 8, 10, 12, 14, 16, 18}};
  const Judged scaled = judged(
      "#include <fixture/contract.hpp>\nrigid::Matrix3d rigid::scaled(const Matrix3d& A, double k) {\n  Matrix3d B;\n"
      "  B.topRows(2) = k * A.topRows(2);\n  return B;\n}\n",
      reference_of("scaled", twice_a_matrix, Kind::matrix3));
  const std::vector<Finding> three = second_look(scaled.task(), toolchain(), shared_cache());
  REQUIRE(three.size() == 1);
  CHECK(three[0].sentence == "Entry (3,1), entry (3,2), entry (3,3) of the result are never given a value.");
}

TEST_CASE("what the language leaves undefined is found in a wrong value") {
  CHECK(finding_at(174) == "double forgets(double x) { -> the function comes to its end here without a return.");
  CHECK(finding_at(175) ==
        "{ int big = 100000; return big * big * x; } -> 100000 · 100000 does not fit into the type "
        "int; calculate in double.");
  CHECK(finding_at(176) ==
        "return int(x * 1e30); -> a number that no whole number of this type can hold (too large, "
        "infinite or NaN) is converted to one.");
}

TEST_CASE("where nothing certain can be said nothing is said") {
  for (const double x : {169.0, 180.0, 181.0, 182.0, 183.0, 184.0}) {
    CAPTURE(x);
    CHECK(findings_at(x).empty());
  }
}

TEST_CASE("a passed, diagnosed or refused exercise is not looked at again") {
  CHECK_FALSE(deserves_second_look(judged(many_failures, 1.0).judgement));
  Judgement judgement;
  judgement.verdict = Verdict::wrong_value;
  CHECK(deserves_second_look(judgement));
  judgement.diagnoses.emplace_back();
  CHECK_FALSE(deserves_second_look(judgement));
  for (const Verdict verdict : {Verdict::compile_error, Verdict::not_started, Verdict::checker_error,
                                Verdict::rejected_file, Verdict::missing_function, Verdict::protocol_violation}) {
    judgement = {};
    judgement.verdict = verdict;
    CHECK_FALSE(deserves_second_look(judgement));
  }
}

TEST_CASE("a file that defeats the look only goes without an explanation") {
  const std::string throws = "throw 1;";
  SUBCASE("it does not compile") { CHECK(full_look(only_when_looked_at("#error no", throws), 1).empty()); }
  SUBCASE("it returns") { CHECK(full_look(only_when_looked_at("return x;", throws), 1).empty()); }
  SUBCASE("it loops") { CHECK(full_look(only_when_looked_at("for (;;) {}", throws), 1).empty()); }
  SUBCASE("it closes the line") { CHECK(full_look(only_when_looked_at("close(3); for (;;) {}", throws), 1).empty()); }
  SUBCASE("it ends before main") {
    CHECK(full_look("#ifndef __OPTIMIZE__\n#include <unistd.h>\nstatic int early = (_exit(0), 1);\n#endif\n"
                    "#include <fixture/contract.hpp>\ndouble rigid::twice(double) { throw 1; }\n",
                    1)
              .empty());
  }
  SUBCASE("it writes noise") {
    CHECK(
        full_look(only_when_looked_at("char noise[4000] = \"noise\"; (void)!write(3, noise, sizeof noise);", throws), 1)
            .empty());
  }
  SUBCASE("it writes half a sighting") {
    CHECK(full_look(
              only_when_looked_at("char noise[7] = \"noise\"; (void)!write(3, noise, sizeof noise); _exit(0);", throws),
              1)
              .empty());
  }
  SUBCASE("it forges a sighting") {
    const std::string forged = "unsigned long forged[" + std::to_string(sizeof(sightings::Sighting) / 8) + "] = {" +
                               std::to_string(sightings::sighting_magic) +
                               "ul, 12345, 13}; (void)!write(3, forged, sizeof forged);";
    CHECK(full_look(only_when_looked_at(forged, throws), 1).empty());
  }
  CHECK(nothing_left_running());
}

TEST_CASE("without its tools there is no second look, and no trouble either") {
  const std::string text = "#include <fixture/contract.hpp>\ndouble rigid::twice(double) { throw 1; }\n";
  const Judged failed = judged(text, 1);
  CHECK(second_look(failed.task(), toolchain(), shared_cache()).size() == 1);
  Toolchain poor = toolchain();
  SUBCASE("no way to find a line") { poor.addr2line = "/nowhere/addr2line"; }
  SUBCASE("no toolchain") { poor.second_look.clear(); }
  SUBCASE("a missing toolchain") { poor.second_look = "/nowhere/toolchain.json"; }
  SUBCASE("a damaged toolchain") { poor.second_look = write(fresh_directory("damaged_look") / "toolchain.json", "{"); }
  CHECK(second_look(failed.task(), poor, shared_cache()).empty());
  CHECK(second_look(failed.task(), toolchain(), "/nowhere/at/all").empty());
}

TEST_CASE("a second look leaves nothing behind") {
  const std::filesystem::path scratch = fresh_directory("second_look_scratch");
  const Judged failed = judged("#include <fixture/contract.hpp>\ndouble rigid::twice(double) { throw 1; }\n", 1);
  CHECK(second_look(failed.task(), toolchain(), scratch).size() == 1);
  CHECK(std::filesystem::is_empty(scratch));
  CHECK(nothing_left_running());
}

TEST_CASE("an odd file name does not hide the line") {
  const std::string text = "#include <fixture/contract.hpp>\ndouble rigid::twice(double) { throw 1; }\n";
  Judged failed = judged(text, 1);
  failed.file = write(fresh_directory("odd_name") / "my \"own\" answer (2): new.cpp", text);
  const std::vector<Finding> findings = second_look(failed.task(), toolchain(), shared_cache());
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].line == 2);
  CHECK(findings[0].excerpt == "double rigid::twice(double) { throw 1; }");
}

}  // namespace workbook::testing
