// A saboteur: files that would change the marks of others, and machines on which things fail.
#include "checker/pipeline/check_exercise.hpp"
#include "tests/grading/made_up_class.hpp"
#include "tests/support/processes.hpp"
#include "tests/support/system_calls.hpp"

#include "checker/base/text.hpp"
#include "checker/grading/grading.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <set>
#include <thread>

using namespace workbook::testing;

namespace {

namespace fs = std::filesystem;

std::string verdict(const nlohmann::json& student, std::size_t exercise = 0) {
  return student.at("results").at(exercise).at("verdict");
}

void check_exports(const MadeUpClass& of, std::size_t students) {
  // Nothing that comes from a student is markup, a formula, or a place in somebody else's folder.
  for (const auto& each : results_in(of.root() / "out")) {
    const std::string &name = each.first, &text = each.second;
    if (name.starts_with("submissions/")) continue;
    CAPTURE(name);
    if (name.ends_with(".html") || name.ends_with(".xml"))
      // Pages of students have plots of ours, and that of the class has a script, at its end.
      for (const char* markup :
           {"<img(?! src=\"data:image/svg\\+xml;base64,[A-Za-z0-9+/=]+\" alt=\"Plot of )", "<script"})
        CHECK(!workbook::search(text.substr(0, text.rfind("<script>// Sorting")), markup));
    CHECK(!has(text, "\033"));
    CHECK(!has(text, "/judging/"));
    CHECK(!has(text, "root:x:0"));
  }
  const workbook::Table grades = workbook::read_csv(read(of.root() / "out/grades.csv"));
  CHECK(grades.size() == students + 1);
  for (const auto& row : grades) {
    CHECK(row.size() == 8);
    for (const std::string& cell : row) CHECK(cell.find_first_of("=+-@") != 0);
  }
}

}  // namespace

TEST_SUITE_BEGIN("saboteur" * doctest::skip(!is_open_to_all()));

TEST_CASE("A file can spoil its own mark, and nobody else's.") {
  const MadeUpClass all;
  all.hand_in_ordinary_files();
  all.hand_in_hostile_files();
  const std::string canary = read(all.solution("spring_energy"));
  const Outcome graded = all.grade();
  REQUIRE_MESSAGE(graded.status == 1, graded.said());  // not all could be read
  CHECK(nothing_left_running());
  CHECK(read(all.solution("spring_energy")) == canary);

  const auto document = nlohmann::json::parse(read(all.root() / "out/class.json"));
  std::map<std::string, double> scores;
  std::map<std::string, int> compared;
  for (const auto& entry : document.at("students")) {
    const std::string id = entry.at("id"), slug = entry.at("slug");
    scores[id] = entry.at("score");
    CAPTURE(id);
    const auto student = all.student(id);
    for (const auto& result : student.at("results")) {
      const std::string exercise = result.at("exercise");
      CAPTURE(exercise);
      const fs::path copy = all.root() / "out/submissions" / slug / (exercise + ".cpp");
      if (!fs::exists(copy)) {
        CHECK((result.at("verdict") == "not_started" || result.at("verdict") == "rejected_file"));
        continue;
      }
      // Of each kind one is enough, and a time limit takes its time.
      if (compared[exercise + result.at("verdict").get<std::string>()]++ > 0 || result.at("verdict") == "time_limit")
        continue;
      auto single = all.run(fmt::format("check {} --file '{}' --json", exercise, copy.string())).result();
      for (const char* key :
           {"verdict", "score", "points", "message", "diagnosis", "findings", "first_failure", "cases"})
        CHECK_MESSAGE(single.at(key) == result.at(key), key);
    }
  }
  const std::map<std::string, double> right = {{"ada", 3},  {"ben", 0},   {"cleo", 3},  {"dora", 0},
                                               {"emil", 0}, {"fritz", 3}, {"gustl", 1}, {"hans", 2},
                                               {"ida", 0},  {"jan", 0},   {"kim", 0},   {"lea", 0}};
  for (const auto& each : right) CHECK_MESSAGE(scores.at(each.first) == each.second, each.first);
  CHECK(scores.size() == right.size() + 15);

  CHECK(verdict(all.student("ben"), 1) == "waiting");
  CHECK(verdict(all.student("ida")) == "uncaught_exception");
  CHECK(verdict(all.student("lea")) == "not_started");
  CHECK(verdict(all.student("jan")) == "rejected_file");  // it has another name
  CHECK(has(all.student("jan").at("results").at(0).at("message"), "spring_energy.cpp"));
  for (const char* id : {"link", "fifo", "folder", "hard_link", "sparse", "binary", "twice", "bomb"})
    CHECK_MESSAGE(verdict(all.student(id)) == "rejected_file", id);
  CHECK(verdict(all.student("slip"), 1) == "rejected_file");
  CHECK(verdict(all.student("ADA")) == "compile_error");
  CHECK(verdict(all.student("killer")) == "forbidden_operation");
  CHECK(!has(graded.said(), "\033"));
  CHECK(document.at("not_judged").empty());
  // The linked folder, a path that leads away, the stray file; of two students the only folder or zip file.
  CHECK(document.at("problems").size() == 5);
  CHECK(document.at("missing") == nlohmann::json{"kim", "locked", "torn"});

  // dora and emil gave the same wrong values for no reason that the exercise knows.
  CHECK(document.at("identical_wrong_outputs").at(0).at("students") == nlohmann::json{"dora", "emil"});
  CHECK(document.at("misconceptions").at(0).at("name") == "no_half");
  CHECK(document.at("exercises").at(0).at("judged") == scores.size());

  check_exports(all, scores.size() - document.at("missing").size());

  // Nothing is judged twice, and what has changed is told with its reason.
  const auto before = results_in(all.root() / "out");
  CHECK(has(all.grade().out, " 0 different files"));
  CHECK(results_in(all.root() / "out") == before);
  all.energy("ben", right_energy);
  const Outcome again = all.grade();
  CHECK(has(again.out, "ben: 3 of 3 points, before 0 of 3: spring_energy was wrong value and is passed"));
  CHECK(!has(again.out, "ada:"));
}

