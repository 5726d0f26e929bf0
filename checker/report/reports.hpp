/// @file
/// What people and programs are told of verdicts: on the terminal, as JSON, as a page; and how far a student has come.
#pragma once

#include "checker/base/console.hpp"
#include "checker/judging/comparison.hpp"
#include "checker/pipeline/check_exercise.hpp"

#include <nlohmann/json_fwd.hpp>

#include <limits>

namespace workbook {

/// What of a verdict is shown.
struct Detail {
  bool full = false;                      ///< every failing case by name, long lists and all that the compiler says
  std::optional<std::size_t> case_index;  ///< this case, whether it passed or not; else the first failing one
  bool by_keys = false;                   ///< in the watch, whose keys do what is to be typed elsewhere
  bool is_pending = false;                ///< the reason may still come: no advice takes its place
};

/// A failure is told on that many lines of 80 columns, unless all is asked for.
inline constexpr std::size_t brief_lines = 14;

/// One line for what passed or was not started; for the rest why, or what to do next, and the first failing case in
/// numbers.
std::string terminal_report(const CheckResult& checked, const Course& course, const Console& console,
                            const Detail& detail = {});

/// "6 of 8 passed, 1 failing, 1 not started."
std::string summary_line(const std::vector<CheckResult>& results);

/// The failing cases by number, the first ones with their names.
std::string failing_cases(const CheckResult& checked);

/// Where a paragraph of the notes can be read: a link to the built page if there is one, else its source and the
/// heading. @param indent  where it stands on its line
std::string notes_place(const Course& course, const Exercise& exercise, const std::string& anchor,
                        const Console& console, std::size_t indent);

// --- one case in full, as plain text

/// What text is laid out on.
struct Page {
  std::size_t width = 78;     ///< all text keeps to it
  bool is_linear = false;     ///< nothing beside each other: for screen readers
  std::size_t most_rows = 8;  ///< of a long list so many are shown; the checker's JSON has them all
  bool is_brief = false;      ///< inputs on one line each, rounded if need be, and one of several matrices
  std::size_t most_lines = std::string::npos;  ///< in all, where something can give way: long results, then inputs
};

/// Inputs, expected, yours and their difference, lined up number by number, with units. On a page too narrow for
/// columns, or a linear one, in sentences.
/// @param actual  empty if no value of the expected shape came back
std::vector<std::string> describe_case(const ExerciseReference& exercise, std::size_t case_index,
                                       const std::optional<Value>& actual, const Page& page = {});

/// In columns of a terminal.
std::size_t widest(const std::vector<std::string>& lines);

/// How large the error is: of the shown entry of the first failing case, or, where it is small, at all of them.
/// Empty where nothing sensible can be said.
std::string error_size(const ExerciseReference& exercise, const std::vector<std::size_t>& failing,
                       const Answers& answers);

/// What a function that passes makes of real data: "on throw 3: a = -0.998 ± 0.004, …", one sentence for each piece.
std::vector<std::string> on_real_data(const CheckResult& checked);

// --- on pages

struct ReportedExercise {
  CheckResult checked;
  std::optional<bool> answered_right = {};  ///< the question on it
};

/// One student's results.
struct ReportedCourse {
  std::string student;                          ///< may be empty
  std::string date;                             ///< as it is to be read
  std::optional<std::uint64_t> seed = {};       ///< of the cases; nothing: not to be told
  std::vector<ReportedExercise> exercises;      ///< in course order
  std::map<std::string, std::string> headings;  ///< of the notes, by anchor
  std::string picture_trouble;                  ///< why there are no plots; empty: there is no trouble
  std::vector<std::string> notes = {};          ///< what else is to be said of the whole
  std::optional<double> counted = {};           ///< points, where fewer count than were earned
};

/// A page as HTML that needs nothing beside it, to hand in or for an instructor to read, made from report_page.html.
/// Whatever came from the student is text on it, never markup. It holds no script, and it asks for no other file.
std::string report_page(const ReportedCourse& reported);

/// The page about a class. @param document  class.json. @param date  as it is to be read
std::string class_page(const nlohmann::ordered_json& document, const std::string& date);

/// How pages show a verdict by its name: its tone, which the style sheet knows, and its mark.
nlohmann::json look_of(const std::string& verdict);

/// What is known of one exercise.
struct State {
  std::string mark;
  std::string words;
  Style style = Style::plain;
};
State state_of(const Course& course, const Progress& progress, const Exercise& exercise);

/// How much of each lecture passes, line by line, and in all.
std::string overview(const Course& course, const ProgressSummary& summary, const Console& console);

/// Every exercise with its state and points, below its lecture and how much of that is the student's own.
std::string exercise_list(const Course& course, const Progress& progress, const ProgressSummary& summary,
                          const Console& console);

/// What an exercise asks for, its file and where to read: "Next: NAME" and a few lines below it.
std::string introduction(const Course& course, const Exercise& exercise, const Console& console);

// --- the plot: the student's curve on the reference results, and the difference below

inline constexpr const char* gnuplot_is_missing =
    "gnuplot is not installed (on Debian: apt-get install gnuplot-nox), so there are no plots and figures; everything "
    "else works without it.";

/// One curve per component of the result. Where there is no value, there is NaN.
struct Overlay {
  using Curves = std::vector<std::vector<double>>;

  const Sweep* sweep = nullptr;
  std::vector<std::string> labels;  ///< of the components: "E", or "|E|" where the sign is free
  Curves reference;
  Curves student;                  ///< empty: no value at all
  Curves misconception;            ///< empty: none is recognised
  std::string misconception_name;  ///< "no half"
  /// The smallest step that no line may join: an angle that starts again at −π, a whole number that changes.
  double jump = std::numeric_limits<double>::infinity();
  bool has_whole_numbers = false;
  bool has_turns = false;  ///< angles that differ by full turns are one attitude
};

/// The student's function along the sweep, where the check asked for its values there.
/// @throws std::runtime_error if there is no sweep
Overlay overlay_of(const CheckResult& checked);

/// Draws DIRECTORY/NAME.svg and DIRECTORY/NAME.png. Returns both paths.
/// @throws std::runtime_error if gnuplot is missing, the folder cannot be written, or gnuplot fails
std::vector<fs::path> draw_overlay(const Overlay& overlay, const fs::path& directory, const std::string& name);

/// Gives a result the plot for a page, where the function gave a value: one that cannot be drawn is left out.
void add_picture(CheckResult& checked, const fs::path& directory);

/// The curves alone, made of letters, as gnuplot draws them on a terminal of that name and options; and what they mean.
/// @param directory  for files on the way. @throws std::runtime_error
std::string drawn_letters(const Overlay& overlay, const std::string& terminal, std::size_t columns,
                          const fs::path& directory);
std::string meaning_of_letters(const Overlay& overlay);

// --- on the terminal itself, in the best way that it can show

/// Of one plot, where somebody looks at a terminal and wants more than words: several would chase each other off the
/// screen.
bool shows_pictures(std::size_t plots, const Console& console);

/// What to print for the plot to be seen, no larger than the window: graphics where the program chafa is installed and
/// knows that the terminal shows them, else letters.
/// @param png  what draw_overlay() has left. @throws std::runtime_error
std::string terminal_picture(const Overlay& overlay, const fs::path& png, const Console& console);

/// A drawing made of letters. @param directory  for files on the way. @throws std::runtime_error
std::string letter_picture(const Overlay& overlay, const fs::path& directory, const Console& console);

}  // namespace workbook
