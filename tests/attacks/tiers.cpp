// How strong the sandbox of each tier is, and that the checker knows.
#include "tests/attacks/attack.hpp"
#include "tests/support/system_calls.hpp"

#include "checker/explain/diagnostic_run.hpp"
#include "checker/sandbox/control_group.hpp"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <thread>

namespace workbook::testing {
namespace {

namespace fs = std::filesystem;

const char* const right = "\ndouble rigid::twice(double x) { return 2 * x; }\n";

}  // namespace

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

int main(int count, char** files) {
  FILE* changed = fopen(files[1], "a");
  const bool harms = rename(files[1], files[2]) == 0 || unlink(files[1]) == 0 || changed;
  if (count == 3) return harms;
  return all_succeed(3, 120) + 2 * all_succeed(80, 0) + 4 * all_written("/tmp", 1, 10) +
         8 * all_written("/tmp", 6, 50) + 16 * harms;
}
)";
  restore_canary();
  const fs::path folder = fresh_directory("starts_others");
  write(folder / "starts_others.cpp", program);
  REQUIRE(compiler_unhindered({"-static", "starts_others.cpp", "-o", "starts_others"}, folder).succeeded());
  Launch launch;
  launch.program = (folder / "starts_others").string();
  launch.arguments = {canary().string(), canary().string() + ".moved"};
  CHECK(run_program(launch, std::chrono::seconds(30), 1000).end.exit_status == 1);  // the control
  restore_canary();
  launch.arguments.emplace_back("all");
  const std::string workspace = fresh_directory("workspace").string();
  SandboxProfile profile = compile_profile(toolchain().compiler.string(), {folder.string()}, workspace);
  profile.memory_bytes = std::size_t{300} << 20;
  confine(launch, profile);
  const FinishedProgram ran = run_program(launch, std::chrono::seconds(30), 1000);
  CHECK(ran.end.signal == 0);
  constexpr int starts_all = 3, has_own_files = 4;
  const bool is_grouped = sandbox_tier() == SandboxTier::grouped, is_full = sandbox_tier() >= SandboxTier::full;
  CHECK(ran.end.exit_status == (is_grouped ? 0 : starts_all) + (is_full ? has_own_files : 0));
  CHECK_FALSE(fs::exists("/tmp/workbook-0"));
  CHECK(canary_is_unchanged());
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
