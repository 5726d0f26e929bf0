/// @file
/// The watch: whatever exercise is saved is checked, and the verdict is shown in place.
#include "checker/commands/watch/watch.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/exam.hpp"

#include <poll.h>
#include <signal.h>

#include <algorithm>
#include <cstdlib>
#include <deque>

namespace workbook {

namespace {

std::vector<fs::path> files_of(const Course& course) {
  std::vector<fs::path> files;
  for (const Exercise& exercise : course.exercises()) files.push_back(course.student_file(exercise));
  return files;
}

/// Why an exercise is checked.
enum class Occasion {
  saved,    ///< a verdict is owed, come what may
  arrived,  ///< to see how the exercise stands that the watch has come to
  asked     ///< by a key, or by name: the exercise stays even if it passes
};

struct Wanted {
  std::size_t index = 0;
  Occasion occasion = Occasion::saved;
};

/// One loop waits for saved files, keys, signals, the running check and the plot. These two have processes of their
/// own: keys work meanwhile, and a save of the file that is being checked ends that check and begins another.
class Watch {
 public:
  /// @param name  where to begin: an exercise, or a lecture that the way leads through; "" for the whole course
  Watch(const Course& course, const std::string& name)
      : course_(course), context_(course), changes_(files_of(course), std::getenv("WORKBOOK_POLL") == nullptr) {
    const Exercise first = name.empty() ? exercises_.front() : course_.find(name).front();
    if (!on_screen_) print(keys_);
    const std::string& problem = changes_.events_missing();
    if (!problem.empty()) notice(fmt::format("The files are polled four times a second: {}.", problem));
    const Progress progress(course_.progress_file());
    notice(console_.wrapped(progress.warning()));
    const ProgressSummary summary = summary_of(course_, progress);
    for (const Exercise& exercise : exercises_) passed_.push_back(summary.passes(exercise));
    const bool is_exercise = first.name() == name;
    if (!name.empty() && !is_exercise) lecture_ = first.lecture();
    current_ =
        static_cast<std::size_t>(std::ranges::find(exercises_, first.entry, &Exercise::entry) - exercises_.begin());
    if (is_exercise || !passed_[current_]) {
      go_to(current_, is_exercise ? Occasion::asked : Occasion::arrived);
    } else {
      go_to_next(lecture_);
    }
  }
  ~Watch() {
    leave_screen();
    const auto open = passed_[current_] ? next_in("") : current_;
    print(open ? fmt::format("{} of {} exercises pass; next is {}.", count_passed(), exercises_.size(), name(*open))
               : fmt::format("All {} exercises pass.", exercises_.size()));
  }

  /// Until a key, a signal or the end of the terminal ends it.
  void run() {
    for (enter_screen(); !over_; wait()) {
      collect_changes();
      begin_next_check();
      if (on_screen_) draw();
    }
  }

 private:
  const std::string& name(std::size_t index) const { return exercises_[index].name(); }
  std::size_t count_passed() const { return static_cast<std::size_t>(std::ranges::count(passed_, true)); }

  // --- what comes in

  void wait() {
    std::array<pollfd, 6> sources = {{{terminal_.signals(), POLLIN, 0},
                                      {terminal_.has_keyboard() ? STDIN_FILENO : -1, POLLIN, 0},
                                      {STDOUT_FILENO, 0, 0},  // only whether it is still there
                                      {changes_.descriptor(), POLLIN, 0},
                                      {check_ ? check_->descriptor() : -1, POLLIN, 0},
                                      {plot_ ? plot_->descriptor() : -1, POLLIN, 0}}};
    // At most a second, which also counts those of a check.
    ::poll(sources.data(), sources.size(), milliseconds_until(changes_.next_look()));
    if (sources[0].revents != 0) handle_signals();
    if (sources[1].revents != 0) handle_keys();
    if (sources[2].revents != 0) over_ = true;
    if (over_) return;
    if (check_) collect_check();  // which may also be over because its time is
    if (plot_ && plot_->collect()) finish_plot();
  }

