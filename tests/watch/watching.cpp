// The watch on a terminal: edit, verdict, next; keys; all the ways in which it can end.
#include "checker/base/text.hpp"
#include "tests/support/system_calls.hpp"
#include "tests/watch/saving.hpp"
#include "tests/watch/terminal_session.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <sstream>

using namespace workbook::testing;
namespace fs = std::filesystem;
using std::chrono::milliseconds;

namespace {

const char* const wrong = "return k * x.squaredNorm();";
/// "checking spring_energy … 3 s"
bool shows_seconds(TerminalSession& watch) {
  return watch.until([&] { return bool(workbook::search(watch.screen(), "checking spring_energy … [0-9]+ s")); });
}

const char* const endless = "for (volatile int i = 0;;) i = i + 1;";
const char* const energy = "spring_energy";
const char* const force = "spring_force";

/// What compiles with this before it never ends within the compiler's limit.
std::string endless_to_compile() {
  std::string text =
      "template <long start>\nconstexpr long sum() {\n  long s = start;\n  for (long i = 0; i < 400; ++i)\n"
      "    for (long j = 0; j < 3000; ++j) s += i ^ j;\n  return s;\n}\n";
  for (int round = 1; round <= 500; ++round) text += fmt::format("static_assert(sum<{}>() > 0);\n", round);
  return text;
}

/// Of a text that was never compiled before.
std::string fresh() { return fmt::format("// {}\n", std::chrono::system_clock::now().time_since_epoch().count()); }

void solve(const CourseCopy& course, const std::string& name) {
  save(course.exercise(name), read(course.solution(name)));
}

/// A watch that has come to its first exercise and has nothing to do.
struct IdleWatch : CourseCopy, TerminalSession {
  explicit IdleWatch(const TerminalOptions& options = {}) : TerminalSession(*this, {}, options) {
    REQUIRE(shows({"Waiting"}));
  }
};

}  // namespace

// What is said is kept in golden/screens.txt: of every screen, what the one before does not show. Reports are left out:
// what follows two spaces.
TEST_CASE("edit, verdict, keys, next: from the first exercise to the last, with every sentence of the watch") {
  const CourseCopy course;
  TerminalOptions options;
  options.rows = 60;
  TerminalSession watch(course, {}, options);
  std::string screens;
  std::set<std::string> before;
  const auto keep = [&](const std::string& title, const std::vector<std::string>& parts) {
    CHECK_MESSAGE(watch.shows(parts), watch.screen());
    watch.wait(milliseconds(50));  // a screen arrives in pieces
    screens += "=== " + title + "\n";
    std::set<std::string> now;
    std::istringstream rows(watch.screen());
    for (std::string row; std::getline(rows, row);) {
      row.resize(std::min(row.size(), row.find("  ")));
      if (!row.empty() && now.insert(row).second && !before.contains(row)) screens += row + "\n";
    }
    before = now;
  };
  keep("the start", {"01_springs › spring_energy", "Next: spring_energy", "Waiting"});
  watch.type("c");
  keep("no verdict yet", {"no verdict on spring_energy"});
  course.answer_energy(wrong);
  CHECK(watch.judges(energy, "wrong_value"));
  keep("a wrong value, with its plot", {"spring_energy.svg", "Waiting"});
  watch.type("h");
  keep("a hint", {"Hint 1 of 3"});
  watch.type("hh");
  keep("the last hint", {"Hint 3 of 3"});
  watch.type("p");
  CHECK(watch.shows({"E (J)", "Waiting"}));
  watch.type("l");
  keep("the list", {"· spring_force"});
  watch.type("x");
  keep("a key without a meaning", {"“x”"});
  watch.type("\033OP");
  keep("F1", {"That key"});
  watch.type("b");
  keep("back at the first", {"first exercise"});
  course.answer_energy("return k * y;");
  CHECK(watch.judges(energy, "compile_error"));
  CHECK_FALSE(has(watch.screen(), "error: 'y'"));
  watch.type("c");
  CHECK_MESSAGE(watch.shows({"error: 'y'"}), watch.screen());
  watch.type("c");
  CHECK(watch.until([&] { return !has(watch.screen(), "error: 'y'"); }));
  watch.type("n");
  keep("the next one", {"01_springs › spring_force", "Waiting"});
  watch.type("r");
  keep("a stub has no verdict unless it is asked for", {"· spring_force  not started", "Waiting"});
  watch.type("b");
  CHECK(watch.shows({"✗ spring_energy", "Waiting"}));
  solve(course, energy);
  CHECK(watch.judges(energy, "passed"));
  keep("passed, and on to the next", {"1 of 2", "Next: spring_force", "Waiting"});
  watch.type("n");
  keep("the last one left", {"last one"});
  const fs::path folder = course.exercise(force).parent_path();
  fs::rename(folder, folder.string() + ".away");
  keep("a missing folder", {"missing"});
  fs::rename(folder.string() + ".away", folder);
  CHECK(watch.until([&] { return !has(watch.screen(), "missing"); }));
  solve(course, force);
  keep("the whole course passes", {"2 of 2", "✓ spring_force", "Waiting"});
  course.answer_energy(wrong);  // it goes on watching
  CHECK(watch.judges(energy, "wrong_value"));
  CHECK_FALSE(watch.is_restored());
  watch.type("q");
  CHECK(watch.ends() == 0);
  keep("the end", {"next is"});
  CHECK(watch.is_restored());
  CHECK(watch.shows_cursor());
  CHECK(nothing_left_running());

  const fs::path golden = fs::path(WORKBOOK_TEST_COURSE) / "../../watch/golden/screens.txt";
  const fs::path actual = fs::path(WORKBOOK_TEST_SCRATCH) / "screens.txt";
  write(actual, screens);
  CHECK_MESSAGE(read(golden) == screens, "see: diff " << golden.lexically_normal() << " " << actual);
}

