// What a student's function tries while it runs: all attacks are cases of one function, in one executable. Each is
// called between two inputs at which the function is right.
#include "tests/attacks/attack.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <map>

namespace workbook::testing {
namespace {

using enum Verdict;

/// `gentle` asks for a bounded variant of what would harm the machine without a sandbox.
const char* const beginning = R"code(
#include <fixture/contract.hpp>
#include <chrono>
#include <csetjmp>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <filesystem>
#include <iostream>
#include <random>
#include <thread>
#include <fcntl.h>
#include <fenv.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/ipc.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/timex.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>
#include <xmmintrin.h>

extern "C" void* __libc_stack_end;

namespace {
struct Reply { unsigned long magic, nonce; int status, rows, cols, signal; long detail; char text[472]; double value; };
Reply fake(unsigned long nonce, double value = 42) { return {REPLY_MAGIC, nonce, 1, 1, 1, 0, 0, {}, value}; }
unsigned long nonce() {
  unsigned long here = 0;
  for (volatile unsigned long* p = &here; p < __libc_stack_end; ++p)
    if (*p == REQUEST_MAGIC && p[2] == 1 + (1ul << 32) && p[3] == 1) return p[1];
  return 0;
}
void send(const Reply& reply, std::size_t size = sizeof(Reply), int descriptor = 3) { (void)!write(descriptor, &reply, size); }
double ok(bool it_works) { return it_works ? 42 : 0; }
bool opens(const char* file, int flags = O_RDONLY) { return open(file, flags | O_CLOEXEC, 0600) >= 0; }
/// The kernel answered, whatever it said.
double reaches(long) { return 42; }
[[gnu::noinline]] double for_ever(double x) { volatile double y = x; return y > 0 ? for_ever(y + 1) + y : y; }
double careless() noexcept { throw std::runtime_error("nobody catches this"); }
/// From an address whose lower half is 0.
double limits(int process) {
  void* none = mmap(reinterpret_cast<void*>(1ul << 32), 4096, 3, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0);
  return ok(syscall(SYS_prlimit64, process, RLIMIT_CORE, none, nullptr) == 0);
}
struct Throws { ~Throws() noexcept(false) { throw 1; } };
)code";

const Attack attacks[] = {
    // --- forging replies: what somebody would believe who takes an exit status, a text or the first bytes for a result
    {"forging replies", "end with success", "std::exit(0);", stopped_early, exits_with_success},
    {"forging replies", "end with success, past all handlers", "_exit(0);", stopped_early, exits_with_success},
    {"forging replies", "end with success, quickly", "std::quick_exit(0);", stopped_early, exits_with_success},
    {"forging replies", "look like a crash", "_exit(139);", stopped_early,
     [](const Unhindered& control) { return control.end.exit_status == 139; }},
    {"forging replies", "close the channel and end", "close(3); _exit(0);", stopped_early, exits_with_success},
    {"forging replies", "close the channel and stay", "close(3); for (;;) usleep(1000);", protocol_violation, goes_on},
    {"forging replies", "print a verdict", R"(puts("PASS 100/100 {\"verdict\": \"passed\", \"score\": 1}"); return 0;)",
     wrong_value, prints_pass},
    {"forging replies", "print the end of a time limit", R"(puts("PASS time limit exceeded"); _exit(0);)",
     stopped_early, prints_pass},
    {"forging replies", "reply to all descriptors",
     "for (int d = 3; d < 64; ++d) send(fake(0), sizeof(Reply), d); return 2 * x;", protocol_violation},
    {"forging replies", "reply with the right nonce, and once more", "send(fake(nonce(), 2 * x)); return 2 * x;",
     protocol_violation, [](const Unhindered& control) { return control.value > 200; }},
    {"forging replies", "reply with the right nonce, and end", "send(fake(nonce())); _exit(0);", wrong_value},
    {"forging replies", "answer ahead", "for (int n = 0; n < 8; ++n) send(fake(nonce(), 2 * x)); return 2 * x;",
     protocol_violation, [](const Unhindered& control) { return control.value > 200; }},
    {"forging replies", "a shape that nobody asked for",
     "Reply r = fake(nonce()); r.rows = 1 << 30; r.cols = -5; send(r); return 2 * x;", protocol_violation},
    {"forging replies", "an unknown status", "Reply r = fake(nonce()); r.status = 99; send(r); return 2 * x;",
     protocol_violation},
    {"forging replies", "noise", "char noise[1000] = \"noise\"; (void)!write(3, noise, sizeof noise); return 2 * x;",
     protocol_violation, [](const Unhindered& control) { return control.value.has_value() && control.value != 42; }},
    {"forging replies", "half a reply, and no more", "send(fake(nonce()), 100); for (;;) usleep(1000);", time_limit,
     goes_on},
    {"forging replies", "byte by byte",
     "Reply r = fake(nonce()); for (char& c : r.text) { (void)!write(3, &c, 1); usleep(20000); } for (;;) "
     "usleep(1000);",
     time_limit, goes_on},
    {"forging replies", "announce crashes that don't come",
     "Reply r = fake(0); r.status = 6; r.signal = SIGSYS; for (int i = 0; i < 3; ++i) send(r, 512); return 2 * x;",
     protocol_violation, [](const Unhindered& control) { return control.value.has_value() && control.value != 42; }},
    {"forging replies", "a handler of the end", "std::atexit([] { send(fake(nonce())); }); std::exit(0);", wrong_value},

