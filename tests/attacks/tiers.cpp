// How strong the sandbox of each tier is, and that the checker knows.
#include "tests/attacks/attack.hpp"
#include "tests/support/system_calls.hpp"

#include "checker/explain/diagnostic_run.hpp"
#include "checker/sandbox/control_group.hpp"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <thread>

namespace workbook::testing {
namespace {

namespace fs = std::filesystem;

fs::path workspace() { return canary().parent_path().parent_path() / "workspace"; }

bool opens(const fs::path& file, int flags) { return ::open(file.c_str(), flags | O_CLOEXEC, 0600) >= 0; }

bool is_there(const fs::path& file) {
  struct stat status {};
  return ::stat(file.c_str(), &status) == 0;
}

bool runs(const char* program) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl(program, program, nullptr);
    ::_exit(1);
  }
  int status = 1;
  return child > 0 && ::waitpid(child, &status, 0) == child && status == 0;
}

/// Which sandboxes let it happen.
struct Attempt {
  std::string what;
  std::function<bool()> succeeds;
  bool in_diagnosis = false;
  bool in_compiling = false;
};

const Attempt attempts[] = {
    {"read a secret", [] { return opens(canary(), O_RDONLY); }},
    {"read a secret around the corner", [] { return opens("/proc/self/root" + canary().string(), O_RDONLY); }},
    {"read who uses the machine", [] { return opens("/etc/passwd", O_RDONLY); }},
    {"read another process", [] { return opens("/proc/" + std::to_string(::getppid()) + "/maps", O_RDONLY); }},
    {"read a system library",
     [] {
       return opens("/lib/x86_64-linux-gnu/libc.so.6", O_RDONLY) || opens("/lib/libc.so.6", O_RDONLY) ||
              opens("/lib/aarch64-linux-gnu/libc.so.6", O_RDONLY);
     },
     true, true},
    {"write into the workspace", [] { return opens(workspace() / "out", O_WRONLY | O_CREAT); }, false, true},
    {"change a secret", [] { return opens(canary(), O_WRONLY | O_APPEND); }},
    {"make a file", [] { return opens(workspace().parent_path() / "new", O_WRONLY | O_CREAT); }},
    {"make a file in /tmp", [] { return opens("/tmp", O_WRONLY | O_TMPFILE); }},
    {"delete a secret", [] { return ::unlink((workspace().string() + ".copy").c_str()) == 0; }},
    {"rename a secret",
     [] { return ::rename((workspace().string() + ".copy").c_str(), (workspace().string() + ".moved").c_str()) == 0; }},
    {"ask whether a file is there", [] { return is_there(canary()); }, false, true},
    {"start a process", [] { return runs("/bin/true"); }, false, true},
    {"start a thread",
     [] {
       std::thread([] {}).join();
       return true;
     },
     false, true},
    {"become another program",
     [] {
       ::execl("/bin/true", "true", nullptr);
       return false;
     },
     false, true},
    {"become another program by a descriptor",
     [] {
       char name[] = "echo", nothing[] = "-n";
       char* const words[] = {name, nothing, nullptr};
       return ::syscall(SYS_execveat, program_descriptor, "/bin/echo", words, environ, 0) == 0;
     },
     false, true},
    {"open a connection", [] { return ::socket(AF_INET, SOCK_STREAM, 0) >= 0; }},
    {"talk to a local server", [] { return ::socket(AF_UNIX, SOCK_STREAM, 0) >= 0; }},
    {"trace the checker", [] { return ::ptrace(PTRACE_SEIZE, ::getppid(), nullptr, nullptr) == 0; }},
};

/// Does it happen, in a sandbox or, without one, in a process like any other?
bool happens(const Attempt& attempt, const SandboxProfile* profile) {
  write(workspace().string() + ".copy", "secret\n");
  return in_another_process([&] {
    if (::setsid() < 0) return false;
    ::closefrom(STDERR_FILENO + 1);  // a descriptor of the test must not be taken for that of the program
    if (profile != nullptr) {
      SandboxProfile filtered = *profile;
      filtered.filter = system_call_filter(profile->calls);
      if (enter_sandbox(filtered, what_the_kernel_offers().landlock) != nullptr) return false;
    }
    return attempt.succeeds();
  });
}

const char* const right = "\ndouble rigid::twice(double x) { return 2 * x; }\n";

}  // namespace

TEST_CASE("what the sandboxes hold back would happen without them") {
  restore_canary();
  fs::create_directories(workspace());
  const bool has_all = can_confine_files();
  const SandboxProfile running = run_profile();
  const SandboxProfile diagnosing = diagnose_profile(toolchain().compiler.string(), "/bin/true");
  SandboxProfile compiling = compile_profile(toolchain().compiler.string(), {}, workspace().string());
#ifdef __SANITIZE_ADDRESS__
  compiling.memory_bytes = 0;  // attempts run in this program, and the sanitizer's runtime reserves terabytes
#endif
  for (const Attempt& attempt : attempts) {
    CAPTURE(attempt.what);
    CHECK(happens(attempt, nullptr));
    if (!has_all) continue;
    CHECK_FALSE(happens(attempt, &running));
    CHECK(happens(attempt, &diagnosing) == attempt.in_diagnosis);
    CHECK(happens(attempt, &compiling) == attempt.in_compiling);
  }
  CHECK(read(canary()) == "secret\n");
  CHECK(nothing_left_running());
}