TEST_CASE("every way of saving leads to the verdict") {
  IdleWatch watch;
  for (const Way& way : ways) {
    CAPTURE(std::string(way.name));
    save(watch.exercise(energy), read(watch.solution(energy)) + "// " + way.name, way);
    CHECK(watch.judges(energy, "passed"));
    watch.answer_energy(wrong);
    CHECK(watch.judges(energy, "wrong_value"));
  }
}

TEST_CASE("a verdict is shown before its plot is drawn") {
  IdleWatch watch;
  watch.answer_energy(wrong);
  CHECK(watch.judges(energy, "wrong_value"));
  CHECK(watch.shows({"spring_energy.svg"}));
  const std::size_t verdict = watch.written().find("✗");
  const std::size_t plot = watch.written().find("spring_energy.svg");
  CHECK(watch.written().substr(verdict, plot - verdict).find("\033[H") != std::string::npos);  // another screen
}

TEST_CASE("a key works while a check runs, and neither loses what the other writes down") {
  IdleWatch watch;
  watch.answer_energy("return 0.5 * k * x.squaredNorm();", fresh());
  CHECK(watch.shows({"checking spring_energy …"}));
  CHECK(watch.until([&] { return watch.send_to_jobs(SIGSTOP) == 1; }));  // so that it lasts as long as this takes
  watch.type("h");
  CHECK(watch.shows({"checking spring_energy …", "Hint 1 of 3"}));
  CHECK_MESSAGE(shows_seconds(watch), watch.screen());
  watch.send_to_jobs(SIGCONT);
  CHECK(watch.judges(energy, "passed"));
  watch.type("bh");
  CHECK(watch.shows({"01_springs › spring_energy", "Hint 2 of 3"}));
  CHECK(has(watch.run("list").out, "✓ spring_energy"));
}

TEST_CASE("a save while another version is checked ends that check") {
  IdleWatch watch;
  watch.answer_energy(wrong, endless_to_compile());
  CHECK(watch.shows({"checking spring_energy …"}));
  watch.answer_energy("return 42; // the second one");
  CHECK(watch.judges(energy, "wrong_value"));
  watch.type("q");
  CHECK(watch.ends() == 0);
  CHECK(nothing_left_running());
}

TEST_CASE("an endless loop ends at its limit" * doctest::test_suite("thorough")) {
  IdleWatch watch;
  watch.answer_energy(endless);
  CHECK(watch.judges(energy, "time_limit"));
}

