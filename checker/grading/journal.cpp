#include "checker/grading/grading.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <boost/iostreams/device/file_descriptor.hpp>
#include <boost/iostreams/stream.hpp>

#include <algorithm>
#include <cstring>

namespace workbook {
namespace {

using nlohmann::ordered_json;

// {"sum":"0123456789abcdef","entry":{"key":"0123456789abcdef", …}}, and the end of the line.
constexpr std::string_view before_sum = R"({"sum":")", before_entry = R"(","entry":)", before_key = R"({"key":")",
                           before_picture = R"(,"picture":")";
constexpr const char* seed_key = "seed_of_the_case";  // as long as a hash, and none
constexpr std::size_t hash_size = 16, entry_at = before_sum.size() + hash_size + before_entry.size();

std::string_view entry_of(std::string_view line) {
  if (line.size() < entry_at + before_key.size() + hash_size + 2 || !line.starts_with(before_sum)) return {};
  const std::string_view entry = line.substr(entry_at, line.size() - entry_at - 1);
  return fingerprint(entry) == line.substr(before_sum.size(), hash_size) ? entry : std::string_view{};
}

std::string line_of(const ordered_json& entry) {
  const std::string text = entry.dump();
  return fmt::format("{}{}{}{}}}", before_sum, fingerprint(text), before_entry, text);
}

[[noreturn]] void fail(const fs::path& file, const char* what) {
  throw std::runtime_error(fmt::format("{} cannot be {} ({}).", shown_path(file), what, std::strerror(errno)));
}

}  // namespace

Journal::Journal(fs::path file, Access access, const std::string& forgotten) : file_(std::move(file)) {
  const int flags = access == Access::write ? O_RDWR | O_CREAT | O_APPEND : O_RDONLY;
  descriptor_ = Descriptor(::open(file_.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, 0600));
  if (!descriptor_) fail(file_, "opened");
  // It holds what students have handed in.
  if (access == Access::write && ::fchmod(descriptor_.number(), 0600) != 0) fail(file_, "kept from other users");
  // A POSIX lock: unlike that of flock it is not inherited by forked jobs.
  struct flock lock {};
  lock.l_type = access == Access::write ? F_WRLCK : F_RDLCK;
  if (::fcntl(descriptor_.number(), F_SETLK, &lock) != 0)
    throw GradingError(fmt::format("Another `grade` is at work in {}.", shown_path(file_.parent_path())));
  // The file is not opened once more to be read: to close it would end the lock.
  namespace io = boost::iostreams;
  const std::string mark = fmt::format(R"("verdict":"{}","content":)", forgotten);  // after names of our own only
  io::stream<io::file_descriptor_source> lines(descriptor_.number(), io::never_close_handle);
  for (std::string line; std::getline(lines, line) && !lines.eof();) {
    const std::string_view entry = entry_of(line);
    if (entry.empty())
      ++damaged_;
    else if (entry.find(mark) == std::string_view::npos)
      places_[std::string(entry.substr(before_key.size(), hash_size))] = {end_, line.size()};
    end_ += static_cast<std::int64_t>(line.size()) + 1;
  }
  if (lines.bad()) fail(file_, "read");
  if (access == Access::write && ::ftruncate(descriptor_.number(), end_) != 0) fail(file_, "written");
}

std::string Journal::line_at(const Place& place) const {
  std::string line(place.size, '\0');
  const ssize_t got = ::pread(descriptor_.number(), line.data(), line.size(), place.offset);
  return got == static_cast<ssize_t>(line.size()) ? line : "";
}

std::optional<CheckResult> Journal::find(const std::string& key, const std::string& content) {
  if (const auto read = passed_.find(key); read != passed_.end() && read->second.first == content)
    return read->second.second;
  const auto place = places_.find(key);
  if (place == places_.end()) return std::nullopt;
  try {
    const std::string line = line_at(place->second);
    const std::string_view text = entry_of(line);
    const std::size_t picture = text.find(before_picture);  // large, and nothing in it needs to be read
    const auto entry = nlohmann::json::parse(std::string(text.substr(0, picture)) + "}");
    // The key is a short hash, for which somebody may have made two files.
    if (entry.at("content").get<std::string>() != base64(content)) return std::nullopt;
    CheckResult checked = read_result(from_base64(entry.at("result").get<std::string>()));
    checked.picture = text.substr(0, text.size() - 2).substr(picture + before_picture.size());  // without "}
    if (checked.judgement.verdict == Verdict::passed) passed_.insert_or_assign(key, std::pair(content, checked));
    return checked;
  } catch (const std::exception&) {  // of another version, or damaged: it is judged again
    return std::nullopt;
  }
}

void Journal::append(const std::string& key, const std::string& content, CheckResult checked) {
  const std::string picture = std::exchange(checked.picture, "");
  const ordered_json entry = {{"key", key},
                              {"exercise", checked.name()},
                              {"verdict", to_string(checked.judgement.verdict)},
                              {"content", base64(content)},
                              {"result", base64(written_result(checked))},
                              {"picture", picture}};
  write(key, line_of(entry));
  if (Clock::now() - synced_ > std::chrono::seconds(1)) sync();
}

std::optional<std::uint64_t> Journal::seed() const {
  const auto place = places_.find(seed_key);
  if (place == places_.end()) return std::nullopt;
  return nlohmann::json::parse(entry_of(line_at(place->second))).at("seed").get<std::uint64_t>();
}

void Journal::remember_seed(std::uint64_t seed) {
  if (this->seed() == seed) return;
  write(seed_key, line_of({{"key", seed_key}, {"seed", seed}}));
  sync();
}

void Journal::merge(const Journal& other) {
  for (const auto& [key, place] : other.places_)
    if (const std::string line = has(key) ? "" : other.line_at(place); !line.empty()) write(key, line);
  damaged_ += other.damaged_;
}

void Journal::write(const std::string& key, const std::string& line) {
  const std::string bytes = line + "\n";
  if (::write(descriptor_.number(), bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    const int reason = errno;
    [[maybe_unused]] const int unused = ::ftruncate(descriptor_.number(), end_);
    errno = reason;
    fail(file_, "written");
  }
  places_[key] = {end_, line.size()};
  end_ += static_cast<std::int64_t>(bytes.size());
}

void Journal::sync() {
  if (::fdatasync(descriptor_.number()) != 0) fail(file_, "written");
  synced_ = Clock::now();
}

}  // namespace workbook