TEST_CASE("Where root grades without namespaces, each function runs as a user of its own.") {
  if (::geteuid() != 0) return;
  const MadeUpClass two;
  for (const char* tool : {"as", "ld", "ld.gold", "ld.bfd"}) {  // and no bubblewrap
    fs::create_directories(two.root() / "bin");
    fs::create_symlink(fs::path("/usr/bin") / tool, two.root() / "bin" / tool);
  }
  for (const char* student : {"ada", "ben"})
    write(two.submissions() / student / "spring_energy.cpp",
          "#include <sys/syscall.h>\n#include <unistd.h>\n" +
              energy_text("throw std::runtime_error(\"user \" + std::to_string(syscall(SYS_getuid))); // " +
                          std::string(student)));
  const Outcome graded = two.grade("out", "--seed 1", "PATH='" + (two.root() / "bin").string() + "'");
  REQUIRE_MESSAGE(graded.status == 0, graded.said());
  std::set<std::string> users;
  for (const char* student : {"ada", "ben"}) {
    const auto result = two.student(student).at("results").at(0);
    CHECK(result.at("verdict") == "uncaught_exception");
    users.insert(workbook::search(result.at("message").get<std::string>(), "user ([0-9]+)")[1]);
  }
  CHECK(users.size() == 2);
  for (const std::string& user : users) CHECK(user.size() == std::string("2000000000").size());
}

TEST_CASE("What the sandbox does not hold back is said at every result.") {
  const CourseCopy course;
  course.solve("spring_energy");
  // The filter of system calls belongs to a thread and what it starts: here it makes a kernel without such filters.
  std::thread([&] {
    CHECK(refuse_system_call(SYS_prctl, EINVAL, PR_GET_SECCOMP));
    const std::string said = "none: limits on time, memory and output only; a function can";
    CHECK(has(course.run("check spring_energy", "COLUMNS=200").out, said));
    const auto result = course.run("check spring_energy --json").result();
    CHECK(result.at("verdict") == "passed");
    CHECK(has(result.at("sandbox"), said));
    const std::string page = (course.root() / "page.html").string();
    CHECK(course.run("report --html '" + page + "'").status == 0);
    CHECK(has(read(page), said));
  }).join();
  CHECK_FALSE(course.run("check spring_energy --json").result().contains("sandbox"));
}

TEST_SUITE_END();

TEST_CASE("Only the answer decides a verdict: a machine that starts no more programs cannot change it.") {
  const CourseCopy course;
  course.solve("spring_energy");
  course.answer_energy("return k * x.squaredNorm();");
  write(course.exercise("spring_force"), force_text("return spring_energy(k, x) * x;"));
  for (const char* exercise : {"spring_energy", "spring_force"}) {
    CAPTURE(exercise);
    const pid_t process = ::fork();
    if (process == 0) {
      const workbook::Course read(course.root() / "course.json");
      workbook::CheckContext context(read);
      const auto checked = workbook::check_exercise(context, workbook::check_task(read, read.find_exercise(exercise)),
                                                    [](const auto&) { refuse_system_call(SYS_clone, EAGAIN); });
      ::_exit(static_cast<int>(checked.judgement.verdict));
    }
    int status = 0;
    REQUIRE(::waitpid(process, &status, 0) == process);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == static_cast<int>(workbook::Verdict::wrong_value));
  }
}

TEST_CASE("Only the answer decides a verdict: a full disk cannot change it.") { CourseCopy().check_story("full_disk"); }
