// The watch on a terminal: edit, verdict, next; keys; all the ways in which it can end.
#include "tests/watch/saving.hpp"
#include "tests/watch/watched.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#if WORKBOOK_HAS_SECCOMP
#include <seccomp.h>
#endif

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

using namespace workbook::testing;
namespace fs = std::filesystem;
using std::chrono::milliseconds;
using std::chrono::seconds;

namespace {

const char* const wrong = "return k * x.squaredNorm();";

/// Keeps the compiler busy, for about a second per round, and is never found compiled already.
std::string slow_to_compile(int rounds) {
  std::string text = fmt::format("// {}\n", std::chrono::system_clock::now().time_since_epoch().count());
  text +=
      "template <long start>\nconstexpr long sum() {\n  long s = start;\n  for (long i = 0; i < 400; ++i)\n"
      "    for (long j = 0; j < 3000; ++j) s += i ^ j;\n  return s;\n}\n";
  for (int round = 1; round <= rounds; ++round) text += fmt::format("static_assert(sum<{}>() > 0);\n", round);
  return text;
}

void solve(const CourseCopy& course, const std::string& name, Way way = Way::directly) {
  save(course.exercise(name), read(course.solution(name)), way);
}

}  // namespace

TEST_CASE("edit, verdict, next: from the first exercise to the last") {
  const CourseCopy course;
  WatchedTerminal watch(course);
  CHECK(watch.shows({"01_springs › spring_energy", "0 of 2", "Next: spring_energy", "The energy of a spring",
                     "spring_energy.cpp", "Waiting for a save of spring_energy.", "h hint", "q quit"}));

  course.answer_energy(wrong);
  CHECK(watch.shows({"✗ spring_energy  wrong value", "The factor ½ is missing."}));
  CHECK_FALSE(has(watch.screen(), "Next: spring_energy"));  // in its place

  solve(course, "spring_energy");
  CHECK(watch.shows({"01_springs › spring_force", "1 of 2", "✓ spring_energy  passed", "Next: spring_force"}));
  CHECK_FALSE(has(watch.screen(), "wrong value"));

  solve(course, "spring_force", Way::by_renaming);
  CHECK(watch.shows({"2 of 2", "✓ spring_force  passed", "All 2 exercises of the course pass."}));

  // It goes on watching.
  course.answer_energy(wrong);
  CHECK(watch.shows({"01_springs › spring_energy", "1 of 2", "The factor ½ is missing."}));
  watch.type("q");
  CHECK(watch.ends() == 0);
  CHECK(watch.shows({"1 of 2 exercises pass; next is spring_energy."}));
  CHECK(nothing_left_running());
}

TEST_CASE("every way of saving leads to the verdict") {
  const CourseCopy course;
  WatchedTerminal watch(course);
  CHECK(watch.shows({"Waiting"}));
  for (const Way way : all_ways) {
    CAPTURE(std::string(to_string(way)));
    save(course.exercise("spring_energy"), read(course.solution("spring_energy")) + "// " + to_string(way), way);
    CHECK(watch.shows({"✓ spring_energy  passed"}));
    course.answer_energy(wrong);
    CHECK(watch.shows({"✗ spring_energy  wrong value"}));
  }
}

TEST_CASE("the keys: hint, list, plot, compiler, next, back, again, quit") {
  const CourseCopy course;
  TerminalOptions options;
  options.rows = 45;
  WatchedTerminal watch(course, {}, options);
  CHECK(watch.shows({"Waiting"}));
  course.answer_energy(wrong);
  CHECK(watch.shows({"The factor ½ is missing."}));
  watch.type("h");
  CHECK(watch.shows({"The factor ½ is missing.", "Hint 1 of 3"}));
  watch.type("h");
  CHECK(watch.shows({"The factor ½ is missing.", "Hint 2 of 3"}));
  watch.type("l");
  CHECK(watch.shows({"✗ spring_energy", "· spring_force", "not started"}));
  watch.type("p");
  CHECK(watch.shows({"spring_energy.svg", "spring_energy.png"}));
  watch.type("n");
  CHECK(watch.shows({"01_springs › spring_force", "Next: spring_force"}));
  CHECK_FALSE(has(watch.screen(), "spring_energy.svg"));
  watch.type("r");  // a stub has no verdict unless it is asked for
  CHECK(watch.shows({"· spring_force  not started"}));
  watch.type("b");
  CHECK(watch.shows({"01_springs › spring_energy", "The factor ½ is missing."}));
  watch.type("b");
  CHECK(watch.shows({"This is the first exercise of the course."}));
  course.answer_energy("return k * y;");
  CHECK(watch.shows({"✗ spring_energy  compile error"}));
  watch.type("c");
  CHECK(watch.shows({"All that the compiler says:"}));
  watch.type("x");
  CHECK(watch.shows({"The key “x” does nothing; these do:"}));
  watch.type("\033OP");
  CHECK(watch.shows({"That key does nothing; these do:"}));
  CHECK_FALSE(watch.has_ordinary_manners());
  watch.type("q");
  CHECK(watch.ends() == 0);
  CHECK(watch.has_ordinary_manners());
  CHECK(watch.shows_cursor());
}