  void handle_signals() {
    for (const int number : terminal_.take_signals()) {
      if (number == SIGTSTP) {
        leave_screen();
        terminal_.stop();
        enter_screen();
      } else if (number == SIGCONT) {
        terminal_.take_keyboard();
      } else if (number != SIGWINCH) {
        over_ = true;
      }
    }
    console_ = Console::of_standard_output();
    drawn_.clear();
  }

  using Action = void (Watch::*)();

  void handle_keys() {
    static const std::map<std::string, Action> actions = {
        {"h", &Watch::show_hint}, {"l", &Watch::show_list},    {"p", &Watch::show_plot},   {"n", &Watch::go_on},
        {"b", &Watch::go_back},   {"c", &Watch::show_in_full}, {"r", &Watch::check_again}, {"q", &Watch::quit},
        {"\x03", &Watch::quit},   {"\x04", &Watch::quit}};
    const auto page = static_cast<long>(std::max<std::size_t>(layout_.body_shown, 2) - 1);
    const std::map<std::string, long> scroll = {{"j", 1},    {"\033[B", 1},     {"\033OB", 1},
                                                {"k", -1},   {"\033[A", -1},    {"\033OA", -1},
                                                {" ", page}, {"\033[6~", page}, {"\033[5~", -page}};
    const std::string typed = Terminal::read();
    if (typed.empty()) over_ = true;  // the terminal is gone
    typed_ += typed;
    for (const std::string& key : take_keys(typed_)) {
      remark_.clear();
      if (const auto action = actions.find(key); action != actions.end()) {
        (this->*action->second)();
      } else if (const auto rows = scroll.find(key); rows != scroll.end()) {
        first_row_ = static_cast<std::size_t>(std::max(static_cast<long>(first_row_) + rows->second, 0L));
      } else {
        const bool is_visible = static_cast<unsigned char>(key[0]) > ' ' && key[0] != 0x7f;
        say(remark_,
            fmt::format("{} does nothing; these do:", is_visible ? "The key “" + printable(key) + "”" : "That key"));
        if (!on_screen_) print(keys_);
      }
    }
  }

  void collect_changes() {
    for (const std::size_t index : changes_.collect()) handle_save(index);
    std::string missing;
    for (const fs::path& folder : changes_.missing_folders())
      missing +=
          console_.styled(fmt::format("The folder {} is missing: put it back.", shown_path(folder)), Style::warning) +
          "\n";
    const bool is_new = std::exchange(missing_, missing) != missing;
    if (is_new && !on_screen_) print(missing.empty() ? "No folder is missing any more." : missing);
  }

  /// What was saved last is what the student waits for; verdicts on other files become notices.
  void handle_save(std::size_t index) {
    if (!check_ && waiting_.empty()) notices_.clear();
    passed_[index] = false;
    // Nobody wants to know how an older version of the file does.
    if (check_ && checked_.index == index) check_.reset();
    std::erase_if(waiting_, [&](const Wanted& each) { return each.index == index; });
    come_to(index);
    waiting_.push_front({index, Occasion::saved});
  }

  // --- checks and plots

  void begin_next_check() {
    while (!check_ && !waiting_.empty()) {
      checked_ = waiting_.front();
      waiting_.pop_front();
      CheckTask task = check_task(course_, exercises_[checked_.index]);
      set_stage(task, Progress(course_.progress_file()));
      context_.forget_failures();  // what was damaged may be repaired by now
      try {
        check_.emplace(context_, task);
        if (!on_screen_ && ::isatty(STDOUT_FILENO) != 0) print(working("checking", checked_.index, check_->begun()));
      } catch (const std::exception& problem) {
        show(failed_check(
            task, fmt::format("It could not be started ({}): close some programs, then check again.", problem.what())));
      }
    }
  }

  /// The verdict is shown before its explanation, which may take a second longer.
  void collect_check() {
    if (check_->collect()) return finish_check();
    if (!on_screen_ || checked_.index != current_) return;
    if (auto verdict = check_->last_message()) result_ = std::move(*verdict);
  }

