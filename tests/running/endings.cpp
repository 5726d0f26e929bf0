// Every way in which a call of a student's function can end, and what the checker sees of it. The sentences stand in
// golden/endings.txt.
#include "tests/running/student.hpp"

#include "checker/judging/run_failures.hpp"
#include "checker/worker/protocol.hpp"
#include "tests/support/golden.hpp"

#include <doctest/doctest.h>

#include <signal.h>
#include <sys/syscall.h>

#include <cmath>
#include <map>
#include <string>

#if !defined(SYS_unlink)  // the C libraries of newer architectures make other calls
#define SYS_unlink SYS_unlinkat
#define SYS_dup2 SYS_dup3
#endif

namespace workbook::testing {
namespace {

/// One file for most of the tests: twice(x) is right for x < 100, and misbehaves in another way for each x above.
const char* const many_faces = R"code(
#include <fixture/contract.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <thread>
#include <csignal>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

extern "C" void* __libc_stack_end;

namespace {
[[gnu::noinline]] double for_ever(double x) { volatile double y = x; return y > 0 ? for_ever(y + 1) + y : y; }
double careless(double x) noexcept { if (x > 0) throw std::runtime_error("nobody catches this"); return x; }
struct Reply { unsigned long magic, nonce; int status, rows, cols, signal; long detail; char text[472]; double value; };
Reply fake(unsigned long nonce) { return {REPLY_MAGIC, nonce, 1, 1, 1, 0, 0, {}, 77.0}; }
unsigned long nonce_on_the_stack() {
  unsigned long here = 0;
  // With one number to read and one to give: the magic number alone may also be a register that was put aside.
  for (volatile unsigned long* p = &here; p < __libc_stack_end; ++p)
    if (*p == REQUEST_MAGIC && p[2] == 1 + (1ul << 32) && p[3] == 1) return p[1];
  return 0;
}
double behave(double x) {
  using namespace Eigen;
  switch (int(x)) {
    case 100: return NAN;
    case 101: throw std::runtime_error("the moon is in the way");
    case 102: throw 42;
    case 103: throw rigid::NotStarted{};
    case 104: throw std::runtime_error(std::string(5000, 'x'));
    case 105: throw std::runtime_error("bell \a, escape \x1b[31m, half a letter \xc3");
    case 110: { volatile int* nowhere = nullptr; *nowhere = 1; return 0; }
    case 111: return for_ever(x);
    case 112: std::abort();
    case 113: return careless(x);
    case 114: { volatile int zero = 0; return 5 / zero; }
    case 120: std::exit(0);
    case 121: _exit(7);
    case 122: std::quick_exit(0);
    case 123: close(3); for (;;) usleep(1000);
    case 124: close(3); _exit(0);
    case 130: for (volatile double y = 0;; y = y + 1) {}
    case 131: for (;;) usleep(1000);
    case 132: std::signal(SIGXCPU, SIG_IGN); for (volatile double y = 0;; y = y + 1) {}
    case 133: raise(SIGSTOP); return 0;
    case 140: { std::vector<std::vector<double>> all; for (;;) all.emplace_back(1 << 20, 1.0); }
    case 141: { VectorXd big(1L << 40); return big[0]; }
    case 150: for (;;) std::cout << "again and again\n";
    case 151: std::cout << "to output\n" << std::flush; std::cerr << "to errors\n"; printf("without an end of line"); return 2 * x;
    case 152: std::cout << "before the crash"; std::abort();
    case 153: close(1); close(2); return 2 * x;
    case 154: { Reply r = fake(0); fwrite(&r, 1, sizeof r, stdout); return 2 * x; }
    case 160: { std::ofstream out("/tmp/workbook-of-a-student"); return out.good(); }
    case 161: { std::ifstream in("/etc/hostname"); return in.good(); }
    case 162: return fork();
    case 163: { std::thread other([] {}); other.join(); return 0; }
    case 164: return kill(getppid(), SIGKILL);
    case 165: return ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr);
    case 166: return socket(AF_INET, SOCK_STREAM, 0);
    case 167: return execl("/bin/true", "true", nullptr);
    case 168: return std::system("true");
    case 169: { rlimit more{RLIM_INFINITY, RLIM_INFINITY}; return setrlimit(RLIMIT_CPU, &more); }
    case 170: return kill(-1, SIGKILL);
    case 171: return dup2(1, 2);
    case 172: return unlink("/tmp/workbook-of-a-student");
    case 173: { struct stat status; return stat("/etc/passwd", &status); }
    case 180: { Reply r = fake(0); for (int d = 3; d < 64; ++d) (void)!write(d, &r, sizeof r); return 2 * x; }
    case 181: { Reply r = fake(nonce_on_the_stack()); (void)!write(3, &r, sizeof r); return 2 * x; }
    case 182: { Reply r = fake(nonce_on_the_stack()); r.rows = 1 << 30; r.cols = -5; (void)!write(3, &r, sizeof r); return 2 * x; }
    case 183: { Reply r = fake(nonce_on_the_stack()); r.status = 99; (void)!write(3, &r, sizeof r); return 2 * x; }
    case 184: { char noise[1000] = "noise"; (void)!write(3, noise, sizeof noise); return 2 * x; }
    case 185: { Reply r = fake(0); r.status = 6; r.signal = SIGSYS; for (int i = 0; i < 3; ++i) (void)!write(3, &r, 512); return 2 * x; }
    case 186: { Reply r = fake(nonce_on_the_stack()); (void)!write(3, &r, 512); _exit(0); }
    case 190: { VectorXd v(3); return v[3]; }
    case 191: { MatrixXd A(2, 2); return A(0, 2); }
    case 192: { VectorXd a = VectorXd::Zero(2), b = VectorXd::Zero(3); a += b; return a[0]; }
    case 193: { MatrixXd A = MatrixXd::Zero(2, 3); A = A * A; return 0; }
    case 194: { Vector3d v; v << 1, 2; return v[0]; }
    case 195: { Vector2d v; v << 1, 2, 3; return v[0]; }
    case 196: { MatrixXd A(2, 3); A << 1, 2, 3, 4, 5, 6; A = A.transpose().eval(); A.resize(-1, 2); return 0; }
    case 197: { MatrixXd A = MatrixXd::Zero(3, 3); A = A.transpose(); return 0; }
    case 198: { MatrixXd A = MatrixXd::Zero(3, 3); return A.block(1, 1, 3, 3).sum(); }
    case 199: { VectorXd v(3); VectorXd w(2); w << v[7], v[8]; return w[0]; }
    case 200: { MatrixXd A = MatrixXd::Zero(3, 2); return A.col(2).sum(); }
    case 201: { MatrixXd A = MatrixXd::Zero(3, 2); return A.determinant(); }
    case 202: { VectorXd v = VectorXd::Zero(2), w = VectorXd::Zero(3); return v.dot(w); }
    case 203: { SelfAdjointEigenSolver<Matrix3d> solver; return solver.eigenvalues()[0]; }
    case 204: { Vector3d v = VectorXd::Zero(4); return v[0]; }
    case 205: { MatrixXd A = MatrixXd::Zero(3, 3); VectorXd b = VectorXd::Zero(2); return A.partialPivLu().solve(b)[0]; }
    case 206: { std::vector<int> v(3); return v.at(9); }
    case 207: { Matrix3d never_filled; return never_filled(0, 0); }
    case 208: { MatrixXd A = MatrixXd::Zero(2, 2); return A.diagonal(3)[0]; }
  }
  return 2 * x;
}
}  // namespace

double rigid::twice(double x) { return behave(x); }
)code";

