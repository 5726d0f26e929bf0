#include "checker/report/report_page.hpp"

#include "checker/base/base64.hpp"
#include "checker/base/printable.hpp"
#include "checker/judging/failure_text.hpp"
#include "checker/messages/report_page.hpp"
#include "checker/messages/reporting.hpp"
#include "checker/report/report_page_parts.hpp"

#include <fmt/format.h>
#include <kainjow/mustache.hpp>

#include <cstddef>
#include <stdexcept>

namespace workbook {

namespace {

using kainjow::mustache::data;

constexpr std::size_t most_steps = 5;
constexpr std::size_t longest_text = std::size_t{48} << 10;  // of one printout or file, in bytes

/// Text on the page: valid, without control characters, and not without end. The template escapes it.
std::string shown(std::string text) {
  std::erase(text, '\r');
  const bool cut = text.size() > longest_text;
  if (cut) text.resize(longest_text);
  return printable(text) + (cut ? "\n" + messages::cut_off() : "");
}

/// Mustache skips a section whose value is false; text that is empty must not open one.
data text_or_nothing(const std::string& text) { return text.empty() ? data(false) : data(shown(text)); }

struct Look {
  const char* tone;
  const char* mark;  ///< in front of the words, for the eye only
};

Look look_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return {"good", "✓"};
    case Verdict::not_started:
      return {"idle", "·"};
    case Verdict::checker_error:
      return {"unclear", "!"};
    default:
      return {"bad", "✗"};
  }
}

bool is_judged(const Checked& checked) { return checked.judgement.verdict != Verdict::checker_error; }
bool is_started(const Checked& checked) { return checked.judgement.verdict != Verdict::not_started; }

struct Score {
  double points = 0.0;
  double possible = 0.0;

  void add(const Checked& checked) {
    if (!is_judged(checked)) return;
    possible += checked.exercise.entry->points;
    points += checked.judgement.passed() ? checked.exercise.entry->points : 0.0;
  }
};

std::string joined(const std::vector<std::string>& lines) { return fmt::format("{}", fmt::join(lines, "\n")); }

std::string link_to(const Checked& checked) { return "exercise-" + shown(checked.exercise.name()); }

/// Where to read, as the lecture calls it; "" if the diagnosis names no place.
std::string place_of(const Diagnosis& diagnosis, const Checked& checked,
                     const std::map<std::string, std::string>& headings) {
  if (diagnosis.notes.empty()) return "";
  const auto heading = headings.find(diagnosis.notes);
  return messages::place_in_notes(checked.exercise.lecture(),
                                  heading == headings.end() ? diagnosis.notes : heading->second);
}

/// What the table of contents and the article have in common.
data entry_of(const Checked& checked) {
  const Look look = look_of(checked.judgement.verdict);
  data entry;
  entry.set("name", shown(checked.exercise.name()));
  entry.set("link", is_started(checked) ? data(link_to(checked)) : data(false));
  entry.set("verdict", messages::verdict_words(checked.judgement.verdict));
  entry.set("tone", look.tone);
  entry.set("mark", look.mark);
  return entry;
}

data findings_of(const Checked& checked) {
  data findings{data::type::list};
  for (const Finding& finding : checked.observation.findings) {
    data entry;
    entry.set("sentence",
              shown(finding.line > 0 ? messages::at_line(finding.line, finding.sentence) : finding.sentence));
    entry.set("excerpt", text_or_nothing(finding.excerpt));
    findings << entry;
  }
  return findings;
}

data diagnoses_of(const Checked& checked, const std::map<std::string, std::string>& headings) {
  data diagnoses{data::type::list};
  for (const Diagnosis& diagnosis : checked.judgement.diagnoses) {
    data entry;
    entry.set("message", shown(diagnosis.message));
    entry.set("read", text_or_nothing(place_of(diagnosis, checked, headings)));
    diagnoses << entry;
  }
  return diagnoses;
}

data article_of(const ReportedExercise& reported, const std::map<std::string, std::string>& headings) {
  const Checked& checked = reported.checked;
  const Judgement& judgement = checked.judgement;
  const double possible = checked.exercise.entry->points;
  const bool wants_words = !judgement.passed();
  data article = entry_of(checked);
  article.set("counts", messages::exercise_counts(judgement.cases_passed, judgement.cases_total,
                                                  judgement.passed() ? possible : 0.0, possible, is_judged(checked)));
  article.set("message", text_or_nothing(wants_words ? judgement.message : ""));
  article.set("next_step", text_or_nothing(wants_words ? judgement.next_step : ""));
  article.set("findings", findings_of(checked));
  article.set("diagnoses", diagnoses_of(checked, headings));
  article.set("failure", text_or_nothing(judgement.first_failure && checked.reference != nullptr
                                             ? joined(describe_failure(*checked.reference, judgement))
                                             : ""));
  article.set("printed", text_or_nothing(checked.observation.printed));
  article.set("compiler", text_or_nothing(checked.observation.refusal_details));
  article.set("source", text_or_nothing(reported.source));
  data picture(false);
  if (!reported.picture.empty()) {
    picture = data();
    picture.set("data", base64(reported.picture));
    picture.set("description", shown(reported.picture_description));
  }
  // What passed is folded away, so that what needs a reader stands out.
  article.set("open_picture", judgement.passed() ? data(false) : picture);
  article.set("folded_picture", judgement.passed() ? picture : data(false));
  return article;
}

