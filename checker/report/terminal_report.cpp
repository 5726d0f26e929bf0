#include "checker/course/exam.hpp"
#include "checker/report/reports.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace workbook {

namespace {

constexpr std::size_t report_indent = 2;
constexpr std::size_t label_width = 6;
constexpr std::size_t narrow_lines = 21;  // of a report that is not full: it fits on 24 rows
constexpr std::size_t lines_of_short_case = 7;
constexpr std::size_t longest_printout = 6;  // lines of the student's own output that are shown unless all is asked for

/// "kinetic_energy.cpp:8:3: …", "kinetic_energy.cpp:8:3, 9:3: …" for the same mistake elsewhere, or the sentence alone.
std::string place_and_sentence(const CheckResult& checked, const std::vector<Reason>& same) {
  if (same.front().line <= 0) return same.front().sentence;
  std::vector<std::string> places;
  for (const Reason& reason : same) places.push_back(fmt::format("{}:{}", reason.line, std::max(reason.column, 1)));
  return fmt::format("{}:{}: {}", printable(checked.task.file.filename().string()), fmt::join(places, ", "),
                     same.front().sentence);
}

/// The text of one report, line by line.
class Report {
 public:
  Report(const CheckResult& checked, const Course& course, const Console& console, const Detail& detail)
      : checked_(checked), course_(course), console_(console), detail_(detail) {}

  std::string text() && {
    headline();
    const Judgement& judgement = checked_.judgement;
    if (judgement.verdict == Verdict::not_started) {
      if (checked_.source.empty()) text_ += console_.wrapped(judgement.next_step, report_indent) + "\n";  // no file
      for (const Reason& reason : checked_.reasons) tell("Why", reason);
      return text_;
    }
    if (!judgement.passed())
      explain();
    else
      for (const Reason& reason : checked_.reasons) tell("Note", reason);
    for (const std::string& sentence : on_real_data(checked_))
      text_ += console_.wrapped("Your function " + sentence, report_indent) + "\n";
    if (shown_case()) add_case(*shown_case());
    printed();
    if (judgement.passed()) return text_;
    const std::string& compiler_output = checked_.observation.refusal_details;
    if (detail_.full && !compiler_output.empty()) {
      text_ += "\n  All that the compiler says:\n";
      for (const std::string& line : lines_of(compiler_output)) text_ += "    " + line + "\n";
    }
    if (checked_.is_judged() && !detail_.by_keys) commands();
    return text_;
  }

 private:
  void headline() {
    const Judgement& judgement = checked_.judgement;
    const auto [mark, style] = judgement.passed()       ? std::pair("✓", Style::good)
                               : !checked_.is_started() ? std::pair("·", Style::quiet)
                               : checked_.is_judged()   ? std::pair("✗", Style::bad)
                                                        : std::pair("!", Style::warning);
    text_ += fmt::format("{}{}  {}", console_.mark(mark, style), console_.styled(checked_.name(), Style::strong),
                         console_.styled(in_words(to_string(judgement.verdict)), style));
    if (!checked_.observation.replies.empty() && checked_.is_started() && checked_.is_judged())
      text_ += console_.styled(
          fmt::format(" ({} of {} right)", judgement.cases_passed(), plural(judgement.cases_total, "case")),
          Style::quiet);
    text_ += "\n";
    if (!checked_.weak_sandbox.empty()) text_ += console_.wrapped(checked_.weak_sandbox, report_indent) + "\n";
  }

  void explain() {
    const Judgement& judgement = checked_.judgement;
    const std::vector<Reason>& reasons = checked_.reasons;
    // Of wrong values headline and case say as much, and of a call that failed a reason with its line.
    const bool is_said =
        judgement.verdict == Verdict::wrong_value || (!reasons.empty() && !checked_.observation.replies.empty());
    if (!is_said || detail_.full) text_ += console_.wrapped(judgement.message, report_indent) + "\n";
    const bool is_certain =
        std::ranges::any_of(reasons, [](const Reason& reason) { return !reason.is_in_code() && reason.is_cause(); });
    // Beside a reason that the values confirm, a formula that auto keeps is only possible; beside any cause, a remark
    // says it again, and takes the place of the case.
    const bool has_cause = std::ranges::any_of(reasons, &Reason::is_cause);
    const auto is_possible = [&](const Reason& reason) {
      return reason.is_in_code() && (reason.is_remark() ? has_cause : is_certain && reason.weight == Weight::possible);
    };
    for (const Reason& reason : reasons)
      if (!is_possible(reason)) tell("Why", reason);
    for (const Reason& reason : reasons)
      if (is_possible(reason) && detail_.full) tell("Note", reason);
    if (reasons.empty() && !detail_.is_pending) labelled("Next", checked_.next_step());
  }