std::string with_magic_numbers(std::string text) {
  for (const auto& [word, number] :
       {std::pair{"REPLY_MAGIC", protocol::reply_magic}, {"REQUEST_MAGIC", protocol::request_magic}})
    for (std::size_t at = 0; (at = text.find(word)) != std::string::npos;)
      text.replace(at, std::string(word).size(), std::to_string(number) + "ul");
  return text;
}

std::string twice_and(const std::string& before) {
  return with_magic_numbers("#include <fixture/contract.hpp>\n#include <unistd.h>\n#include <csignal>\n" + before +
                            "\ndouble rigid::twice(double x) { return 2 * x; }\n");
}

bool is_right(const Reply& reply, double x) {
  return reply.ending == Ending::returned && reply.value == Value{1, 1, {2.0 * x}};
}

/// Calls the file of many faces at a good, a bad and a good input. What the bad one does must not touch the others.
Reply at(double x, const RunLimits& limits = short_limits()) {
  static const std::string text = with_magic_numbers(many_faces);
  CAPTURE(x);
  const Observation observation = run(text, {1.0, x, 2.0}, limits);
  REQUIRE_FALSE(observation.refusal.has_value());
  REQUIRE(observation.replies.size() == 3);
  CHECK(is_right(observation.replies[0], 1.0));
  const Ending ending = observation.replies[1].ending;
  if (ending == Ending::time_limit || ending == Ending::output_limit)
    CHECK(observation.replies[2].ending == Ending::not_run);
  else
    CHECK(is_right(observation.replies[2], 2.0));
  CHECK(nothing_left_running());
  return observation.replies[1];
}

