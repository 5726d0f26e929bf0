// Whole runs: all kinds of values, shapes, repeats, probes, and a checker that cannot run anything.
#include "tests/running/student.hpp"
#include "tests/support/system_calls.hpp"

#include <doctest/doctest.h>

#include <sys/syscall.h>

#include <cerrno>
#include <ctime>
#include <numeric>

namespace workbook::testing {
namespace {

Value vector_of(std::vector<double> numbers) {
  const int size = static_cast<int>(numbers.size());
  return {size, 1, std::move(numbers)};
}

Value counted_to(int n) {
  std::vector<double> numbers(static_cast<std::size_t>(n));
  std::iota(numbers.begin(), numbers.end(), 0.0);
  return vector_of(numbers);
}

const char* const counted = R"(
#include <fixture/contract.hpp>
rigid::VectorXd rigid::counted(int n) { return VectorXd::LinSpaced(n, 0, n - 1); }
)";

}  // namespace

TEST_CASE("numbers and integers travel") {
  ExerciseRunner runner(executable("double rigid::signed_by(int n, double x) { return n < 0 ? -x : x; }", "signed_by"),
                        short_limits());
  const std::vector<Reply> replies =
      runner.evaluate({{{vector_of({-3}), vector_of({0.1})}}, {{vector_of({4}), vector_of({0.1})}}});
  REQUIRE(replies.size() == 2);
  CHECK(replies[0].value == Value{1, 1, {-0.1}});
  CHECK(replies[1].value == Value{1, 1, {0.1}});
}

TEST_CASE("matrices travel column by column") {
  ExerciseRunner runner(executable("rigid::Matrix3d rigid::scaled(const Matrix3d& A, double factor) { Matrix3d B = "
                                   "factor * A; B(2, 0) = 70; return B; }",
                                   "scaled"),
                        short_limits());
  const Value A{3, 3, {1, 2, 3, 4, 5, 6, 7, 8, 9}};
  const std::vector<Reply> replies = runner.evaluate({{{A, vector_of({10})}, 3, 3}});
  REQUIRE(replies.size() == 1);
  CHECK(replies[0].value == Value{3, 3, {10, 20, 70, 40, 50, 60, 70, 80, 90}});
}

TEST_CASE("what a function adds to a result that it never filled is absurd at every call") {
  ExerciseRunner runner(
      executable("rigid::Matrix3d rigid::scaled(const Matrix3d& A, double factor) { Matrix3d B(3, 3); "
                 "B += factor * A; return B; }",
                 "scaled"),
      short_limits());
  const PlannedCall call{{Value{3, 3, {1, 2, 3, 4, 5, 6, 7, 8, 9}}, vector_of({10})}, 3, 3};
  for (const Reply& reply : runner.evaluate({call, call, call}))
    for (const double number : reply.value.numbers) CHECK(number < -1e300);
}

TEST_CASE("lists of matrices and points travel, empty ones too") {
  ExerciseRunner runner(executable(R"(
    rigid::Matrix3Xd rigid::moved(const std::vector<Matrix3d>& matrices, const Matrix3Xd& points) {
      Matrix3d sum = Matrix3d::Zero();
      for (const Matrix3d& matrix : matrices) sum += matrix;
      return sum * points;
    })",
                                   "moved"),
                        short_limits());
  const Value two{
      3, 6, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 5, 0, 0}};  // the identity, and 5 at row 0, column 2
  const Value points{3, 2, {1, 2, 3, 4, 5, 6}};
  const Value none{3, 0, {}};
  const std::vector<Reply> replies =
      runner.evaluate({{{two, points}, 3, 2}, {{none, points}, 3, 2}, {{two, none}, 3, 0}});
  REQUIRE(replies.size() == 3);
  CHECK(replies[0].value == Value{3, 2, {16, 2, 3, 34, 5, 6}});
  CHECK(replies[1].value == Value{3, 2, {0, 0, 0, 0, 0, 0}});
  CHECK(replies[2].ending == Ending::returned);
  CHECK(replies[2].value == none);
}

