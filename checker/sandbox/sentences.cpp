#include "checker/sandbox/sentences.hpp"

#include "checker/base/printable.hpp"
#include "checker/messages/running.hpp"
#include "checker/sandbox/sandbox.hpp"

#include <signal.h>

#include <algorithm>
#include <regex>
#include <set>

namespace workbook {
namespace {

using messages::NonFinite;
using sightings::Arithmetic;
using sightings::Sighting;
using sightings::What;

std::vector<CallPlace> chain_of(const Sighting& sighting, const CallPlaces& places) {
  std::vector<CallPlace> chain;
  for (int n = 0; n < sighting.call_count; ++n)
    if (const auto found = places.find(sighting.calls[n]); found != places.end())
      chain.insert(chain.end(), found->second.begin(), found->second.end());
  return chain;
}

std::vector<long> facts_of(const Sighting& sighting) { return {sighting.facts, sighting.facts + sighting.fact_count}; }

/// The calls inside the innermost one of the student's file.
std::vector<std::string> functions_inside(const Sighting& sighting, const CallPlaces& places) {
  std::vector<std::string> functions;
  for (const CallPlace& place : chain_of(sighting, places)) {
    if (place.line > 0) break;
    functions.push_back(place.function);
  }
  return functions;
}

bool is_called(const std::vector<std::string>& functions, const std::string& name) {
  return std::ranges::find(functions, name) != functions.end();
}

/// "acos" for the C library's "__ieee754_acos_fma", "powf64" and their like; "" for others.
std::string plain_name(const std::string& function) {
  static const std::regex inner(
      "_*(?:ieee754_|w_|kernel_)?([a-z]+?(?:2|10)?)(?:f|f32x?|f64x?)?(?:_fma4?|_sse2|_avx2?|_finite|_compat|_r)*");
  std::smatch found;
  return std::regex_match(function, found, inner) ? found[1].str() : "";
}

/// The functions of the C library that the line calls, by their names.
std::set<std::string> functions_named_in(const std::string& line) {
  static const std::regex call("([a-z]+[0-9]*)\\s*\\(");
  std::set<std::string> names;
  for (auto found = std::sregex_iterator(line.begin(), line.end(), call); found != std::sregex_iterator(); ++found)
    if (messages::has_domain((*found)[1])) names.insert((*found)[1]);
  return names;
}

/// The function of <cmath> at work, "" if it is one but nobody knows which; nothing if it is none.
std::optional<std::string> function_of_c(const std::vector<std::string>& inside, const std::string& line) {
  // What is written in C++ has parentheses in its demangled name.
  const bool is_c = !inside.empty() && inside.front().find('(') == std::string::npos;
  if (!is_c) return std::nullopt;
  for (const std::string& function : inside)
    if (const std::string name = plain_name(function); messages::has_domain(name)) return name;
  // Some leave the last step to a function that they share, and are gone by then.
  const std::set<std::string> named = functions_named_in(line);
  return named.size() == 1 ? *named.begin() : "";
}

std::string floating_point(const Sighting& sighting, const std::vector<std::string>& inside, const std::string& line) {
  if (const auto function = function_of_c(inside, line))
    return messages::non_finite(NonFinite::from_function, *function);
  switch (sighting.detail) {
    case FPE_FLTDIV:
      return messages::non_finite(NonFinite::division_by_zero);
    case FPE_FLTOVF:
      return messages::non_finite(NonFinite::too_large);
    case FPE_FLTINV:
      switch (sighting.arithmetic) {
        case Arithmetic::zero_by_zero:
          return messages::non_finite(NonFinite::zero_by_zero);
        case Arithmetic::division:
          return messages::non_finite(NonFinite::undefined_division);
        case Arithmetic::root:
          return messages::non_finite(NonFinite::root);
        case Arithmetic::other:
          return messages::non_finite(NonFinite::other);
        case Arithmetic::comparison:  // the NaN is older
        case Arithmetic::conversion:
        case Arithmetic::unknown:
          return "";
      }
      return "";
    default:
      return "";
  }
}

std::string of_signal(const Sighting& sighting, const CallPlaces& places, const std::string& line) {
  const std::vector<std::string> inside = functions_inside(sighting, places);
  switch (sighting.signal) {
    case SIGFPE:
      if (sighting.detail == FPE_INTDIV) return messages::whole_number_division();
      return floating_point(sighting, inside, line);
    case SIGSEGV:
    case SIGBUS: {
      constexpr std::uint64_t first_page = 4096;
      const bool is_null =
          sighting.signal == SIGSEGV && sighting.detail == SEGV_MAPERR && sighting.address < first_page;
      return is_null ? messages::null_pointer() : messages::foreign_memory();
    }
    case SIGABRT:
      return is_called(inside, "malloc_printerr") ? messages::damaged_memory() : messages::aborted();
    case SIGILL:
    case SIGTRAP:
      return messages::trap_instruction();
    default:
      return "";
  }
}

std::string undefined_behavior(const Sighting& sighting, const std::string& type) {
  using sightings::Undefined;
  const long first = sighting.facts[0];
  const long second = sighting.facts[1];
  switch (static_cast<Undefined>(sighting.detail)) {
    case Undefined::sum:
      return messages::whole_number_too_large(first, "+", second, type);
    case Undefined::difference:
      return messages::whole_number_too_large(first, "−", second, type);
    case Undefined::product:
      return messages::whole_number_too_large(first, "·", second, type);
    case Undefined::quotient:
      return second == 0 ? messages::division_by_whole_zero()
                         : messages::whole_number_too_large(first, "/", second, type);
    case Undefined::negative:
      return messages::whole_number_too_large(0, "−", first, type);
    case Undefined::shift:
      return messages::shift(first, second);
    case Undefined::index:
      return messages::array_index(first, type);
    case Undefined::conversion:
      return messages::conversion_to_whole_number();
    case Undefined::missing_return:
      return messages::ends_without_return();
  }
  return "";
}

/// The line from which the student's function calls itself, if the chain shows that it does so without end.
int recursion_line(const Sighting& sighting, const CallPlaces& places) {
  constexpr int surely_without_end = 100;
  if (sighting.repeated < surely_without_end) return 0;
  std::set<std::uint64_t> seen;
  for (int n = 0; n < sighting.call_count; ++n) {
    const std::uint64_t address = sighting.calls[n];
    const auto found = places.find(address);
    if (found == places.end()) continue;
    for (const CallPlace& place : found->second)
      if (place.line > 0 && !seen.insert(address).second) return place.line;
  }
  return 0;
}

}  // namespace

std::string line_of(const SourceLines& source, int line) {
  const auto index = static_cast<std::size_t>(line) - 1;
  return line > 0 && index < source.size() ? source[index] : "";
}

int student_line(const Sighting& sighting, const CallPlaces& places) {
  for (const CallPlace& place : chain_of(sighting, places))
    if (place.line > 0) return place.line;
  return 0;
}

std::optional<PlacedSentence> sentence_of(const Sighting& sighting, const CallPlaces& places,
                                          const SourceLines& source) {
  PlacedSentence result{student_line(sighting, places), ""};
  const std::string text = printable(sighting.text);
  switch (sighting.what) {
    case What::eigen_assertion:
      result.sentence = messages::eigen_assertion(text, facts_of(sighting));
      break;
    case What::library_assertion:
      result.sentence = messages::library_assertion(printable(sighting.more_text), text, facts_of(sighting));
      break;
    case What::own_assertion:
      result.sentence = messages::own_assertion(text);
      break;
    case What::exception:
      result.sentence = messages::thrown(text);
      break;
    case What::terminated:
      result.sentence = messages::nobody_caught(text);
      break;
    case What::out_of_memory:
      result.sentence = messages::out_of_memory();
      break;
    case What::undefined_behavior:
      result.sentence = undefined_behavior(sighting, text);
      break;
    case What::signal:
      result.sentence = of_signal(sighting, places, line_of(source, result.line));
      break;
    case What::stack_used_up:
      if (const int line = recursion_line(sighting, places); line > 0)
        result = {line, messages::recursion_without_end()};
      else
        result.sentence = messages::stack_used_up();
      break;
    case What::forbidden_call:
      result.sentence = messages::forbidden(forbidden_operation(static_cast<long>(sighting.detail)));
      break;
    case What::program_ended:
      result.sentence = messages::program_ended();
      break;
    case What::still_running:
      result.sentence = messages::still_at_work();
      break;
    case What::returned:
    case What::not_started:
      break;
  }
  if (result.line == 0 || result.sentence.empty()) return std::nullopt;
  return result;
}

std::optional<PlacedSentence> sentence_of_long_run(const std::vector<Sighting>& answers, const CallPlaces& places,
                                                   bool printing) {
  // Of every answer the lines of the student's file, outermost first.
  std::vector<std::vector<int>> lines;
  for (const Sighting& answer : answers) {
    std::vector<int> calls;
    for (const CallPlace& place : chain_of(answer, places))
      if (place.line > 0) calls.insert(calls.begin(), place.line);
    if (!calls.empty()) lines.push_back(calls);
  }
  if (lines.empty()) return std::nullopt;
  if (printing) return PlacedSentence{lines.back().back(), messages::still_printing()};
  // The outermost call that moves from answer to answer is the loop; below it lie the calls that it makes.
  for (std::size_t depth = 0;; ++depth) {
    const bool all_as_deep = std::ranges::all_of(lines, [&](const auto& calls) { return calls.size() > depth; });
    if (!all_as_deep) return PlacedSentence{lines.front().at(depth == 0 ? 0 : depth - 1), messages::still_at_work()};
    int first = lines.front()[depth];
    int last = first;
    for (const std::vector<int>& calls : lines) {
      first = std::min(first, calls[depth]);
      last = std::max(last, calls[depth]);
    }
    if (first != last) return PlacedSentence{first, messages::still_at_work_between(first, last)};
  }
}

}  // namespace workbook
