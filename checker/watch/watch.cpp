#include "checker/watch/watch.hpp"

#include "checker/base/printable.hpp"
#include "checker/course/progress.hpp"
#include "checker/course/progress_summary.hpp"
#include "checker/course/stub.hpp"
#include "checker/messages/watching.hpp"

#include <fmt/format.h>

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <numeric>
#include <string_view>
#include <utility>

namespace workbook {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_notices = 8;

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0' && std::string_view(value) != "0";
}

FileChanges::Events events_wanted() {
  return is_set("WORKBOOK_POLL") ? FileChanges::Events::unwanted : FileChanges::Events::wanted;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string ending_with_newline(const std::string& text) {
  return text.empty() || text.ends_with('\n') ? text : text + '\n';
}

long seconds_since(Clock::time_point begun) {
  return std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - begun).count();
}

std::vector<fs::path> files_of(const Course& course) {
  std::vector<fs::path> files;
  for (const Exercise& exercise : course.exercises()) files.push_back(course.student_file(exercise));
  return files;
}

std::vector<std::size_t> places(const std::vector<Exercise>& some, const std::vector<Exercise>& all) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto same = [&](const Exercise& each) { return each.entry == all[i].entry; };
    if (std::any_of(some.begin(), some.end(), same)) result.push_back(i);
  }
  return result;
}

}  // namespace

Watch::Watch(const Course& course, fs::path course_file, const WatchedPart& part)
    : course_(course),
      course_file_(std::move(course_file)),
      exercises_(course.exercises()),
      files_(files_of(course)),
      everything_(exercises_.size()),
      part_(places(part.exercises, exercises_)),
      part_name_(part.name),
      passed_here_(exercises_.size()),
      judged_(exercises_.size()),
      doubtful_(exercises_.size()),
      console_(Console::of_standard_output()),
      on_screen_(can_be_drawn_on() && !console_.plain()),
      changes_(files_, events_wanted()) {
  std::iota(everything_.begin(), everything_.end(), std::size_t{0});
  if (!on_screen_) print(words_of_keys());
  read_progress();
  if (is_set("WORKBOOK_POLL")) notice(console_.wrapped(messages::polling_wanted()));
  const bool one_exercise = part_.size() == 1 && part_name_.empty();
  if (one_exercise) part_ = everything_;  // it is where the way through the course begins
  const auto next = std::find_if(part_.begin(), part_.end(), [&](std::size_t index) { return !passed_[index]; });
  if (one_exercise) {
    go_to(places(part.exercises, exercises_).front(), Reason::asked);
  } else if (next != part_.end()) {
    go_to(*next, Reason::arrived);
  } else {
    current_ = part_.front();
    verdict(console_.wrapped(messages::all_pass(part_name_, part_.size())));
  }
}

void Watch::run() {
  struct Screen {
    explicit Screen(Watch& shown) : watch(shown) {
      if (watch.on_screen_) watch.begin_screen();
    }
    ~Screen() {
      if (watch.on_screen_) watch.leave_screen();
    }
    Watch& watch;
  };
  {
    const Screen screen(*this);
    while (!over_) {
      on_changes();
      begin_next_check();
      if (changed_) draw();
      if (!over_) wait();
    }
    check_.reset();
    request_.reset();
  }
  const auto next = next_after(current_, everything_);
  print(messages::goodbye(count_passed(), exercises_.size(),
                          passed_[current_] && next ? name(*next)
                          : passed_[current_]       ? ""
                                                    : name(current_)));
}

// --- what comes in

