// Every way in which a call of a student's function can end, and what the checker sees of it.
#include "tests/running/student.hpp"

#include "checker/worker/protocol.hpp"

#include <doctest/doctest.h>

#include <signal.h>

#include <cmath>
#include <string>

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
    case 152: std::cout << "before the crash\n"; std::abort();
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

struct Seen {
  Reply reply;
  std::string printed;
};

/// Calls the file of many faces at a good, a bad and a good input. What the bad one does must not touch the others.
Seen at(double x, RunLimits limits = short_limits()) {
  static const std::string text = with_magic_numbers(many_faces);
  const Observation observation = run(text, {1.0, x, 2.0}, limits);
  REQUIRE_FALSE(observation.refusal.has_value());
  REQUIRE(observation.replies.size() == 3);
  CHECK(is_right(observation.replies[0], 1.0));
  CHECK(is_right(observation.replies[2], 2.0));
  CHECK(nothing_left_running());
  return {observation.replies[1], observation.printed};
}

/// The same where the bad input uses up a limit, so that nothing more can run.
Seen exhausting(double x, RunLimits limits = short_limits()) {
  static const std::string text = with_magic_numbers(many_faces);
  const Observation observation = run(text, {1.0, x, 2.0}, limits);
  REQUIRE(observation.replies.size() == 3);
  CHECK(is_right(observation.replies[0], 1.0));
  CHECK(observation.replies[2].ending == Ending::not_run);
  CHECK(nothing_left_running());
  return {observation.replies[1], observation.printed};
}

}  // namespace

TEST_CASE("a right function returns its values, and nothing else is seen") {
  const Observation observation = run(twice_and(""), {1.0, -0.0, 1e300, 0.1});
  CHECK_FALSE(observation.refusal.has_value());
  REQUIRE(observation.replies.size() == 4);
  CHECK(is_right(observation.replies[0], 1.0));
  CHECK(is_right(observation.replies[1], -0.0));
  CHECK(is_right(observation.replies[2], 1e300));
  CHECK(is_right(observation.replies[3], 0.1));
  CHECK(observation.printed.empty());
  CHECK(observation.run_seconds > 0.0);
  CHECK(nothing_left_running());
}

TEST_CASE("a NaN arrives as a NaN") {
  const Reply reply = at(100).reply;
  REQUIRE(reply.ending == Ending::returned);
  CHECK(std::isnan(reply.value.numbers.at(0)));
}

TEST_CASE("a matrix that was never filled gives NaN instead of a number by chance") {
  const Reply reply = at(207).reply;
  REQUIRE(reply.ending == Ending::returned);
  CHECK(std::isnan(reply.value.numbers.at(0)));
}

TEST_CASE("exceptions are reported with their text, and the worker goes on") {
  CHECK(at(101).reply.ending == Ending::exception);
  CHECK(at(101).reply.text == "the moon is in the way");
  CHECK(at(102).reply.ending == Ending::exception);
  CHECK(at(102).reply.text == "something that is not a std::exception");
  CHECK(at(103).reply.ending == Ending::not_started);
  CHECK(at(104).reply.text == std::string(471, 'x'));
  CHECK(at(105).reply.text == "bell ?, escape ?[31m, half a letter ");
  CHECK(at(206).reply.ending == Ending::exception);
  CHECK(at(206).reply.text.find("range_check") != std::string::npos);
}

TEST_CASE("what Eigen complains about becomes a sentence") {
  const auto sentence = [](double x) {
    const Reply reply = at(x).reply;
    CHECK(reply.ending == Ending::exception);
    const std::string start = "Eigen stopped the calculation: ";
    CHECK(reply.text.starts_with(start));
    return reply.text.substr(std::min(start.size(), reply.text.size()));
  };
  CHECK(sentence(190) == "an index lies outside its vector; a vector of size n has the indices 0 to n - 1");
  CHECK(sentence(191) == "a row or column index lies outside its matrix; indices start at 0");
  CHECK(sentence(192) == "two operands of a sum, difference or assignment have different sizes");
  CHECK(sentence(193) == "in a matrix product the left factor must have as many columns as the right one has rows");
  CHECK(sentence(194) == "too few numbers follow <<; it must fill the whole matrix or vector");
  CHECK(sentence(195) == "too many numbers follow << for this matrix or vector");
  CHECK(sentence(196) == "a matrix or vector is given a size that is negative or that its type does not allow");
  CHECK(sentence(197) ==
        "A = A.transpose() overwrites A while reading it; use A.transposeInPlace() or A.transpose().eval()");
  CHECK(sentence(198) == "a block, segment, head or tail reaches beyond its matrix or vector");
  CHECK(sentence(199) == "an index lies outside its vector; a vector of size n has the indices 0 to n - 1");
  CHECK(sentence(200) == "row(i) or col(i) is asked for an i that the matrix does not have; indices start at 0");
  CHECK(sentence(201) == "inverse, determinant and eigenvalues need a square matrix");
  CHECK(sentence(202) == "dot() needs two vectors of the same size");
  CHECK(sentence(203) == "a decomposition is used before compute() was called");
  CHECK(sentence(204) == "a matrix or vector is given a size that is negative or that its type does not allow");
  CHECK(sentence(205) == "solve() needs a right-hand side with as many rows as the matrix has");
  CHECK(sentence(208) == "diagonal(i) is asked for a diagonal that the matrix does not have");
}

