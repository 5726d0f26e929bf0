// What a closer look at a failure finds: the line in the student's file, and a sentence that is true.
#include "tests/running/student.hpp"

#include "checker/judging/judge.hpp"
#include "checker/second_look/second_look.hpp"

#include <doctest/doctest.h>
#include <cstdio>

using namespace workbook;
using namespace workbook::testing;

namespace {
const char* const top = "#include <fixture/contract.hpp>\n#include <cassert>\n#include <csignal>\n#include <unistd.h>\nusing namespace Eigen;\n";

struct Seen { Verdict verdict; std::string message; std::vector<Finding> findings; double seconds; };

Seen look_at(const std::string& exercise, const std::string& text, double x) {
  ExerciseReference reference;
  reference.name = exercise;
  Case one = twice_case(x);
  one.name = "made up";
  one.scale = {1}; one.tolerance = 1e-9;
  reference.signature = "double twice(double x)";
  if (exercise == "counted") { one.expected = Value{int(x), 1, {}}; for (int i = 0; i < x; ++i) one.expected.numbers.push_back(i); reference.result_kind = Kind::vector; reference.signature="VectorXd counted(int n)"; }
  if (exercise == "scaled") { one.inputs = {Value{3,3,{1,2,3,4,5,6,7,8,9}}, Value{1,1,{x}}}; one.expected = {3,3,{}}; for (int i = 1; i < 10; ++i) one.expected.numbers.push_back(i*x);  reference.result_kind = Kind::matrix3; }
  reference.cases = {one};
  const auto file = write(std::filesystem::path(WORKBOOK_TEST_SCRATCH) / "students" / (exercise + ".cpp"), text);
  RunLimits limits = short_limits(); limits.processor_time = std::chrono::seconds(1);
  ExerciseRunner runner(executable(text, exercise), limits);
  Observation observation = runner.observe(reference.cases, {0});
  Judgement judgement = judge(reference, observation);
  const auto start = std::chrono::steady_clock::now();
  auto findings = second_look({file, reference, observation, judgement}, toolchain(), shared_cache());
  return {judgement.verdict, judgement.message, findings, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}
struct Try { const char* code; const char* exercise = "twice"; double x = 3; };
}
TEST_CASE("experiment") {
  const std::string T = "double rigid::twice(double x) {\n";
  for (const auto& [body, exercise, x] : std::vector<Try>{
    {"  VectorXd v = VectorXd::Ones(3);\n  return v(3);"}, {"  Vector3d v(1,2,x);\n  return v[int(x)];"},
    {"  MatrixXd A = MatrixXd::Ones(3,4);\n  return A(1,4);"}, {"  MatrixXd A = MatrixXd::Ones(3,4);\n  return A.col(4).sum();"}, {"  MatrixXd A = MatrixXd::Ones(3,4);\n  return A.row(-1).sum();"},
    {"  MatrixXd A = MatrixXd::Ones(3,4);\n  return A.block(1,2,2,3).sum();"}, {"  VectorXd A = VectorXd::Ones(4);\n  return A.segment(2,3).sum();"}, {"  VectorXd A = VectorXd::Ones(4);\n  return A.head(5).sum();"}, {"  VectorXd A = VectorXd::Ones(4);\n  return A.tail<5>().sum();"},
    {"  VectorXd a = VectorXd::Ones(4), b = VectorXd::Ones(3);\n  return (a + b).sum();"}, {"  VectorXd a = VectorXd::Ones(4), b = VectorXd::Ones(3);\n  a += b; return a.sum();"}, {"  MatrixXd A = MatrixXd::Ones(3,4); VectorXd b = VectorXd::Ones(3);\n  return (A * b).sum();"},
    {"  VectorXd a = VectorXd::Ones(4), b = VectorXd::Ones(3);\n  return a.dot(b);"}, {"  Vector3d v;\n  v << 1, x;\n  return v[0];"}, {"  Vector3d v;\n  v << 1, 2, x, 4;\n  return v[0];"}, {"  Vector3d v;\n  v = VectorXd::Ones(int(x) + 1);\n  return v[0];"},
    {"  std::vector<double> v(3);\n  return v[int(x)];"}, {"  std::array<double, 3> v{};\n  return v[int(x)];"}, {"  std::vector<double> v(3);\n  return v.at(9);"}, {"  double v[3] = {};\n  return v[int(x)];"},
    {"  if (x > 2)\n    throw std::runtime_error(\"the moon\\x1b[31m is in the way\");\n  return x;"}, {"  throw 42;"}, {"  int n = int(x) - 3;\n  return 5 / n;"}, {"  int* p = nullptr;\n  *p = 1;\n  return x;"}, {"  return twice(x + 1) + 1;"}, {"  volatile double a[4000000];\n  a[0] = x;\n  return a[0];"},
    {"  std::abort();"}, {"  assert(x < 0);\n  return x;"}, {"  struct A { ~A() noexcept { throw std::runtime_error(\"late\"); } };\n  { A a; }\n  return x;"}, {"  delete[] (new double[3] + 1);\n  return x;"},
    {"  std::exit(0);"}, {"  std::vector<std::vector<double>> all;\n  for (;;)\n    all.emplace_back(1 << 20, 1.0);"}, {"  fork();\n  return x;"},
    {"  double y = 0;\n  while (true) {\n    y += std::sin(x);\n    y *= 0.5;\n  }\n  return y;"}, {"  for (;;) {}\n  return x;"}, {"  for (;;)\n    usleep(1000);\n  return x;"}, {"  for (;;)\n    std::cout << \"again\\n\";\n  return x;"},
    {"  double zero = x - 3;\n  return x / zero;"}, {"  double zero = x - 3;\n  return zero / zero;"}, {"  return std::sqrt(-x);"}, {"  return std::acos(x);"}, {"  return std::log(x - 3);"}, {"  Vector3d v(x - 3, 0, 0);\n  return v.normalized().sum() / v.norm();"}, {"  return std::exp(x * 1000);"}, {"  return NAN;"}, {"  return std::pow(-x, 0.5);"},
    {"  double sum;\n  for (int i = 0; i < 2; ++i)\n    sum += x;\n  return sum;"}, {"  Matrix3d A;\n  A(0, 0) = x;\n  return A.sum();"}, {"  int n;\n  double s = 0;\n  for (int i = 0; i < n % 7; ++i) s += 1;\n  return s;"}, {"  double r;\n  return r;"}, {"  if (x < 0) return x;\n}\nvoid g() {"}, {"  int big = 100000;\n  return big * big * x;"}, {"  return int(x * 1e30);"},
    {"  return 3 * x;"}, {"  static int n = 0;\n  return x + n++;"}, {"  std::random_device d;\n  return d();"},
    {"VectorXd rigid::counted(int n) {\n  VectorXd v(n);\n  for (int i = 1; i < n; ++i) v[i] = i;\n  return v;\n}\n", "counted", 5}, {"Matrix3d rigid::scaled(const Matrix3d& A, double k) {\n  Matrix3d B;\n  B.row(0) = k * A.row(0);\n  B.row(1) = k * A.row(1);\n  return B;\n}\n", "scaled", 2},
    {"  std::signal(SIGFPE, [](int) { _exit(3); });\n  double zero = x - 3;\n  return zero / zero;"}, {"  std::cerr << \"exercise.cpp:3:1: runtime error: division by zero\\n\";\n  return 3 * x;"}, {"  char noise[1072] = \"noise\";\n  (void)!write(3, noise, sizeof noise);\n  return NAN;"},
    {"  try { VectorXd v(2); v[2] = 1; } catch (...) {}\n  throw std::runtime_error(\"second\");"}, {"  MatrixXd A = MatrixXd::Ones(3,4);\n  return A.inverse().sum();"}, {"  Vector3d x1(1, 2, 3); x1 = x1.cross(Vector3d(VectorXd::Ones(2)));\n  return 0;"},
  }) {
    const std::string text = std::string(top) + (std::string(exercise) == "twice" ? T : "") + body + (std::string(exercise) == "twice" ? "\n}\n" : "");
    const Seen seen = look_at(exercise, text, x);
    std::printf("---- %s\n     [%s] %s  (%.2f s)\n", body, to_string(seen.verdict).c_str(), seen.message.c_str(), seen.seconds);
    for (const Finding& f : seen.findings) std::printf("  => Line %d: %s   | %s\n", f.line - 6, f.sentence.c_str(), f.excerpt.c_str());
  }
}
#include "checker/second_look/run_look.hpp"
#include "checker/second_look/call_places.hpp"
TEST_CASE("debug look") {
  for (const char* body : {"return std::log(x - 3);", "return std::pow(-x, 0.5);", "return std::sqrt(-x);", "return std::acos(x);", "return std::exp(1000 * x);", "return std::atan2(x, x) * std::log10(-x);", "return std::fmod(x, 0.0);", "return std::tgamma(-x);"}) {
  const std::string text = std::string(top) + "double rigid::twice(double x) {\n  "+body+"\n}\n";
  const auto file = write(std::filesystem::path(WORKBOOK_TEST_SCRATCH) / "students" / "twice.cpp", text);
  auto c = compile({.file = file, .exercise = "twice", .signature = "x"}, read_toolchain(toolchain().second_look), fresh_directory("dbg"));
  REQUIRE(c.executable);
  Look l = run_look(*c.executable, {Value{1,1,{3}}}, Paint::zero, sightings::Traps::non_finite);
  std::puts(body);
    for (auto& s : l.sightings) { std::printf(" [%d sig %d detail %ld %s %d]", int(s.what), s.signal, long(s.detail), s.text, int(s.arithmetic));
      auto p = find_places(toolchain().addr2line, *c.executable, std::vector<std::uint64_t>(s.calls, s.calls + s.call_count), "twice.cpp");
      for (int i = 0; i < s.call_count; ++i) for (auto& q : p[s.calls[i]]) { std::printf(" %s:%d |", q.function.substr(0, 40).c_str(), q.line); if (q.line) break; } }
    std::puts("");
  }
}
