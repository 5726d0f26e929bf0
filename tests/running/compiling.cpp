// From a file to an executable, and all that can stand in a file instead of a right function.
#include "tests/running/student.hpp"

#include "checker/base/child_process.hpp"

#include <doctest/doctest.h>

#include <signal.h>
#include <sys/resource.h>

namespace workbook::testing {
namespace fs = std::filesystem;
namespace {

Compilation compile_file(const fs::path& file, const CompileLimits& limits = {}, const Toolchain& tools = toolchain(),
                         const fs::path& cache = shared_cache(), const std::string& exercise = "twice") {
  return compile({read_submission(file), exercise, signature("twice")}, tools, cache, limits);
}

/// Compiles a text that cannot be compiled.
Compilation refused_text(const std::string& text, Refusal refusal = Refusal::compile_error,
                         const CompileLimits& limits = {}) {
  Compilation compilation =
      compile({submit(text, "twice"), "twice", signature("twice")}, toolchain(), shared_cache(), limits);
  CHECK_FALSE(compilation.executable.has_value());
  CHECK(compilation.refusal == refusal);
  CHECK_FALSE(compilation.message.empty());
  CHECK(nothing_left_running());
  return compilation;
}

/// The compiler behind a few lines of shell, in a folder where the sandbox lets it start.
fs::path stand_in_compiler(const fs::path& directory, const std::string& beginning) {
  fs::path script = write(directory / "bin" / "compiler",
                          "#!/usr/bin/sh\n" + beginning + "\nexec " + toolchain().compiler.string() + " \"$@\"\n");
  fs::permissions(script, fs::perms::owner_all | fs::perms::group_all | fs::perms::others_all);
  return script;
}

bool says(const Compilation& compilation, const std::string& word) {
  return compilation.message.find(word) != std::string::npos;
}

}  // namespace

TEST_CASE("the first error is told with file, line and column, and shown with them") {
  const Compilation compilation = refused_text("// a comment\ndouble rigid::twice(double x) {\n  return 2 * y;\n}\n");
  CHECK(says(compilation, "line 3"));
  REQUIRE(compilation.errors.size() == 1);
  CHECK(compilation.errors[0].excerpt == "  return 2 * y;\n             ^");
  CHECK(compilation.details.find("twice.cpp:3:14: error:") != std::string::npos);
  CHECK(compilation.details.find("return 2 * y;") != std::string::npos);
  CHECK(compilation.details.find("unit.cpp") == std::string::npos);
  CHECK(refused(compilation).errors.size() == 1);
}

TEST_CASE("what is missing when the program is linked has a name, and a place if the file mentions it") {
  struct Unlinked {
    const char* text;
    Refusal refusal;
    const char* name;
    int line, column;
    const char* word;
  };
  const Unlinked files[] = {
      {"", Refusal::missing_function, "", 0, 0, "empty"},
      {"double twice(double x) { return 2 * x; }", Refusal::missing_function, "missing_namespace", 1, 8,
       "outside of the namespace"},
      {"namespace rigid { double twice(const Vector3d& x) { return x[0]; } }", Refusal::missing_function,
       "parameter_types", 1, 26, "`double twice(double x)`"},
      {"namespace rigid { inline double twice(double x) { return 2 * x; } }", Refusal::missing_function,
       "missing_function", 1, 33, "no function"},
      {"namespace rigid { namespace { double twice(double x) { return 2 * x; } } }", Refusal::missing_function,
       "missing_function", 1, 38, "no function"},
      {"namespace rigid { double double_of(double x) { return 2 * x; } }", Refusal::missing_function, "", 0, 0,
       "`rigid::double_of(double)`"},
      {"double rigid::twice(double x) {\n  return signed_by(1, x) + 1;\n}", Refusal::compile_error,
       "undefined_function", 2, 10, "`rigid::signed_by`"},
      {"void elsewhere();\ndouble rigid::twice(double x) { elsewhere(); return 2 * x; }", Refusal::compile_error,
       "undefined_function", 2, 33, "`elsewhere`"},
      {"double rigid::twice(double x) { return 2 * x; }\nint main() {}", Refusal::compile_error, "defines_main", 2, 5,
       "main"},
      {"extern double elsewhere;\ndouble rigid::twice(double x) { return elsewhere * x; }", Refusal::compile_error,
       "undefined_function", 2, 40, "`elsewhere`"},
  };
  for (const Unlinked& file : files) {
    CAPTURE(file.text);
    const Compilation compilation = refused_text(file.text, file.refusal);
    CHECK(has(compilation.errors.empty() ? compilation.message : compilation.errors[0].sentence, file.word));
    CHECK(compilation.errors.size() == (*file.name == '\0' ? 0 : 1));
    for (const Reason& finding : compilation.errors) {
      CHECK(finding.name == file.name);
      CHECK(finding.line == file.line);
      CHECK(finding.column == file.column);
    }
  }
}

TEST_CASE("a name of the linker that stands for an endless signature does no harm" * doctest::test_suite("thorough")) {
  // f(A<int>, A<A<int>, A<int>>, …): every parameter is twice as long as the one before it.
  std::string name = "_Z1f1AIiE";
  for (const char digit : std::string("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"))
    name += std::string("S_IS") + digit + "_S" + digit + "_E";
  const Compilation compilation =
      refused_text("extern \"C\" void " + name + "() {}\nextern \"C\" void " + std::string(3000, 'a') +
                       "() {}\ndouble twice(double x) { return x; }\n",
                   Refusal::missing_function);
  CHECK(compilation.message.size() < 1000);
  CHECK(compilation.processor_seconds < 20.0);
}

TEST_CASE("a file may define helpers of its own") {
  CHECK(compile_text("namespace { double half(double x) { return x / 2; } }\n"
                     "double rigid::twice(double x) { return 4 * half(x); }")
            .executable.has_value());
}

TEST_CASE("templates and includes without end are stopped") {
  const Compilation deep = refused_text(
      "template <int n> struct Deep { static constexpr int value = Deep<n + 1>::value; };\n"
      "double rigid::twice(double) { return Deep<0>::value; }");
  CHECK(deep.errors.size() == 1);
  CHECK(says(refused_text("#include \"unit.cpp\"\n"), "line 1"));
  CHECK(says(refused_text("#include \"/dev/zero\"\n"), "/dev/zero"));
}

TEST_CASE("a compilation that takes too long is stopped with all its processes") {
  CompileLimits limits;
  limits.time = std::chrono::milliseconds(500);
  const Compilation slow = refused_text(
      "constexpr long f(long n) { long sum = 0; for (long i = 0; i < 200000; ++i) sum += i % n; return sum; }\n"
      "template <long n> struct F { static constexpr long value = f(n) + F<n - 1>::value; };\n"
      "template <> struct F<0> { static constexpr long value = 0; };\n"
      "double rigid::twice(double) { return double(F<800>::value); }\n",
      Refusal::compile_error, limits);
  CHECK(says(slow, "too long"));
  CHECK(slow.seconds < 60.0);
}

TEST_CASE("a program that would fill the disk is stopped") {
  CHECK(says(refused_text(std::string(right_twice) + "double huge[1 << 27] = {1.0};\n"), "too large"));
  CHECK(says(refused_text(std::string(right_twice) + "asm(\".data; .fill 3000000000, 1, 7\");\n"), "too large"));
}

TEST_CASE("a file and the own functions that it calls are compiled within one limit of time") {
  const fs::path directory = fresh_directory("slowly");
  Toolchain slow = toolchain();
  slow.compiler = stand_in_compiler(directory, "sh -c 'ulimit -t 1; while :; do :; done'");
  Submission calls =
      submit("double rigid::twice(double x) { return signed_by(1, x) * scaled(Matrix3d::Zero(), x)(0); }\n", "twice");
  calls.library = {submit("double rigid::signed_by(int n, double x) { return n * x + counted(n)(0); }\n", "signed_by"),
                   submit("Matrix3d rigid::scaled(const Matrix3d& A, double x) { return A * x; }\n", "scaled"),
                   submit("VectorXd rigid::counted(int n) { return VectorXd::Zero(n); }\n", "counted")};
  CompileLimits limits;
  limits.time = std::chrono::seconds(2);  // five times one second is more
  const Compilation compilation = compile({calls, "twice", signature("twice")}, slow, directory / "cache", limits);
  CHECK_FALSE(compilation.executable.has_value());
  CHECK(compilation.refusal == Refusal::compile_error);
  CHECK(says(compilation, "too long to compile"));
}

TEST_CASE("a full disk is not believed because the compiler's messages speak of it") {
  refused_text("#error No space left on device\n");
  CHECK(says(refused_text("#error out of memory\n"), "line 1"));
  CHECK(says(refused_text("#error File too large\n"), "line 1"));
}

TEST_CASE("the compiler's messages are cut where they become a flood") {
  CompileLimits limits;
  limits.output_bytes = 5000;
  CHECK(refused_text("#error " + std::string(100000, 'x') + "\n", Refusal::compile_error, limits).details.size() <=
        5100);
}

TEST_CASE("other files cannot be included, in any way, and nothing of them is shown") {
  const fs::path directory = fresh_directory("answers");
  const std::string answer = write(directory / "answer.cpp", right_twice).string();
  const std::string spaced = write(directory / "two words" / "answer.cpp", right_twice).string();
  const std::string secret = write(directory / "secret", "a_secret_word\n").string();
  CHECK(says(refused_text("#include \"" + answer + "\"\n"), answer));
  CHECK(says(refused_text("#include \"" + spaced + "\"\n"), spaced));
  CHECK(says(refused_text(std::string(right_twice) + "asm(\".incbin \\\"" + answer + "\\\"\");\n"), answer));
  refused_text("#include \"/proc/self/cwd/unit.cpp\"\n");
  for (const std::string& text :
       {"#include \"" + secret + "\"\n", std::string(right_twice) + "asm(\".include \\\"" + secret + "\\\"\");\n",
        "#include \"" + secret + "\"\nint x = y;\n", "#line 1 \"" + secret + "\"\nint rigid;\n"}) {
    CAPTURE(text);
    const Compilation compilation = refused_text(text);
    for (const Reason& finding : compilation.errors)
      CHECK((finding.sentence + finding.excerpt).find("secret_w") == std::string::npos);
    CHECK((compilation.details + compilation.message).find("secret_w") == std::string::npos);
  }
}

TEST_CASE("headers of the course, of Eigen and of the standard library can be included") {
  CHECK(compile_text(
            std::string("#include <fixture/contract.hpp>\n#include <rigid/vocabulary.hpp>\n#include <Eigen/Geometry>\n"
                        "#include <unsupported/Eigen/MatrixFunctions>\n#include <cmath>\n#include <deque>\n"
                        "#include <unistd.h>\n") +
            right_twice)
            .executable.has_value());
}

TEST_CASE("any file name will do") {
  const fs::path directory = fresh_directory("names");
  for (const std::string name : {"-o worker.cpp", "two words.cpp", "quote\".cpp", "back\\slash.cpp", "a=b.cpp",
                                 "semi;colon$(true).cpp", "unit.cpp", "Trägheit.cpp", "no-ending", "line\nbreak.cpp"}) {
    INFO(name);
    const Compilation good = compile_file(write(directory / name, right_twice));
    INFO(good.message << good.details);
    CHECK(good.executable.has_value());
  }
  const Compilation bad = compile_file(write(directory / "-x c \"q\".cpp", "\nint\n"));
  CHECK(bad.details.find("-x c \"q\".cpp:2:") != std::string::npos);
  CHECK(has(bad.details, "-x c \"q\".cpp:2:"));
}

TEST_CASE("line ends of other systems and byte order marks do not matter") {
  CHECK(compile_file(write(fresh_directory("encodings") / "dos.cpp",
                           "\xef\xbb\xbf// two lines\r\ndouble rigid::twice(double x) { return 2 * x; }\r\n"))
            .executable.has_value());
}

TEST_CASE("nothing of the checker's environment reaches the compiler") {
  ::setenv("CPLUS_INCLUDE_PATH", fresh_directory("environment").c_str(), 1);
  write(scratch() / "environment" / "only_here.hpp", "");
  refused_text("#include <only_here.hpp>\n");
  ::unsetenv("CPLUS_INCLUDE_PATH");
}

TEST_CASE("the precompiled prelude is used") {
  const fs::path file = write(fresh_directory("prelude") / "unit.cpp", "");
  const CompileLimits limits;
  const Compiler compiler(toolchain(), limits, file.parent_path());
  CHECK(compiler.run(compiler.arguments({"-H", "-fsyntax-only", "unit.cpp"}))
            .output.starts_with("! " + toolchain().prelude.string() + ".gch"));
}

TEST_CASE("a toolchain that cannot be used is a checker error, never the student's") {
  const fs::path directory = fresh_directory("bad-tools");
  const fs::path file = write(directory / "twice.cpp", right_twice);
  const auto trouble = [&](const Toolchain& tools, const std::string& named, const std::string& exercise = "twice") {
    const Compilation compilation = compile_file(file, {}, tools, directory / "cache", exercise);
    CHECK(compilation.refusal == Refusal::checker_error);
    CHECK(says(compilation, named));
    CHECK(refused(compilation).refusal == Refusal::checker_error);
    CHECK(refused(compilation).refusal_message == compilation.message);
  };
  Toolchain broken = toolchain();
  broken.compiler = "/nowhere/c++";
  trouble(broken, "/nowhere/c++");
  broken.compiler = write(directory / "compiler", "no program");
  trouble(broken, (directory / "compiler").string());
  broken = toolchain();
  broken.prelude = "/nowhere/prelude.hpp";
  trouble(broken, "/nowhere/prelude.hpp");
  trouble(toolchain(), "thrice", "thrice");
}

TEST_CASE("a tool of the compiler that is missing is no mistake in the file, but one that a file makes fail is") {
  CHECK(in_another_process([] {
    ::setenv("PATH", "/nowhere", 1);  // where the compiler looks for its assembler
    return compile_text(std::string(right_twice) + "// without tools\n").refusal == Refusal::checker_error;
  }));
  const fs::path directory = fresh_directory("failing-tools");
  const fs::path file = write(directory / "twice.cpp", right_twice);
  Toolchain tools = toolchain();
  const auto refusal_with = [&](const char* beginning) {
    tools.compiler = stand_in_compiler(directory, beginning);
    return compile_file(file, {}, tools, directory / "cache").refusal;
  };
  CHECK(refusal_with("case \"$*\" in *empty.cpp*) ;; *) echo internal compiler error; exit 1;; esac") ==
        Refusal::compile_error);
  CHECK(refusal_with("echo internal compiler error; exit 1") == Refusal::checker_error);
  const char* no_linker = "case \"$*\" in *' -c '*) ;; *) echo 'collect2: fatal error: cannot find ld'; exit 1;; esac";
  CHECK(refusal_with(no_linker) == Refusal::checker_error);
}

TEST_CASE("where the checker may not write, it says so") {
  const fs::path directory = fresh_directory("no-room");
  const Compilation compilation = compile_file(write(directory / "twice.cpp", right_twice), {}, toolchain(),
                                               write(directory / "file", "") / "cache");
  CHECK(compilation.refusal == Refusal::checker_error);
  CHECK(says(compilation, directory.string()));
}

TEST_CASE("where the disk is full, the checker says so and does not blame the student") {
  const auto is_our_fault_with = [&](rlim_t bytes, const char* text) {
    return in_another_process([&] {
      // A limit on the size of files stands for a disk without room: writing fails in the same way.
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit room{bytes, RLIM_INFINITY};
      ::setrlimit(RLIMIT_FSIZE, &room);
      const Compilation compilation =
          compile({submit(text, "twice"), "twice", signature("twice")}, toolchain(), fresh_directory("full"));
      return compilation.refusal == Refusal::checker_error && !compilation.executable;
    });
  };
  CHECK(is_our_fault_with(1 << 20, "int"));  // not enough for what the compiler makes
  CHECK(is_our_fault_with(2, "int"));        // not even for the copy of the file
}

TEST_CASE("a damaged toolchain file is a checker error that names the file") {
  const fs::path directory = fresh_directory("toolchain");
  const std::string whole = read(WORKBOOK_TEST_TOOLCHAIN);
  const fs::path file = directory / "toolchain.json";
  for (const std::string& text :
       {whole.substr(0, whole.size() / 2), std::string(), std::string("[]"), std::string("{}"),
        std::string("{\"format\": 1, \"compiler\": 7}"), std::string("{\"format\": 2}"), std::string("absent")}) {
    CAPTURE(text);
    if (text == "absent")
      fs::remove(file);
    else
      write(file, text);
    try {
      read_toolchain(file);
      FAIL_CHECK("no error");
    } catch (const ToolchainError& reason) {
      CHECK(std::string(reason.what()).find(file.string()) != std::string::npos);
    }
  }
}

}  // namespace workbook::testing