TEST_CASE("the watch begins where it is told to") {
  const CourseCopy course;
  SUBCASE("at an exercise") {
    TerminalSession watch(course, {force});
    CHECK(watch.shows({"Next: spring_force", "Waiting"}));
    solve(course, force);
    CHECK(watch.judges(force, "passed"));
    CHECK(watch.shows({"Next: spring_energy"}));
  }
  SUBCASE("at an exercise that passes: there it stays") {
    solve(course, force);
    TerminalSession watch(course, {force});
    CHECK(watch.judges(force, "passed"));
    CHECK(watch.shows({"01_springs › spring_force", "Waiting"}));
    watch.type("n");
    CHECK(watch.shows({"Next: spring_energy"}));
  }
  SUBCASE("in a lecture") {
    TerminalSession watch(course, {"springs"});
    CHECK(watch.shows({"Next: spring_energy"}));
    solve(course, force);
    CHECK(watch.judges(force, "passed"));
    CHECK(watch.shows({"Next: spring_energy", "Waiting"}));
    solve(course, energy);
    CHECK(watch.shows({"All 2 exercises of 01_springs pass."}));
  }
  SUBCASE("with what is begun already, in the part that is not done") {
    solve(course, energy);
    CHECK(course.run("check spring_energy").status == 0);
    save(course.exercise(force), "not C++");
    TerminalSession watch(course);
    CHECK(watch.judges(force, "compile_error"));
  }
  SUBCASE("with everything done") {
    solve(course, force);
    solve(course, energy);
    CHECK(course.run("check").status == 0);
    TerminalSession watch(course);
    CHECK(watch.shows({"2 of 2", "All 2 exercises"}));
    watch.type("nq");
    CHECK(watch.ends() == 0);
    CHECK(watch.shows({"All 2 exercises pass."}));
  }
  SUBCASE("nowhere: a name that means nothing, and a course without exercises") {
    const Outcome unknown = course.run("watch spring_enrgy");
    CHECK(unknown.status == 2);
    CHECK(has(unknown.err, "spring_energy"));
    CHECK(unknown.out.empty());
    fs::remove_all(course.root() / "lectures/01_springs");
    CHECK(course.run("watch").status == 3);
  }
}

TEST_CASE("a file that is deleted is an exercise that is not started, and watching goes on") {
  IdleWatch watch;
  fs::remove(watch.exercise(energy));
  CHECK_MESSAGE(watch.shows({"· spring_energy", "reset spring_energy"}), watch.screen());
  solve(watch, energy);
  CHECK(watch.judges(energy, "passed"));
}

TEST_CASE("progress that cannot be saved is said, and the watch goes on all the same") {
  const CourseCopy course;
  write(course.root() / ".workbook", "a file where the folder should be");
  TerminalSession watch(course);
  CHECK(watch.shows({"Waiting"}));
  solve(course, energy);
  CHECK(watch.shows({"1 of 2", "✓ spring_energy", "Your progress could not be saved", "Next: spring_force"}));
  solve(course, force);
  CHECK(watch.shows({"2 of 2", "✓ spring_force"}));
}

TEST_CASE("a new size of the terminal is used, down to a few rows") {
  IdleWatch watch;
  watch.answer_energy(wrong);
  CHECK(watch.judges(energy, "wrong_value"));
  CHECK(watch.shows({"spring_energy.svg"}));
  watch.resize(40, 12);
  CHECK(watch.shows({"Lines 1–", "✗ spring_energy", "q:quit"}));
  CHECK_FALSE(has(watch.screen(), "spring_energy.svg"));
  watch.type("          ");
  CHECK(watch.shows({"↑ goes back up", "Plot"}));
  watch.type("\033[5~\033[5~\033[5~\033[5~\033[5~\033[5~\033[5~\033[5~");
  CHECK(watch.shows({"Lines 1–"}));
  watch.resize(10, 2);
  CHECK(watch.shows({"spring_en…"}));
  watch.resize(160, 50);
  CHECK(watch.shows({"01_springs › spring_energy", "✗ spring_energy", "Waiting"}));
}

TEST_CASE("colour only where it is wanted") {
  for (const bool is_wanted : {true, false}) {
    TerminalOptions options;
    if (!is_wanted) options.environment = {"NO_COLOR=1"};
    IdleWatch watch(options);
    CHECK(has(watch.written(), "\033[1m") == is_wanted);
  }
}

