/// @file
/// Attacks as data: what a hostile file tries, what becomes of it, and what shows that it would work without walls.
#pragma once

#include "checker/judging/judge.hpp"
#include "tests/running/student.hpp"

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace workbook::testing {

/// What an attack does where nothing holds it back: the control.
struct Unhindered {
  FinishedProgram compiler;     ///< of the file, where the compiler is attacked
  std::string object;           ///< what it made
  std::string answer;           ///< the first bytes on the channel
  std::optional<double> value;  ///< in them, for somebody who compares no nonce
  std::string printed;
  ProcessEnd end;
  bool went_on = false;  ///< it neither answered nor ended
};

/// The evidence that it worked. By convention a function that got what it must not get returns 42.
using Evidence = bool (*)(const Unhindered&);
bool answers_42(const Unhindered& control);
bool prints_pass(const Unhindered& control);
bool goes_on(const Unhindered& control);
/// These of the compiler alone:
bool shows_secret(const Unhindered& control);      ///< in messages of the compiler, or in the object
bool compiles(const Unhindered& control);          ///< alone, as an ordinary compiler does it
bool takes_long(const Unhindered& control);        ///< or memory, or disk
bool says_much(const Unhindered& control);         ///< or what no pattern is through with
bool says_99999999999(const Unhindered& control);  ///< a number that is too large

struct Attack {
  std::string kind;
  std::string what;
  std::string code;  ///< CANARY stands for the path of a file with the word secret
  Verdict verdict = Verdict::forbidden_operation;
  Evidence works = answers_42;
};

/// A text of attacks; its head says how each is written, and may be code that stands before them.
struct AttackFile {
  std::string head;
  std::vector<Attack> attacks;
};

/// Would it act on a terminal or a page?
bool is_markup(const std::string& text);

/// in_a_call, of_a_file or shown: tests/attacks/NAME.txt.
AttackFile read_attacks(const std::string& name);

/// One function with all these attacks as its cases: the k-th at the number `number_of(k)`, or gently between it and
/// the next; right at all others.
std::string function_of(const AttackFile& file);
double number_of(std::size_t attack);

/// A file that no student's code or compiler may read or change, alone in its folder.
std::filesystem::path canary();
bool canary_is_unchanged();
/// After a control, which may have changed it. Waits for what the control left running.
void restore_canary();

/// With all that is written in capitals filled in.
std::string filled_in(std::string code);

/// Runs a worker without any sandbox, and kills it when it has answered, or has not for a while.
Unhindered run_unhindered(const std::filesystem::path& program, double x, bool will_go_on = false);

/// The compiler as anybody would start it.
FinishedProgram compiler_unhindered(const std::vector<std::string>& arguments, const std::filesystem::path& directory,
                                    std::chrono::seconds limit = std::chrono::seconds(60));

/// Compiles a file in this way. @param name  of the file
Unhindered compile_unhindered(const std::string& text, const std::string& name = "unit.cpp",
                              std::chrono::seconds limit = std::chrono::seconds(60));

/// What compiles `twice`, at 1, x and 2.
ExerciseReference reference_at(double x);

/// Asserts what holds after every attack: verdict, score, canary, nothing left running, not more than that time.
void expect(const Attack& attack, const ExerciseReference& reference, const Observation& observation,
            std::chrono::steady_clock::time_point begun);

}  // namespace workbook::testing