    {"forging replies", "a shape of more numbers than there are",
     "Reply r = fake(nonce()); r.status = 2; r.rows = r.cols = 2147483647; send(r, 512); for (;;) usleep(1000);",
     wrong_shape, goes_on},

    // --- values
    {"values", "NaN, which fails no comparison that was turned round", "return NAN;", non_finite_value,
     [](const Unhindered& control) { return control.value && !(std::abs(*control.value - 1) > 1e-9); }},
    {"values", "NaN with a sign and a payload", "return -std::nan(\"42\");", non_finite_value,
     [](const Unhindered& control) { return control.value && std::isnan(*control.value); }},
    {"values", "infinity", "return INFINITY;", non_finite_value,
     [](const Unhindered& control) { return control.value && std::isinf(*control.value); }},
    {"values", "the largest number", "return 1.7976931348623157e308;", wrong_value,
     [](const Unhindered& control) { return control.value > 1e308; }},
    {"values", "denormal numbers", "return 2 * x + 4.9e-324;", passed,
     [](const Unhindered& control) { return control.value > 0; }},
    {"values", "another rounding mode for what follows", "fesetround(FE_UPWARD); return 2 * x;", passed,
     [](const Unhindered& control) { return control.value > 0; }},
    {"values", "a processor that flushes, rounds and is not precise",
     "_mm_setcsr((_mm_getcsr() & ~0x6000u) | 0xa040u); unsigned short x87 = 0x47f; asm volatile(\"fldcw %0\" : : "
     "\"m\"(x87)); return 2 * x;",
     passed, [](const Unhindered& control) { return control.value > 0; }},
    {"values", "a table of one seed's answers", "return x == 7 ? 14 : 42;", wrong_value},
    {"values", "traps for the one who compares", "feenableexcept(FE_ALL_EXCEPT); return 2 * x;", passed,
     [](const Unhindered& control) { return control.value > 0; }},

    // --- random answers, and those that remember
    {"random answers", "by the clock",
     "return 2 * x + 1e-3 * double(std::chrono::steady_clock::now().time_since_epoch().count() % 100000 + 1);",
     inconsistent_value, [](const Unhindered& control) { return control.value.has_value(); }},
    {"random answers", "by chance", "return std::random_device{}();", inconsistent_value,
     [](const Unhindered& control) { return control.value.has_value(); }},
    {"random answers", "by an address", "return double((unsigned long)__libc_stack_end >> 4);", inconsistent_value,
     [](const Unhindered& control) { return control.value.has_value(); }},
    {"random answers", "by the processor's counter", "return double(__builtin_ia32_rdtsc());", inconsistent_value,
     [](const Unhindered& control) { return control.value.has_value(); }},

