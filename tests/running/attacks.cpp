// What hostile files try, in every sandbox, each beside a control that shows that it works without.
#include "tests/running/student.hpp"
#include "tests/support/system_calls.hpp"

#include "checker/compile/compile.hpp"
#include "checker/sandbox/diagnostic_run.hpp"
#include "checker/sandbox/sandbox.hpp"

#include <doctest/doctest.h>

#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <thread>

namespace workbook::testing {
namespace {

namespace fs = std::filesystem;

/// A file that no student's code or compiler may read or change.
fs::path canary() {
  static const fs::path file = write(fresh_directory("attacks") / "canary", "secret\n");
  return file;
}

fs::path workspace() { return canary().parent_path() / "workspace"; }

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
    {"make a file", [] { return opens(canary().parent_path() / "new", O_WRONLY | O_CREAT); }},
    {"make a file in /tmp", [] { return opens("/tmp", O_WRONLY | O_TMPFILE); }},
    {"delete a secret", [] { return ::unlink((canary().string() + ".copy").c_str()) == 0; }},
    {"rename a secret",
     [] { return ::rename((canary().string() + ".copy").c_str(), (canary().string() + ".moved").c_str()) == 0; }},
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
    {"open a connection", [] { return ::socket(AF_INET, SOCK_STREAM, 0) >= 0; }},
    {"talk to a local server", [] { return ::socket(AF_UNIX, SOCK_STREAM, 0) >= 0; }},
    {"trace the checker", [] { return ::ptrace(PTRACE_SEIZE, ::getppid(), nullptr, nullptr) == 0; }},
};

/// Does it happen, in a sandbox or, without one, in a process like any other?
bool happens(const Attempt& attempt, const SandboxProfile* profile) {
  write(canary().string() + ".copy", "secret\n");
  return in_another_process([&] {
    if (::setsid() < 0 || (profile != nullptr && Sandbox(*profile).enter() != nullptr)) return false;
    return attempt.succeeds();
  });
}

/// The text of an assembler file as a string of C++.
std::string as_asm(const std::string& text) { return "asm(R\"~~(" + text + ")~~\");\n"; }

FinishedProgram run_unwatched(const std::vector<std::string>& arguments, const fs::path& directory) {
  Launch launch;
  launch.program = toolchain().compiler.string();
  launch.arguments = arguments;
  launch.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C"};
  launch.directory = directory;
  return run_program(launch, std::chrono::seconds(60), 1 << 20);
}

std::vector<std::string> with_flags(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), toolchain().flags.begin(), toolchain().flags.end());
  return arguments;
}

/// Links an object as it was done before: no look at its sections, code generated at the link.
fs::path linked_as_before(const fs::path& object) {
  std::vector<std::string> arguments = {object.string(), toolchain().worker_object("twice").string()};
  for (const fs::path& part : toolchain().support) arguments.push_back(part.string());
  for (const std::string& flag : toolchain().link_flags)
    if (flag != "-fno-lto") arguments.push_back(flag);
  fs::path program = object.parent_path() / "program";
  arguments.insert(arguments.end(), {"-o", program.string()});
  const FinishedProgram linked = run_unwatched(arguments, object.parent_path());
  INFO(linked.output);
  REQUIRE(linked.succeeded());
  return program;
}

const char* const right = "\ndouble rigid::twice(double x) { return 2 * x; }\n";

}  // namespace