RunLimits short_time() {
  RunLimits limits = short_limits();
  limits.time = std::chrono::milliseconds(800);
  return limits;
}

/// What makes a reply, besides its text.
struct Facts {
  Ending ending;
  int number = 0;  ///< the signal, exit status or system call
  CrashCause cause = CrashCause::unknown;
};

Facts facts_of(const Reply& reply) {
  const int number = reply.ending == Ending::crashed         ? reply.signal
                     : reply.ending == Ending::stopped_early ? reply.exit_status
                                                             : static_cast<int>(reply.system_call);
  const bool has_number = reply.ending == Ending::crashed || reply.ending == Ending::stopped_early ||
                          reply.ending == Ending::forbidden_operation;
  return {reply.ending, has_number ? number : 0, reply.cause};
}

/// Facts that hold on every machine, in the order of the inputs.
const std::map<double, Facts> endings = {
    {101, {Ending::exception}},
    {102, {Ending::exception, 0, CrashCause::foreign_exception}},
    {103, {Ending::not_started}},
    {104, {Ending::exception}},
    {105, {Ending::exception}},
    {110, {Ending::crashed, SIGSEGV}},
    {111, {Ending::crashed, SIGSEGV, CrashCause::stack_overflow}},
    {112, {Ending::crashed, SIGABRT}},
    {113, {Ending::crashed, SIGABRT, CrashCause::uncaught_exception}},
    {114, {Ending::crashed, SIGFPE}},
    {120, {Ending::stopped_early, 0}},
    {121, {Ending::stopped_early, 7}},
    {122, {Ending::stopped_early, 0}},
    {124, {Ending::stopped_early, 0}},
    {130, {Ending::time_limit}},
    {132, {Ending::time_limit}},
    {140, {Ending::memory_limit}},
    {141, {Ending::memory_limit}},
    {150, {Ending::output_limit}},
    {180, {Ending::protocol_violation}},
    {186, {Ending::stopped_early, 0}},
    {206, {Ending::exception}},
};

/// −1: the C library holds back all signals meanwhile, so that the worker cannot say which call it was.
const std::map<double, int> forbidden = {{160, SYS_openat}, {161, SYS_openat},    {162, SYS_clone},  {163, -1},
                                         {164, SYS_kill},   {165, SYS_ptrace},    {166, SYS_socket}, {167, SYS_execve},
                                         {168, -1},         {169, SYS_prlimit64}, {170, SYS_kill},   {171, SYS_dup2},
                                         {172, SYS_unlink}, {173, SYS_newfstatat}};

const std::map<double, ProtocolViolation> violations = {
    {180, ProtocolViolation::another_request}, {182, ProtocolViolation::impossible_shape},
    {183, ProtocolViolation::unknown_status},  {184, ProtocolViolation::not_a_reply},
    {185, ProtocolViolation::another_request}, {123, ProtocolViolation::closed_channel}};

