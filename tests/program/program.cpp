#include "tests/program/program.hpp"

#include <fmt/format.h>

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace workbook::testing {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

void replace_in(const fs::path& file, const std::string& from, const std::string& to) {
  std::string text = read(file);
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error(fmt::format("'{}' is not in {}", from, file.string()));
  write(file, text.replace(at, from.size(), to));
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

CourseCopy::CourseCopy() {
  static std::atomic<int> number{0};
  root_ = fs::path(WORKBOOK_TEST_SCRATCH) / fmt::format("course-{}-{}", getpid(), number++);
  fs::remove_all(root_);
  fs::create_directories(root_);
  fs::copy(WORKBOOK_TEST_COURSE, root_, fs::copy_options::recursive);
  fs::copy(WORKBOOK_TEST_REFERENCE, root_ / "reference", fs::copy_options::recursive);
  // Compiled workers are shared between tests, so that each stub and solution is compiled once.
  const nlohmann::json course = {{"root", root_.string()},
                                 {"lectures", {"01_springs"}},
                                 {"reference", (root_ / "reference").string()},
                                 {"toolchain", WORKBOOK_TEST_TOOLCHAIN},
                                 {"scratch", std::string(WORKBOOK_TEST_SCRATCH) + "/shared"},
                                 {"notes", (root_ / "html").string()},
                                 {"build", (root_ / "build").string()}};
  write(root_ / "course.json", course.dump(2));
}

CourseCopy::~CourseCopy() {
  std::error_code ignored;
  fs::remove_all(root_, ignored);
}

Outcome CourseCopy::run(const std::string& arguments, const std::string& environment) const {
  const fs::path out = root_ / "stdout.txt";
  const fs::path err = root_ / "stderr.txt";
  const std::string command =
      fmt::format("cd '{}' && {} '{}' --course '{}' {} </dev/null >'{}' 2>'{}'", root_.string(), environment,
                  WORKBOOK_TEST_CHECKER, (root_ / "course.json").string(), arguments, out.string(), err.string());
  const int raw = std::system(command.c_str());
  return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, read(out), read(err)};
}

void CourseCopy::answer_energy(const std::string& body, const std::string& before) const {
  write(exercise("spring_energy"),
        before +
            "#include <rigid/springs.hpp>\nnamespace rigid {\ndouble spring_energy(double k, const Vector3d& x) {\n" +
            body + "\n}\n}\n");
}

}  // namespace workbook::testing