  /// Does a short case still fit below, and what to type to see more, with so many lines before them?
  bool has_room(std::size_t lines) const {
    return detail_.full || rows() + lines + (shown_case() ? lines_of_short_case : 1) <= most_rows();
  }

  /// The same mistake in several lines once. The first reason is told whatever it takes, the others, and where to read
  /// on, as long as the case fits below.
  void tell(const char* label, const Reason& reason) {
    const std::string before = text_;
    const bool is_first = told_.empty();
    if (!told_.insert(reason.sentence).second) return;
    std::vector<Reason> same = checked_.reasons;
    std::erase_if(same, [&](const Reason& other) { return other.sentence != reason.sentence; });
    labelled(label, place_and_sentence(checked_, same));
    for (const std::string& line : around_caret(lines_of(reason.excerpt))) text_ += "    " + fitted(line) + "\n";
    if (!is_first && !has_room(0))
      text_ = before;
    else if (has_room(1))
      read(reason.notes);
  }

  /// Where to read on, once.
  void read(const std::string& anchor) {
    if (anchor.empty() || std::exchange(last_anchor_, anchor) == anchor) return;
    text_ += "  " + console_.styled(padded("Read", label_width), Style::strong) + " " +
             notes_place(course_, checked_.task.exercise, anchor, console_, report_indent + label_width + 1) + "\n";
  }

  std::size_t most_rows() const { return console_.width() < Console().width() ? narrow_lines : brief_lines; }
  std::size_t rows() const { return static_cast<std::size_t>(std::ranges::count(text_, '\n')); }

  /// The case to be shown in full, if any.
  std::optional<std::size_t> shown_case() const {
    const bool has_values = checked_.reference != nullptr && !checked_.observation.replies.empty();
    return has_values && detail_.case_index ? detail_.case_index : checked_.first_failure();
  }

  void add_case(std::size_t index) {
    const ExerciseReference& reference = *checked_.reference;
    const Answers answers = answers_of(reference, checked_.observation.replies);
    Page page{console_.width() - report_indent, console_.plain()};
    const bool is_asked = detail_.full || (detail_.case_index && !detail_.by_keys);
    page.is_brief = !is_asked;
    std::string size;
    if (checked_.reasons.empty() && !detail_.is_pending && !checked_.judgement.passed())
      size = error_size(reference, checked_.judgement.failing, answers);
    if (!size.empty()) size = console_.wrapped(size, report_indent) + "\n";
    // That follows, and a line that says what to type to see more.
    const std::size_t taken = rows() + static_cast<std::size_t>(std::ranges::count(size, '\n')) + 1;
    const std::size_t room = most_rows() - std::min(most_rows(), taken);
    if (is_asked)
      page.most_rows = 10000;
    else
      page.most_lines = room;
    const std::vector<std::string> lines = describe_case(reference, index, answers.at(index), page);
    if (is_asked || lines.size() < room) text_ += "\n";
    for (const std::string& line : lines) text_ += "  " + line + "\n";
    text_ += size;
    if (!checked_.judgement.passed() && checked_.judgement.failing.size() > 1 && detail_.full)
      labelled("Failed", failing_cases(checked_));
  }

  /// What the student's code printed: at the shown case, or where it printed first; all where all is asked for.
  void printed() {
    const std::vector<Reply>& replies = checked_.observation.replies;
    std::size_t left_out = 0;
    bool has_begun = false;
    for (std::size_t index = 0; index < replies.size(); ++index) {
      const std::vector<std::string> lines = lines_of(replies[index].printed);
      const bool is_shown = shown_case() ? shown_case() == index : !has_begun && !lines.empty();
      const std::size_t most = detail_.full || detail_.case_index == index ? lines.size()
                               : is_shown                                  ? std::min(longest_printout, lines.size())
                                                                           : 0;
      has_begun = has_begun || is_shown;
      if (most > 0) text_ += fmt::format("\n  Your code printed at case {}:\n", index + 1);
      for (std::size_t k = 0; k < most; ++k) text_ += "    " + fitted(lines[k]) + "\n";
      left_out += lines.size() - most;
    }
    if (left_out > 0)
      text_ += fmt::format("  Your code printed {} ({} shows all).\n", plural(left_out, "more line"),
                           detail_.by_keys ? "c" : "--full");
  }

  /// What to type to see more: never broken, so that it can be copied.
  void commands() {
    const std::string& name = checked_.name();
    std::string again = "check " + name;
    if (detail_.full && shown_case()) again += fmt::format(" --case {}", *shown_case() + 1);
    if (!detail_.full) again += " --full";
    if (checked_.task.is_other_seed) again += fmt::format(" --seed {}", checked_.task.seed);
    if (checked_.task.is_elsewhere) again += " --file " + shell_quoted(printable(checked_.task.file.string()));
    // Without a name it is the hint of what was checked last.
    const std::string hint = checked_.task.counts_as_progress() ? "" : " " + name;
    text_ += "  " + console_.styled(padded(detail_.full ? "Again" : "More", label_width), Style::strong) + " " +
             command(again) + ", or hint" + hint + "\n";
  }