TEST_CASE("a signal is a crash with its number, and the next case runs in a new process") {
  const auto crash = [](double x, int signal) {
    const Reply reply = at(x).reply;
    CHECK(reply.ending == Ending::crashed);
    CHECK(reply.signal == signal);
    return reply.text;
  };
  CHECK(crash(110, SIGSEGV).empty());
  CHECK(crash(111, SIGSEGV) == "the stack is used up");
  CHECK(crash(112, SIGABRT).empty());
  CHECK(crash(113, SIGABRT) == "nobody catches this");
  CHECK(crash(114, SIGFPE).empty());
}

TEST_CASE("a program that ends by itself has not answered, whatever its exit status says") {
  CHECK(at(120).reply.ending == Ending::stopped_early);
  CHECK(at(120).reply.exit_status == 0);
  CHECK(at(121).reply.ending == Ending::stopped_early);
  CHECK(at(121).reply.exit_status == 7);
  CHECK(at(122).reply.ending == Ending::stopped_early);
  CHECK(at(124).reply.ending == Ending::stopped_early);
}

TEST_CASE("a program that ends before main has not answered") {
  const Observation observation = run(twice_and("static int early = (_exit(0), 1);"), {1.0, 2.0});
  CHECK(observation.replies.at(0).ending == Ending::stopped_early);
  CHECK(observation.replies.at(1).ending == Ending::stopped_early);
  CHECK(nothing_left_running());
}

TEST_CASE("an exception before main is a crash with its text") {
  const Observation observation =
      run(twice_and("static int early = [] { throw std::runtime_error(\"too early\"); return 1; }();"), {1.0});
  CHECK(observation.replies.at(0).ending == Ending::crashed);
  CHECK(observation.replies.at(0).signal == SIGABRT);
  CHECK(observation.replies.at(0).text == "too early");
}

TEST_CASE("processor time is limited, also for a program that ignores the signal") {
  CHECK(exhausting(130).reply.ending == Ending::time_limit);
  CHECK(exhausting(132).reply.ending == Ending::time_limit);
}

TEST_CASE("time is limited for a program that sleeps or stops itself") {
  RunLimits limits = short_limits();
  limits.time = std::chrono::milliseconds(800);
  CHECK(exhausting(131, limits).reply.ending == Ending::time_limit);
  CHECK(exhausting(133, limits).reply.ending == Ending::time_limit);
}

TEST_CASE("time is limited before main too") {
  RunLimits limits = short_limits();
  limits.time = std::chrono::milliseconds(800);
  const Observation observation =
      run(twice_and("static int early = [] { for (;;) usleep(9); return 1; }();"), {1.0, 2.0}, limits);
  CHECK(observation.replies.at(0).ending == Ending::time_limit);
  CHECK(observation.replies.at(1).ending == Ending::not_run);
  CHECK(nothing_left_running());
}

TEST_CASE("memory is limited") {
  CHECK(at(140).reply.ending == Ending::memory_limit);
  CHECK(at(141).reply.ending == Ending::memory_limit);
}

TEST_CASE("output is limited, and its beginning kept") {
  RunLimits limits = short_limits();
  limits.output_bytes = 1000;
  const Seen seen = exhausting(150, limits);
  CHECK(seen.reply.ending == Ending::output_limit);
  CHECK(seen.printed.size() == 1000);
  CHECK(seen.printed.starts_with("again and again\nagain"));
}

TEST_CASE("a flood that fills every pipe is stopped too") {
  const Seen seen = exhausting(150);
  CHECK(seen.reply.ending == Ending::output_limit);
  CHECK(seen.printed.size() == (std::size_t{64} << 10));
}

TEST_CASE("what a function prints is kept and does not disturb its answer") {
  const Seen seen = at(151);
  CHECK(is_right(seen.reply, 151));
  CHECK(seen.printed == "to output\nto errors\nwithout an end of line");
  CHECK(at(152).reply.ending == Ending::crashed);
  CHECK(at(152).printed == "before the crash\n");
  CHECK(is_right(at(153).reply, 153));
}