const std::map<double, const char*> eigen_kinds = {
    {190, "index_out_of_range"}, {191, "index_out_of_range"}, {192, "size_mismatch"},      {193, "size_mismatch"},
    {194, "comma_initializer"},  {195, "comma_initializer"},  {196, "size_mismatch"},      {197, "aliasing"},
    {198, "index_out_of_range"}, {199, "index_out_of_range"}, {200, "index_out_of_range"}, {201, "not_square"},
    {202, "size_mismatch"},      {203, "not_computed"},       {204, "size_mismatch"},      {205, "size_mismatch"},
    {208, "index_out_of_range"}};

}  // namespace

TEST_CASE("a right function returns its values, and nothing else is seen") {
  const Observation observation = run(twice_and(""), {1.0, -0.0, 1e300, 0.1});
  CHECK_FALSE(observation.refusal.has_value());
  REQUIRE(observation.replies.size() == 4);
  CHECK(is_right(observation.replies[0], 1.0));
  CHECK(is_right(observation.replies[1], -0.0));
  CHECK(is_right(observation.replies[2], 1e300));
  CHECK(is_right(observation.replies[3], 0.1));
  CHECK(printed(observation).empty());
  CHECK(observation.run_seconds > 0.0);
  CHECK(nothing_left_running());
}

TEST_CASE("a NaN arrives as a NaN, and a matrix that was never filled gives one") {
  for (const double x : {100.0, 207.0}) {
    const Reply reply = at(x);
    REQUIRE(reply.ending == Ending::returned);
    CHECK(std::isnan(reply.value.numbers.at(0)));
  }
}

TEST_CASE("every ending is seen as it was, and told in a sentence") {
  std::string sentences;
  const auto tell = [&](double x, const Reply& reply) {
    const Advice advice = advice_on_ending("at the case “made up”", reply, "double twice(double x)");
    sentences += std::to_string(static_cast<int>(x)) + ": " + advice.message + "\n     " + advice.next_step + "\n";
  };
  for (const auto& [input, expected] : endings) {
    const double x = input;
    CAPTURE(x);
    const Reply reply = at(x);
    const Facts facts = facts_of(reply);
    CHECK(facts.ending == expected.ending);
    CHECK(facts.number == expected.number);
    CHECK(facts.cause == expected.cause);
    tell(x, reply);
  }
  for (const auto& [input, kind] : eigen_kinds) {
    const double x = input;
    CAPTURE(x);
    const Reply reply = at(x);
    CHECK(reply.ending == Ending::exception);
    REQUIRE(reply.eigen.has_value());
    CHECK(kind_of_eigen(*reply.eigen) == kind);
    tell(x, reply);
  }
  for (const auto& [input, violation] : violations) {
    const double x = input;
    CAPTURE(x);
    const Reply reply = at(x);
    CHECK(reply.ending == Ending::protocol_violation);
    CHECK(reply.violation == violation);
    tell(x, reply);
  }
  compare_with_golden(golden("endings.txt"), sentences);
}

TEST_CASE("files, processes, threads, signals and connections are forbidden and named") {
  if (!probe_sandbox().filters_system_calls) return;
  for (const auto& [input, system_call] : forbidden) {
    const double x = input;
    CAPTURE(x);
    const Reply reply = at(x);
    CHECK(reply.ending == Ending::forbidden_operation);
    CHECK(reply.system_call == system_call);
  }
  CHECK_FALSE(std::filesystem::exists("/tmp/workbook-of-a-student"));
}

TEST_CASE("the text of an exception is kept, cut and made safe to show") {
  CHECK(at(101).text == "the moon is in the way");
  CHECK(at(104).text == std::string(471, 'x'));
  CHECK(at(105).text == "bell ?, escape ?[31m, half a letter ");
  CHECK(at(113).text == "nobody catches this");
}

TEST_CASE("time is limited for a program that sleeps or stops itself") {
  CHECK(at(131, short_time()).ending == Ending::time_limit);
  CHECK(at(133, short_time()).ending == Ending::time_limit);
}

TEST_CASE("output is limited, and its beginning kept") {
  RunLimits limits = short_limits();
  limits.output_bytes = 1000;
  const Reply cut_off = at(150, limits);
  CHECK(cut_off.printed.size() == 1000);
  CHECK(cut_off.printed.starts_with("again and again\nagain"));
  CHECK(at(150).printed.size() == (std::size_t{64} << 10));
}

