#include "checker/course/course.hpp"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

namespace workbook {

using nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Review, day, verdict)

namespace {

constexpr int progress_format = 1;

}  // namespace

void Progress::read() {
  std::error_code problem;
  if (!fs::exists(file_, problem)) return;
  try {
    const json document = json::parse(read_file(file_).value_or(""));
    if (document.at("format").get<int>() != progress_format) throw std::runtime_error("format");
    std::map<std::string, Practice> known;
    for (const auto& [exercise, entry] : document.at("exercises").get_ref<const json::object_t&>()) {
      Practice& one = known[exercise];
      if (entry.contains("verdict")) {
        one.verdict = entry.at("verdict");
        one.source = entry.at("source");
      }
      one.values = entry.value("values", "");
      one.wrong_tries = entry.value("wrong_tries", 0);
      one.passed_on = entry.value("passed_on", "");
      one.reviews = entry.value("reviews", std::vector<Review>());
      if (entry.contains("answered_right")) one.answered_right = entry.at("answered_right").get<bool>();
      if (entry.contains("hints")) one.hints_shown = entry.at("hints").get_ref<const json::number_unsigned_t&>();
    }
    known_ = std::move(known);
    last_ = document.value("last", last_);
  } catch (const std::exception&) {
    const fs::path aside = free_name(file_.string() + ".damaged");
    fs::rename(file_, aside, problem);
    warning_ = problem ? fmt::format(
                             "Your progress file {} is damaged and cannot be renamed; make its folder "
                             "writable. Your exercises are untouched.",
                             file_.string())
                       : fmt::format(
                             "Your progress file was damaged; it is kept as {} and counting starts again. "
                             "Your exercises are untouched.",
                             aside.string());
  }
}

template <class Change>
void Progress::change(const Change& something) {
  // A hint may be asked for while a check runs: each changes only what is its own. Where a folder cannot be locked,
  // both are still written whole, one after the other.
  std::error_code problem;
  fs::create_directories(file_.parent_path(), problem);
  const Descriptor folder(::open(file_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder) ::flock(folder.number(), LOCK_EX);
  read();
  something();
  json exercises = json::object();
  for (const auto& [exercise, one] : known_) {
    if (!one.verdict.empty()) exercises[exercise] = {{"verdict", one.verdict}, {"source", one.source}};
    if (one.hints_shown > 0) exercises[exercise]["hints"] = one.hints_shown;
    if (!one.values.empty()) exercises[exercise]["values"] = one.values;
    if (one.wrong_tries > 0) exercises[exercise]["wrong_tries"] = one.wrong_tries;
    if (!one.passed_on.empty()) exercises[exercise]["passed_on"] = one.passed_on;
    if (!one.reviews.empty()) exercises[exercise]["reviews"] = one.reviews;
    if (one.answered_right) exercises[exercise]["answered_right"] = *one.answered_right;
  }
  json document = {{"format", progress_format}, {"exercises", exercises}};
  if (!last_[0].empty()) document["last"] = last_;
  if (!write_file(file_, document.dump(2) + "\n").empty())
    warning_ = fmt::format(
        "Your progress could not be saved in {}; make that folder writable. The verdict above is valid all the same.",
        file_.string());
}

bool Progress::remember(const std::string& exercise, const std::string& verdict, const std::string& source,
                        const std::string& values) {
  bool is_repeated = false;
  change([&] {
    Practice& one = known_[exercise];
    is_repeated = !values.empty() && values == one.values && one.source != fingerprint(source);
    one.wrong_tries += !values.empty() && one.source != fingerprint(source) ? 1 : 0;
    one.verdict = verdict;
    one.source = fingerprint(source);
    one.values = values;
    if (verdict != "not_started") last_ = {exercise, verdict, current_day()};
    if (verdict == "passed" && one.passed_on.empty()) one.passed_on = current_day();
  });
  return is_repeated;
}

int Progress::wrong_tries_before(const std::string& exercise, const std::string& source) const {
  const Practice one = of(exercise);
  return one.wrong_tries - (!one.values.empty() && one.source == source ? 1 : 0);
}

void Progress::begin_review(const std::string& exercise) {
  change([&] {
    std::vector<Review>& reviews = known_[exercise].reviews;
    if (reviews.empty() || !reviews.back().verdict.empty()) reviews.push_back({current_day(), ""});
  });
}

void Progress::remember_review(const std::string& exercise, const std::string& verdict) {
  change([&] {
    std::vector<Review>& reviews = known_[exercise].reviews;
    if (reviews.empty()) reviews.emplace_back();
    reviews.back().day = current_day();
    if (reviews.back().verdict.empty()) reviews.back().verdict = verdict;
  });
}

void Progress::remember_answer(const std::string& exercise, bool is_right) {
  change([&] {
    std::optional<bool>& first = known_[exercise].answered_right;
    first = first.value_or(is_right);
  });
}

std::string current_day() {
  if (const char* given = std::getenv("WORKBOOK_TODAY")) return given;
  const std::time_t now = std::time(nullptr);
  std::string day(std::size("YYYY-MM-DD"), '\0');
  day.resize(std::strftime(day.data(), day.size(), "%Y-%m-%d", std::localtime(&now)));
  return day;
}

void Progress::forget(const std::string& exercise) {
  if (known_.contains(exercise)) change([&] { known_.erase(exercise); });
}

void Progress::remember_hints(const std::string& exercise, std::size_t count) {
  change([&] { known_[exercise].hints_shown = count; });
}

std::size_t ProgressSummary::count_passed(const std::string& lecture) const {
  return static_cast<std::size_t>(std::ranges::count_if(exercises, [&](const Exercise& exercise) {
    return passes(exercise) && (lecture.empty() || exercise.lecture() == lecture);
  }));
}

const Exercise* ProgressSummary::next() const {
  const auto found = std::ranges::find_if_not(exercises, [&](const Exercise& exercise) { return passes(exercise); });
  return found == exercises.end() ? nullptr : &*found;
}

ProgressSummary summary_of(const Course& course, const Progress& progress) {
  ProgressSummary summary{course.exercises(), {}};
  for (const Exercise& exercise : summary.exercises)
    if (progress.passed(exercise.name(), file_fingerprint(course.student_file(exercise))))
      summary.passed.insert(exercise.name());
  return summary;
}

}  // namespace workbook