  /// A heading and the text that belongs to it, side by side.
  void labelled(const std::string& label, const std::string& text) {
    const std::string body = console_.wrapped(text, report_indent + label_width + 1);
    text_ += "  " + console_.styled(padded(label, label_width), Style::strong) + " " +
             body.substr(std::min(body.size(), report_indent + label_width + 1)) + "\n";
  }

  /// A line and the ^ below it, without their beginnings where there is no room for the ^.
  std::vector<std::string> around_caret(std::vector<std::string> lines) const {
    constexpr std::size_t behind = 12;
    const std::size_t caret = lines.empty() ? std::string::npos : lines.back().find('^');
    if (caret == std::string::npos || caret + 4 + behind <= console_.width()) return lines;
    const std::size_t begin = caret + 4 + behind - console_.width();
    for (std::string& line : lines)
      if (std::ranges::all_of(line, [](char letter) { return static_cast<unsigned char>(letter) < 0x80; }) &&
          line.size() > begin)
        line = (&line == &lines.back() ? " " : "…") + line.substr(begin + 1);
    return lines;
  }

  /// One line cut to the width of the terminal, less its margin; a tab is as wide as the terminal likes.
  std::string fitted(const std::string& line) const {
    constexpr std::size_t most_bytes_per_column = 8;
    const std::size_t width = console_.width() - 4;
    std::string text = cut(line, most_bytes_per_column * width);
    std::ranges::replace(text, '\t', ' ');
    return shortened(text.size() < line.size() ? text + "…" : text, width);
  }

  const CheckResult& checked_;
  const Course& course_;
  const Console& console_;
  const Detail& detail_;
  std::string text_;
  std::string last_anchor_;
  std::set<std::string> told_;
};

}  // namespace

State state_of(const Course& course, const Progress& progress, const Exercise& exercise) {
  const std::string verdict = progress.of(exercise.name()).verdict;
  if (verdict == "passed") {
    if (progress.passed(exercise.name(), file_fingerprint(course.student_file(exercise))))
      return {"✓", "passed", Style::good};
    return {"?", "changed since it passed", Style::warning};
  }
  if (verdict.empty() || verdict == "not_started") return {"·", "not started", Style::quiet};
  return {"✗", in_words(verdict), Style::bad};
}

/// "7 points, 1 h 20 min left"; "" if nothing is.
static std::string left_of(const ProgressSummary& summary, const Card& card) {
  double points = 0;
  int minutes = 0;
  for (const Exercise& exercise : summary.exercises) {
    if (summary.passes(exercise) || exercise.card != &card) continue;
    points += exercise.entry->points;
    minutes += exercise.entry->minutes;
  }
  if (points == 0 && minutes == 0) return "";
  return fmt::format("{}, {} left", points == 1 ? "1 point" : fmt::format("{} points", points),
                     hours_and_minutes(std::chrono::minutes(minutes)));
}

std::string overview(const Course& course, const ProgressSummary& summary, const Console& console) {
  double points = 0, all_points = 0;
  for (const Exercise& exercise : summary.exercises) {
    all_points += exercise.entry->points;
    if (summary.passes(exercise)) points += exercise.entry->points;
  }
  std::string text = console.wrapped(fmt::format("{} of {} exercises pass, {} of {} points.", summary.count_passed(),
                                                 summary.exercises.size(), points, all_points)) +
                     "\n\n";
  std::size_t name_width = 0;
  std::size_t left_width = 0;
  for (const Card& card : course.cards()) {
    name_width = std::max(name_width, display_width(card.lecture));
    left_width = std::max(left_width, display_width(left_of(summary, card)));
  }
  const std::size_t beside = name_width + 16 + left_width;
  const std::size_t bar_width = std::clamp<std::size_t>(console.width() - std::min(console.width(), beside), 8, 20);
  for (const Card& card : course.cards()) {
    const std::size_t total = card.exercises.size();
    const std::size_t passed = summary.count_passed(card.lecture);
    const std::string bar = console.plain() ? "" : console.bar(passed, total, bar_width) + "  ";
    const bool has_room = console.width() >= beside + bar_width;
    const std::string count = fmt::format("{} of {}", passed, total), left = left_of(summary, card);
    text += console.mark(passed == total ? "✓" : " ", Style::good) + padded(card.lecture, name_width) + "  " + bar +
            (has_room && !left.empty() ? padded(count, 10) + console.styled(left, Style::quiet) : count) + "\n";
  }
  return text;
}