TEST_CASE("what a function prints belongs to its call and does not disturb its answer") {
  CHECK(is_right(at(151), 151));
  CHECK(at(151).printed == "to output\nto errors\nwithout an end of line");
  CHECK(at(152).printed == "before the crash");  // although its line has not ended
  CHECK(is_right(at(153), 153));
  const Reply forged = at(154);
  CHECK(is_right(forged, 154));
  CHECK_FALSE(forged.printed.empty());
}

TEST_CASE("what happens before main counts as the first call's") {
  const auto first = [](const std::string& code, const RunLimits& limits = short_limits()) {
    const Observation observation = run(twice_and("static int early = " + code + ";"), {1.0, 2.0}, limits);
    CHECK(nothing_left_running());
    return observation.replies.at(0);
  };
  CHECK(first("(_exit(0), 1)").ending == Ending::stopped_early);
  const Reply thrown = first("[] { throw std::runtime_error(\"too early\"); return 1; }()");
  CHECK(thrown.signal == SIGABRT);
  CHECK(thrown.text == "too early");
  CHECK(first("[] { for (;;) usleep(9); return 1; }()", short_time()).ending == Ending::time_limit);
  CHECK(first("printf(\"early\\n\")").printed == "early\n");
  // Streams need no #include, and what they keep back until they are flushed comes all the same.
  CHECK(first("(std::ios::sync_with_stdio(false), std::cout << \"early\", 1)").printed == "early");
  if (probe_sandbox().filters_system_calls) CHECK(first("fork()").ending == Ending::forbidden_operation);
  CHECK(first("[] { unsigned long reply[65] = {REPLY_MAGIC, 0, 1 + (1ul << 32), 1};"
              " for (int d = 3; d < 64; ++d) (void)!write(d, reply, sizeof reply); return 1; }()")
            .ending == Ending::protocol_violation);
}

TEST_CASE("replacing the worker's signal handler does not open the sandbox") {
  if (!probe_sandbox().filters_system_calls) return;
  const Observation observation =
      run(twice_and("static int early = (std::signal(SIGSYS, [](int) {}), unlink(\"/tmp/workbook-canary\"), "
                    "kill(getppid(), SIGKILL), fork() == 0 ? (_exit(3), 1) : 1);"),
          {1.0});
  CHECK(is_right(observation.replies.at(0), 1.0));
  CHECK(nothing_left_running());
}

TEST_CASE("a second reply is a protocol violation at this case or, if it comes late, at the next") {
  const Observation observation = run(with_magic_numbers(many_faces), {1.0, 181, 2.0}, short_limits());
  CHECK(is_right(observation.replies.at(0), 1.0));
  const bool seen_at_once = observation.replies.at(1).ending == Ending::protocol_violation;
  CHECK(observation.replies.at(seen_at_once ? 1 : 2).ending == Ending::protocol_violation);
  CHECK(nothing_left_running());
}

TEST_CASE("one byte after the last reply spoils it") {
  // The destructor of a thread-local object of the main thread, or of a static one, would be the place; both are
  // skipped. A reader that takes the worker's place can still try.
  const Observation observation =
      run(twice_and("static int early = [] { unsigned long request[6]; double x; (void)!read(3, request, 40); "
                    "(void)!read(3, &x, 8);"
                    " unsigned long reply[65] = {REPLY_MAGIC, request[1], 1 + (1ul << 32), 1};"
                    " (void)!write(3, reply, sizeof reply); (void)!read(3, &x, 8); (void)!write(3, &x, 1); _exit(0); "
                    "return 1; }();"),
          {1.0});
  CHECK(observation.replies.at(0).violation == ProtocolViolation::after_last_reply);
  CHECK(nothing_left_running());
}

TEST_CASE("a condition of Eigen that is not known is shown") {
  CHECK(sentence_on_eigen("something new\nhere").find("something new here") != std::string::npos);
  CHECK(kind_of_eigen("something new") == "eigen_assertion");
  // "0x0" in a condition that fails for another reason
  CHECK(kind_of_eigen("m_xpr.rows() >= other.rows() && \"Cannot comma-initialize a 0x0 matrix\"") ==
        "comma_initializer");
}

}  // namespace workbook::testing