TEST_CASE("where nothing can be drawn, verdicts come one below the other, without control codes") {
  struct Terminal {
    const char* variable;
    bool has_keys;
    std::function<void()> prepare;
  };
  const Terminal terminals[] = {
      {"TERM=dumb", true, {}}, {"WORKBOOK_PLAIN=1", true, {}}, {"LANG=C.UTF-8", false, pipe_through_cat}};
  for (const Terminal& terminal : terminals) {
    CAPTURE(std::string(terminal.variable));
    const CourseCopy course;
    TerminalOptions options;
    options.environment = {terminal.variable, "WORKBOOK_POLL=1"};
    options.prepare = terminal.prepare;
    options.rows = 100;
    TerminalSession watch(course, {}, options);
    CHECK(watch.shows({terminal.has_keys ? "h:hint" : "Ctrl-C", "WORKBOOK_POLL", "Next: spring_energy"}));
    course.answer_energy(wrong);
    CHECK(watch.shows({"spring_energy  wrong value", "spring_energy.svg"}));
    if (terminal.has_keys) {
      watch.type("xl");
      CHECK(watch.shows({"“x”", "spring_force"}));
    }
    for (const char* name : {force, energy}) solve(course, name);  // both at once
    CHECK(watch.shows({"spring_force  passed", "spring_energy  passed", "All 2 exercises of the course"}));
    CHECK(watch.has_verdict(force, "passed"));
    watch.send(SIGTERM);
    CHECK(watch.ends() == 0);
    // With its end the terminal is hung up, perhaps before cat has written.
    if (terminal.has_keys) CHECK(watch.shows({"All 2 exercises pass."}));
    CHECK_FALSE(has(watch.written(), "\033"));
    if (terminal.variable == std::string("WORKBOOK_PLAIN=1")) CHECK_FALSE(has(watch.written(), "✓"));
  }
}

TEST_CASE("the end of the reader is the end of the watch") {
  const CourseCopy course;
  CHECK(course.run("watch </dev/null 2>&1 | head -n 1 >/dev/null; true").status == 0);
}

TEST_CASE("however the watch ends, nothing of it is left") {
  const CourseCopy course;
  const std::pair<const char*, milliseconds> works[] = {{"return 0;", milliseconds(300)},  // while it is compiled
                                                        {endless, milliseconds(900)}};     // while it runs
  struct End {
    const char* how;
    std::function<void(TerminalSession&)> end;
    int status;
  };
  const End ends[] = {{"q", [](auto& watch) { watch.type("q"); }, 0},
                      {"Ctrl-C", [](auto& watch) { watch.type("\x03"); }, 0},
                      {"SIGTERM", [](auto& watch) { watch.send(SIGTERM); }, 0},
                      {"SIGKILL", [](auto& watch) { watch.send(SIGKILL); }, 128 + SIGKILL},
                      {"SIGSEGV", [](auto& watch) { watch.send(SIGSEGV); }, 128 + SIGSEGV},
                      {"a closed terminal", [](auto& watch) { watch.close(); }, 0}};
  int number = 0;
  for (const auto& work : works) {
    for (const End& end : ends) {
      CAPTURE(std::string(work.first));
      CAPTURE(std::string(end.how));
      TerminalSession watch(course);
      CHECK(watch.shows({"q:quit"}));
      course.answer_energy(fmt::format("{} // never compiled before: {}", work.first, ++number),
                           work.first == endless ? "" : endless_to_compile());
      CHECK(watch.shows({"checking spring_energy …"}));
      watch.wait(work.second);
      end.end(watch);
      CHECK(watch.ends() == end.status);
      CHECK(nothing_left_running());
      if (end.how == std::string("a closed terminal") || end.status == 128 + SIGKILL) continue;
      CHECK(watch.shows_cursor());
      CHECK(watch.is_restored());
    }
  }
}

TEST_CASE("a check that dies is no verdict, and the watch survives it") {
  IdleWatch watch;
  watch.answer_energy(endless);
  CHECK_MESSAGE(shows_seconds(watch), watch.screen());
  CHECK(watch.send_to_jobs(SIGSEGV) == 1);
  CHECK(watch.shows({"! spring_energy", "signal 11", "0 of 2"}));
  CHECK_FALSE(watch.is_restored());
  watch.answer_energy(wrong);
  CHECK(watch.judges(energy, "wrong_value"));
}