TEST_CASE("a key works while a check runs, and neither loses what the other writes down") {
  const CourseCopy course;
  WatchedTerminal watch(course);
  CHECK(watch.shows({"Waiting"}));
  course.answer_energy("return 0.5 * k * x.squaredNorm();", slow_to_compile(3));
  CHECK(watch.shows({"checking spring_energy …"}));
  watch.type("h");
  CHECK(watch.shows({"checking spring_energy …", "Hint 1 of 3"}));
  CHECK(watch.shows({"checking spring_energy … 1 s"}));
  CHECK(watch.shows({"✓ spring_energy  passed"}, seconds(60)));
  watch.type("b");
  CHECK(watch.shows({"01_springs › spring_energy"}));
  watch.type("h");
  CHECK(watch.shows({"Hint 2 of 3"}));
  CHECK(has(course.run("list").out, "✓ spring_energy"));
}

TEST_CASE("a save while another version is checked ends that check") {
  const CourseCopy course;
  WatchedTerminal watch(course);
  CHECK(watch.shows({"Waiting"}));
  course.answer_energy(wrong, slow_to_compile(20));
  CHECK(watch.shows({"checking spring_energy …"}));
  const auto begun = std::chrono::steady_clock::now();
  course.answer_energy("return 42;");
  CHECK(watch.shows({"✗ spring_energy  wrong value"}));
  CHECK(std::chrono::steady_clock::now() - begun < seconds(10));
  CHECK_FALSE(has(watch.written(), "The factor ½ is missing."));
  watch.type("q");
  CHECK(watch.ends() == 0);
  CHECK(nothing_left_running());
}

TEST_CASE("an endless loop ends at its limit, and the exercise is named") {
  const CourseCopy course;
  WatchedTerminal watch(course);
  CHECK(watch.shows({"Waiting"}));
  course.answer_energy("for (volatile int i = 0;;) i = i + 1;");
  CHECK(watch.shows({"checking spring_energy … 1 s"}, seconds(30)));
  CHECK(watch.shows({"✗ spring_energy  time limit"}, seconds(60)));
}

TEST_CASE("the watch begins where it is told to") {
  const CourseCopy course;
  SUBCASE("at an exercise") {
    WatchedTerminal watch(course, {"spring_force"});
    CHECK(watch.shows({"Next: spring_force", "Waiting for a save of spring_force."}));
    solve(course, "spring_force");
    CHECK(watch.shows({"✓ spring_force  passed", "Next: spring_energy"}));
  }
  SUBCASE("at an exercise that passes: there it stays") {
    solve(course, "spring_force");
    WatchedTerminal watch(course, {"spring_force"});
    CHECK(watch.shows({"✓ spring_force  passed", "spring_force passes. n goes on."}));
    watch.type("n");
    CHECK(watch.shows({"Next: spring_energy"}));
    watch.type("n");
    CHECK(watch.shows({"All others pass: spring_energy is the last one."}));
  }
  SUBCASE("in a lecture") {
    WatchedTerminal watch(course, {"springs"});
    CHECK(watch.shows({"Next: spring_energy"}));
    solve(course, "spring_force");
    CHECK(watch.shows({"✓ spring_force  passed", "Next: spring_energy"}));
    solve(course, "spring_energy");
    CHECK(watch.shows({"All 2 exercises of 01_springs pass."}));
  }
  SUBCASE("with what is begun already") {
    course.answer_energy(wrong);
    WatchedTerminal watch(course);
    CHECK(watch.shows({"The factor ½ is missing."}));
  }
  SUBCASE("with everything done") {
    solve(course, "spring_force");
    solve(course, "spring_energy");
    CHECK(course.run("check").status == 0);
    WatchedTerminal watch(course);
    CHECK(watch.shows({"2 of 2", "All 2 exercises of the course pass."}));
    watch.type("n");
    CHECK(watch.shows({"All 2 exercises of the course pass."}));
    watch.type("q");
    CHECK(watch.ends() == 0);
    CHECK(watch.shows({"All 2 exercises pass."}));
  }
}