TEST_CASE("what the sandboxes hold back would happen without them") {
  fs::create_directories(workspace());
  const bool has_all = can_confine_files();
  const SandboxProfile running = run_profile();
  const SandboxProfile diagnosing = diagnose_profile(toolchain().compiler.string(), "/bin/true");
  const SandboxProfile compiling = compile_profile(toolchain().compiler.string(), {}, workspace().string());
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
  const auto tier_without = [](int system_call, SandboxTier expected) {
    return in_another_process(
        [&] { return refuse_system_call(system_call, EOPNOTSUPP) && probe_sandbox().tier() == expected; });
  };
  constexpr int landlock_create_ruleset = 444;
  if (sandbox_tier() == SandboxTier::full) {
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

TEST_CASE("without Landlock a function is still judged, but not run again for reasons") {
  const fs::path program = executable(right);
  CHECK(in_another_process([&] {
    SandboxStrength minimal = what_the_kernel_offers();
    minimal.landlock = 0;
    use_sandbox(minimal);
    return missing_for_diagnostic_runs(toolchain()).find("Landlock") == 0 &&
           compile_text(std::string(right) + "// again\n").executable.has_value() &&
           ExerciseRunner(program, short_limits()).observe({twice_case(1)}, {}).replies.at(0).ending ==
               Ending::returned;
  }));
}

TEST_CASE("code generated at the link reaches no file, for there is none") {
  const fs::path directory = fresh_directory("link_time");
  const fs::path secret = write(directory / "secret", "*");  // 42
  // A file is compiled into the compiler's own intermediate language; the text of that is the attack.
  write(directory / "inner.cpp",
        "#include <fixture/contract.hpp>\nextern \"C\" const char secret[];\n"
        "asm(\".section .rodata\\n.globl secret\\nsecret: .incbin \\\"" +
            secret.string() +
            "\\\"\\n\");\n"
            "double rigid::twice(double) { return secret[0]; }\n");
  REQUIRE(run_unwatched(with_flags({"-flto", "-S", "inner.cpp", "-o", "inner.s"}), directory).succeeded());
  const std::string attack = as_asm(read(directory / "inner.s"));

  write(directory / "attack.cpp", attack);
  REQUIRE(run_unwatched(with_flags({"-c", "attack.cpp", "-o", "attack.o"}), directory).succeeded());
  ExerciseRunner deceived(linked_as_before(directory / "attack.o"), short_limits());
  CHECK(deceived.observe({twice_case(1)}, {}).replies.at(0).value.numbers.at(0) == 42.0);  // the control

  const Compilation refused = compile_text(attack);
  CHECK(refused.refusal == Refusal::compile_error);
  CHECK_FALSE(refused.executable.has_value());
  // Each of the other cures is enough by itself.
  std::vector<std::string> arguments = {"attack.o", toolchain().worker_object("twice").string(), "-fno-lto", "-o", "p"};
  CHECK_FALSE(run_unwatched(arguments, directory).succeeded());
  if (!can_confine_files()) return;
  const CompileLimits limits;
  const Workspace place(directory);
  const Compiler compiler(toolchain(), limits, place.directory());
  compiler.write(attack);
  fs::copy(directory / "attack.o", place.directory() / "unit.o");
  arguments = {"unit.o", toolchain().worker_object("twice").string(), "-static", "-o", "p"};
  for (const fs::path& part : toolchain().support) arguments.push_back(part.string());
  const FinishedProgram linked = compiler.run(arguments);
  CHECK_FALSE(linked.succeeded());
  CHECK(linked.output.find("secret") != std::string::npos);  // which it was kept from reading
}

TEST_CASE("compiler and assembler show no line of a foreign file") {
  for (const std::string code :
       {"#include \"FILE\"", "asm(\".include \\\"FILE\\\"\");", "asm(\".incbin \\\"FILE\\\"\");"}) {
    CAPTURE(code);
    std::string text = code;
    text.replace(text.find("FILE"), 4, canary().string());
    const fs::path directory = fresh_directory("reading");
    write(directory / "unit.cpp", text + right);
    const FinishedProgram control =
        run_unwatched(with_flags({"-include", "fixture/contract.hpp", "-c", "unit.cpp", "-o", "unit.o"}), directory);
    const std::string object = is_there(directory / "unit.o") ? read(directory / "unit.o") : "";
    CHECK((control.output + object).find("secret") != std::string::npos);

    const Compilation compilation = compile_text(text + right);
    CHECK(compilation.refusal == Refusal::compile_error);
    CHECK(compilation.message.find(canary().string()) != std::string::npos);
    if (can_confine_files()) CHECK(compilation.details.find("secret\n") == std::string::npos);
  }
}

TEST_CASE("a program that asks for another to run it is the student's error, not ours") {
  const std::string attack =
      "#include <fixture/contract.hpp>\n"
      "[[gnu::section(\".interp\"), gnu::used]] const char interpreter[] = \"/nowhere/at/all\";" +
      std::string(right);
  const fs::path directory = fresh_directory("interpreter");
  write(directory / "attack.cpp", attack);
  REQUIRE(run_unwatched(with_flags({"-c", "attack.cpp", "-o", "attack.o"}), directory).succeeded());
  const fs::path program = linked_as_before(directory / "attack.o");
  CHECK(ExerciseRunner(program, short_limits()).observe({twice_case(1)}, {}).refusal == Refusal::checker_error);

  const Compilation refused = compile_text(attack);
  CHECK_FALSE(refused.executable.has_value());
  CHECK(refused.refusal == Refusal::compile_error);
}

TEST_CASE("a function learns of no file whether it is there") {
  if (!probe_sandbox().filters_system_calls) return;
  ExerciseRunner runner(executable("#include <fcntl.h>\n#include <sys/syscall.h>\n#include <unistd.h>\n"
                                   "double rigid::twice(double x) {\n  char status[512];\n"
                                   "  return syscall(SYS_newfstatat, AT_FDCWD, x == 1 ? \"/etc/passwd\" : \"/nowhere\","
                                   " status, AT_EMPTY_PATH) == 0 ? 1 : errno;\n}"),
                        short_limits());
  const Observation observation = runner.observe({twice_case(1), twice_case(2)}, {});
  CHECK(observation.replies.at(0).value == Value{1, 1, {EACCES}});
  CHECK(observation.replies.at(1).value == Value{1, 1, {EACCES}});
}

TEST_CASE("memory beyond the limit ends a diagnostic run, however it is asked for") {
  const Submission endless = submit(
      "#include <sys/mman.h>\ndouble rigid::twice(double x) {\n  for (;;) {\n"
      "    void* more = mmap(nullptr, 1 << 26, PROT_READ | PROT_WRITE, MAP_PRIVATE | "
      "MAP_ANONYMOUS | MAP_POPULATE, -1, 0);\n"
      "    if (more == MAP_FAILED) return x;\n  }\n}\n",
      "twice");
  if (toolchain().diagnostic.empty() || !can_confine_files()) return;
  const Compilation compilation =
      compile({endless, "twice", "twice"}, read_toolchain(toolchain().diagnostic), shared_cache());
  REQUIRE(compilation.executable.has_value());
  Budget budget{Clock::now() + std::chrono::seconds(20), 10.0, 1 << 16};
  Worker worker(*compilation.executable,
                diagnose_profile(toolchain().compiler.string(), compilation.executable->string()), budget);
  CHECK(worker.call({twice_case(1).inputs, 1, 1}).ending == Ending::memory_limit);
  CHECK(nothing_left_running());
}

TEST_CASE("a pipe in the place of a kept executable is not waited for") {
  const std::string text = "double rigid::twice(double x) { return x + x + 0; }";
  const fs::path kept = executable(text);
  fs::remove(kept);
  REQUIRE(::mkfifo(kept.c_str(), 0600) == 0);
  const Compilation again = compile_text(text);
  CHECK(again.executable.has_value());
  CHECK_FALSE(again.from_cache);
}

}  // namespace workbook::testing
