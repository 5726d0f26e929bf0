#include "checker/messages/judging.hpp"

#include "checker/base/superscript.hpp"
#include "checker/judging/value_text.hpp"
#include "checker/messages/program.hpp"
#include "checker/messages/running.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

namespace workbook::messages {

namespace {

std::string at(const Case& one) { return fmt::format("at the case “{}”", one.name); }

/// A student's text inside a sentence: on one line, and not for ever.
std::string quoted(std::string text) {
  constexpr std::size_t longest = 300;
  for (char& character : text) {
    if (static_cast<unsigned char>(character) < 0x20) character = ' ';
  }
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not inside a character
  return text.substr(0, end) + " …";
}

std::string plural(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// The shape in the words of the kind.
std::string shape(Kind kind, const Value& value) {
  const auto rows = static_cast<std::size_t>(std::max(value.rows, 0));
  const auto cols = static_cast<std::size_t>(std::max(value.cols, 0));
  if (kind == Kind::vector && value.cols == 1) return plural(rows, "component");
  if (kind == Kind::points && value.rows == 3) return plural(cols, "column");
  if (kind == Kind::matrices && value.rows == 3 && value.cols % 3 == 0) {
    return cols == 3 ? "1 matrix" : fmt::format("{} matrices", cols / 3);
  }
  return fmt::format("the shape {}×{}", value.rows, value.cols);
}

std::string unit_change(char base) {
  switch (base) {
    case 'k':
      return "with masses in g";
    case 'm':
      return "with lengths in cm";
    default:
      return "with times in ms";
  }
}

std::string result_or_component(const std::string& owner, std::optional<std::size_t> component) {
  return component ? fmt::format("component {} of {} result", *component, owner) : owner + " result";
}

std::string growth(double decades) {
  const double size = std::abs(decades);
  const double whole = std::round(size);
  return size == whole ? "10" + superscript(static_cast<int>(whole)) : number_text(std::pow(10, size), 3);
}

std::string should_grow(double decades) {
  if (decades == 0) return "should not change";
  return fmt::format("should {} {} times", decades > 0 ? "grow" : "shrink", growth(decades));
}

std::string grows(double decades) {
  if (decades == 0) return "does not change";
  return fmt::format("{} {} times", decades > 0 ? "grows" : "shrinks", growth(decades));
}

std::string without_full_stop(const std::string& sentence) {
  return sentence.ends_with('.') ? sentence.substr(0, sentence.size() - 1) : sentence;
}

std::string capitalized(std::string sentence) {
  if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z')
    sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
  return sentence;
}

/// `when` is where in the run it happened: "at the case …".
Advice ended_without_value(const std::string& when, const Reply& reply, const std::string& signature) {
  switch (reply.ending) {
    case Ending::not_started:
      return {fmt::format("The function still reports that it is not started {}, but not everywhere.", when),
              "Remove what is left of the TODO, so that every way through the function returns a result."};
    case Ending::exception:
      return {fmt::format("The function threw an exception {}: {}", when,
                          reply.text.empty() ? "it says nothing more." : quoted(reply.text)),
              "Check the indices and sizes that the message names, and print the inputs of this case if in doubt."};
    case Ending::wrong_shape:
      return {fmt::format("The result has the wrong shape {}.", when),
              "Read in the header which shape is asked for: " + signature + "."};
    case Ending::crashed:
      return {fmt::format("The function crashed {}: {}.", when, without_full_stop(crash(reply.signal, reply.text))),
              after_crash(reply.signal, reply.text)};
    case Ending::stopped_early:
      return {fmt::format("The program ended {} before the function returned, with exit status {}.", when,
                          reply.exit_status),
              "Remove calls such as exit or abort: a function hands its result back with return."};
    case Ending::time_limit:
      return {fmt::format("The function did not return in time {}.", when),
              "Look for a loop that never ends, or for a step that is far too small."};
    case Ending::memory_limit:
      return {fmt::format("The function asked for more memory than an exercise may use {}.", when),
              "Look for a size computed from the wrong number, or for a list that grows in every step."};
    case Ending::output_limit:
      return {fmt::format("The function printed more than the checker reads {}.", when),
              "Remove the printing, or keep it out of the loop."};
    case Ending::forbidden_operation:
      return {fmt::format("The function tried something that no exercise needs {}{}.", when,
                          reply.text.empty() ? "" : ": " + without_full_stop(quoted(reply.text))),
              "Compute the result from the arguments alone: no files, no network, no other programs."};
    case Ending::protocol_violation:
      return {fmt::format("Something other than the function answered {}{}.", when,
                          reply.text.empty() ? "" : ": " + without_full_stop(quoted(reply.text))),
              "Let the file hold the function and its helpers only, and let it return its result."};
    case Ending::not_run:
      return {
          fmt::format("The time for this exercise was used up before the function could be run {}.", when),
          "Make the function faster: look for steps that are far too small, or for work that is done again and again."};
    case Ending::returned:
      break;
  }
  return {};
}

}  // namespace

Advice passed(std::size_t cases) {
  return {cases == 1 ? "The one case agrees with the reference."
                     : fmt::format("All {} cases agree with the reference.", cases),
          "Go on to the next exercise, or read in the notes what to try next."};
}

Advice refused(Refusal refusal, const std::string& message, const std::string& signature) {
  const auto message_or = [&](const std::string& usual) { return message.empty() ? usual : message; };
  switch (refusal) {
    case Refusal::rejected_file:
      return {message_or("The file cannot be taken as an exercise."),
              "Check that it is the right file, plain C++ text and not empty."};
    case Refusal::compile_error:
      return {message_or("The file does not compile."),
              "Mend the first error that the compiler shows; the later ones often follow from it."};
    case Refusal::missing_function:
      return {message_or("The file compiles, but the function of the exercise is not in it."),
              "Keep name and parameters as the header declares them, in namespace rigid: " + signature + "."};
    case Refusal::checker_error:
      break;
  }
  return {message_or("Something went wrong in the checker."),
          fmt::format("This is not your fault and costs no points: run `{}`, and tell your instructor if it stays.",
                      command("doctor"))};
}

Advice no_cases(const std::string& exercise) {
  return refused(Refusal::checker_error, fmt::format("The reference results hold no cases for {}.", exercise), "");
}

Advice repeat_of_no_case() { return refused(Refusal::checker_error, "A case was repeated that does not exist.", ""); }

Advice not_started() {
  return {"You have not started this exercise: the TODO is still there.",
          "Open the file, replace the TODO by your formula, and check again."};
}

Advice no_value(const ExerciseReference& exercise, const Case& one, const Reply& reply) {
  if (reply.ending == Ending::wrong_shape) return wrong_shape(one, exercise.result_kind, reply.value);
  return ended_without_value(at(one), reply, exercise.signature);
}

Advice no_value_when_repeated(const ExerciseReference& exercise, const Case& one, const Reply& reply) {
  return ended_without_value(fmt::format("when the case “{}” was run once more", one.name), reply, exercise.signature);
}

Advice missing_reply(const Case& one) {
  return {fmt::format("No reply came back {}.", at(one)),
          "Check that the function returns at every input and does not end the program."};
}

Advice surplus_replies(std::size_t replies, std::size_t cases) {
  return {fmt::format("There were {} replies to {} calls.", replies, cases),
          "Let the file hold the function and its helpers only, and let it return its result."};
}

Advice damaged_value(const Case& one) {
  return {fmt::format("The reply {} does not hold as many numbers as its shape says.", at(one)),
          "Let the file hold the function and its helpers only, and let it return its result."};
}

Advice wrong_shape(const Case& one, Kind kind, const Value& actual) {
  return {fmt::format("The result has {} {}, expected {}.", shape(kind, actual), at(one), shape(kind, one.expected)),
          "Give the result its size from the sizes of the arguments before you fill it."};
}

Advice non_finite(const Case& one, Kind kind, const Value& actual) {
  const auto found = std::ranges::find_if(actual.numbers, [](double number) { return !std::isfinite(number); });
  const std::string entry = entry_name(actual, kind, static_cast<std::size_t>(found - actual.numbers.begin()));
  return {
      fmt::format("{} is {} {}.", capitalized(entry), std::isnan(*found) ? "not a number (NaN)" : "infinite", at(one)),
      "Look for a division by zero, the root of a negative number, an acos beyond 1, or an entry that is never set."};
}

Advice wrong_value(const Case& one, std::size_t cases_passed, std::size_t cases_total, bool is_diagnosed) {
  return {fmt::format("The value is wrong at {} of {}, first {}.", cases_total - cases_passed,
                      plural(cases_total, "case"), at(one)),
          is_diagnosed ? "Mend what the diagnosis names, and check again."
                       : "Compare your value with the expected one entry by entry, and work this case out by hand."};
}

Advice inconsistent(const Case& one, Kind kind, const Value& first, const Value& again) {
  const auto differs = [](double one_number, double other) {
    return std::isfinite(one_number) || std::isfinite(other) ? one_number != other : false;
  };
  const auto found = std::ranges::mismatch(first.numbers, again.numbers, std::not_fn(differs));
  const auto n = static_cast<std::size_t>(found.in1 - first.numbers.begin());
  const auto [once, later] = distinct_texts(first.numbers[n], again.numbers[n], 6);
  return {fmt::format("The same input gave two results {}: {} was {} at first and {} when run again.", at(one),
                      entry_name(first, kind, n), once, later),
          "Let the result depend on the arguments alone: look for static variables, random numbers, the clock, or "
          "variables that are never set."};
}

std::string wrong_coefficients(const std::vector<WrongCoefficient>& wrong) {
  constexpr std::size_t most = 2;
  std::string text;
  for (std::size_t k = 0; k < std::min(wrong.size(), most); ++k) {
    std::string actual = coefficient_text(wrong[k].actual);
    std::string expected = coefficient_text(wrong[k].expected);
    if (actual == expected) std::tie(actual, expected) = distinct_texts(wrong[k].actual, wrong[k].expected, 4);
    text += k == 0 ? "The term " : ", and the term ";
    text += wrong[k].term;
    text += actual == "0" ? " is missing" : fmt::format(" enters with {}, expected {}", actual, expected);
  }
  const std::size_t others = wrong.size() - std::min(wrong.size(), most);
  if (others > 0) text += fmt::format("; {} more {} off", others, others == 1 ? "is" : "are");
  return text + ".";
}

std::string common_factor(double factor) {
  const std::string text = coefficient_text(factor);
  if (text == "0") return "Your result is zero everywhere, also where the expected one is not.";
  if (text == "−1")
    return "Your result is the negative of the expected one at every case: a sign is lost or one too many.";
  if (text == "1/2") return "Your result is half of the expected one at every case.";
  return fmt::format("Your result is {} times the expected one at every case.", text);
}

std::string degrees_for_radians() { return "Your result is in degrees; angles here are in radians."; }

std::string radians_taken_for_degrees() {
  return "Your result is converted from degrees to radians once too often: it is π/180 times the expected one.";
}

std::string transposed() { return "Your matrix is the transpose of the expected one: rows and columns are exchanged."; }

std::string reversed_components() { return "Your components are the expected ones in reverse order."; }

std::string permuted_components(const std::vector<int>& order) {
  std::vector<int> from_one = order;
  for (int& component : from_one) ++component;
  return fmt::format("Your components are the expected ones in another order: {}.", fmt::join(from_one, ", "));
}

std::string broken_property(const std::string& property, const std::string& detail, const std::string& case_name) {
  return fmt::format("{}; with yours, {} (case “{}”).", capitalized(without_full_stop(property)), detail, case_name);
}

std::string wrong_power(char base, double expected_decades, double actual_decades,
                        std::optional<std::size_t> component) {
  return capitalized(fmt::format("{} {} {}, yours {}.", unit_change(base), result_or_component("the", component),
                                 should_grow(expected_decades), grows(actual_decades)));
}

std::string no_single_power(char base, std::optional<std::size_t> component) {
  return capitalized(fmt::format(
      "{} {} grows by no single power of ten: quantities of different dimension are being added, or a number "
      "in the formula hides a unit.",
      unit_change(base), result_or_component("your", component)));
}

std::string error_size(double relative, double tolerance) {
  if (!std::isfinite(relative)) return "The error has no size: a number is missing or infinite.";
  if (relative >= 10)
    return fmt::format("The error is {:.0f} times the size of the result: look for a wrong power or unit.", relative);
  if (relative >= 1.5)
    return fmt::format("The error is {:.2g} times the size of the result: not rounding, but another formula.",
                       relative);
  if (relative >= 0.01)
    return fmt::format("The error is {:.0f} % of the size of the result: not rounding, but another formula.",
                       100 * relative);
  const std::string one_part =
      fmt::format("1 part in 10{}", superscript(static_cast<int>(std::lround(-std::log10(relative)))));
  if (relative >= 1e-6) {
    return fmt::format(
        "The error is about {} of the size of the result: too large for rounding, so look for an approximation.",
        one_part);
  }
  const double excess = relative / tolerance;
  return fmt::format(
      "The error is about {} of the size of the result, {} times what is allowed: digits are lost, as with float or "
      "3.14159.",
      one_part, excess < 10 ? fmt::format("{:.2g}", excess) : fmt::format("{:.0f}", excess));
}

}  // namespace workbook::messages
