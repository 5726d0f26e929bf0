#include "tests/program/program.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <atomic>

namespace workbook::testing {

namespace fs = std::filesystem;

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
  const int status = run_in_shell(command);
  return {status, read(out), read(err)};
}

void CourseCopy::answer_energy(const std::string& body, const std::string& before) const {
  write(exercise("spring_energy"),
        before +
            "#include <rigid/springs.hpp>\nnamespace rigid {\ndouble spring_energy(double k, const Vector3d& x) {\n" +
            body + "\n}\n}\n");
}

}  // namespace workbook::testing
