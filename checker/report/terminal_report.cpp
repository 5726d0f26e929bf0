#include "checker/report/terminal_report.hpp"

#include "checker/judging/failure_text.hpp"
#include "checker/messages/program.hpp"
#include "checker/messages/reporting.hpp"
#include "checker/messages/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace workbook {

namespace {

constexpr std::size_t indent = 2;
constexpr std::size_t longest_printout = 12;  // lines of the student's own output that are shown

std::string mark(const Judgement& judgement) {
  switch (judgement.verdict) {
    case Verdict::passed:
      return "✓";
    case Verdict::not_started:
      return "·";
    case Verdict::checker_error:
      return "!";
    default:
      return "✗";
  }
}

Style style_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return Style::good;
    case Verdict::not_started:
      return Style::quiet;
    case Verdict::checker_error:
      return Style::warning;
    default:
      return Style::bad;
  }
}

std::string headline(const Checked& checked, const Console& console) {
  const Judgement& judgement = checked.judgement;
  std::string count;
  if (judgement.cases_total > 0 && judgement.verdict != Verdict::not_started) {
    count = " " + messages::cases_right(judgement.cases_passed, judgement.cases_total);
  }
  return fmt::format("{}{}  {}{}", console.mark(mark(judgement), style_of(judgement.verdict)),
                     console.styled(checked.exercise.name(), Style::strong),
                     console.styled(messages::in_words(judgement.verdict), style_of(judgement.verdict)),
                     console.styled(count, Style::quiet));
}

/// A heading and the text that belongs to it, side by side.
std::string labelled(const std::string& label, const std::string& text, const Console& console) {
  const std::string body = console.wrapped(text, indent + 7);
  return std::string(indent, ' ') + console.styled(padded(label, 6), Style::strong) + " " +
         body.substr(std::min(body.size(), indent + 7)) + "\n";
}

/// A heading and what to type: never broken, so that it can be copied.
std::string command_line(const std::string& label, const std::string& command, const Console& console) {
  return std::string(indent, ' ') + console.styled(padded(label, 6), Style::strong) + " " + command + "\n";
}

/// The beginning of a line that may be very long.
std::string cut(const std::string& line, std::size_t width) {
  constexpr std::size_t most_bytes_per_column = 8;
  std::size_t end = std::min(line.size(), most_bytes_per_column * width);
  while (end < line.size() && end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0) == 0x80) --end;
  const std::string text = shortened(line.substr(0, end), width);
  return end == line.size() || text.ends_with("…") ? text : text + "…";
}

/// The first lines of a long text, each cut to the width of the terminal, and how many more there are.
std::string first_lines(const std::string& text, std::size_t most, std::size_t margin, const Console& console) {
  constexpr std::size_t narrowest = 20;
  const std::size_t width = std::max(console.width(), margin + narrowest) - margin;
  std::istringstream lines(text);
  std::string shown;
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    if (count >= most) continue;
    std::replace(line.begin(), line.end(), '\t', ' ');  // a tab is as wide as the terminal likes
    shown += std::string(margin, ' ') + cut(line, width) + "\n";
  }
  if (count > most) shown += std::string(margin, ' ') + messages::more_lines(count - most) + "\n";
  return shown;
}

/// A text as it is, every line with a margin.
std::string indented(const std::string& text, std::size_t margin) {
  std::istringstream lines(text);
  std::string shown;
  for (std::string line; std::getline(lines, line);) shown += std::string(margin, ' ') + line + "\n";
  return shown;
}

/// "Line 7: …", the line itself and the caret.
std::string finding_text(const Finding& finding, const Console& console) {
  std::string text = console.wrapped(messages::at_line(finding.line, finding.sentence), indent) + "\n";
  if (!finding.excerpt.empty()) text += first_lines(finding.excerpt, longest_printout, 2 * indent, console);
  return text;
}

/// The case of judgement.first_failure in full.
std::string case_text(const Checked& checked, const Console& console) {
  const Page page{console.width() - indent, console.plain()};
  std::string text;
  for (const std::string& line : describe_failure(*checked.reference, checked.judgement, page))
    text += (line.empty() ? "" : std::string(indent, ' ')) + line + "\n";
  return text;
}

/// What to type to see exactly this failure again.
std::string replay_command(const Checked& checked) {
  const Case& failed = checked.reference->cases.at(checked.judgement.first_failure->case_index);
  std::string arguments = fmt::format("check {} --case '{}'", checked.exercise.name(), failed.name);
  if (checked.seed != 1) arguments += fmt::format(" --seed {}", checked.seed);
  if (checked.is_elsewhere) arguments += fmt::format(" --file {}", checked.file.string());
  return messages::command(arguments);
}

}  // namespace

std::string notes_place(const Course& course, const std::string& lecture, const std::string& anchor) {
  if (const auto page = course.notes_page(lecture))
    return std::filesystem::proximate(*page).string() + (anchor.empty() ? "" : "#" + anchor);
  const std::string source = "lectures/" + lecture + "/notes.md";
  return anchor.empty() ? source : messages::paragraph(source, anchor);
}

std::string terminal_report(const Course& course, const Checked& checked, const Console& console,
                            const Detail& detail) {
  const Judgement& judgement = checked.judgement;
  std::string text = headline(checked, console) + "\n";
  if (judgement.verdict == Verdict::not_started) return text;
  if (judgement.passed()) return detail.one_case ? text + "\n" + case_text(checked, console) : text;

  text += console.wrapped(judgement.message, indent) + "\n";
  for (const Finding& finding : checked.observation.findings) text += "\n" + finding_text(finding, console);
  if (judgement.first_failure && checked.reference != nullptr) text += "\n" + case_text(checked, console);
  if (!checked.observation.printed.empty()) {
    text += "\n" + std::string(indent, ' ') + messages::your_code_printed() + "\n" +
            first_lines(checked.observation.printed, longest_printout, 2 * indent, console);
  }
  const std::string& compiler_output = checked.observation.refusal_details;
  if (detail.full && !compiler_output.empty()) {
    text +=
        "\n" + std::string(indent, ' ') + messages::the_compiler_says() + "\n" + indented(compiler_output, 2 * indent);
  }
  text += "\n";
  for (const Diagnosis& diagnosis : judgement.diagnoses) {
    text += labelled(messages::why_label(), diagnosis.message, console);
    if (!diagnosis.notes.empty())
      text +=
          labelled(messages::read_label(), notes_place(course, checked.exercise.lecture(), diagnosis.notes), console);
  }
  text += labelled(messages::next_label(), judgement.next_step, console);
  if (judgement.verdict == Verdict::checker_error) return text;
  const std::string& name = checked.exercise.name();
  if (judgement.first_failure) text += command_line(messages::again_label(), replay_command(checked), console);
  if (!detail.full && !compiler_output.empty())
    text += command_line(messages::more_label(), messages::command(fmt::format("check {} --full", name)), console);
  text += command_line(messages::hint_label(), messages::command("hint " + name), console);
  return text;
}

std::string summary_line(const std::vector<Checked>& results) {
  std::size_t passed = 0;
  std::size_t not_started = 0;
  std::size_t errors = 0;
  for (const Checked& checked : results) {
    passed += checked.judgement.passed() ? 1 : 0;
    not_started += checked.judgement.verdict == Verdict::not_started ? 1 : 0;
    errors += checked.judgement.verdict == Verdict::checker_error ? 1 : 0;
  }
  return messages::summary(results.size(), passed, results.size() - passed - not_started - errors, not_started, errors);
}

}  // namespace workbook
