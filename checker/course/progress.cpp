#include "checker/course/progress.hpp"

#include "checker/base/descriptor.hpp"
#include "checker/base/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

namespace workbook {

namespace fs = std::filesystem;

namespace {

constexpr int current_format = 1;

}  // namespace

Progress::Progress(fs::path file) : file_(std::move(file)) { read(); }

void Progress::read() {
  std::error_code problem;
  if (!fs::exists(file_, problem)) return;
  try {
    std::ifstream in(file_);
    const auto document = nlohmann::json::parse(in);
    if (document.at("format").get<int>() != current_format) throw std::runtime_error("format");
    std::map<std::string, LastVerdict> verdicts;
    std::map<std::string, std::size_t> hints;
    using Object = nlohmann::json::object_t;
    for (const auto& [exercise, value] : document.at("exercises").get_ref<const Object&>()) {
      const auto& entry = value.get_ref<const Object&>();
      if (entry.contains("verdict")) {
        verdicts[exercise] = {entry.at("verdict").get<std::string>(), entry.at("source").get<std::string>()};
      }
      if (entry.contains("hints"))
        hints[exercise] = entry.at("hints").get_ref<const nlohmann::json::number_unsigned_t&>();
    }
    verdicts_ = std::move(verdicts);
    hints_ = std::move(hints);
  } catch (const std::exception&) {
    const fs::path aside = free_name(file_.string() + ".damaged");
    fs::rename(file_, aside, problem);
    warning_ = problem ? fmt::format(
                             "Your progress file {} is damaged and cannot be renamed; make its folder writable. "
                             "Your exercises are untouched.",
                             file_.string())
                       : fmt::format(
                             "Your progress file was damaged; it is kept as {} and counting starts again. Your "
                             "exercises are untouched.",
                             aside.string());
  }
}

void Progress::change(const std::function<void()>& something) {
  // A hint may be asked for while a check runs: each changes only what is its own. Where a folder cannot be locked,
  // both are still written whole, one after the other.
  std::error_code problem;
  fs::create_directories(file_.parent_path(), problem);
  const Descriptor folder(::open(file_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder) ::flock(folder.number(), LOCK_EX);
  read();
  something();
  write();
}

void Progress::write() {
  nlohmann::json exercises = nlohmann::json::object();
  for (const auto& [exercise, last] : verdicts_)
    exercises[exercise] = {{"verdict", last.verdict}, {"source", last.source}};
  for (const auto& [exercise, count] : hints_) {
    if (count > 0) exercises[exercise]["hints"] = count;
  }
  const nlohmann::json document = {{"format", current_format}, {"exercises", exercises}};

  if (!write_file(file_, document.dump(2) + "\n").empty())
    warning_ = fmt::format(
        "Your progress could not be saved in {}; make that folder writable. The verdict above is valid "
        "all the same.",
        file_.string());
}

void Progress::remember(const std::string& exercise, const LastVerdict& verdict) {
  change([&] { verdicts_[exercise] = verdict; });
}

void Progress::forget(const std::string& exercise) {
  if (!verdicts_.contains(exercise) && !hints_.contains(exercise)) return;
  change([&] {
    verdicts_.erase(exercise);
    hints_.erase(exercise);
  });
}

std::string Progress::verdict(const std::string& exercise) const {
  const auto found = verdicts_.find(exercise);
  return found == verdicts_.end() ? "" : found->second.verdict;
}

bool Progress::passed(const std::string& exercise, const std::string& source) const {
  const auto found = verdicts_.find(exercise);
  return found != verdicts_.end() && found->second.verdict == "passed" && found->second.source == source;
}

std::size_t Progress::hints_shown(const std::string& exercise) const {
  const auto found = hints_.find(exercise);
  return found == hints_.end() ? 0 : found->second;
}

void Progress::remember_hints(const std::string& exercise, std::size_t count) {
  change([&] { hints_[exercise] = count; });
}

std::size_t ProgressSummary::count_passed() const {
  return static_cast<std::size_t>(std::count(passed.begin(), passed.end(), true));
}

std::size_t ProgressSummary::count_passed(const std::string& lecture) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < exercises.size(); ++i) count += passed[i] && exercises[i].lecture() == lecture ? 1 : 0;
  return count;
}

const Exercise* ProgressSummary::next() const {
  const auto found = std::find(passed.begin(), passed.end(), false);
  return found == passed.end() ? nullptr : &exercises[static_cast<std::size_t>(found - passed.begin())];
}

ProgressSummary summary_of(const Course& course, const Progress& progress) {
  ProgressSummary summary{course.exercises(), {}};
  for (const Exercise& exercise : summary.exercises)
    summary.passed.push_back(progress.passed(exercise.name(), file_fingerprint(course.student_file(exercise))));
  return summary;
}

}  // namespace workbook