std::string exercise_list(const Course& course, const Progress& progress, const ProgressSummary& summary,
                          const Console& console) {
  std::size_t name_width = 0;
  for (const Exercise& exercise : course.exercises()) name_width = std::max(name_width, display_width(exercise.name()));
  const bool is_wide = console.width() >= name_width + 55;
  std::string text;
  for (const Card& card : course.cards()) {
    text += (text.empty() ? "" : "\n") + console.styled(card.lecture, Style::strong) + "\n";
    std::string place =
        fmt::format("{}: {} of {} are yours", card.title, summary.count_passed(card.lecture), card.exercises.size());
    if (const std::string left = left_of(summary, card); !left.empty()) place += ", " + left;
    if (!card.builds_on.empty()) place += fmt::format("; builds on {}", fmt::join(card.builds_on, ", "));
    text += console.wrapped(place, 2) + "\n";
    for (const CardExercise& entry : card.exercises) {
      const State state = state_of(course, progress, {&card, &entry});
      text += "  " + console.mark(state.mark, state.style) + padded(entry.name, is_wide ? name_width : 0) + "  " +
              console.styled(is_wide ? padded(state.words, 24) : state.words, state.style);
      std::string worth = entry.points == 1 ? "1 point" : fmt::format("{} points", entry.points);
      worth += fmt::format(", {} min{}", entry.minutes, entry.is_problem() ? ", problem" : "");
      if (is_wide)
        text += console.styled(worth, Style::quiet);
      else if (entry.is_problem())
        text += console.styled(", problem", Style::quiet);
      text += "\n";
    }
  }
  return text;
}

std::string introduction(const Course& course, const Exercise& exercise, const Console& console) {
  return fmt::format("Next: {}\n{}\n  file   {}\n  notes  {}\n", console.styled(exercise.name(), Style::strong),
                     console.wrapped(exercise.entry->task, 2), shown_path(course.student_file(exercise)),
                     notes_place(course, exercise, "", console, 9));
}

std::string notes_place(const Course& course, const Exercise& exercise, const std::string& anchor,
                        const Console& console, std::size_t indent) {
  std::map<std::string, std::string> headings = read_headings(course.notes_file(*exercise.card));
  std::string lecture = exercise.lecture();
  if (!anchor.empty() && !headings.contains(anchor))  // what C++ is about stands in another one
    for (const Card& card : course.cards())
      if (auto others = read_headings(course.notes_file(card)); others.contains(anchor)) {
        lecture = card.lecture;
        headings = std::move(others);
      }
  const std::string heading = headings[anchor].empty() ? "" : ", “" + headings[anchor] + "”";
  if (const auto page = course.notes_page(lecture))
    return console.linked(shortened("lecture " + lecture + heading, console.width() - indent),
                          file_address(*page) + (anchor.empty() ? "" : "#" + anchor));
  const std::string place = console.wrapped("lectures/" + lecture + "/notes.md" + heading, indent);
  return place.substr(std::min(place.size(), indent));
}

std::string terminal_report(const CheckResult& checked, const Course& course, const Console& console,
                            const Detail& detail) {
  return Report(checked, course, console, detail).text();
}

std::string failing_cases(const CheckResult& checked) {
  constexpr std::size_t most_named = 4;
  const std::vector<std::size_t>& failing = checked.judgement.failing;
  std::string list;
  std::size_t shown = 0;
  for (; shown < std::min(failing.size(), most_named); ++shown)
    list += fmt::format("{}{} “{}”", shown == 0 ? "" : ", ", failing[shown] + 1,
                        checked.reference->cases[failing[shown]].name);
  while (shown < failing.size()) {  // runs of three and more as "5–70"
    std::size_t last = shown;
    while (last + 1 < failing.size() && failing[last + 1] == failing[last] + 1) ++last;
    if (last < shown + 2) last = shown;
    list += fmt::format(", {}", failing[shown] + 1);
    if (last > shown) list += fmt::format("–{}", failing[last] + 1);
    shown = last + 1;
  }
  return list;
}

std::string summary_line(const std::vector<CheckResult>& results) {
  std::size_t passed = 0, not_started = 0, errors = 0, failing = 0;
  for (const CheckResult& checked : results)
    ++(checked.judgement.passed() ? passed
       : !checked.is_started()    ? not_started
       : !checked.is_judged()     ? errors
                                  : failing);
  std::string line = fmt::format("{} of {} passed", passed, results.size());
  if (failing > 0) line += fmt::format(", {} failing", failing);
  if (not_started > 0) line += fmt::format(", {} not started", not_started);
  if (errors > 0) line += fmt::format(", {} could not be judged (our fault, not yours)", errors);
  return line + ".";
}

}  // namespace workbook
