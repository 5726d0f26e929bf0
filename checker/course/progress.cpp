#include "checker/course/progress.hpp"

#include "checker/base/descriptor.hpp"
#include "checker/messages/progress.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace workbook {

namespace fs = std::filesystem;

namespace {

constexpr int current_format = 1;

/// The name itself, or the first of NAME.2, NAME.3, … that is free: what was set aside earlier stays too.
fs::path name_not_taken(const std::string& name) {
  std::error_code ignored;
  fs::path free = name;
  for (int number = 2; fs::exists(fs::symlink_status(free, ignored)); ++number)
    free = fmt::format("{}.{}", name, number);
  return free;
}

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
    const fs::path aside = name_not_taken(file_.string() + ".damaged");
    fs::rename(file_, aside, problem);
    warning_ = problem ? messages::damaged_progress_stays(file_.string())
                       : messages::damaged_progress_set_aside(aside.string());
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

  const auto fail = [this] { warning_ = messages::progress_not_saved(file_.string()); };
  std::error_code problem;
  const fs::path fresh = fmt::format("{}.{}", file_.string(), getpid());
  {
    std::ofstream out(fresh);
    out << document.dump(2) << '\n';
    if (!out) return fail();
  }
  fs::rename(fresh, file_, problem);
  if (problem) {
    fail();
    fs::remove(fresh, problem);
  }
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

std::string fingerprint(const fs::path& file) {
  std::error_code problem;
  if (!fs::is_regular_file(file, problem)) return "";
  std::ifstream in(file, std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a
  for (std::istreambuf_iterator<char> byte(in), end; byte != end; ++byte) {
    hash = (hash ^ static_cast<unsigned char>(*byte)) * 0x100000001b3ULL;
  }
  return in.bad() ? "" : fmt::format("{:016x}", hash);
}

}  // namespace workbook
