#include "tests/program/program.hpp"

#include "checker/base/text.hpp"
#include "tests/support/golden.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <stdexcept>

namespace workbook::testing {

namespace fs = std::filesystem;

namespace {

fs::path golden_file(const std::string& name) {
  return fs::path(WORKBOOK_TEST_COURSE).parent_path() / "golden" / (name + ".txt");
}

/// What hands do in stories: `answer BODY [BEFORE]` writes that body of spring_energy with something before it, `force
/// BODY [BEFORE]` that of spring_force, `judged` tells the checker's document on the first, `solve NAME` the solution;
/// `offered WORD...` is what bash would complete the last word to, and `restore` brings back what a story saved of the
/// course. `hand_in PATH...` makes the folder of a class and a zip file of it, in which each path is a right
/// spring_energy of its own text, in a folder where it is none; `whose OPTION...` says who has handed in what by the
/// folder, and nothing more where it says the same by the zip file.
constexpr const char* words = R"sh(
answer() {
  printf '%s#include <rigid/springs.hpp>\nnamespace rigid {\ndouble spring_energy(double k, const Vector3d& x) {\n%s\n}\n}\n' \
    "${2:+$2
}" "$1" >lectures/01_springs/exercises/spring_energy.cpp
}
judged() {
  ours check spring_energy --json >said.json
  echo "status $?"
  grep -E '^ *"(verdict|score|points|kind|name|line|excerpt|message|next)":' said.json
}
force() {
  printf '#include <rigid/springs.hpp>\nnamespace rigid {\n%s\nVector3d spring_force(double k, const Vector3d& x) {\n%s\n}\n}\n' \
    "$2" "$1" >lectures/01_springs/exercises/spring_force.cpp
}
solve() { cp "solutions/01_springs/$1.cpp" lectures/01_springs/exercises; }
offered() {
  bash -c '. ./completion.bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _rigid_body_workbook; echo "${COMPREPLY[@]}"' \
    bash "$@"
}
restore() { rm -rf include lectures solutions; cp -r saved/* .; }
hand_in() {
  rm -rf submissions class.zip
  for path; do
    case $path in *.*) ;; *) path=$path/spring_energy.cpp ;; esac
    mkdir -p "submissions/$(dirname "$path")"
    (cat solutions/01_springs/spring_energy.cpp; echo "// $path") >"submissions/$path"
  done
  (cd submissions && LC_ALL=C.UTF-8 cmake -E tar cf ../class.zip --format=zip -- *)
}
whose() {
  for class in submissions class.zip; do ours grade $class --who "$@" >$class.said 2>&1; done
  cat submissions.said
  diff submissions.said class.zip.said
}
)sh";

}  // namespace

CourseCopy::CourseCopy() {
  static std::atomic<int> number{0};
  root_ = fs::path(WORKBOOK_TEST_SCRATCH) / fmt::format("course-{}-{}", getpid(), number++);
  fs::remove_all(root_);
  fs::create_directories(root_);
  fs::copy(WORKBOOK_TEST_COURSE, root_, fs::copy_options::recursive);
  fs::copy(WORKBOOK_TEST_REFERENCE, root_ / "reference", fs::copy_options::recursive);
  // Compiled workers are shared between tests, so that each stub and solution is compiled once.
  const nlohmann::json course = {{"root", root_.string()},
                                 {"reference", (root_ / "reference").string()},
                                 {"toolchain", WORKBOOK_TEST_TOOLCHAIN},
                                 {"scratch", std::string(WORKBOOK_TEST_SCRATCH) + "/shared"},
                                 {"notes", (root_ / "html").string()},
                                 {"build", (root_ / "build").string()},
                                 {"setup", (root_ / "setup.sh").string()}};
  write(root_ / "course.json", course.dump(2));
  stand_in("setup.sh", "exit 0");  // as if all were built
}

CourseCopy::~CourseCopy() {
  std::error_code ignored;
  fs::remove_all(root_, ignored);
}

std::string CourseCopy::shell_command(const std::string& arguments, const std::string& environment) const {
  return fmt::format("cd '{}' && {} '{}' --course '{}' {}", root_.string(), environment, WORKBOOK_TEST_CHECKER,
                     (root_ / "course.json").string(), arguments);
}

Outcome CourseCopy::run(const std::string& arguments, const std::string& environment) const {
  return run_command(shell_command(arguments, environment), root_);
}

std::pair<pid_t, int> CourseCopy::start_on_terminal(const std::string& arguments, int columns, int rows,
                                                    const std::string& environment,
                                                    const std::function<void()>& prepare) const {
  winsize size{};
  size.ws_row = static_cast<unsigned short>(rows);
  size.ws_col = static_cast<unsigned short>(columns);
  const std::string command = shell_command(arguments, "exec env -i PATH=\"$PATH\" " + environment);
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
  if (child < 0) throw std::runtime_error("no pseudo terminal");
  if (child == 0) {
    if (prepare) prepare();
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  return {child, terminal};
}

TerminalOutcome CourseCopy::run_on_terminal(const std::string& arguments, int columns, int rows,
                                            const std::string& environment) const {
  const auto [child, terminal] = start_on_terminal(arguments, columns, rows, environment, [] {
    alarm(120);  // survives exec: a checker that hangs ends the test
  });
  TerminalOutcome outcome;
  char buffer[65536];
  for (ssize_t count = 0; (count = ::read(terminal, buffer, sizeof buffer)) > 0;)  // an error when all has ended
    outcome.shown.append(buffer, static_cast<std::size_t>(count));
  int status = 0;
  waitpid(child, &status, 0);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  close(terminal);
  return outcome;
}

std::string CourseCopy::shown_after(const std::string& typed, const std::string& environment) const {
  const std::string checker = fmt::format("/usr/bin/env {} '{}' --course '{}' ", environment, WORKBOOK_TEST_CHECKER,
                                          (root_ / "course.json").string());
  const std::string command = replaced(typed, R"((^|[;|] |do |^\w+=\S+ )checker )", "$1" + checker);
  const Outcome outcome = run_command(
      fmt::format("cd '{}' && {{ {}ours() {{ {} \"$@\"; }}\n{}\n}}", root_.string(), words, checker, command), root_);
  const bool is_silent = outcome.status == 0 && outcome.said().empty();
  const std::string end = is_silent ? "" : fmt::format("[{}]\n", outcome.status);
  return without_place(fmt::format("$ {}\n{}{}\n", typed, outcome.said(), end));
}

std::string CourseCopy::screens(const std::vector<std::string>& commands, const std::string& environment) const {
  std::string text;
  for (const std::string& command : commands) text += shown_after("checker " + command, environment);
  return text;
}

std::string CourseCopy::check_story(const std::string& name, const std::string& environment) const {
  std::string text;
  for (const std::string& line : lines_of(read(golden_file(name))))
    if (line.starts_with("$ ")) text += shown_after(line.substr(2), environment);
  REQUIRE(!text.empty());
  check_golden(name, text);
  return text;
}

std::string CourseCopy::without_place(std::string text) const {
  const std::string root = root_.string();
  const bool needs_quotes = workbook::shell_quoted(root) != root;  // as a folder with a blank does, in commands
  for (std::size_t at = 0; (at = text.find(root, at)) != std::string::npos;) {
    text.replace(at, root.size(), "COURSE");
    const std::size_t end = text.find('\'', at);
    if (!needs_quotes || at == 0 || text[at - 1] != '\'' || end == std::string::npos) continue;
    text.erase(end, 1).erase(at - 1, 1);
  }
  return text;
}

void CourseCopy::answer_energy(const std::string& body, const std::string& before) const {
  write(exercise("spring_energy"), before + energy_text(body));
}

void CourseCopy::solve(const std::string& name) const {
  fs::copy_file(solution(name), exercise(name), fs::copy_options::overwrite_existing);
}

void CourseCopy::stand_in(const std::string& program, const std::string& script) const {
  write(root_ / program, "#!/bin/sh\n" + script + "\n");
  fs::permissions(root_ / program, fs::perms::owner_all);
}

std::string energy_text(const std::string& body) {
  return "#include <rigid/springs.hpp>\nnamespace rigid {\ndouble spring_energy(double k, const Vector3d& x) {\n" +
         body + "\n}\n}\n";
}

std::string force_text(const std::string& body) {
  return "#include <rigid/springs.hpp>\nnamespace rigid {\nVector3d spring_force(double k, const Vector3d& x) {\n" +
         body + "\n}\n}\n";
}

void check_golden(const std::string& name, const std::string& text) { compare_with_golden(golden_file(name), text); }

}  // namespace workbook::testing