    {"random answers", "by code that changes itself",
     "auto* code = reinterpret_cast<unsigned char*>(&rigid::twice); const auto page = (unsigned long)code & ~4095ul; "
     "mprotect((void*)page, 8192, 7); memcpy(code, \"\\x0f\\x57\\xc0\\xc3\", 4); return 2 * x;",
     wrong_value, [](const Unhindered& control) { return control.value > 200; }},

    // --- reading
    {"reading at run time", "a secret", "return ok(opens(\"CANARY\"));"},
    {"reading at run time", "a secret as a stream", "return ok(std::ifstream(\"CANARY\").good());"},
    {"reading at run time", "a secret around the corner", "return ok(opens(\"/proc/self/root/CANARY\"));"},
    {"reading at run time", "whether a secret is there", "struct stat s; return ok(stat(\"CANARY\", &s) == 0);"},
    {"reading at run time", "whether a secret is there, by another call",
     "return ok(syscall(SYS_statx, AT_FDCWD, \"CANARY\", 0, 0, new char[512]) == 0);"},
    {"reading at run time", "whether a secret may be read", "return ok(access(\"CANARY\", R_OK) == 0);"},
    {"reading at run time", "what is in a folder",
     "return ok(std::filesystem::directory_iterator(\"/\") != std::filesystem::directory_iterator());"},
    {"reading at run time", "who uses the machine", "return ok(opens(\"/etc/passwd\"));"},
    {"reading at run time", "its own path",
     "char path[999]; return ok(readlink(\"/proc/self/exe\", path, sizeof path) > 0);", wrong_value},
    {"reading at run time", "by a call that no C library makes",
     "unsigned long how[3] = {}; return ok(syscall(SYS_openat2, AT_FDCWD, \"CANARY\", how, sizeof how) >= 0);"},
    {"reading at run time", "the memory of the checker",
     "char byte; iovec here{&byte, 1}, there{(void*)__libc_stack_end, 1}; return reaches(process_vm_readv(getppid(), "
     "&here, 1, &there, 1, 0));"},
    {"reading at run time", "the checker's maps",
     "return ok(opens((\"/proc/\" + std::to_string(getppid()) + \"/maps\").c_str()));"},
    {"reading at run time", "a descriptor of the checker", "return ok(syscall(SYS_pidfd_open, getppid(), 0) >= 0);"},
    {"reading at run time", "the environment", "return ok(std::getenv(\"SECRET\"));", wrong_value},
    {"reading at run time", "the other end of a pipe", "return ok(opens(\"/proc/self/fd/1\"));"},
    {"reading at run time", "the name of the machine's user",
     "return ok(getxattr(\"CANARY\", \"user.a\", nullptr, 0) >= 0 || errno == ENODATA || errno == EOPNOTSUPP);"},