TEST_CASE("a check that hangs ends at its limit") {
  TerminalOptions options;
  options.environment = {"WORKBOOK_CHECK_SECONDS=3"};
  IdleWatch watch(options);
  watch.answer_energy(endless);
  CHECK_MESSAGE(shows_seconds(watch), watch.screen());
  watch.send_to_jobs(SIGSTOP);
  CHECK_MESSAGE(watch.shows({"! spring_energy", "too long"}), watch.screen());
}

TEST_CASE("a file that is rejected is checked once, and the next save as ever") {
  IdleWatch watch;
  const fs::path file = watch.exercise(energy);
  write(file, std::string("\xff\xfe/\0/\0", 6));
  CHECK_MESSAGE(watch.shows({"is not a text file", "Waiting"}), watch.screen());
  fs::remove(file);
  fs::create_symlink(watch.solution(energy), file);
  CHECK_MESSAGE(watch.shows({"is a symbolic link", "Waiting"}), watch.screen());
  fs::remove(file);
  watch.answer_energy(wrong);
  CHECK(watch.judges(energy, "wrong_value"));
}

TEST_CASE("a change that changes no value is told here too") {
  IdleWatch watch;
  watch.answer_energy(wrong);
  CHECK(watch.judges(energy, "wrong_value"));
  watch.answer_energy("return x.squaredNorm() * k;");
  CHECK_MESSAGE(watch.shows({"has changed no value"}), watch.screen());
}

TEST_CASE("an error of the checker is no verdict, and the watch survives it") {
  IdleWatch watch;
  const std::string sound = read(watch.reference());
  write(watch.reference(), "damaged");
  watch.answer_energy(wrong);
  CHECK_MESSAGE(watch.shows({"! spring_energy", "01_springs.json"}), watch.screen());
  write(watch.reference(), sound);
  watch.type("r");
  CHECK(watch.judges(energy, "wrong_value"));
}

TEST_CASE("a check that cannot be started is said, and so is a plot") {
  TerminalOptions options;
  options.prepare = [] {
    ::closefrom(STDERR_FILENO + 1);
    const rlimit few{6, 6};  // descriptors: enough to watch, not enough to start anything
    ::setrlimit(RLIMIT_NOFILE, &few);
  };
  IdleWatch watch(options);
  watch.answer_energy(wrong);
  CHECK_MESSAGE(watch.shows({"! spring_energy", "could not be started (open a pipe: Too many open files)"}),
                watch.screen());
  watch.type("p");
  CHECK(watch.shows({"The plot could not be started"}));
  watch.type("q");
  CHECK(watch.ends() == 0);
}

TEST_CASE("where the system has no events left, the watch says so and polls the files") {
  for (const int call : {SYS_inotify_init1, SYS_inotify_add_watch}) {
    TerminalOptions options;
    options.prepare = [call] { refuse_system_call(call, ENOSPC); };
    IdleWatch watch(options);
    CHECK(watch.shows({"inotify: No space left on device"}));
    watch.answer_energy("return 0; // " + std::to_string(call));
    CHECK(watch.judges(energy, "wrong_value"));
  }
}

TEST_CASE("a signal that is ignored, as by nohup, does not end the watch") {
  TerminalOptions options;
  options.prepare = [] { ::signal(SIGHUP, SIG_IGN); };
  IdleWatch watch(options);
  watch.send(SIGHUP);
  watch.answer_energy(wrong);
  CHECK(watch.judges(energy, "wrong_value"));
}

TEST_CASE("Ctrl-Z gives the terminal back, and the watch comes back to it; the check that runs is not stopped") {
  IdleWatch watch;
  watch.answer_energy("return 0.5 * k * x.squaredNorm();", fresh());
  CHECK(watch.shows({"checking spring_energy …"}));
  // Nobody could continue it here, so it goes on at once, on a fresh screen.
  const std::size_t before = watch.written().size();
  watch.type("\x1a");
  CHECK(watch.until([&] { return has(watch.written().substr(before), "\033[?25h"); }));
  CHECK(watch.shows({"q:quit"}));
  CHECK(watch.judges(energy, "passed"));
  CHECK_FALSE(watch.is_restored());
}