  void finish_check() {
    CheckResult checked = check_->result();
    check_.reset();
    if (checked.is_judged()) {
      // Written meanwhile: that verdict is on a version that is gone. Of a rejected file there is no text.
      if (checked.judgement.verdict != Verdict::rejected_file &&
          read_file(checked.task.file, largest_source).value_or("") != checked.source)
        return waiting_.push_front(checked_);
      passed_[checked_.index] = checked.judgement.passed();
      Progress progress(course_.progress_file());
      notice(console_.wrapped(remember(progress, checked)));
      notice(console_.wrapped(progress.warning()));
    }
    const bool passed = checked.judgement.passed();
    const bool is_current = checked_.index == current_;
    if (is_current && (!passed || checked_.occasion == Occasion::asked)) return show(std::move(checked));
    const std::string text = terminal_report(checked, course_, console_);
    notice(passed || !on_screen_ ? text : text.substr(0, text.find('\n')));
    if (is_current) go_to_next(lecture_);
  }

  void show(CheckResult checked) {
    result_ = std::move(checked);
    if (!on_screen_) print(report());
    if (result_->judgement.verdict == Verdict::wrong_value && !program_on_path("gnuplot").empty()) begin_plot(false);
  }

  std::string report() const {
    const bool is_pending = check_ && checked_.index == current_;
    return terminal_report(*result_, course_, console_, {full_, {}, terminal_.has_keyboard(), is_pending});
  }

  /// Beside the loop: no verdict waits for gnuplot. Shown in letters if it was asked for.
  void begin_plot(bool is_asked) {
    plot_is_asked_ = is_asked;
    try {
      plot_.emplace([this] { return plot(); }, std::chrono::seconds(60));
    } catch (const std::exception& problem) {
      panel(fmt::format("The plot could not be started ({}): close some programs, then press p.", problem.what()));
    }
  }

  std::string plot() {
    try {
      CheckTask task = check_task(course_, exercises_[current_]);
      task.is_always_drawn = true;
      task.is_explained = false;
      const bool is_asked = result_ && !result_->observation.sweep.empty();
      const CheckResult checked = is_asked ? *result_ : check_exercise(context_, task);
      if (!checked.is_judged()) return checked.judgement.message;
      const Overlay overlay = overlay_of(checked);
      const std::vector<fs::path> files = draw_overlay(overlay, course_.plots(), checked.name());
      std::string text = fmt::format("  Plot   {}\n", shown_path(files.front()));
      if (plot_is_asked_) text = letter_picture(overlay, course_.plots(), console_) + text;
      if (overlay.student.empty())
        text += console_.wrapped("Only the reference is drawn: your function returned no value.", 2) + "\n";
      return text;
    } catch (const std::exception& problem) {
      return console_.wrapped(problem.what(), 2);
    }
  }

  void finish_plot() {
    const std::string problem = plot_->finish();
    const std::string text = problem.empty() ? plot_->output() : fmt::format("There is no plot: {}.", problem);
    plot_.reset();
    if (plot_is_asked_) return panel(text);
    plot_text_ = text;
    if (!on_screen_) print(text);
  }

  // --- from exercise to exercise

  /// The next one in the order of the course that does not pass; after the last comes the first.
  std::optional<std::size_t> next_in(const std::string& lecture) const {
    for (std::size_t step = 1; step < exercises_.size(); ++step) {
      const std::size_t index = (current_ + step) % exercises_.size();
      if (exercises_[index].lecture().starts_with(lecture) && !passed_[index]) return index;
    }
    return std::nullopt;
  }

  void go_to_next(const std::string& lecture) {
    if (const auto next = next_in(lecture)) return go_to(*next, Occasion::arrived);
    come_to(current_);
    const auto count =
        std::ranges::count_if(exercises_, [&](const Exercise& each) { return each.lecture().starts_with(lecture); });
    say(text_, console_.wrapped(fmt::format("All {} exercises of {} pass. Every save is still checked{}.", count,
                                            lecture.empty() ? "the course" : lecture,
                                            lecture.empty() ? "" : "; n goes on with the rest of the course")));
  }