    // --- exhaustion
    {"exhaustion", "the processor",
     "for (volatile double y = 0; !gentle || clock() < CLOCKS_PER_SEC / 5;) y = y + 1; return 42;", time_limit},
    {"exhaustion", "the processor, deaf to the warning",
     "std::signal(SIGXCPU, SIG_IGN); for (volatile double y = 0; !gentle || clock() < CLOCKS_PER_SEC / 5;) y = y + 1; "
     "return 42;",
     time_limit},
    {"exhaustion", "time, asleep", "sleep(100); return 0;", time_limit, goes_on},
    {"exhaustion", "time, waiting for a signal", "select(0, nullptr, nullptr, nullptr, nullptr); return 0;",
     forbidden_operation, goes_on},
    {"exhaustion", "time, stopped", "raise(SIGSTOP); return 0;", time_limit, goes_on},
    {"exhaustion", "memory, bit by bit",
     "for (std::vector<std::vector<double>> all; !gentle || all.size() < 30;) all.emplace_back(1 << 20, 1.0); return "
     "42;",
     memory_limit},
    {"exhaustion", "memory, at once", "std::vector<double> big(1 << 26); return ok(big.size() > 0);", memory_limit},
    {"exhaustion", "memory, mapped",
     "for (std::size_t n = 0; !gentle || n < 8; ++n) if (mmap(nullptr, 1 << 25, 3, MAP_PRIVATE | MAP_ANONYMOUS | "
     "MAP_POPULATE, -1, 0) == MAP_FAILED) throw std::bad_alloc(); return 42;",
     memory_limit},
    {"exhaustion", "memory that counts as a file", "return ok(memfd_create(\"m\", 0) >= 0);"},
    {"exhaustion", "memory that others share",
     "return ok(syscall(SYS_shmget, 42, 4096, IPC_CREAT | 0600) >= 0 && syscall(SYS_shmctl, syscall(SYS_shmget, 42, 0, "
     "0), IPC_RMID, nullptr) == 0);"},
    {"exhaustion", "the stack", "return for_ever(x);", crashed, is_killed},
    {"exhaustion", "a stack of one's own choice",
     "rlimit more{RLIM_INFINITY, RLIM_INFINITY}; getrlimit(RLIMIT_STACK, &more); more.rlim_cur = more.rlim_max; return "
     "ok(setrlimit(RLIMIT_STACK, &more) == 0);"},
    {"exhaustion", "descriptors", "return ok(dup(1) >= 0 && dup(1) >= 0);"},
    {"exhaustion", "pipes", "int ends[2]; return ok(pipe(ends) == 0);"},
    {"exhaustion", "processes",
     "for (int n = 0; !gentle || n < 5; ++n) { pid_t child = fork(); if (child == 0) _exit(0); if (child < 0) return "
     "0; waitpid(child, nullptr, 0); } return 42;"},
    {"exhaustion", "output", "for (int n = 0; !gentle || n < 20000; ++n) puts(\"PASS\"); return 0;", output_limit,
     prints_pass},
    {"exhaustion", "errors", "for (int n = 0; !gentle || n < 20000; ++n) std::cerr << \"PASS\\n\"; return 0;",
     output_limit, prints_pass},
    {"exhaustion", "the disk", "return ok(opens(\"CANARY.more\", O_WRONLY | O_CREAT));"},
    {"exhaustion", "the disk, without a name", "return ok(opens(\"/tmp\", O_WRONLY | O_TMPFILE));"},
    {"exhaustion", "locks",
     "return ok(syscall(SYS_flock, 1, LOCK_SH) == 0 || errno == EBADF || errno == EWOULDBLOCK || errno == EINVAL);"},

    // --- the host
    {"the host", "signal the checker", "return ok(kill(getppid(), 0) == 0);"},
    {"the host", "signal everybody", "return gentle ? reaches(kill(-1, 0)) : kill(-1, SIGKILL);"},
    {"the host", "stop the checker", "return gentle ? ok(kill(getppid(), SIGCONT) == 0) : kill(getppid(), SIGSTOP);"},
    {"the host", "trace the checker", "return reaches(ptrace(PTRACE_SEIZE, getppid(), nullptr, nullptr));"},
    {"the host", "change a file", "return ok(opens(\"CANARY\", O_WRONLY | O_APPEND));"},
    {"the host", "empty a file", "return ok(truncate(\"CANARY\", 0) == 0);"},
    {"the host", "delete a file", "return ok(unlink(\"CANARY\") == 0);"},
    {"the host", "rename a file", "return ok(rename(\"CANARY\", \"CANARY.moved\") == 0);"},
    {"the host", "open a file to everybody", "return ok(chmod(\"CANARY\", 0777) == 0);"},
    {"the host", "make a folder", "return ok(mkdir(\"CANARY.folder\", 0700) == 0);"},
    {"the host", "make a link", "return ok(symlink(\"CANARY\", \"CANARY.link\") == 0);"},
    {"the host", "make a pipe with a name", "return ok(mknod(\"CANARY.pipe\", S_IFIFO | 0600, 0) == 0);"},
    {"the host", "leave its folder", "return ok(chdir(\"/\") == 0);"},
    {"the host", "open a terminal", "return ok(opens(\"/dev/ptmx\", O_RDWR | O_NOCTTY));"},
    {"the host", "the program that gets core dumps",
     "return ok(opens(\"/proc/sys/kernel/core_pattern\", gentle ? O_RDONLY : O_WRONLY));"},
    {"the host", "become another program", "execl(\"/bin/sh\", \"sh\", \"-c\", \"echo PASS\", nullptr); return 0;",
     forbidden_operation, prints_pass},
    {"the host", "have a shell do it", "return ok(std::system(\"true\") == 0);"},
    {"the host", "open a connection", "return ok(socket(AF_INET, SOCK_STREAM, 0) >= 0);"},
    {"the host", "talk to a local server", "return ok(socket(AF_UNIX, SOCK_STREAM, 0) >= 0);"},
    {"the host", "talk to the kernel", "return ok(socket(AF_NETLINK, SOCK_RAW, 0) >= 0);"},
    {"the host", "talk to the machine's host", "return reaches(socket(40, SOCK_STREAM, 0));"},
    {"the host", "the checker's limits", "return limits(getppid());"},
    {"the host", "its own limits", "return limits(0);"},
    {"the host", "the checker's limits, only to know them",
     "rlimit now; return ok(syscall(SYS_prlimit64, getppid(), RLIMIT_CORE, nullptr, &now) == 0);"},
    {"the host", "another processor",
     "cpu_set_t all; memset(&all, 255, sizeof all); return ok(sched_setaffinity(0, sizeof all, &all) == 0);"},
    {"the host", "less for others", "return ok(setpriority(PRIO_PROCESS, 0, 5) == 0);"},