void Watch::wait() {
  Clock::time_point until = changes_.next_look();
  if (check_ || request_) {
    // To count the seconds.
    const Clock::time_point begun = check_ ? check_->process->begun() : request_->process->begun();
    until = std::min(until, begun + std::chrono::seconds(seconds_since(begun) + 1));
  }
  enum Source { signals, keys, files, check, request, reader, count };
  std::array<pollfd, count> sources{};
  sources[signals] = {signals_.descriptor(), POLLIN, 0};
  sources[keys] = {keyboard_.has_keyboard() ? STDIN_FILENO : -1, POLLIN, 0};
  sources[files] = {changes_.descriptor(), POLLIN, 0};
  sources[check] = {check_ ? check_->process->descriptor() : -1, POLLIN, 0};
  sources[request] = {request_ ? request_->process->descriptor() : -1, POLLIN, 0};
  sources[reader] = {STDOUT_FILENO, 0, 0};  // only whether it is still there
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
  const int ready = ::poll(sources.data(), sources.size(), static_cast<int>(std::clamp<long>(left, 0, 60'000)));
  if (ready <= 0) {
    if (check_ || request_) changed_ = true;
    const bool takes_long = check_ && seconds_since(check_->process->begun()) >= 1;
    if (!on_screen_ && takes_long && !std::exchange(check_->said, true) && ::isatty(STDOUT_FILENO) != 0)
      print(words_of_check());
    return;
  }
  if (sources[reader].revents != 0) over_ = true;
  if (sources[signals].revents != 0) on_signals();
  if (sources[keys].revents != 0) on_keys();
  if (sources[request].revents != 0 && request_ && request_->process->collect()) finish_request();
  if (sources[check].revents != 0 && check_ && check_->process->collect()) finish_check();
}

void Watch::on_signals() {
  for (const int number : signals_.take()) {
    switch (number) {
      case SIGWINCH:
        console_ = Console::of_standard_output();
        if (on_screen_) write_out("\033[2J");
        changed_ = true;
        break;
      case SIGTSTP:
        if (on_screen_) leave_screen();
        keyboard_.give_back();
        Signals::stop_as_usual();
        keyboard_.take();
        if (on_screen_) begin_screen();
        break;
      case SIGCONT:
        keyboard_.take();
        changed_ = true;
        break;
      default:
        over_ = true;
    }
  }
}

void Watch::on_keys() {
  std::array<char, 256> buffer;
  const ssize_t got = ::read(STDIN_FILENO, buffer.data(), buffer.size());
  if (got < 0 && (errno == EINTR || errno == EAGAIN)) return;
  if (got <= 0) {
    over_ = true;  // the terminal is gone
    return;
  }
  for (const Key& key : key_reader_.read({buffer.data(), static_cast<std::size_t>(got)})) on_key(key);
}

void Watch::on_key(const Key& key) {
  remark_.clear();
  changed_ = true;
  const auto page = static_cast<long>(std::max<std::size_t>(layout_.body_shown, 2) - 1);
  switch (key.action) {
    case Action::hint:
    case Action::list:
    case Action::plot:
    case Action::compiler:
      return begin_request(key.action);
    case Action::next:
      notices_.clear();
      return go_on_by_key();
    case Action::back:
      if (current_ > 0) {
        notices_.clear();
        return go_to(current_ - 1, Reason::asked);
      }
      remark_ = messages::first_of_the_course();
      break;
    case Action::again:
      notices_.clear();
      return check_again();
    case Action::quit:
      over_ = true;
      break;
    case Action::down:
      return scroll(1);
    case Action::up:
      return scroll(-1);
    case Action::page_down:
      return scroll(page);
    case Action::page_up:
      return scroll(-page);
    case Action::unknown:
      remark_ = messages::unknown_key(key.name);
  }
  if (!on_screen_ && !remark_.empty()) print(key.action == Action::unknown ? remark_ + " " + words_of_keys() : remark_);
}

void Watch::on_changes() {
  for (const std::size_t index : changes_.collect()) on_saved(index);
  if (changes_.trouble() != trouble_) {
    trouble_ = changes_.trouble();
    notice(console_.wrapped(messages::no_events(trouble_)));
  }
  const std::vector<fs::path> missing = changes_.missing_folders();
  if (missing == missing_folders_) return;
  const auto contains = [](const std::vector<fs::path>& list, const fs::path& one) {
    return std::find(list.begin(), list.end(), one) != list.end();
  };
  for (const fs::path& folder : missing) {
    if (!on_screen_ && !contains(missing_folders_, folder)) print(messages::folder_gone(printable(folder.string())));
  }
  for (const fs::path& folder : missing_folders_) {
    if (!on_screen_ && !contains(missing, folder)) print(messages::folder_back(printable(folder.string())));
  }
  missing_folders_ = missing;
  changed_ = true;
}

void Watch::on_saved(std::size_t index) {
  const std::string content = fingerprint(file(index));
  const bool only_again = std::exchange(doubtful_[index], {}) == content && !content.empty();
  if (check_ && check_->wanted.index == index && check_->fingerprint == content) {
    check_->wanted.reason = Reason::saved;
    if (!only_again && current_ != index) show(index);
    return;
  }
  if (judged_[index] == content && !content.empty()) return;
  if (!only_again && !check_ && waiting_.empty()) notices_.clear();
  // Nobody wants to know how an older version of the file does, nor what nobody has saved.
  if (check_ && (check_->wanted.index == index || check_->wanted.reason != Reason::saved)) check_.reset();
  std::erase_if(waiting_, [&](const Wanted& each) { return each.reason != Reason::saved || each.index == index; });
  waiting_.push_front({index, Reason::saved, content});
  if (!only_again) show(index);
}

/// What was saved last is what the student waits for; verdicts on other files become notices.
void Watch::show(std::size_t index) {
  const FileStamp stamp = stamp_of(file(index));
  const bool noticed_late = stamp.exists && stamp.saved < shown_since_;
  const bool clock_was_put_back = shown_since_ > std::chrono::system_clock::now().time_since_epoch();
  if (noticed_late && !clock_was_put_back) return;
  shown_since_ = stamp.saved;
  current_ = index;
  remark_.clear();
  request_.reset();
  verdict_.clear();
  panel_.clear();
  first_row_ = 0;
  changed_ = true;
}

// --- checks and other commands

void Watch::begin_next_check() {
  while (!check_ && !waiting_.empty()) {
    const Wanted wanted = waiting_.front();
    waiting_.pop_front();
    changed_ = true;
    Check check{wanted, stamp_of(file(wanted.index)), fingerprint(file(wanted.index)), nullptr, false};
    judged_[wanted.index].clear();
    const bool saved_since = wanted.reason == Reason::saved && check.fingerprint != wanted.content;
    if (saved_since && current_ != wanted.index) show(wanted.index);
    try {
      check.process = std::make_unique<CheckerProcess>(course_file_,
                                                       std::vector<std::string>{"check", name(wanted.index)}, console_);
      check_ = std::move(check);
    } catch (const LaunchError& problem) {
      verdict(console_.wrapped(messages::check_cannot_start(name(wanted.index), problem.what())));
    }
  }
}

void Watch::finish_check() {
  const Check check = std::move(*check_);
  check_.reset();
  changed_ = true;
  const std::size_t index = check.wanted.index;
  const ProcessEnd end = check.process->end();
  if (stamp_of(file(index)) != check.stamp) {
    // The file was written meanwhile: which of the versions was checked, nobody knows.
    doubtful_[index] = check.fingerprint;
    changes_.report_again(index);
    return;
  }
  judged_[index] = check.fingerprint;
  // It may be newer than what was reported. If the reported version comes back, that is a change.
  changes_.know(index, check.fingerprint);
  const bool passes = end.signal == 0 && end.exit_status == 0;
  passed_here_[index] = passes ? check.fingerprint : "";
  read_progress();

  std::string text = ending_with_newline(check.process->output());
  if (end.signal != 0) text += console_.wrapped(messages::check_died(name(index), end.signal)) + "\n";
  const bool stays = check.wanted.reason == Reason::asked;
  if (index != current_) {
    notice(passes || !on_screen_ ? text : first_line(text));
  } else if (passes && !stays) {
    notice(text);
    go_on_after_passing();
  } else {
    if (passes) text += console_.wrapped(messages::passes_already(name(index))) + "\n";
    verdict(text);
  }
}

void Watch::begin_request(Action action) {
  std::vector<std::string> arguments;
  if (action == Action::hint) arguments = {"hint", name(current_)};
  if (action == Action::list) arguments = {"list"};
  if (action == Action::plot) arguments = {"plot", name(current_), "--picture", "text"};
  if (action == Action::compiler) arguments = {"check", name(current_), "--full"};
  request_.reset();
  try {
    request_ = Request{action, current_, std::make_unique<CheckerProcess>(course_file_, arguments, console_)};
  } catch (const LaunchError& problem) {
    panel(console_.wrapped(messages::command_cannot_start(problem.what())));
  }
}

void Watch::finish_request() {
  const Request request = std::move(*request_);
  request_.reset();
  const ProcessEnd end = request.process->end();
  std::string text = ending_with_newline(request.process->output());
  if (end.signal != 0) text += console_.wrapped(messages::command_died(end.signal)) + "\n";
  panel(text);
}

// --- from exercise to exercise

void Watch::go_to(std::size_t index, Reason reason) {
  forget_what_is_not_owed();
  current_ = index;
  verdict(introduction(course_, exercises_[index], messages::label_of_exercise(passed_[index]), console_));
  // A stub has no verdict worth waiting for.
  const bool runs_already = check_ && check_->wanted.index == index;
  if (!runs_already && is_begun(file(index))) waiting_.push_back({index, reason, ""});
}

void Watch::check_again() {
  if (check_ && check_->wanted.index == current_) return;
  forget_what_is_not_owed();
  verdict_.clear();
  waiting_.push_front({current_, Reason::asked, ""});
}

/// Before something else is looked at. A saved file keeps its right to a verdict.
void Watch::forget_what_is_not_owed() {
  std::erase_if(waiting_, [](const Wanted& each) { return each.reason != Reason::saved; });
  if (check_ && check_->wanted.reason != Reason::saved) check_.reset();
  request_.reset();
  panel_.clear();
}

void Watch::go_on_after_passing() {
  if (const auto next = next_after(current_, part_)) return go_to(*next, Reason::arrived);
  verdict(console_.wrapped(messages::all_pass(part_name_, part_.size())));
}

void Watch::go_on_by_key() {
  auto next = next_after(current_, part_);
  if (!next) next = next_after(current_, everything_);
  if (next) return go_to(*next, Reason::arrived);
  const bool at_the_last = !passed_[current_];
  verdict(console_.wrapped(at_the_last ? messages::last_one_left(name(current_))
                                       : messages::all_pass("", exercises_.size())));
}

/// The next one in the order of the course that does not pass; after the last comes the first.
std::optional<std::size_t> Watch::next_after(std::size_t index, const std::vector<std::size_t>& among) const {
  const auto begin = std::upper_bound(among.begin(), among.end(), index);
  std::vector<std::size_t> in_turn(begin, among.end());
  in_turn.insert(in_turn.end(), among.begin(), begin);
  for (const std::size_t each : in_turn) {
    if (each != index && !passed_[each]) return each;
  }
  return std::nullopt;
}

void Watch::read_progress() {
  const Progress progress(course_.progress_file());
  passed_ = standing_of(course_, progress).passed;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (!passed_here_[i].empty() && passed_here_[i] == fingerprint(files_[i])) passed_[i] = true;
  }
  if (!progress.warning().empty()) notice(console_.wrapped(progress.warning()));
}

std::size_t Watch::count_passed() const {
  return static_cast<std::size_t>(std::count(passed_.begin(), passed_.end(), true));
}

// --- what is shown

void Watch::notice(const std::string& text) {
  notices_.push_back(text);
  changed_ = true;
  if (!on_screen_) print(text);
}

void Watch::verdict(const std::string& text) {
  verdict_ = ending_with_newline(text);
  first_row_ = 0;
  changed_ = true;
  if (!on_screen_) print(text);
}

void Watch::panel(const std::string& text) {
  panel_ = ending_with_newline(text);
  // If not everything fits, what was asked for comes first.
  first_row_ = folded(body_above_panel(), terminal_size().columns).size();
  changed_ = true;
  if (!on_screen_) print(text);
}

void Watch::print(const std::string& text) {
  if (!write_out(ending_with_newline(text))) over_ = true;
}

void Watch::scroll(long rows) {
  const long last = static_cast<long>(layout_.body_total - layout_.body_shown);
  first_row_ = static_cast<std::size_t>(std::clamp(std::min(static_cast<long>(first_row_), last) + rows, 0L, last));
  changed_ = true;
}

std::string Watch::body_above_panel() const {
  std::string body;
  for (const fs::path& folder : missing_folders_) {
    const std::string sentence = console_.wrapped(messages::folder_gone(printable(folder.string())));
    body += console_.styled(sentence, Style::warning) + "\n";
  }
  const std::size_t hidden = notices_.size() > most_notices ? notices_.size() - most_notices : 0;
  if (hidden > 0) body += messages::more_verdicts(hidden) + "\n";
  for (std::size_t i = hidden; i < notices_.size(); ++i) body += ending_with_newline(notices_[i]);
  if (!body.empty()) body += "\n";
  if (check_ && verdict_.empty()) body += words_of_check() + "\n";
  return body + verdict_ + (panel_.empty() ? "" : "\n");
}

std::string Watch::words_of_keys() const {
  return keyboard_.has_keyboard() ? fmt::format("{}", fmt::join(messages::keys(), " · ")) : messages::no_keyboard();
}

std::string Watch::words_of_check() const {
  return messages::checking(name(check_->wanted.index), seconds_since(check_->process->begun()));
}

Scene Watch::scene() const {
  Scene scene;
  scene.lecture = exercises_[current_].lecture();
  scene.exercise = name(current_);
  scene.passed = count_passed();
  scene.total = exercises_.size();
  scene.body = body_above_panel() + panel_;
  if (!remark_.empty()) {
    scene.state = console_.styled(remark_, Style::warning);
  } else if (check_ && !verdict_.empty()) {
    scene.state = words_of_check();
  } else if (request_ && (request_->action == Action::plot || request_->action == Action::compiler)) {
    scene.state = messages::working_for(name(request_->index), seconds_since(request_->process->begun()));
  }
  if (!check_ && waiting_.empty()) scene.idle = messages::waiting(name(current_));
  scene.keys = keyboard_.has_keyboard() ? messages::keys() : std::vector<std::string>{messages::no_keyboard()};
  scene.first_row = first_row_;
  return scene;
}

void Watch::draw() {
  changed_ = false;
  if (!on_screen_) return;
  layout_ = lay_out(scene(), terminal_size(), console_);
  std::string text = "\033[?25l\033[H";
  for (std::size_t i = 0; i < layout_.rows.size(); ++i) text += (i > 0 ? "\r\n\033[2K" : "\033[2K") + layout_.rows[i];
  if (!write_out(text)) over_ = true;
}

void Watch::begin_screen() {
  // What the terminal shows moves up and can still be scrolled back to.
  std::string text = "\r";
  for (std::size_t row = 1; row < terminal_size().rows; ++row) text += "\n";
  if (!write_out(text)) over_ = true;
  changed_ = true;
}

void Watch::leave_screen() { write_out(fmt::format("\033[{};1H\033[J\033[?25h", layout_.end_of_body + 1)); }

}  // namespace workbook