TEST_CASE("a result of another size comes back as its size only") {
  ExerciseRunner runner(executable(counted, "counted"), short_limits());
  const std::vector<Reply> replies =
      runner.evaluate({{{vector_of({4})}, 4, 1}, {{vector_of({4})}, 3, 1}, {{vector_of({0})}, 3, 1}});
  REQUIRE(replies.size() == 3);
  CHECK(replies[0].value == counted_to(4));
  CHECK(replies[1].ending == Ending::wrong_shape);
  CHECK(replies[1].value == Value{4, 1, {}});
  CHECK(replies[2].ending == Ending::wrong_shape);
  CHECK(replies[2].value == Value{0, 1, {}});
}

TEST_CASE("requests and replies larger than any buffer pass") {
  ExerciseRunner counting(executable(counted, "counted"), short_limits());
  const std::vector<Reply> long_reply = counting.evaluate({{{vector_of({300000})}, 300000, 1}});
  CHECK(long_reply.at(0).value == counted_to(300000));

  ExerciseRunner moving(
      executable(
          "rigid::Matrix3Xd rigid::moved(const std::vector<Matrix3d>&, const Matrix3Xd& points) { return -points; }",
          "moved"),
      short_limits());
  Value points{3, 100000, std::vector<double>(300000, 1.0)};
  const std::vector<Reply> both = moving.evaluate({{{Value{3, 0, {}}, points}, 3, 100000}});
  points.numbers.assign(300000, -1.0);
  CHECK(both.at(0).value == points);
}

TEST_CASE("a worker that does not read its request is not waited for in vain") {
  RunLimits limits = short_limits();
  limits.time = std::chrono::milliseconds(300);
  ExerciseRunner runner(
      executable("#include <unistd.h>\nstatic int early = [] { for (;;) usleep(9); return 1; }();\n"
                 "rigid::Matrix3Xd rigid::moved(const std::vector<Matrix3d>&, const Matrix3Xd& p) { return p; }",
                 "moved"),
      limits);
  const std::vector<Reply> replies =
      runner.evaluate({{{Value{3, 0, {}}, Value{3, 100000, std::vector<double>(300000, 1.0)}}, 3, 100000}});
  CHECK(replies.at(0).ending == Ending::time_limit);
  CHECK(nothing_left_running());
}

TEST_CASE("repeats run in a fresh process, where a state that grows starts again") {
  ExerciseRunner runner(executable("static int calls = 0;\ndouble rigid::twice(double x) { return 2 * x + calls++; }"),
                        short_limits());
  const Observation observation = runner.observe(plan_calls({twice_case(1), twice_case(2), twice_case(3)}), {2, 0});
  REQUIRE(observation.replies.size() == 3);
  CHECK(observation.replies[2].value == Value{1, 1, {8.0}});
  REQUIRE(observation.repeats.size() == 2);
  CHECK(observation.repeats[0].case_index == 2);
  CHECK(observation.repeats[0].reply.value == Value{1, 1, {6.0}});
  CHECK(observation.repeats[1].case_index == 0);
  CHECK(observation.repeats[1].reply.value == Value{1, 1, {3.0}});
  CHECK(nothing_left_running());
}

TEST_CASE("answers by chance differ in a repeat") {
  ExerciseRunner runner(executable("#include <chrono>\ndouble rigid::twice(double) { return "
                                   "double(std::chrono::steady_clock::now().time_since_epoch().count()); }"),
                        short_limits());
  const Observation observation = runner.observe(plan_calls({twice_case(1)}), {0});
  CHECK(observation.repeats.at(0).reply.ending == Ending::returned);
  CHECK_FALSE(observation.repeats.at(0).reply.value == observation.replies.at(0).value);
}

TEST_CASE("after a used-up limit the repeats are not run") {
  RunLimits limits = short_limits();
  limits.time = std::chrono::milliseconds(200);
  ExerciseRunner runner(executable("#include <unistd.h>\ndouble rigid::twice(double) { for (;;) usleep(9); }"), limits);
  const Observation observation = runner.observe(plan_calls({twice_case(1), twice_case(2)}), {0});
  CHECK(observation.replies.at(0).ending == Ending::time_limit);
  CHECK(observation.replies.at(1).ending == Ending::not_run);
  CHECK(observation.repeats.at(0).reply.ending == Ending::not_run);
}

