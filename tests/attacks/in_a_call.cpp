// What a student's function tries while it runs: all attacks are cases of one function, in one executable. Each is
// called between two inputs at which the function is right.
#include "tests/attacks/attack.hpp"

#include <doctest/doctest.h>

#include <map>

namespace workbook::testing {

TEST_CASE("what a function tries while it runs gets it no answer, and nothing else") {
  restore_canary();
  const AttackFile file = read_attacks("in_a_call");
  const std::filesystem::path program = executable(function_of(file));
  RunLimits limits = short_limits();
  std::map<std::string, int> of_kind;
  for (std::size_t k = 0; k < file.attacks.size(); ++k) {
    const Attack& attack = file.attacks[k];
    INFO(attack.kind << ": " << attack.what);
    ++of_kind[attack.kind];
    const double x = number_of(k);
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