    // --- system calls that no function needs
    {"system calls", "namespaces", "return reaches(unshare(CLONE_NEWUSER));"},
    {"system calls", "other namespaces", "return reaches(syscall(SYS_setns, 1, 0));"},
    {"system calls", "mount", "return reaches(syscall(SYS_mount, \"none\", \"/nowhere\", \"tmpfs\", 0, nullptr));"},
    {"system calls", "chroot", "return reaches(chroot(\"/nowhere\"));"},
    {"system calls", "bpf", "return reaches(syscall(SYS_bpf, 99, nullptr, 0));"},
    {"system calls", "perf", "return reaches(syscall(SYS_perf_event_open, nullptr, 0, 0, 0, 0));"},
    {"system calls", "userfaultfd", "return reaches(syscall(SYS_userfaultfd, 1 << 30));"},
    {"system calls", "io_uring", "return reaches(syscall(SYS_io_uring_setup, 0, nullptr));"},
    {"system calls", "keys", "return reaches(syscall(SYS_keyctl, 0, -3, 0));"},
    {"system calls", "seccomp", "return reaches(syscall(SYS_seccomp, 0, 1, nullptr));"},
    {"system calls", "own privileges", "return reaches(setuid(getuid()));"},
    {"system calls", "the kernel's clock", "timex none{}; return ok(adjtimex(&none) >= 0);"},
    {"system calls", "of another architecture",
     "long result = 20; asm volatile(\"int $0x80\" : \"+a\"(result) : : \"memory\"); return ok(result > 0);"},
    {"system calls", "by a number that is none", "return reaches(syscall(0x40000000 + 999));"},
    {"system calls", "terminal input for others",
     "char c = 'x'; return ok(ioctl(1, 0x5412, &c) == 0 || errno == ENOTTY);", wrong_value},

    // --- exceptions and signals
    {"exceptions and signals", "an exception that nobody can catch", "return careless();", crashed, is_killed},
    {"exceptions and signals", "an exception from a destructor", "Throws one; throw 2;", crashed, is_killed},
    {"exceptions and signals", "no exception of the language", "throw 42;", uncaught_exception,
     [](const Unhindered& control) { return !control.value; }},
    {"exceptions and signals", "a reason that never ends",
     "struct Deaf : std::exception { const char* what() const noexcept override { for (;;) usleep(1000); } }; throw "
     "Deaf();",
     time_limit, goes_on},
    {"exceptions and signals", "a reason that is none",
     "struct Mute : std::exception { const char* what() const noexcept override { return nullptr; } }; throw Mute();",
     uncaught_exception, [](const Unhindered& control) { return !control.value; }},
    {"exceptions and signals", "that it was not started", "throw rigid::NotStarted{};", uncaught_exception,
     [](const Unhindered& control) { return !control.value; }},
    {"exceptions and signals", "a smashed stack",
     "char here[8]; memset(here, 0x41, gentle ? 4096 : 65536); return here[7];", crashed, is_killed},
    {"exceptions and signals", "a signal that cannot be caught", "raise(SIGKILL);", crashed, is_killed},
    {"exceptions and signals", "a handler that goes on",
     "std::signal(SIGSYS, [](int) {}); return ok(opens(\"CANARY\"));", wrong_value},
    {"exceptions and signals", "deaf to what is forbidden",
     "std::signal(SIGSYS, SIG_IGN); return ok(opens(\"CANARY\"));"},
    {"exceptions and signals", "a handler that never ends",
     "std::signal(SIGSEGV, [](int) { for (;;) usleep(1000); }); *(volatile int*)8 = 1; return 0;", time_limit, goes_on},
    {"exceptions and signals", "an end that never ends",
     "std::set_terminate([] { for (;;) usleep(1000); }); return careless();", time_limit, goes_on},
    {"exceptions and signals", "a jump out of a crash",
     "static sigjmp_buf place; std::signal(SIGSEGV, [](int) { siglongjmp(place, 1); }); if (sigsetjmp(place, 1) == 0) "
     "*(volatile int*)8 = 1; return 42;",
     wrong_value},