  /// Before something else is looked at. A saved file keeps its right to a verdict.
  void come_to(std::size_t index) {
    std::erase_if(waiting_, [](const Wanted& each) { return each.occasion != Occasion::saved; });
    if (check_ && checked_.occasion != Occasion::saved) check_.reset();
    plot_.reset();
    result_.reset();
    for (std::string* text : {&text_, &plot_text_, &panel_, &remark_}) text->clear();
    full_ = false;
    first_row_ = 0;
    current_ = index;
  }

  void go_to(std::size_t index, Occasion occasion) {
    come_to(index);
    say(text_, introduction(course_, exercises_[index], console_));
    // A stub has no verdict worth waiting for.
    const bool is_checked = check_ && checked_.index == index;
    if (!is_checked && is_begun(course_.student_file(exercises_[index]))) waiting_.push_back({index, occasion});
  }

  // --- keys

  void go_on() {
    notices_.clear();
    if (next_in(lecture_)) return go_to_next(lecture_);
    if (!next_in("") && !passed_[current_])
      return say(remark_, fmt::format("All others pass: {} is the last one.", name(current_)));
    go_to_next("");
  }

  void go_back() {
    if (current_ == 0) return say(remark_, "This is the first exercise of the course.");
    notices_.clear();
    go_to(current_ - 1, Occasion::asked);
  }

  void check_again() {
    const bool is_running = check_ && checked_.index == current_;
    if (is_running && !result_) return;
    if (is_running) check_.reset();  // its verdict is shown; what it still does is for that one
    notices_.clear();
    come_to(current_);
    waiting_.push_front({current_, Occasion::asked});
  }

  void show_in_full() {
    if (!result_) return say(remark_, fmt::format("There is no verdict on {} yet; r checks it.", name(current_)));
    full_ = !full_;
    first_row_ = 0;
    if (!on_screen_) print(report());
  }

  void show_plot() { begin_plot(true); }

  void show_list() {
    const Progress progress(course_.progress_file());
    panel(exercise_list(course_, progress, summary_of(course_, progress), console_));
  }

  void show_hint() {
    const Exercise& exercise = exercises_[current_];
    try {
      const std::vector<std::string> hints = read_hints(course_.hints_file(exercise));
      Progress progress(course_.progress_file());
      const std::size_t number = std::min(progress.of(exercise.name()).hints_shown + 1, hints.size());
      progress.remember_hints(exercise.name(), number);
      const std::string heading = fmt::format("Hint {} of {}", number, hints.size());
      const std::string notes = notes_place(course_, exercise, exercise.entry->notes, console_, 2);
      panel(fmt::format(
          "{}\n{}\n{}\n", console_.styled(heading, Style::strong), console_.wrapped(hints[number - 1], 2),
          number < hints.size() ? "h shows the next one." : "That was the last hint; read on in\n  " + notes));
      notice(console_.wrapped(progress.warning()));
    } catch (const CourseError& problem) {
      panel(console_.wrapped(problem.what()));
    }
  }

  void quit() { over_ = true; }

  // --- what is shown: on a screen in place, otherwise one below the other

  void write(const std::string& text) { over_ = !Terminal::write(text) || over_; }

  void print(const std::string& text) { write(text.ends_with('\n') ? text : text + "\n"); }

  void say(std::string& place, const std::string& text) {
    place = text;
    if (!on_screen_) print(text);
  }

  void notice(const std::string& text) {
    if (text.empty()) return;
    notices_.push_back(text);
    if (notices_.size() > 8) notices_.pop_front();  // the list shows them all
    if (!on_screen_) print(text);
  }

  void panel(const std::string& text) {
    panel_.clear();
    first_row_ = folded(body(), Terminal::size().columns).size();  // if not all fits, what was asked for comes first
    say(panel_, text);
  }

  std::string working(const std::string& what, std::size_t index, Clock::time_point begun) const {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - begun).count();
    return fmt::format("{} {} …{}", what, name(index), seconds < 1 ? "" : fmt::format(" {} s", seconds));
  }

