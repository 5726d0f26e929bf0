// An unlucky student: programs that are killed, tools that are missing, releases that come while one works.
#include "tests/grading/made_up_class.hpp"
#include "tests/support/processes.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <random>
#include <thread>

using namespace workbook::testing;

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Of each command.
const int kills = [] {
  const char* given = std::getenv("WORKBOOK_TEST_KILLS");
  return given ? std::atoi(given) : 20;
}();

/// Starts a command of the checker in the course's folder and kills it at a random moment of the time that it takes
/// undisturbed.
class Killer {
 public:
  explicit Killer(const CourseCopy& course) : course_(course) {}

  /// `between` is done once the command runs. Returns false if the command ended before.
  bool operator()(std::vector<std::string> arguments, Clock::duration undisturbed,
                  const std::function<void()>& between = {}) {
    const std::string description = (course_.root() / "course.json").string();
    arguments.insert(arguments.begin(), {"checker", "--course", description});
    std::vector<char*> words;
    for (std::string& word : arguments) words.push_back(word.data());
    words.push_back(nullptr);
    std::fflush(stdout);  // or the copy would say it again
    const pid_t process = fork();
    if (process == 0) {
      if (chdir(course_.root().c_str()) != 0 || !std::freopen("/dev/null", "w", stdout) ||
          !std::freopen("/dev/null", "w", stderr))
        _exit(1);
      execv(WORKBOOK_TEST_CHECKER, words.data());
      _exit(127);
    }
    if (between) between();
    std::this_thread::sleep_for(std::uniform_real_distribution<>(0, 1.1)(random_) * undisturbed);
    int status = 0;
    const bool ended = waitpid(process, &status, WNOHANG) == process;
    if (!ended) {
      kill(process, SIGKILL);
      waitpid(process, &status, 0);
    }
    return !ended;
  }

 private:
  const CourseCopy& course_;
  std::mt19937 random_{7};
};

template <class Work>
Clock::duration time_of(const Work& work) {
  const auto begun = Clock::now();
  work();
  return Clock::now() - begun;
}

nlohmann::json without_seconds(nlohmann::json document) {
  for (auto& result : document.at("results")) result.erase("seconds");
  return document;
}

/// Every file below a folder. Locked files are made with another salt each time.
std::map<std::string, std::string> all_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::path& file : files_below(folder)) {
    const std::string name = file.lexically_relative(folder).string();
    if (name != ".release.json" && !name.ends_with(".locked")) files[name] = read(file);
  }
  return files;
}

void check_same(const std::map<std::string, std::string>& files, const std::map<std::string, std::string>& expected) {
  for (const auto& [name, text] : files) CHECK_MESSAGE((expected.contains(name) && expected.at(name) == text), name);
  CHECK(files.size() == expected.size());
}

/// A wrong answer that was never compiled before.
void answer_anew(const CourseCopy& course) {
  static int number = 0;
  course.answer_energy("return k * x.squaredNorm();");
  write(course.exercise("spring_energy"),
        read(course.exercise("spring_energy")) + fmt::format("// {} {}\n", getpid(), ++number));
}

}  // namespace

TEST_CASE("Our own failure is no zero.") { CourseCopy().check_story("own_failure"); }

TEST_SUITE_BEGIN("a killed command");

TEST_CASE("Whatever stops a command, the next run ends with the same results: check and watch.") {
  const CourseCopy course;
  Killer kill(course);
  nlohmann::json right;
  answer_anew(course);
  const auto undisturbed = time_of([&] { right = without_seconds(course.run("check spring_energy --json").json()); });
  const std::string list = course.run("list").out;
  int killed = 0;
  for (int k = 0; k < 2 * kills; ++k) {
    CAPTURE(k);
    if (k % 2 == 0) {
      answer_anew(course);
      killed += kill({"check", "spring_energy"}, undisturbed) ? 1 : 0;
    } else {
      killed += kill({"watch"}, undisturbed, [&] { answer_anew(course); }) ? 1 : 0;
    }
    CHECK(without_seconds(course.run("check spring_energy --json").json()) == right);
    CHECK(course.run("list").out == list);
  }
  CHECK(killed > 0);
  CHECK(nothing_left_running());
}