TEST_CASE("a reply printed to standard output is only text") {
  const Seen seen = at(154);
  CHECK(is_right(seen.reply, 154));
  CHECK(seen.printed.find("perl") == std::string::npos);
  CHECK_FALSE(seen.printed.empty());
}

TEST_CASE("files, processes, threads, signals and connections are forbidden and named") {
  if (!sandbox_strength().filters_system_calls) return;
  const auto forbidden = [](double x) {
    const Reply reply = at(x).reply;
    CHECK(reply.ending == Ending::forbidden_operation);
    return reply.text;
  };
  CHECK(forbidden(160).starts_with("open a file"));
  CHECK_FALSE(std::filesystem::exists("/tmp/workbook-of-a-student"));
  CHECK(forbidden(161).starts_with("open a file"));
  CHECK(forbidden(162).starts_with("start a thread or another process"));
  CHECK(forbidden(163).empty());  // the C library blocks all signals while it starts a thread: no last words
  CHECK(forbidden(164) == "send a signal to another process (kill)");
  CHECK(forbidden(165) == "look into another process (ptrace)");
  CHECK(forbidden(166) == "open a connection (socket)");
  CHECK(forbidden(167) == "start another program (execve)");
  CHECK(forbidden(168).empty());
  CHECK_FALSE(forbidden(169).empty());
  CHECK(forbidden(170) == "send a signal to another process (kill)");
  CHECK(forbidden(171) == "make the system call dup2");
  CHECK(forbidden(172) == "change files or folders (unlink)");
}

TEST_CASE("what is forbidden is forbidden before main too") {
  if (!sandbox_strength().filters_system_calls) return;
  const Observation observation = run(twice_and("static int early = fork();"), {1.0, 2.0});
  CHECK(observation.replies.at(0).ending == Ending::forbidden_operation);
  CHECK(observation.replies.at(0).text.starts_with("start a thread or another process"));
  CHECK(observation.replies.at(1).ending == Ending::forbidden_operation);
  CHECK(nothing_left_running());
}

TEST_CASE("replacing the worker's signal handler does not open the walls") {
  if (!sandbox_strength().filters_system_calls) return;
  const Observation observation =
      run(twice_and(
              "static int early = (std::signal(SIGSYS, [](int) {}), unlink(\"/tmp/workbook-witness\"), kill(getppid(), "
              "SIGKILL), fork() == 0 ? (_exit(3), 1) : 1);"),
          {1.0});
  CHECK(is_right(observation.replies.at(0), 1.0));
  CHECK(nothing_left_running());
}

TEST_CASE("forged replies are protocol violations") {
  const auto violation = [](double x) {
    const Reply reply = at(x).reply;
    CHECK(reply.ending == Ending::protocol_violation);
    return reply.text;
  };
  CHECK(violation(180) == "a reply came that does not belong to the request");
  CHECK(violation(182) == "a reply has an impossible shape");
  CHECK(violation(183) == "a reply has an unknown status");
  CHECK(violation(184) == "what came back is not a reply");
  CHECK(violation(185) == "a reply came that does not belong to the request");
  CHECK(violation(123) == "the line to the checker was closed");
}

TEST_CASE("a second reply is a protocol violation at this case or, if it comes late, at the next") {
  const Observation observation = run(with_magic_numbers(many_faces), {1.0, 181, 2.0}, short_limits());
  CHECK(is_right(observation.replies.at(0), 1.0));
  const bool seen_at_once = observation.replies.at(1).ending == Ending::protocol_violation;
  CHECK(observation.replies.at(seen_at_once ? 1 : 2).ending == Ending::protocol_violation);
  CHECK(nothing_left_running());
}

TEST_CASE("half a reply before the end is no reply") { CHECK(at(186).reply.ending == Ending::stopped_early); }

TEST_CASE("a reply before its request is a protocol violation") {
  const Observation observation =
      run(twice_and("static int early = [] { unsigned long reply[65] = {REPLY_MAGIC, 0, 1 + (1ul << 32), 1};"
                    " for (int d = 3; d < 64; ++d) (void)!write(d, reply, sizeof reply); return 1; }();"),
          {1.0, 2.0});
  CHECK(observation.replies.at(0).ending == Ending::protocol_violation);
  CHECK(observation.replies.at(1).ending == Ending::protocol_violation);
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
  CHECK(observation.replies.at(0).ending == Ending::protocol_violation);
  CHECK(observation.replies.at(0).text == "something came back after the last reply");
  CHECK(nothing_left_running());
}

}  // namespace workbook::testing