TEST_CASE("a file or a folder that goes away is named, and watching goes on") {
  const CourseCopy course;
  WatchedTerminal watch(course);
  CHECK(watch.shows({"Waiting"}));
  fs::remove(course.exercise("spring_energy"));
  CHECK(watch.shows({"spring_energy.cpp does not exist; check the name and the folder."}));
  solve(course, "spring_energy");
  CHECK(watch.shows({"✓ spring_energy  passed", "Next: spring_force"}));
  const fs::path folder = course.exercise("spring_force").parent_path();
  fs::rename(folder, folder.string() + ".away");
  CHECK(watch.shows({"The folder", "is gone. Put it back and watching goes on."}));
  fs::rename(folder.string() + ".away", folder);
  CHECK(watch.until([&] { return !has(watch.screen(), "is gone."); }));
  solve(course, "spring_force");
  CHECK(watch.shows({"✓ spring_force  passed"}));
}

TEST_CASE("progress that cannot be saved is said, and the watch goes on all the same") {
  const CourseCopy course;
  write(course.root() / ".workbook", "a file where the folder should be");
  WatchedTerminal watch(course);
  CHECK(watch.shows({"Waiting"}));
  solve(course, "spring_energy");
  CHECK(watch.shows({"1 of 2", "✓ spring_energy  passed", "Your progress could not be saved", "Next: spring_force"}));
}

TEST_CASE("a new size of the terminal is used, down to a few rows") {
  const CourseCopy course;
  WatchedTerminal watch(course);
  CHECK(watch.shows({"Waiting"}));
  course.answer_energy(wrong);
  CHECK(watch.shows({"The factor ½ is missing."}));
  watch.resize(40, 12);
  CHECK(watch.shows({"Lines 1–", "space or ↓ shows more", "q quit"}));
  CHECK_FALSE(has(watch.screen(), "The factor ½ is missing."));
  watch.type("          ");
  CHECK_MESSAGE(watch.shows({"Next   Mend what the diagnosis names", "↑ goes back up"}), watch.screen());
  for (int page = 0; page < 10; ++page) watch.type("\033[5~");
  CHECK(watch.shows({"Lines 1–"}));
  watch.resize(10, 2);
  CHECK(watch.shows({"spring_en…"}));
  watch.resize(160, 50);
  CHECK(watch.shows({"01_springs › spring_energy", "The factor ½ is missing.", "Waiting"}));
}

TEST_CASE("colour only where it is wanted") {
  const CourseCopy course;
  course.answer_energy(wrong);
  const auto has_colour = [&](const std::vector<std::string>& environment) {
    TerminalOptions options;
    options.environment = environment;
    WatchedTerminal watch(course, {}, options);
    CHECK(watch.shows({"The factor ½ is missing."}));
    return has(watch.written(), "\033[1m") || has(watch.written(), "\033[31m");
  };
  CHECK(has_colour({}));
  CHECK_FALSE(has_colour({"NO_COLOR=1"}));
}

TEST_CASE("a terminal without a cursor, and the plain mode: one below the other, but with keys") {
  const CourseCopy course;
  for (const char* variable : {"TERM=dumb", "WORKBOOK_PLAIN=1"}) {
    CAPTURE(std::string(variable));
    TerminalOptions options;
    options.environment = {variable};
    WatchedTerminal watch(course, {}, options);
    CHECK(watch.shows({"h hint", "Next: spring_energy"}));
    watch.type("x");
    CHECK(watch.shows({"The key “x” does nothing; these do: h hint"}));
    watch.type("l");
    CHECK(watch.shows({"spring_force"}));
    watch.type("q");
    CHECK(watch.ends() == 0);
    CHECK(watch.has_ordinary_manners());
    CHECK_FALSE(has(watch.written(), "\033["));
  }
}

TEST_CASE("however the watch ends, nothing of it is left") {
  const CourseCopy course;
  struct Work {
    const char* body;
    std::string before;
    milliseconds time_to_begin;
  };
  const Work works[] = {{"return 0;", slow_to_compile(20), milliseconds(300)},
                        {"for (volatile int i = 0;;) i = i + 1;", "", milliseconds(900)}};
  struct End {
    const char* how;
    std::function<void(WatchedTerminal&)> end;
    int status;
  };
  const End ends[] = {
      {"q", [](WatchedTerminal& watch) { watch.type("q"); }, 0},
      {"Ctrl-C", [](WatchedTerminal& watch) { watch.type("\x03"); }, 0},
      {"SIGTERM", [](WatchedTerminal& watch) { watch.send(SIGTERM); }, 0},
      {"SIGKILL", [](WatchedTerminal& watch) { watch.send(SIGKILL); }, 128 + SIGKILL},
      {"SIGSEGV", [](WatchedTerminal& watch) { watch.send(SIGSEGV); }, 128 + SIGSEGV},
      {"a closed terminal", [](WatchedTerminal& watch) { watch.close(); }, 0},
  };
  int number = 0;
  for (const Work& work : works) {
    for (const End& end : ends) {
      CAPTURE(std::string(work.body));
      CAPTURE(std::string(end.how));
      WatchedTerminal watch(course);
      CHECK(watch.shows({"q quit"}));
      // Never compiled before.
      course.answer_energy(std::string(work.body) + " // " + std::to_string(++number), work.before);
      CHECK(watch.shows({"checking spring_energy …"}));
      watch.wait(work.time_to_begin);
      end.end(watch);
      CHECK(watch.ends() == end.status);
      CHECK(nothing_left_running());
      if (end.status == 0 && std::string(end.how) != "a closed terminal") CHECK(watch.shows_cursor());
      const bool can_tidy_up = end.status != 128 + SIGKILL && std::string(end.how) != "a closed terminal";
      if (can_tidy_up) CHECK(watch.has_ordinary_manners());
    }
  }
}

