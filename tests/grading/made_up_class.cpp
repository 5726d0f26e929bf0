#include "tests/grading/made_up_class.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>

namespace workbook::testing {

namespace fs = std::filesystem;

const char* const right_energy = "return 0.5 * k * x.squaredNorm();";
const char* const right_force = "return -k * x;";
const char* const force_by_energy =
    "if (x.isZero(0)) return x;\n  return -2 * spring_energy(k, x) / x.squaredNorm() * x;";

namespace {

bool others_reach_the_checker() {
  const pid_t process = fork();
  if (process == 0) _exit(setuid(64000) == 0 && access(WORKBOOK_TEST_CHECKER, X_OK) == 0 ? 0 : 1);
  int status = 1;
  waitpid(process, &status, 0);
  return status == 0;
}

/// Where the workbook lies below a folder of root alone, as /root is: puts an empty folder in its place that others may
/// enter, and the workbook into that. Nobody but this process and its children sees it.
bool open_the_way() {
  const fs::path workbook = WORKBOOK_ROOT;
  fs::path closed = workbook.root_path();
  for (auto part = std::next(workbook.begin()); part != workbook.end(); ++part) {
    closed /= *part;
    if ((fs::status(closed).permissions() & fs::perms::others_exec) == fs::perms::none) break;
  }
  if (closed == workbook) return false;
  if (unshare(CLONE_NEWNS) != 0 || mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return false;
  const std::string inside = fmt::format("/proc/self/fd/{}", open(workbook.c_str(), O_PATH | O_CLOEXEC));
  std::error_code failed;
  return mount("way", closed.c_str(), "tmpfs", 0, "mode=755") == 0 && fs::create_directories(workbook, failed) &&
         mount(inside.c_str(), workbook.c_str(), nullptr, MS_BIND | MS_REC, nullptr) == 0 &&
         chdir(workbook.c_str()) == 0;
}

}  // namespace

bool is_open_to_all() {
  static const bool is_open = [] {
    if (geteuid() != 0 || others_reach_the_checker() || (open_the_way() && others_reach_the_checker())) return true;
    std::puts("Left out: as root, grading needs a workbook that everybody can read.");
    return false;
  }();
  return is_open;
}

void MadeUpClass::energy(const std::string& student, const std::string& body) const {
  write(submissions() / student / "spring_energy.cpp", energy_text(body));
}

void MadeUpClass::force(const std::string& student, const std::string& body) const {
  write(submissions() / student / "spring_force.cpp", force_text(body));
}

void MadeUpClass::hand_in_ordinary_files() const {
  energy("ada", right_energy);
  force("ada", right_force);
  energy("ben", "return k * x.squaredNorm();");
  force("ben", force_by_energy);  // waits for the other one
  energy("cleo", right_energy);
  force("cleo", force_by_energy);
  const std::string odd = "double e = 0;\n  for (int i = 0; i < 3; ++i) e += std::cosh(k * x[i]);\n  return e;";
  energy("dora/deeper/and deeper", odd);
  energy("emil", odd);
  energy("emil/kept", odd);  // the same once more
  const std::string clone = "fritz/workbook/lectures/01_springs/exercises";
  energy("fritz", "return 7;");  // not where the workbook has it
  energy(clone, right_energy);
  force(clone, right_force);
  write(submissions() / "fritz/workbook/.git/spring_force.cpp", "not looked at");
  write(submissions() / "gustl_spring_energy.cpp", energy_text("return 0.5 * k * x^2;"));
  write(submissions() / "gustl_spring_force-2.cpp", force_text(right_force));
  write_zip(submissions() / "hans.zip", {{"spring_energy.cpp", energy_text(right_energy).c_str()},
                                         {"files/spring_force.cpp", force_text("return k * x;").c_str()},
                                         {"readme.txt", "Hello."}});
  const fs::path inner = root() / "inner.zip";
  write_zip(submissions() / "ida/work.zip", {{"ü/spring_energy.cpp", energy_text("return x(7);").c_str()}});
  write(submissions() / "jan/Spring Energy (1).cpp", energy_text(right_energy));
  write(submissions() / "kim/readme.txt", "I have not done anything.");
  energy("lea", "throw NotStarted{};");
}

void MadeUpClass::hand_in_few_files() const {
  energy("ada", right_energy);
  force("ada", force_by_energy);
  energy("ben", "return k * x.squaredNorm();");
  force("ben", force_by_energy);
  energy("cleo", "return 0.5 * k * x.norm()");
}

void MadeUpClass::hand_in_hostile_files() const {
  const auto place = [&](const std::string& student) {
    fs::create_directories(submissions() / student);
    return submissions() / student / "spring_energy.cpp";
  };
  fs::create_symlink(solution("spring_energy"), place("link"));
  fs::create_directory_symlink(submissions() / "ada", submissions() / "linked_folder");
  if (::mkfifo(place("fifo").c_str(), 0600) != 0) throw std::runtime_error("no FIFO can be made");
  fs::create_directories(place("folder") / "below");
  fs::create_hard_link(solution("spring_energy"), place("hard_link"));
  write(place("sparse"), "");
  fs::resize_file(place("sparse"), std::uintmax_t{20} << 30);
  write(place("binary"), energy_text(right_energy) + std::string(1, '\0'));
  energy("locked/away", right_energy);
  fs::permissions(submissions() / "locked/away", fs::perms::none);
  energy("twice/a", right_energy);
  energy("twice/b", "return 1;");
  const std::string zeros(std::size_t{8} << 20, '/');
  write_zip(submissions() / "bomb.zip", {{"spring_energy.cpp", zeros.c_str()}});
  const std::string right = energy_text(right_energy), wrong = energy_text("return 0;");
  write_zip(submissions() / "slip.zip", {{"../ada/spring_energy.cpp", wrong.c_str()},
                                         {"/tmp/spring_energy.cpp", wrong.c_str()},
                                         {"x/spring_force.cpp", std::nullopt}});
  write(submissions() / "torn.zip", "PK\3\4 and then nothing of use");
  energy("=HYPERLINK(\"http:evil\",\"click\")", "for (volatile int i = 0;;) i = i + 1;");
  energy("<img src=x onerror=alert(1)>\n\033[31m", "throw std::runtime_error(\"<script>alert(1)</script>\");");
  energy("ADA", "asm(\".incbin \\\"/etc/passwd\\\"\"); return 0;");
  write(place("killer"), "#include <signal.h>\n#include <unistd.h>\n" + energy_text("kill(getppid(), 9); return 0;"));
  write(submissions() / "stray.txt", "Nobody's.");
}

Outcome MadeUpClass::grade(const std::string& out, const std::string& options, const std::string& environment) const {
  const bool has_cases =
      options.find("--seed") != std::string::npos || options.find("--reference") != std::string::npos;
  return run(fmt::format("grade submissions --out {} --allow-reduced {} {}", out, has_cases ? "" : "--seed 1", options),
             environment);
}

nlohmann::json MadeUpClass::student(const std::string& id) const {
  const auto document = nlohmann::json::parse(read(root() / "out/class.json"));
  for (const auto& student : document.at("students"))
    if (student.at("id") == id)
      return nlohmann::json::parse(read(root() / "out/students" / (student.at("slug").get<std::string>() + ".json")));
  throw std::runtime_error("no student " + id);
}

bool is_judged_once(const fs::path& journal) {
  std::set<std::string> keys;
  std::istringstream lines(read(journal));
  for (std::string line; std::getline(lines, line);)
    if (!keys.insert(nlohmann::json::parse(line).at("entry").at("key")).second) return false;
  return !keys.empty();
}

std::map<std::string, std::string> results_in(const fs::path& out) {
  std::map<std::string, std::string> files;
  for (const fs::path& file : files_below(out))
    if (file.filename() != "journal.jsonl") files[file.lexically_relative(out).string()] = read(file);
  return files;
}

}  // namespace workbook::testing