TEST_CASE("many slow crashes together may not use more than the limit") {
  RunLimits limits = short_limits();
  limits.time = std::chrono::seconds(1);
  const Observation observation =
      run("#include <unistd.h>\ndouble rigid::twice(double) { usleep(50000); std::abort(); }",
          std::vector<double>(30, 1), limits);
  CHECK(observation.replies.front().ending == Ending::crashed);
  CHECK(observation.replies.back().ending == Ending::not_run);
}

TEST_CASE("the worker has an empty environment, no input, and knows no descriptors but its own") {
  const Observation observation = run(R"(
#include <unistd.h>
#include <cstdio>
double rigid::twice(double) {
  double open = 0;
  char byte;
  for (int d = 0; d < 1024; ++d) open += lseek(d, 0, SEEK_CUR) == -1 && errno == EBADF ? 0 : 1;
  return 100 * (environ[0] != nullptr) + 10 * (read(0, &byte, 1) != 0) + open;
})",
                                      {1});
  CHECK(observation.replies.at(0).value == Value{1, 1, {4.0}});
}

TEST_CASE("a program too large for its memory is the student's, not a checker error") {
  const Observation observation =
      run("volatile double huge[1 << 26];\n"
          "double rigid::twice(double x) { huge[int(x)] = x; return huge[int(x)]; }",
          {1});
  CHECK_FALSE(observation.refusal.has_value());
  REQUIRE(observation.replies.size() == 1);
  CHECK(observation.replies[0].ending == Ending::crashed);
  CHECK(nothing_left_running());
}

TEST_CASE("an executable that cannot be started, or is no program, is a checker error") {
  const std::filesystem::path absent = fresh_directory("absent") / "worker",
                              odd = write(fresh_directory("no-program") / "worker", "hello");
  std::filesystem::permissions(odd, std::filesystem::perms::owner_all);
  for (const auto& [file, reason] : {std::pair{absent, "(start the program: No such file or directory)"},
                                     {odd, "start the program: Exec format error"}}) {
    const Observation observation = ExerciseRunner(file, short_limits()).observe(plan_calls({twice_case(1)}), {});
    CHECK(observation.refusal == Refusal::checker_error);
    CHECK_MESSAGE(has(observation.refusal_message, reason), observation.refusal_message);
    CHECK(observation.replies.empty());
    CHECK(nothing_left_running());
  }
}

TEST_CASE("where the filter of system calls cannot be loaded, nothing runs and the checker says so") {
  if (!probe_sandbox().filters_system_calls) return;
  const std::filesystem::path program = executable("double rigid::twice(double x) { return 2 * x; }");
  const bool refused = in_another_process([&] {
    if (!refuse_system_call(SYS_seccomp, EPERM)) return false;  // as some containers do
    const Observation observation = ExerciseRunner(program, short_limits()).observe(plan_calls({twice_case(1)}), {});
    return observation.refusal == Refusal::checker_error && observation.replies.empty() &&
           observation.refusal_message.find("filter its system calls: Operation not permitted") != std::string::npos;
  });
  CHECK(refused);
}

TEST_CASE("an unchanged file is checked in an instant") {
  const std::string text = "double rigid::twice(double x) { return x + x; }";
  executable(text);
  const std::clock_t start = std::clock();
  const Compilation compilation = compile_text(text);
  REQUIRE(compilation.executable.has_value());
  const Observation observation =
      ExerciseRunner(*compilation.executable).observe(plan_calls(std::vector<Case>(14, twice_case(1))), {0, 1, 2});
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;  // of a processor
  CHECK(compilation.from_cache);
  CHECK(observation.replies.back().ending == Ending::returned);
  CHECK(seconds <= 0.5);  // usually a hundredth of it
}

}  // namespace workbook::testing