    // --- what goes on without the function
    {"threads and children", "a thread", "std::thread([] {}).join(); return 42;"},
    {"threads and children", "a thread that stays", "std::thread([] { for (;;) usleep(1000); }).detach(); return 42;"},
    {"threads and children", "a child that stays",
     "if (fork() == 0) { usleep(gentle ? 100000 : 99999999); _exit(0); } return 42;"},
    {"threads and children", "a child in a session of its own",
     "if (fork() == 0) { setsid(); if (fork() == 0) usleep(gentle ? 100000 : 99999999); _exit(0); } return 42;"},
    {"threads and children", "a child by another call", "if (vfork() == 0) _exit(0); return 42;"},
    {"threads and children", "an alarm", "alarm(1); return 42;"},
    {"threads and children", "a timer",
     "itimerval soon{{0, 0}, {0, 200000}}; return ok(setitimer(ITIMER_REAL, &soon, nullptr) == 0);"},
};

constexpr double first_number = 100;

std::string program_text() {
  std::string text = beginning, cases;
  for (std::size_t k = 0; k < std::size(attacks); ++k) {
    text += fmt::format(
        "[[maybe_unused]] double attack_{}([[maybe_unused]] double x, [[maybe_unused]] bool gentle) {{ {} }}\n", k,
        attacks[k].code);
    cases += fmt::format("    case {}: return attack_{}(x, gentle);\n", first_number + static_cast<double>(k), k);
  }
  return filled_in("#include <sys/xattr.h>\n#include <sys/file.h>\n#include <cfenv>\n" + text +
                   "}\ndouble rigid::twice(double x) {\n  const bool gentle = x != int(x);\n  switch (int(x)) {\n" +
                   cases + "  }\n  return 2 * x;\n}\n");
}

}  // namespace

TEST_CASE("what a function tries while it runs gets it no answer, and nothing else") {
  restore_canary();
  const std::filesystem::path program = executable(program_text());
  RunLimits limits = short_limits();
  std::map<std::string, int> of_kind;
  for (std::size_t k = 0; k < std::size(attacks); ++k) {
    const Attack& attack = attacks[k];
    INFO(std::string(attack.kind) << ": " << std::string(attack.what));
    ++of_kind[attack.kind];
    const double x = first_number + static_cast<double>(k);
    const Unhindered control = run_unhindered(program, x + 0.5, attack.works == goes_on);
    CHECK_MESSAGE(attack.works(control), "the control does not work: value "
                                             << control.value.value_or(-1) << ", signal " << control.end.signal
                                             << ", exit status " << control.end.exit_status
                                             << (control.went_on ? ", went on" : ""));
    restore_canary();
    const ExerciseReference reference = reference_at(x);
    limits.time = std::chrono::milliseconds(attack.works == goes_on ? 600 : 5000);
    const auto begun = std::chrono::steady_clock::now();
    ExerciseRunner runner(program, limits);
    expect(attack, reference, runner.observe(plan_calls(reference.cases), {1}), begun);
  }
  for (const auto& [kind, count] : of_kind) MESSAGE(kind << ": " << count);
}

}  // namespace workbook::testing
