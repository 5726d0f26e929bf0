// What a student's whole file tries: before main, in place of the worker's functions, in the compiler, the assembler
// and the linker. Each is compiled.
#include "tests/attacks/attack.hpp"

#include <doctest/doctest.h>

namespace workbook::testing {
namespace {

/// A reason may name a file that was asked for, and never tell what is in it, nor whether it is there.
void expect_silence(const Compilation& compilation) {
  if (!can_confine_files()) return;  // the tier minimal says so of itself
  std::string said = compilation.message + compilation.details + compilation.compiler_output;
  for (const Reason& finding : compilation.errors) said += finding.excerpt + finding.sentence;
  CHECK_MESSAGE(!has(said, "secret\n"), said);
}

}  // namespace

TEST_CASE("what a file tries before it runs, and in the compiler, gets it nothing") {
  CompileLimits limits;
  limits.memory_bytes = std::size_t{1} << 30;
  limits.file_bytes = std::size_t{16} << 20;
  limits.output_bytes = 16'000;
  restore_canary();
  for (const Attack& attack : read_attacks("of_a_file").attacks) {
    INFO(attack.kind << ": " << attack.what);
    const std::string text = filled_in(attack.code);
    const auto begun = std::chrono::steady_clock::now();
    limits.time = std::chrono::seconds(attack.works == takes_long ? 1 : 5);
    const Compilation compilation =
        compile({submit(text, "twice"), "twice", signature("twice")}, toolchain(), shared_cache(), limits);
    const bool is_run = compilation.executable.has_value();
    INFO(compilation.message << compilation.details);
    const bool is_for_compiler = attack.works == compiles || attack.works == shows_secret ||
                                 attack.works == takes_long || attack.works == says_much ||
                                 attack.works == says_99999999999;
    const std::chrono::seconds patience(attack.works == takes_long ? 1 : 60);
    const Unhindered control = is_run && !is_for_compiler ? run_unhindered(*compilation.executable, 7)
                                                          : compile_unhindered(text, "unit.cpp", patience);
    CHECK_MESSAGE(attack.works(control), "the control does not work: " << control.compiler.output.substr(0, 300)
                                                                       << control.value.value_or(-1));
    restore_canary();
    const ExerciseReference reference = reference_at(7);
    expect(attack, reference,
           is_run
               ? ExerciseRunner(*compilation.executable, short_limits()).observe(plan_calls(reference.cases), {2, 1, 0})
               : refused(compilation),
           begun);
    expect_silence(compilation);
  }
}

}  // namespace workbook::testing