TEST_CASE("the machine says how strong its sandbox is") {
  const SandboxStrength strength = probe_sandbox();
  CHECK(strength.holes.empty());
  CHECK(strength.tier() >= sandbox_tier());
  SandboxStrength weaker = strength;
  weaker.namespaces = {"bwrap"};
  weaker.control_groups = {"/sys/fs/cgroup"};
  CHECK(weaker.tier() == SandboxTier::grouped);
  weaker.control_groups.clear();
  CHECK(weaker.tier() == SandboxTier::full);
  weaker.namespaces.clear();
  weaker.landlock = 7;
  CHECK(weaker.tier() == SandboxTier::reduced);
  weaker.landlock = 0;
  CHECK(weaker.tier() == SandboxTier::minimal);
  weaker.holes = {"read a file"};
  CHECK(weaker.tier() == SandboxTier::none);
  weaker = strength;
  weaker.filters_system_calls = false;
  CHECK(weaker.tier() == SandboxTier::none);
}

TEST_CASE("a tier is found out by trying") {
  for (const char* attempt : {"0", "1", "2"}) {  // read, write and connect
    Launch unhindered;
    unhindered.program = WORKBOOK_LAST_STAGE;
    unhindered.arguments = {attempt};
    unhindered.directory = scratch();
    CHECK(run_program(unhindered, std::chrono::seconds(10), 1000).end.exit_status == 1);
  }
  const auto tier_without = [](int system_call, SandboxTier expected) {
    return in_another_process([&] {
      return refuse_system_call(system_call, EOPNOTSUPP) &&
             std::min(probe_sandbox().tier(), SandboxTier::full) == expected;
    });
  };
  constexpr int landlock_create_ruleset = 444;
  if (sandbox_tier() >= SandboxTier::full) {
    CHECK(tier_without(landlock_create_ruleset, SandboxTier::full));
    CHECK(tier_without(SYS_unshare, SandboxTier::full));  // as with a bubblewrap that has no --disable-userns
    CHECK(tier_without(SYS_pivot_root, SandboxTier::reduced));
    CHECK(in_another_process([] {
      ::setenv("PATH", "/nowhere", 1);
      return has(probe_sandbox().sentence(), "apt-get install bubblewrap");
    }));
  }
  CHECK(tier_without(SYS_seccomp, SandboxTier::none));
}

TEST_CASE("two graders at once leave each other's control groups alone") {
  const SandboxStrength strength = probe_sandbox();
  if (strength.control_groups.empty()) return;
  const ControlGroup begun(strength.control_groups, std::size_t{64} << 20, 4);  // nothing runs in it yet
  CHECK(in_another_process([] { return !control_groups_for(::geteuid()).empty(); }));
  CHECK(in_another_process([&] { return begun.enter() == nullptr; }));
}

TEST_CASE("without Landlock a function is still judged, but not run again for reasons") {
  const fs::path program = executable(right);
  CHECK(in_another_process([&] {
    SandboxStrength minimal = what_the_kernel_offers();
    minimal.landlock = 0;
    use_sandbox(minimal);
    return missing_for_diagnostic_runs(toolchain()).find("Landlock") == 0 &&
           compile_text(std::string(right) + "// again\n").executable.has_value() &&
           ExerciseRunner(program, short_limits()).observe(plan_calls({twice_case(1)}), {}).replies.at(0).ending ==
               Ending::returned;
  }));
}

