// From a file to an executable, and all that can stand in a file instead of a right function.
#include "tests/running/student.hpp"

#include "checker/base/child_process.hpp"
#include "checker/compile/plain_words.hpp"

#include <doctest/doctest.h>

#include <signal.h>
#include <sys/resource.h>

#include <fstream>

namespace workbook::testing {
namespace fs = std::filesystem;
namespace {

const char* const right = "double rigid::twice(double x) { return 2 * x; }\n";

/// Compiles a text that cannot be compiled.
Compilation refused_text(const std::string& text, Refusal refusal) {
  Compilation compilation = compile_text(text);
  CHECK_FALSE(compilation.executable.has_value());
  CHECK(compilation.refusal == refusal);
  CHECK(nothing_left_running());
  return compilation;
}

std::string compile_error(const std::string& text) { return refused_text(text, Refusal::compile_error).message; }

std::string missing_function(const std::string& text) { return refused_text(text, Refusal::missing_function).message; }

CompileTask twice_in(const fs::path& file) { return {file, "twice", "double twice(double x)"}; }

}  // namespace

TEST_CASE("the first error is said with its line in the student's file, and shown with it") {
  const Compilation compilation =
      refused_text("// a comment\ndouble rigid::twice(double x) {\n  return 2 * y;\n}\n", Refusal::compile_error);
  CHECK(compilation.message == "Your file does not compile: the first error is in line 3.");
  REQUIRE(compilation.findings.size() == 1);
  CHECK(compilation.findings[0].line == 3);
  CHECK(compilation.findings[0].excerpt == "  return 2 * y;\n             ^");
  CHECK(compilation.findings[0].sentence ==
        "`y` is not known here: is it spelt as where it was declared, and was that before this line?");
  CHECK(compilation.details.find("twice.cpp:3:14: error:") != std::string::npos);
  CHECK(compilation.details.find("return 2 * y;") != std::string::npos);
  CHECK(compilation.details.find("unit.cpp") == std::string::npos);
}

TEST_CASE("a file without the function says what it defines instead") {
  CHECK(missing_function("") ==
        "Your file does not define `rigid::twice(double)`; it defines no function that can be called "
        "from outside.");
  CHECK(missing_function("double twice(double x) { return 2 * x; }") ==
        "Your file does not define `rigid::twice(double)`; it defines `twice(double)` outside the namespace rigid.");
  CHECK(missing_function("namespace rigid { double twice(const Vector3d& x) { return x[0]; } }") ==
        "Your file does not define `rigid::twice(double)`; it defines `rigid::twice(const Vector3d&)`, whose "
        "parameters differ.");
  CHECK(missing_function("namespace rigid { inline double twice(double x) { return 2 * x; } }") ==
        "Your file does not define `rigid::twice(double)` for others: it is there, but marked inline or as a template; "
        "leave that out.");
  CHECK(missing_function("namespace rigid { namespace { double twice(double x) { return 2 * x; } } }") ==
        "Your file does not define `rigid::twice(double)`; it defines no function that can be called from outside.");
  CHECK(missing_function("namespace rigid { double double_of(double x) { return 2 * x; } }") ==
        "Your file does not define `rigid::twice(double)`; it defines `rigid::double_of(double)`.");
}

TEST_CASE("a file that calls another exercise is told that it is compiled alone") {
  CHECK(compile_error("double rigid::twice(double x) { return signed_by(1, x) + signed_by(1, x); }") ==
        "Your file calls `rigid::signed_by`, which it does not define; each file is compiled alone, so write what you "
        "need "
        "into this one.");
}

TEST_CASE("a file may define helpers of its own") {
  CHECK(compile_text("namespace { double half(double x) { return x / 2; } }\n"
                     "double rigid::twice(double x) { return 4 * half(x); }")
            .executable.has_value());
}

TEST_CASE("a file with main is told to leave it out") {
  CHECK(compile_error(std::string(right) + "int main() {}") ==
        "Your file defines main(); leave it out, the checker calls your function itself.");
}

TEST_CASE("what cannot be linked for another reason is a compile error") {
  CHECK(compile_error("void elsewhere();\ndouble rigid::twice(double x) { elsewhere(); return 2 * x; }") ==
        "Your file compiles, but cannot be linked into a program; see the linker's message.");
}

TEST_CASE("templates and includes without end are stopped") {
  CHECK(compile_error("template <int n> struct Deep { static constexpr int value = Deep<n + 1>::value; };\n"
                      "double rigid::twice(double) { return Deep<0>::value; }")
            .starts_with("Your file does not compile: the first error is in line "));
  CHECK(compile_error("#include \"twice.cpp\"\n")
            .starts_with("Your file does not compile: the first error is in line 1."));

  const fs::path file = write(fresh_directory("endless") / "zero.cpp", "#include \"/dev/zero\"\n");
  CompileLimits limits;
  limits.memory_bytes = std::size_t{600} << 20;
  const Compilation compilation = compile(twice_in(file), toolchain(), shared_cache(), limits);
  CHECK(compilation.refusal == Refusal::compile_error);
  CHECK(compilation.message ==
        "Compiling your file takes too much memory; look for a template or an #include that never ends.");
  CHECK(nothing_left_running());
}

TEST_CASE("a compilation that takes too long is stopped with all its processes") {
  const fs::path file =
      write(fresh_directory("slow") / "slow.cpp",
            "constexpr long f(long n) { long sum = 0; for (long i = 0; i < 200000; ++i) sum += i % n; return sum; }\n"
            "template <long n> struct F { static constexpr long value = f(n) + F<n - 1>::value; };\n"
            "template <> struct F<0> { static constexpr long value = 0; };\n"
            "double rigid::twice(double) { return double(F<800>::value); }\n");
  CompileLimits limits;
  limits.time = std::chrono::milliseconds(500);
  const Compilation compilation = compile(twice_in(file), toolchain(), shared_cache(), limits);
  CHECK(compilation.refusal == Refusal::compile_error);
  CHECK(compilation.message ==
        "Your file takes too long to compile; look for a template or an #include that never ends.");
  CHECK(compilation.seconds < 10.0);
  CHECK(nothing_left_running());
}

TEST_CASE("a program that would fill the disk is stopped") {
  const std::string sentence = "Your file makes a program that is too large; look for a huge array.";
  CHECK(compile_error(std::string(right) + "double huge[1 << 27] = {1.0};\n") == sentence);
  CHECK(compile_error(std::string(right) + "asm(\".data; .fill 3000000000, 1, 7\");\n") == sentence);
}

TEST_CASE("a full disk is not believed because the compiler's messages speak of it") {
  CHECK(compile_error("#error No space left on device\n") ==
        "Your file does not compile: the first error is in line 1.");
}

TEST_CASE("the compiler's messages are cut where they become a flood") {
  const fs::path file = write(fresh_directory("chatty") / "chatty.cpp", "#error " + std::string(100000, 'x') + "\n");
  CompileLimits limits;
  limits.output_bytes = 5000;
  const Compilation compilation = compile(twice_in(file), toolchain(), shared_cache(), limits);
  CHECK(compilation.refusal == Refusal::compile_error);
  CHECK(compilation.details.size() <= 5000);
  CHECK(compilation.message.starts_with("Your file does not compile"));
}

TEST_CASE("other files cannot be included, in any way") {
  const fs::path directory = fresh_directory("answers");
  const std::string answer = write(directory / "answer.cpp", right).string();
  write(directory / "two words" / "answer.cpp", right);
  const auto told = [](const std::string& name) {
    return "Your file includes " + name +
           ", but it is compiled alone: include only headers of the course, of Eigen and of the standard library.";
  };
  CHECK(compile_error("#include \"" + answer + "\"\n") == told(answer));
  CHECK(compile_error("#include \"" + (directory / "two words" / "answer.cpp").string() + "\"\n") ==
        told((directory / "two words" / "answer.cpp").string()));
  CHECK(compile_error(std::string(right) + "asm(\".incbin \\\"" + answer + "\\\"\");\n") == told(answer));
  CHECK(compile_error("#include \"/proc/self/cwd/twice.cpp\"\n").find("Your file") == 0);
}

TEST_CASE("headers of the course, of Eigen and of the standard library can be included") {
  CHECK(compile_text(
            std::string("#include <fixture/contract.hpp>\n#include <rigid/vocabulary.hpp>\n#include <Eigen/Geometry>\n"
                        "#include <unsupported/Eigen/MatrixFunctions>\n#include <cmath>\n#include <deque>\n"
                        "#include <unistd.h>\n") +
            right)
            .executable.has_value());
}

TEST_CASE("any file name will do") {
  const fs::path directory = fresh_directory("names");
  for (const std::string name : {"-o worker.cpp", "two words.cpp", "quote\".cpp", "back\\slash.cpp",
                                 "semi;colon$(true).cpp", "unit.cpp", "Trägheit.cpp", "no-ending", "line\nbreak.cpp"}) {
    INFO(name);
    const Compilation good = compile(twice_in(write(directory / name, right)), toolchain(), shared_cache());
    INFO(good.message << good.details);
    CHECK(good.executable.has_value());
  }
  const Compilation bad =
      compile(twice_in(write(directory / "-x c \"q\".cpp", "\nint\n")), toolchain(), shared_cache());
  CHECK(bad.details.find("-x c \"q\".cpp:2:") != std::string::npos);
  CHECK(bad.message.starts_with("Your file does not compile: the first error is in line "));
}

TEST_CASE("line ends of other systems and byte order marks do not matter") {
  const fs::path directory = fresh_directory("encodings");
  const fs::path dos =
      write(directory / "dos.cpp", "\xef\xbb\xbf// two lines\r\ndouble rigid::twice(double x) { return 2 * x; }\r\n");
  CHECK(compile(twice_in(dos), toolchain(), shared_cache()).executable.has_value());
}

TEST_CASE("nothing of the checker's environment reaches the compiler") {
  ::setenv("CPLUS_INCLUDE_PATH", fresh_directory("environment").c_str(), 1);
  write(fs::path(WORKBOOK_TEST_SCRATCH) / "environment" / "only_here.hpp", "");
  CHECK(compile_error("#include <only_here.hpp>\n") == "Your file does not compile: the first error is in line 1.");
  ::unsetenv("CPLUS_INCLUDE_PATH");
}

TEST_CASE("the precompiled prelude is used") {
  const fs::path file = write(fresh_directory("prelude") / "empty.cpp", "");
  const std::string compiler = toolchain().compiler.string();
  Launch launch;
  launch.program = compiler.c_str();
  launch.arguments = toolchain().flags;
  launch.arguments.insert(launch.arguments.end(),
                          {"-H", "-include", toolchain().prelude.string(), "-fsyntax-only", file.string()});
  launch.environment = {"PATH=/usr/bin:/bin"};
  CHECK(run_program(launch, std::chrono::seconds(60), 1 << 20)
            .output.starts_with("! " + toolchain().prelude.string() + ".gch"));
}

TEST_CASE("signatures are told in the words of the contracts") {
  CHECK(in_contract_words("rigid::f(Eigen::Matrix<double, 3, 3, 0, 3, 3> const&, double)") ==
        "rigid::f(const Matrix3d&, double)");
  CHECK(in_contract_words(
            "f(std::vector<Eigen::Matrix<double, 3, 3, 0, 3, 3>, std::allocator<Eigen::Matrix<double, 3, 3, 0, 3, "
            "3> > > const&, Eigen::Matrix<double, 3, -1, 0, 3, -1> const&)") ==
        "f(const std::vector<Matrix3d>&, const Matrix3Xd&)");
}

TEST_CASE("a compiler that is missing is a checker error, never the student's") {
  Toolchain broken = toolchain();
  broken.compiler = "/nowhere/c++";
  const fs::path file = write(fresh_directory("no-compiler") / "twice.cpp", right);
  const Compilation compilation = compile(twice_in(file), broken, shared_cache());
  CHECK(compilation.refusal == Refusal::checker_error);
  CHECK(compilation.message == "The compiler /nowhere/c++ is missing; build the workbook again.");
  CHECK(refused(compilation).refusal == Refusal::checker_error);
  CHECK(refused(compilation).refusal_message == compilation.message);
}

TEST_CASE("a compiler that cannot be started is a checker error") {
  Toolchain broken = toolchain();
  const fs::path directory = fresh_directory("bad-compiler");
  broken.compiler = write(directory / "compiler", "no program");
  const Compilation compilation = compile(twice_in(write(directory / "twice.cpp", right)), broken, shared_cache());
  CHECK(compilation.refusal == Refusal::checker_error);
  CHECK(compilation.message.find("cannot be used (start the program: ") != std::string::npos);
}

TEST_CASE("an exercise without a worker is a checker error") {
  const fs::path file = write(fresh_directory("no-worker") / "thrice.cpp", right);
  const Compilation compilation = compile({file, "thrice", "double thrice(double x)"}, toolchain(), shared_cache());
  CHECK(compilation.refusal == Refusal::checker_error);
  CHECK(compilation.message.starts_with("The worker "));
  CHECK(compilation.message.ends_with("thrice.o is missing; build the workbook again."));
}

TEST_CASE("where the checker may not write, it says so") {
  const fs::path directory = fresh_directory("no-room");
  const fs::path in_the_way = write(directory / "file", "");
  const Compilation compilation =
      compile(twice_in(write(directory / "twice.cpp", right)), toolchain(), in_the_way / "cache");
  CHECK(compilation.refusal == Refusal::checker_error);
  CHECK(compilation.message.starts_with("The checker cannot write to "));
  CHECK(compilation.message.ends_with("; this is not your mistake."));
}

TEST_CASE("where the disk is full, the checker says so and does not blame the student") {
  const fs::path file = write(fresh_directory("full-disk") / "twice.cpp", "int");
  const auto compiled_with_room_for = [&](rlim_t bytes) {
    return in_another_process([&] {
      // A limit on the size of files stands for a disk without room: writing fails in the same way.
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit room{bytes, RLIM_INFINITY};
      ::setrlimit(RLIMIT_FSIZE, &room);
      const Compilation compilation = compile(twice_in(file), toolchain(), shared_cache());
      return compilation.refusal == Refusal::checker_error &&
             compilation.message.find("(is the disk full?); this is not your mistake.") != std::string::npos;
    });
  };
  CHECK(compiled_with_room_for(1 << 20));  // not enough for what the compiler makes
  CHECK(compiled_with_room_for(2));        // not even for the copy of the file
}

TEST_CASE("a damaged toolchain file is a checker error with file and reason") {
  const fs::path directory = fresh_directory("toolchain");
  const auto error = [](const fs::path& file) -> std::string {
    try {
      read_toolchain(file);
    } catch (const ToolchainError& reason) {
      return reason.what();
    }
    return "no error";
  };
  const fs::path absent = directory / "absent.json";
  CHECK(error(absent) == "The toolchain file " + absent.string() + " cannot be read; build the workbook again.");
  std::ifstream stream(WORKBOOK_TEST_TOOLCHAIN);
  const std::string whole((std::istreambuf_iterator<char>(stream)), {});
  const fs::path half = write(directory / "half.json", whole.substr(0, whole.size() / 2));
  CHECK(error(half).starts_with("The toolchain file " + half.string() + " is damaged ("));
  CHECK(error(write(directory / "empty.json", "")).find("is damaged") != std::string::npos);
  CHECK(error(write(directory / "list.json", "[]")).find("is damaged") != std::string::npos);
  CHECK(error(write(directory / "poor.json", "{\"format\": 1}")).find("is damaged") != std::string::npos);
  CHECK(error(write(directory / "type.json", "{\"format\": 1, \"compiler\": 7}")).find("is damaged") !=
        std::string::npos);
  CHECK(error(write(directory / "new.json", "{\"format\": 2}")).find("has another format than this checker") !=
        std::string::npos);
}

}  // namespace workbook::testing