/// A diagnosis, or what was found in the file, says more than the general advice for its verdict.
std::string step_of(const Checked& checked, const std::map<std::string, std::string>& headings) {
  if (checked.judgement.diagnoses.empty()) {
    const std::vector<Finding>& findings = checked.observation.findings;
    if (findings.empty()) return checked.judgement.next_step;
    return messages::at_line(findings.front().line, findings.front().sentence);
  }
  const Diagnosis& diagnosis = checked.judgement.diagnoses.front();
  const std::string place = place_of(diagnosis, checked, headings);
  return place.empty() ? diagnosis.message : messages::read_about(diagnosis.message, place);
}

/// What is worth doing first: mend in course order, then begin what is not begun.
data steps_of(const ReportedCourse& reported) {
  data steps{data::type::list};
  const auto add = [&](const Checked* about, const std::string& text) {
    data step;
    step.set("link", about == nullptr ? data(false) : data(link_to(*about)));
    step.set("exercise", about == nullptr ? "" : shown(about->exercise.name()));
    step.set("text", shown(text));
    steps << step;
  };
  std::size_t to_mend = 0;
  const Checked* first_not_started = nullptr;
  bool all_passed = true;
  for (const ReportedExercise& exercise : reported.exercises) {
    const Checked& checked = exercise.checked;
    all_passed = all_passed && checked.judgement.passed();
    if (!is_started(checked)) {
      if (first_not_started == nullptr) first_not_started = &checked;
    } else if (is_judged(checked) && !checked.judgement.passed()) {
      if (++to_mend <= most_steps) add(&checked, step_of(checked, reported.headings));
    }
  }
  if (to_mend > most_steps) add(nullptr, messages::more_to_mend(to_mend - most_steps));
  if (first_not_started != nullptr)
    add(nullptr,
        first_not_started->exercise.name() + ": " + messages::begin_with(first_not_started->exercise.entry->task));
  if (all_passed) add(nullptr, messages::everything_passed());
  return steps;
}

/// A lecture as the exercises show it: those of the page that belong to one card.
struct ReportedLecture {
  const Card* card = nullptr;
  std::vector<const ReportedExercise*> exercises;
};

std::vector<ReportedLecture> lectures_of(const ReportedCourse& reported) {
  std::vector<ReportedLecture> lectures;
  for (const ReportedExercise& exercise : reported.exercises) {
    const Card* card = exercise.checked.exercise.card;
    if (lectures.empty() || lectures.back().card != card) lectures.push_back({card, {}});
    lectures.back().exercises.push_back(&exercise);
  }
  return lectures;
}

}  // namespace

std::string report_page(const ReportedCourse& reported) {
  data page;
  data words;
  for (const auto& [name, text] : messages::report_words()) words.set(name, text);
  page.set("words", words);
  page.set("style", report_page_style);
  page.set("title", shown(messages::report_title(reported.student)));
  page.set("when", shown(messages::report_date(reported.date, reported.seed)));

  Score score;
  double points_not_judged = 0.0;
  messages::VerdictCounts counts;
  for (const ReportedExercise& exercise : reported.exercises) {
    const Checked& checked = exercise.checked;
    score.add(checked);
    if (!is_judged(checked)) {
      ++counts.not_judged;
      points_not_judged += checked.exercise.entry->points;
    } else if (checked.judgement.passed()) {
      ++counts.passed;
    } else if (is_started(checked)) {
      ++counts.to_mend;
    } else {
      ++counts.not_started;
    }
  }
  page.set("score", messages::report_score(score.points, score.possible));
  page.set("summary", messages::report_summary(counts));
  page.set("not_judged",
           text_or_nothing(counts.not_judged == 0 ? "" : messages::not_judged(counts.not_judged, points_not_judged)));
  page.set("picture_trouble", text_or_nothing(reported.picture_trouble));
  page.set("steps", steps_of(reported));

  data lectures{data::type::list};
  data not_started{data::type::list};
  for (const ReportedLecture& each : lectures_of(reported)) {
    Score lecture_score;
    data entries{data::type::list};
    data articles{data::type::list};
    std::vector<std::string> idle;
    for (const ReportedExercise* exercise : each.exercises) {
      lecture_score.add(exercise->checked);
      entries << entry_of(exercise->checked);
      if (is_started(exercise->checked)) {
        articles << article_of(*exercise, reported.headings);
      } else {
        idle.push_back(exercise->checked.exercise.name());
      }
    }
    const std::string heading = shown(messages::lecture_heading(each.card->lecture, each.card->title));
    data lecture;
    lecture.set("heading", heading);
    lecture.set("score", messages::report_score(lecture_score.points, lecture_score.possible));
    lecture.set("exercises", entries);
    lecture.set("has_articles", !articles.is_empty_list());
    lecture.set("articles", articles);
    lectures << lecture;
    if (!idle.empty()) {
      data entry;
      entry.set("heading", heading);
      entry.set("names", shown(fmt::format("{}", fmt::join(idle, ", "))));
      not_started << entry;
    }
  }
  page.set("lectures", lectures);
  page.set("has_not_started", !not_started.is_empty_list());
  page.set("not_started", not_started);

  kainjow::mustache::mustache form{report_page_template};
  const std::string text = form.render(page);
  if (!form.is_valid()) throw std::logic_error(messages::report_template_damaged(form.error_message()));
  return text;
}

}  // namespace workbook