  std::string body() const {
    std::string notices;
    for (const std::string& each : notices_) notices += each.ends_with('\n') ? each : each + "\n";
    std::string body = missing_;
    for (const std::string& part : {notices, result_ ? report() + plot_text_ : text_, panel_}) {
      if (!body.empty() && !part.empty()) body += body.ends_with('\n') ? "\n" : "\n\n";
      body += part;
    }
    return body;
  }

  void draw() {
    const Scene scene = {.lecture = exercises_[current_].lecture(),
                         .exercise = name(current_),
                         .passed = count_passed(),
                         .total = exercises_.size(),
                         .body = body(),
                         .state = !remark_.empty()          ? console_.styled(remark_, Style::warning)
                                  : check_                  ? working("checking", checked_.index, check_->begun())
                                  : plot_ && plot_is_asked_ ? working("drawing", current_, plot_->begun())
                                                            : "",
                         .idle = fmt::format("Waiting for a save of {}.", name(current_)),
                         .keys = keys_,
                         .first_row = first_row_};
    layout_ = lay_out(scene, Terminal::size(), console_);
    first_row_ = layout_.first_row;
    std::string text = "\033[?25l\033[H";
    for (std::size_t i = 0; i < layout_.rows.size(); ++i) text += (i > 0 ? "\r\n\033[2K" : "\033[2K") + layout_.rows[i];
    if (std::exchange(drawn_, text) != drawn_) write(text);
  }

  /// What the terminal shows moves up and can still be scrolled back to.
  void enter_screen() {
    if (on_screen_) write("\r" + std::string(Terminal::size().rows - 1, '\n'));
  }

  void leave_screen() {
    if (on_screen_) write(fmt::format("\033[{};1H\033[J\033[?25h", layout_.end_of_body + 1));
  }

  const Course& course_;
  CheckContext context_;
  const std::vector<Exercise> exercises_ = course_.exercises();
  std::string lecture_;
  std::vector<bool> passed_;  ///< as the files stand now
  std::size_t current_ = 0;   ///< what the screen is for

  Console console_ = Console::of_standard_output();
  const bool on_screen_ = Terminal::can_be_drawn_on() && !console_.plain();
  Terminal terminal_;
  const std::string keys_ = terminal_.has_keyboard() ? "h:hint l:list p:plot n:next b:back c:complete r:again q:quit"
                                                     : "Ctrl-C ends the watch.";
  FileChanges changes_;

  std::deque<Wanted> waiting_;
  Wanted checked_;  ///< by the check that runs, or ran last
  std::optional<CheckJob> check_;
  std::optional<ForkedJob> plot_;
  bool plot_is_asked_ = false;

  std::string missing_;  ///< folders
  std::deque<std::string> notices_;
  std::string text_;                   ///< in the place of a verdict
  std::optional<CheckResult> result_;  ///< on the current exercise
  bool full_ = false;                  ///< it is shown with all that the compiler says
  std::string plot_text_;              ///< below it
  std::string panel_;                  ///< what a key asked for
  std::string remark_;                 ///< about the last key
  std::string typed_;                  ///< the beginning of a key
  std::size_t first_row_ = 0;
  Layout layout_;
  std::string drawn_;
  bool over_ = false;
};

int watch(const Course& course, const std::string& name) {
  if (course.exercises().empty()) {
    fmt::print(stderr, "This course has no exercises, so there is nothing to watch.\n");
    return checker_failed;
  }
  Watch(course, name).run();
  return all_passed;
}

}  // namespace

Command watch_command() {
  const auto options = std::make_shared<std::string>();
  return {
      "watch",
      students,
      "Check every file as you save it\n\nStarts at the next exercise, or at the one that is named, and waits. Each "
      "time an exercise file is saved, its verdict replaces the one before; when it passes, the next exercise is "
      "shown. Keys: h hint, l list, p plot, n next, c all compiler messages, r check again, q quit.",
      {"watch", "watch 03", "watch inertia_of_points"},
      {name_parameter(*options)},
      with_options(options, &watch),
      [](const Course& course) { refuse_in_exam(course, course.exercises()); }};
}

}  // namespace workbook