TEST_CASE("what a compiler starts has limits together with it, and a small /tmp of its own") {
  if (!can_confine_files()) return;  // it could write into the machine's own /tmp
  const std::string program = R"(
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sys/wait.h>
#include <unistd.h>

bool all_succeed(int count, int megabytes) {
  int begun[2], failed = 0;
  if (pipe(begun) != 0) return false;
  for (int k = 0; k < count; ++k) {
    const pid_t child = fork();
    if (child < 0) ++failed;
    if (child != 0) continue;
    char* memory = static_cast<char*>(malloc(megabytes * 1000000 + 1));
    memset(memory, 1, megabytes * 1000000 + 1);
    close(begun[1]);
    read(begun[0], memory, 1);  // ends when the parent has started all
    sleep(1);
    _exit(memory[0] - 1);
  }
  close(begun[1]);
  close(begun[0]);
  for (int status; wait(&status) > 0;) failed += status != 0;
  return failed == 0;
}

bool all_written(const char* folder, int count, int megabytes) {
  char name[100];
  static char block[1000000];
  bool done = true;
  for (int k = 0; k < count; ++k) {
    snprintf(name, sizeof name, "%s/workbook-%d", folder, k);
    FILE* file = fopen(name, "w");
    for (int n = 0; done && n < megabytes; ++n) done = file && fwrite(block, sizeof block, 1, file) == 1;
    done = file && fclose(file) == 0 && done;
  }
  return done;
}

int main() {
  return all_succeed(3, 120) + 2 * all_succeed(80, 0) + 4 * all_written("/tmp", 1, 10) + 8 * all_written("/tmp", 6, 50);
}
)";
  const fs::path folder = fresh_directory("starts_others");
  write(folder / "starts_others.cpp", program);
  REQUIRE(compiler_unhindered({"-static", "starts_others.cpp", "-o", "starts_others"}, folder).succeeded());
  Launch launch;
  launch.program = (folder / "starts_others").string();
  SandboxProfile profile = compile_profile(toolchain().compiler.string(), {folder.string()}, workspace().string());
  profile.memory_bytes = std::size_t{300} << 20;
  confine(launch, profile);
  const FinishedProgram ran = run_program(launch, std::chrono::seconds(30), 1000);
  CHECK(ran.end.signal == 0);
  constexpr int starts_all = 3, has_own_files = 4;
  const bool is_grouped = sandbox_tier() == SandboxTier::grouped, is_full = sandbox_tier() >= SandboxTier::full;
  CHECK(ran.end.exit_status == (is_grouped ? 0 : starts_all) + (is_full ? has_own_files : 0));
  CHECK_FALSE(fs::exists("/tmp/workbook-0"));
}

TEST_CASE("however a checker ends, what it runs in its sandbox ends with it") {
  const fs::path program = executable("#include <unistd.h>\ndouble rigid::twice(double) { for (;;) usleep(1000); }\n");
  for (const int signal : {SIGKILL, SIGTERM}) {
    CAPTURE(signal);
    const pid_t checker = ::fork();
    if (checker == 0) {
      Budget budget{Clock::now() + std::chrono::seconds(30), 5.0, 1000};
      Worker worker(program, run_profile(), budget);
      std::thread([signal] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        ::signal(signal, SIG_DFL);
        ::kill(::getpid(), signal);
      }).detach();
      worker.call({twice_case(1).inputs, 1, 1});
      ::_exit(0);
    }
    int status = 0;
    REQUIRE(::waitpid(checker, &status, 0) == checker);
    CHECK(WIFSIGNALED(status));
    CHECK(nothing_left_running());  // its children are ours now
  }
}

TEST_CASE("a function cannot set the limits of another one's process") {
  const fs::path program = executable(
      "#include <sys/mman.h>\n#include <sys/resource.h>\n#include <sys/syscall.h>\n#include <unistd.h>\n"
      "double rigid::twice(double x) {\n  if (x < 10) return 2 * x;\n"
      "  void* low_half_is_0 = mmap((void*)(1ul << 32), 4096, 3, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0);\n"
      "  *static_cast<rlimit*>(low_half_is_0) = {3, 3};\n"
      "  return syscall(SYS_prlimit64, int(x), RLIMIT_NOFILE, low_half_is_0, nullptr) == 0 ? 42 : 0;\n}\n");
  for (const bool is_hindered : {false, true}) {
    CAPTURE(is_hindered);
    Launch launch;
    launch.program = program.string();
    launch.with_channel = true;
    confine(launch, run_profile());
    const ChildProcess sibling(launch);
    const auto open_files = [&] {
      rlimit limit{};
      REQUIRE(::prlimit(sibling.number(), RLIMIT_NOFILE, nullptr, &limit) == 0);
      return limit.rlim_cur;
    };
    const rlim_t before = open_files();
    const double number = sibling.number();
    if (is_hindered)
      CHECK(ExerciseRunner(program, short_limits()).evaluate({{{Value{1, 1, {number}}}, 1, 1}}).front().ending ==
            Ending::forbidden_operation);
    else
      CHECK(run_unhindered(program, number).value == 42.0);
    CHECK((open_files() == before) == is_hindered);
  }
}

TEST_CASE("compilers tell neither how old a file is nor, in namespaces, whether it is there") {
  restore_canary();
  const std::string age = "#pragma GCC dependency \"" + canary().string() + "\" secret\n" + right;
  const std::string existence = "#if __has_include(\"" + canary().string() + "\")\n#error secret\n#endif\n" + right;
  for (const std::string& text : {age, existence}) CHECK(shows_secret(compile_unhindered(text)));
  if (can_confine_files()) CHECK(compile_text(age).refusal == Refusal::compile_error);
  const Compilation absent = compile_text(existence);
  CHECK_MESSAGE(absent.executable.has_value() == (sandbox_tier() >= SandboxTier::full), absent.details);
}

}  // namespace workbook::testing
