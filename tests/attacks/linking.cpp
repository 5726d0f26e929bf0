// The linker, attacked with a file in the compiler's own language, written as the text of an assembler file.
#include "tests/attacks/attack.hpp"

#include <doctest/doctest.h>

namespace workbook::testing {
namespace {

namespace fs = std::filesystem;

/// The text of an assembler file as a string of C++.
std::string as_asm(const std::string& text) { return "asm(R\"~~(" + text + ")~~\");\n"; }

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
  const FinishedProgram linked = compiler_unhindered(arguments, object.parent_path());
  INFO(linked.output);
  REQUIRE(linked.succeeded());
  return program;
}

}  // namespace

TEST_CASE("code generated at the link reaches no file, for there is none") {
  const fs::path directory = fresh_directory("link_time");
  const fs::path secret = write(directory / "secret", "*");  // 42
  // A file is compiled into the compiler's own intermediate language; the text of that is the attack.
  write(directory / "inner.cpp",
        "#include <fixture/contract.hpp>\nextern \"C\" const char secret[];\n"
        "asm(\".pushsection .rodata\\n.globl secret\\nsecret: .incbin \\\"" +
            secret.string() +
            "\\\"\\n.popsection\\n\");\n"
            "double rigid::twice(double) { return secret[0]; }\n");
  REQUIRE(compiler_unhindered(with_flags({"-flto", "-S", "inner.cpp", "-o", "inner.s"}), directory).succeeded());
  const std::string attack = as_asm(read(directory / "inner.s"));

  write(directory / "attack.cpp", attack);
  REQUIRE(compiler_unhindered(with_flags({"-c", "attack.cpp", "-o", "attack.o"}), directory).succeeded());
  ExerciseRunner deceived(linked_as_before(directory / "attack.o"), short_limits());
  CHECK(deceived.observe(plan_calls({twice_case(1)}), {}).replies.at(0).value.numbers.at(0) == 42.0);  // the control

  const Compilation refused = compile_text(attack);
  CHECK(refused.refusal == Refusal::compile_error);
  CHECK_FALSE(refused.executable.has_value());
  // Each of the other cures is enough by itself.
  std::vector<std::string> arguments = {"attack.o", toolchain().worker_object("twice").string(), "-fno-lto", "-o", "p"};
  CHECK_FALSE(compiler_unhindered(arguments, directory).succeeded());
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

}  // namespace workbook::testing
