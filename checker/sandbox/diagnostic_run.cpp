#include "checker/sandbox/diagnostic_run.hpp"

#include "checker/base/printable.hpp"
#include "checker/compile/build_cache.hpp"
#include "checker/compile/compile.hpp"
#include "checker/compile/compiler.hpp"
#include "checker/compile/source_file.hpp"
#include "checker/judging/value_text.hpp"
#include "checker/messages/running.hpp"
#include "checker/sandbox/run_look.hpp"
#include "checker/sandbox/sentences.hpp"

#include <signal.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <sstream>

namespace workbook {
namespace {

using sightings::Sighting;
using sightings::Traps;
using sightings::What;

/// The case whose second look promises most.
std::size_t case_to_look_at(const SecondLookTask& task) {
  if (task.judgement.first_failure) return task.judgement.first_failure->case_index;
  for (const Repeat& repeat : task.observation.repeats) {
    const std::size_t index = repeat.case_index;
    if (index >= task.reference.cases.size() || index >= task.observation.replies.size()) continue;
    const Reply& first = task.observation.replies[index];
    if (repeat.reply.ending != first.ending || !(repeat.reply.value == first.value)) return index;
  }
  return 0;
}

SourceLines lines_of(const std::string& source) {
  std::istringstream text(source);
  SourceLines lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// The line as the student wrote it, without the space around it.
std::string excerpt_of(const std::string& line) {
  constexpr std::size_t longest = 100;
  std::string text = printable(line);
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  text = text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not inside a character
  return text.substr(0, end) + " …";
}

/// One second look, at one compiled file.
class SecondLook {
 public:
  SecondLook(const SecondLookTask& task, const SourceLines& source, const std::filesystem::path& witness,
             const std::filesystem::path& addr2line)
      : task_(task),
        source_(source),
        witness_(witness),
        addr2line_(addr2line),
        failing_(task.reference.cases.at(case_to_look_at(task))),
        file_name_(shown_name(task.file)) {}

  std::vector<PlacedSentence> take() {
    switch (task_.judgement.verdict) {
      case Verdict::time_limit:
      case Verdict::output_limit:
        return long_run();
      case Verdict::wrong_value:
      case Verdict::inconsistent_value:
      case Verdict::non_finite_value:
        return value();
      default:
        return ending();
    }
  }

 private:
  Look look(Paint paint, Traps traps = Traps::none, const LookLimits& limits = {}) const {
    return run_look(witness_, failing_.inputs, paint, traps, limits);
  }

  CallPlaces places_of(const std::vector<Sighting>& seen) const {
    std::vector<std::uint64_t> addresses;
    for (const Sighting& sighting : seen)
      addresses.insert(addresses.end(), sighting.calls, sighting.calls + sighting.call_count);
    std::ranges::sort(addresses);
    const auto repeated = std::ranges::unique(addresses);
    addresses.erase(repeated.begin(), repeated.end());
    return find_places(addr2line_, witness_, addresses, file_name_);
  }

  std::optional<PlacedSentence> sentence(const Sighting& sighting) const {
    return sentence_of(sighting, places_of({sighting}), source_);
  }

  /// What the compiler's checks found, and how the call ended.
  std::vector<PlacedSentence> told_by(const Look& look) const {
    const CallPlaces places = places_of(look.sightings);
    std::vector<PlacedSentence> found;
    for (const Sighting& sighting : look.sightings) {
      // The abort that follows an assertion or an exception that nobody caught adds nothing.
      if (&sighting != look.end() && sighting.what != What::undefined_behavior) continue;
      if (const auto one = sentence_of(sighting, places, source_)) found.push_back(*one);
    }
    return found;
  }

  /// The function did not return.
  std::vector<PlacedSentence> ending() const {
    const Look again = look(Paint::as_in_judging);
    std::vector<PlacedSentence> found = told_by(again);
    const bool failed_again = again.end() != nullptr && !again.result && again.end()->what != What::not_started;
    if (!failed_again || !is_harmless(again)) return found;
    if (const Look zeros = look(Paint::zero); zeros.result) append(found, never_set(zeros));
    return found;
  }

  /// Did the compiler's checks find nothing?
  static bool is_harmless(const Look& look) {
    return std::ranges::none_of(look.sightings,
                                [](const Sighting& one) { return one.what == What::undefined_behavior; });
  }

  /// The function returned, but not what it should.
  std::vector<PlacedSentence> value() const {
    const Look first = look(Paint::zero);
    // What the optimiser had removed, such as a second delete, may also end the call now.
    std::vector<PlacedSentence> found = told_by(first);
    // What lies outside an array was never set either.
    if (is_harmless(first) && first.result) found = never_set(first);
    if (task_.judgement.verdict == Verdict::non_finite_value && found.empty()) {
      const Look trapped = look(Paint::zero, Traps::non_finite);
      if (const Sighting* end = trapped.end(); end != nullptr && end->what == What::signal)
        if (const auto one = sentence(*end)) found.push_back(*one);
    }
    return found;
  }

  /// Does what the function does depend on memory that it never set? Certain where it is the same at every run with
  /// the same paint, and differs from paint to paint.
  /// @param zeros  a look with Paint::zero
  std::vector<PlacedSentence> never_set(const Look& zeros) const {
    const Look painted = look(Paint::signalling);
    const bool depends = !(painted == zeros) && zeros == look(Paint::zero) && painted == look(Paint::signalling) &&
                         zeros.end() != nullptr && painted.end() != nullptr;
    if (!depends) return {};
    if (painted.result) {
      const std::vector<std::string> entries = entries_never_set(*painted.result);
      const std::size_t all = painted.result->numbers.size();
      if (!entries.empty()) return {{0, messages::entries_never_set(entries, all)}};
    }
    // A signalling NaN traps where it is first used; with zeros nothing must happen there.
    const Look trapped = look(Paint::signalling, Traps::invalid);
    const Look untrapped = look(Paint::zero, Traps::invalid);
    const Sighting* const end = trapped.end();
    if (end != nullptr && end->what == What::signal && end->signal == SIGFPE) {
      const CallPlaces places = places_of({*end});
      const bool also_with_zeros = untrapped.end() != nullptr && untrapped.end()->what == What::signal;
      const int line = student_line(*end, places);
      if (line > 0 && !also_with_zeros) return {{line, messages::never_set_here()}};
    }
    return {{0, messages::never_set()}};
  }

  /// The entries of the result that are still as they were painted.
  std::vector<std::string> entries_never_set(const Value& result) const {
    std::vector<std::string> names;
    for (std::size_t n = 0; n < result.numbers.size(); ++n)
      if (is_painted(result.numbers[n])) names.push_back(entry_name(result, task_.reference.result_kind, n));
    return names;
  }

  /// The function did not return in time, or printed without end.
  std::vector<PlacedSentence> long_run() const {
    LookLimits limits;
    limits.time = std::chrono::milliseconds(300);
    limits.between_questions = std::chrono::milliseconds(13);  // no multiple of what loops are likely to take
    limits.questions = 16;
    const Look long_look = look(Paint::as_in_judging, Traps::none, limits);
    if (long_look.end() != nullptr || !(long_look.out_of_time || long_look.too_much_output)) return {};
    std::vector<Sighting> answers;
    std::vector<PlacedSentence> found;
    for (const Sighting& sighting : long_look.sightings) {
      if (sighting.what == What::still_running) answers.push_back(sighting);
      if (sighting.what == What::undefined_behavior)
        if (const auto one = sentence(sighting)) found.push_back(*one);
    }
    if (const auto one = sentence_of_long_run(answers, places_of(answers), long_look.too_much_output))
      found.push_back(*one);
    return found;
  }

  static void append(std::vector<PlacedSentence>& found, const std::vector<PlacedSentence>& more) {
    found.insert(found.end(), more.begin(), more.end());
  }

  const SecondLookTask& task_;
  const SourceLines& source_;
  const std::filesystem::path& witness_;
  const std::filesystem::path& addr2line_;
  const Case& failing_;
  std::string file_name_;  ///< as the compiler was told
};

std::vector<Finding> in_full(std::vector<PlacedSentence> sentences, const SourceLines& source) {
  constexpr std::size_t most = 3;
  std::vector<Finding> findings;
  for (PlacedSentence& one : sentences) {
    // Of one line the first is the cause and the others follow from it.
    const bool told = std::ranges::any_of(findings, [&](const Finding& earlier) { return earlier.line == one.line; });
    if (findings.size() == most || told) continue;
    const std::string excerpt = excerpt_of(line_of(source, one.line));
    findings.push_back(
        {one.line, excerpt, one.line > 0 ? one.sentence : messages::at_no_line(std::move(one.sentence))});
  }
  return findings;
}

}  // namespace

bool deserves_second_look(const Judgement& judgement) {
  switch (judgement.verdict) {
    case Verdict::wrong_value:
    case Verdict::non_finite_value:
    case Verdict::inconsistent_value:
      return judgement.diagnoses.empty();
    case Verdict::uncaught_exception:
    case Verdict::crashed:
    case Verdict::stopped_early:
    case Verdict::time_limit:
    case Verdict::memory_limit:
    case Verdict::output_limit:
    case Verdict::forbidden_operation:
      return true;
    default:
      return false;
  }
}

std::vector<Finding> second_look_with(const std::filesystem::path& witness, const SecondLookTask& task,
                                      const Toolchain& toolchain) {
  if (!deserves_second_look(task.judgement) || task.reference.cases.empty()) return {};
  const SourceLines source = lines_of(read_source(task.file));
  return in_full(SecondLook(task, source, witness, toolchain.addr2line).take(), source);
}

std::vector<Finding> second_look(const SecondLookTask& task, const Toolchain& toolchain,
                                 const std::filesystem::path& scratch) {
  if (!deserves_second_look(task.judgement) || toolchain.second_look.empty()) return {};
  try {
    const Workspace workspace(scratch);
    CompileLimits limits;
    limits.time = std::chrono::seconds(10);
    const Compilation compilation =
        compile({.file = task.file, .exercise = task.reference.name, .signature = task.reference.signature},
                read_toolchain(toolchain.second_look), workspace.directory(), limits);
    if (!compilation.executable) return {};
    return second_look_with(*compilation.executable, task, toolchain);
  } catch (const std::exception&) {
    return {};  // an explanation less; the verdict stands
  }
}

}  // namespace workbook