TEST_CASE("a check that dies is no verdict, and the watch survives it") {
  const CourseCopy course;
  WatchedTerminal watch(course);
  CHECK(watch.shows({"Waiting"}));
  course.answer_energy("for (volatile int i = 0;;) i = i + 1; // and the check dies");
  CHECK(watch.shows({"checking spring_energy … 1 s"}));
  CHECK(watch.send_to_commands(SIGSEGV) == 1);
  CHECK(watch.shows({"The check of spring_energy ended unexpectedly (signal 11); this is not your", "0 of 2"}));
  course.answer_energy(wrong);
  CHECK(watch.shows({"The factor ½ is missing."}));
}

TEST_CASE("trouble of our own is no verdict, and the watch survives it") {
  const CourseCopy course;
  TerminalOptions options;
  options.columns = 300;
  WatchedTerminal watch(course, {}, options);
  CHECK(watch.shows({"Waiting"}));
  const std::string sound = read(course.reference());
  write(course.reference(), "damaged");
  course.answer_energy(wrong);
  CHECK(watch.shows({"01_springs.json"}));
  write(course.reference(), sound);
  watch.type("r");
  CHECK(watch.shows({"The factor ½ is missing."}));
}

TEST_CASE("a check that cannot be started is said, and so is a command") {
  const CourseCopy course;
  TerminalOptions options;
  options.prepare = [] {
    ::closefrom(STDERR_FILENO + 1);
    rlimit few{};
    few.rlim_cur = few.rlim_max = 8;  // descriptors: enough to watch, not enough to start a program
    ::setrlimit(RLIMIT_NOFILE, &few);
  };
  WatchedTerminal watch(course, {}, options);
  CHECK(watch.shows({"Waiting"}));
  course.answer_energy(wrong);
  CHECK(watch.shows({"The check of spring_energy could not be started (open a pipe: Too many", "press r."}));
  watch.type("h");
  CHECK(watch.shows({"That could not be started (open a pipe: Too many open files)", "press the key again."}));
  watch.type("q");
  CHECK(watch.ends() == 0);
}

#if WORKBOOK_HAS_SECCOMP
TEST_CASE("where the system has no events left, the watch says so and looks at the files") {
  const CourseCopy course;
  for (const int call : {SCMP_SYS(inotify_init1), SCMP_SYS(inotify_add_watch)}) {
    TerminalOptions options;
    options.prepare = [call] {
      scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
      seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSPC), call, 0);
      seccomp_load(filter);
    };
    WatchedTerminal watch(course, {}, options);
    CHECK(watch.shows({"The system sends no news of files here (No space left on device)", "Next: spring_energy"}));
    course.answer_energy("return 0; // " + std::to_string(call));
    CHECK(watch.shows({"✗ spring_energy  wrong value"}));
    fs::copy_file(fs::path(WORKBOOK_TEST_COURSE) / "lectures/01_springs/exercises/spring_energy.cpp",
                  course.exercise("spring_energy"), fs::copy_options::overwrite_existing);
  }
}
#endif

TEST_CASE("a signal that is ignored, as by nohup, does not end the watch") {
  const CourseCopy course;
  TerminalOptions options;
  options.prepare = [] { ::signal(SIGHUP, SIG_IGN); };
  WatchedTerminal watch(course, {}, options);
  CHECK(watch.shows({"Waiting"}));
  watch.send(SIGHUP);
  course.answer_energy(wrong);
  CHECK(watch.shows({"The factor ½ is missing."}));
}

TEST_CASE("Ctrl-Z gives the terminal back, and the watch comes back to it") {
  const CourseCopy course;
  WatchedTerminal watch(course);
  CHECK(watch.shows({"Waiting"}));
  // Nobody could continue it here, so it goes on at once, on a fresh screen.
  const std::size_t before = watch.written().size();
  watch.type("\x1a");
  CHECK(watch.until([&] { return has(watch.written().substr(before), "\033[?25h"); }));
  CHECK(watch.shows({"Waiting", "q quit"}));
  course.answer_energy(wrong);
  CHECK(watch.shows({"The factor ½ is missing."}));
  CHECK_FALSE(watch.has_ordinary_manners());
}
