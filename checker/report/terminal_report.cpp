#include "checker/report/terminal_report.hpp"

#include "checker/judging/failure_text.hpp"

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

/// "wrong value" for wrong_value.
std::string in_words(Verdict verdict) {
  std::string words = to_string(verdict);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string headline(const Checked& checked, const Console& console) {
  const Judgement& judgement = checked.judgement;
  std::string count;
  if (judgement.cases_total > 0 && judgement.verdict != Verdict::not_started) {
    count = fmt::format(" ({} of {} cases right)", judgement.cases_passed, judgement.cases_total);
  }
  return fmt::format("{}{}  {}{}", console.mark(mark(judgement), style_of(judgement.verdict)),
                     console.styled(checked.exercise.name(), Style::strong),
                     console.styled(in_words(judgement.verdict), style_of(judgement.verdict)),
                     console.styled(count, Style::quiet));
}

/// A heading and the text that belongs to it, side by side.
std::string labelled(const std::string& label, const std::string& text, const Console& console) {
  const std::string body = console.wrapped(text, indent + 7);
  return std::string(indent, ' ') + console.styled(padded(label, 6), Style::strong) + " " +
         body.substr(std::min(body.size(), indent + 7)) + "\n";
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
  if (count > most) {
    shown +=
        std::string(margin, ' ') + fmt::format("… and {} more line{}\n", count - most, count - most == 1 ? "" : "s");
  }
  return shown;
}

/// "line 7: …", the line itself and the caret.
std::string finding_text(const Finding& finding, const Console& console) {
  const std::string place = finding.line > 0 ? fmt::format("Line {}: ", finding.line) : "";
  std::string text = console.wrapped(place + finding.sentence, indent) + "\n";
  if (!finding.excerpt.empty()) text += first_lines(finding.excerpt, longest_printout, 2 * indent, console);
  return text;
}

}  // namespace

std::string notes_place(const Course& course, const std::string& lecture, const std::string& anchor) {
  if (const auto page = course.notes_page(lecture))
    return std::filesystem::proximate(*page).string() + (anchor.empty() ? "" : "#" + anchor);
  const std::string source = "lectures/" + lecture + "/notes.md";
  return anchor.empty() ? source : source + ", paragraph " + anchor;
}

std::string terminal_report(const Course& course, const Checked& checked, const Console& console) {
  const Judgement& judgement = checked.judgement;
  std::string text = headline(checked, console) + "\n";
  if (judgement.passed()) return text;
  if (judgement.verdict == Verdict::not_started) return text;

  text += console.wrapped(judgement.message, indent) + "\n";
  for (const Finding& finding : checked.observation.findings) text += "\n" + finding_text(finding, console);
  if (judgement.first_failure && checked.reference != nullptr) {
    text += "\n";
    for (const std::string& line : describe_failure(*checked.reference, judgement))
      text += std::string(indent, ' ') + line + "\n";
  }
  if (!checked.observation.printed.empty()) {
    text += "\n" + std::string(indent, ' ') + "Your code printed:\n" +
            first_lines(checked.observation.printed, longest_printout, 2 * indent, console);
  }
  text += "\n";
  for (const Diagnosis& diagnosis : judgement.diagnoses) {
    text += labelled("Why", diagnosis.message, console);
    if (!diagnosis.notes.empty())
      text += labelled("Read", notes_place(course, checked.exercise.lecture(), diagnosis.notes), console);
  }
  text += labelled("Next", judgement.next_step, console);
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
  const std::size_t wrong = results.size() - passed - not_started - errors;
  std::string line = fmt::format("{} of {} passed", passed, results.size());
  if (wrong > 0) line += fmt::format(", {} to mend", wrong);
  if (not_started > 0) line += fmt::format(", {} not started", not_started);
  if (errors > 0) line += fmt::format(", {} could not be judged (our fault, not yours)", errors);
  return line + ".";
}

}  // namespace workbook