TEST_CASE("Whatever stops a command, the next run ends with the same results: handout and update.") {
  const CourseCopy course;
  write(course.root() / "build/printed/01_springs.txt", "E = 9 J\n");
  Killer kill(course);
  REQUIRE(course.run("handout whole").status == 0);
  const auto undisturbed = time_of([&] { REQUIRE(course.run("handout copy").status == 0); });
  const auto right = all_in(course.root() / "whole");
  for (int k = 0; k < kills; ++k) {
    CAPTURE(k);
    fs::remove_all(course.root() / "copy");
    kill({"handout", "copy"}, undisturbed);
    const Outcome again = course.run("handout copy");
    CHECK((again.status == 0 || has(again.err, "is not empty")));  // whole, or not there
    check_same(all_in(course.root() / "copy"), right);
  }

  replace_in(course.root() / "lectures/01_springs/hints/spring_force.md", "---", "More of it.\n\n---");
  fs::copy(course.root() / "whole", course.root() / "next", fs::copy_options::recursive);
  REQUIRE(course.run("handout next --update").status == 0);
  const fs::path student = course.root() / "student";
  auto description = nlohmann::json::parse(read(course.root() / "course.json"));
  description["root"] = student.string();

  write(course.root() / "course.json", description.dump());
  const auto begin = [&] {
    fs::remove_all(student);
    fs::copy(course.root() / "whole", student, fs::copy_options::recursive);
    write(student / "lectures/01_springs/exercises/spring_energy.cpp", "// mine\n");
    write(student / "lectures/01_springs/notes.md", "my remarks\n");
    write(student / "drafts/spin.cpp", "mine\n");
  };
  begin();
  const auto for_update = time_of([&] { REQUIRE(course.run("update next").status == 0); });
  const auto updated = all_in(student);
  CHECK(updated.at("lectures/01_springs/exercises/spring_energy.cpp") == "// mine\n");
  CHECK(updated.at("drafts/spin.cpp") == "mine\n");
  CHECK(has(updated.at("lectures/01_springs/hints/spring_force.md"), "More of it."));
  for (int k = 0; k < kills; ++k) {
    CAPTURE(k);
    begin();
    kill({"update", "next"}, for_update);
    CHECK(course.run("update next").status == 0);
    check_same(all_in(student), updated);
  }
}

TEST_SUITE_END();

TEST_SUITE_BEGIN("a killed run of grade" * doctest::skip(!is_open_to_all()));

TEST_CASE("Whatever stops a command, the next run ends with the same results: grade.") {
  const MadeUpClass few;
  few.hand_in_few_files();
  Killer kill(few);
  const auto undisturbed = time_of([&] { REQUIRE(few.grade("undisturbed").status == 0); });
  const auto right = results_in(few.root() / "undisturbed");
  const auto journal = few.root() / "out/journal.jsonl";
  const auto lines = [&] {
    const std::string text = fs::exists(journal) ? read(journal) : "";
    return text.substr(0, text.rfind('\n') + 1);
  };
  for (int k = 0; k < kills; ++k) {
    CAPTURE(k);
    const std::string known = lines();
    kill({"grade", "submissions", "--out", "out", "--allow-reduced", "--seed", "1"}, undisturbed / (k % 4 + 1));
    CHECK(lines().starts_with(known));  // what is judged stays
    if (k % 4 != 3 && k + 1 < kills) continue;
    REQUIRE(few.grade().status == 0);
    check_same(results_in(few.root() / "out"), right);
    CHECK(is_judged_once(journal));
    fs::remove_all(few.root() / "out");
  }
  CHECK(nothing_left_running());
}

TEST_SUITE_END();
