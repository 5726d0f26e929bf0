// A student's whole course: what the checker calls next is written, checked and passed, until nothing is left.
#include <doctest/doctest.h>
#include "checker/base/text.hpp"
#include "tests/support/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace workbook::testing;

/// The course with nothing solved, in a folder of its own; compiled files and the rest of the build are shared.
class FreshCourse {
 public:
  FreshCourse() : root_(WORKBOOK_TEST_SCRATCH) {
    fs::remove_all(root_);
    fs::create_directories(root_);
    const fs::path workbook = WORKBOOK_ROOT;
    for (const char* part : {"lectures", "include"})
      fs::copy(workbook / part, root_ / part, fs::copy_options::recursive);
    auto course = nlohmann::json::parse(read(WORKBOOK_COURSE));
    course["root"] = root_.string();
    write(root_ / "course.json", course.dump(2));
  }

  Outcome run(const std::string& arguments) const {
    return run_command(
        fmt::format("cd '{}' && '{}' --course course.json {}", root_.string(), WORKBOOK_TEST_CHECKER, arguments),
        root_);
  }

  const fs::path& root() const { return root_; }

 private:
  fs::path root_;
};

}  // namespace

TEST_CASE("the whole course is solved, one exercise after another, through the commands of a student") {
  const FreshCourse course;
  std::vector<std::string> solved;
  while (true) {
    const std::string status = course.run("").out;
    const std::string next = workbook::search(status, "Next: (\\w+)")[1];
    if (next.empty()) break;
    CAPTURE(next);
    const std::string file = workbook::search(status, "file +(\\S+)")[1];
    REQUIRE_MESSAGE(fs::is_regular_file(course.root() / file), status);
    CHECK(course.run("hint " + next).status == 0);
    const Outcome stub = course.run("check " + next);
    CHECK(stub.status == 1);
    CHECK_MESSAGE(stub.out.find("not started") != std::string::npos, stub.out);
    const std::string lecture = fs::path(file).parent_path().parent_path().filename().string();
    fs::copy_file(fs::path(WORKBOOK_ROOT) / "solutions" / lecture / (next + ".cpp"), course.root() / file,
                  fs::copy_options::overwrite_existing);
    const Outcome checked = course.run("check " + next);
    REQUIRE_MESSAGE(checked.status == 0, checked.out);
    CHECK(checked.out.find("✓ " + next) != std::string::npos);
    solved.push_back(next);
    REQUIRE(solved.size() <= 1000);
  }
  CHECK(solved.size() == WORKBOOK_EXERCISES);
  const std::string end = course.run("").out;
  CHECK_MESSAGE(end.find(fmt::format("All {} exercises pass", solved.size())) != std::string::npos, end);
  // Everything at once, as a student does at the end; compiled files are remembered, so this is quick.
  const Outcome all = course.run("check");
  CHECK(all.status == 0);
  CHECK(all.out.find(fmt::format("{} of {} passed.", solved.size(), solved.size())) != std::string::npos);
  // The student's functions as WebAssembly, where the notes are there and emscripten is installed.
  if (fs::exists(fs::path(WORKBOOK_COURSE).parent_path().parent_path() / "notes/html/live/live.js")) {
    const Outcome live = course.run("live 02");
    if (live.said().find("install the package emscripten") != std::string::npos) return;
    CHECK_MESSAGE(live.status == 0, live.said());
    CHECK(live.out.find("lecture_02_rotating_frames.html?yours") != std::string::npos);
  }
}

TEST_CASE("lectures 07 and 08 are solved with functions that are written once, and one that breaks is named") {
  const FreshCourse course;
  const auto file = [&](const std::string& lecture, const std::string& name) {
    return course.root() / "lectures" / lecture / "exercises" / (name + ".cpp");
  };
  for (const char* lecture : {"07_euler_angles", "08_kinetic_energy"})
    for (const auto& solution : fs::directory_iterator(fs::path(WORKBOOK_ROOT) / "solutions" / lecture))
      if (const fs::path own = file(lecture, solution.path().stem().string());
          solution.path().extension() == ".cpp" && fs::exists(own))
        fs::copy_file(solution.path(), own, fs::copy_options::overwrite_existing);
  const auto answer = [&](const std::string& lecture, const std::string& header, const std::string& function,
                          const std::string& body) {
    const std::string name = function.substr(0, function.find('(')).substr(function.find(' ') + 1);
    write(file(lecture, name), fmt::format("#include <rigid/{}.hpp>\n\nnamespace rigid {{\n\n{} {{\n  {}\n}}\n\n}}\n",
                                           header, function, body));
  };
  answer("07_euler_angles", "euler_angles",
         "Vector3d inertial_components(const Vector3d& V_body, const Vector3d& angles)",
         "return rotation_matrix(angles).transpose() * V_body;");
  answer("07_euler_angles", "euler_angles", "Vector3d vertical_in_body(double theta, double psi)",
         "return rotation_matrix({0, theta, psi}).col(2);");
  answer("07_euler_angles", "euler_angles",
         "Vector3d angular_velocity_inertial(const Vector3d& angles, const Vector3d& rates)",
         "return inertial_components(angular_velocity_body(angles, rates), angles);");
  answer("08_kinetic_energy", "kinetic_energy",
         "double kinetic_energy_euler(const Vector3d& I, const Vector3d& angles, const Vector3d& rates)",
         "return 0.5 * I.dot(angular_velocity_body(angles, rates).cwiseAbs2());");
  const Outcome solved = course.run("check 07 08");
  CHECK_MESSAGE(solved.status == 0, solved.out);

  replace_in(file("07_euler_angles", "rotation_matrix"), "return about_z", "return -about_z");
  const auto verdict_of = [&](const std::string& name) {
    const auto document = nlohmann::json::parse(course.run("check --json " + name).out);
    return document.at("results").at(0);
  };
  CHECK(verdict_of("rotation_matrix").at("verdict") == "wrong_value");
  for (const char* name : {"inertial_components", "vertical_in_body"}) {
    const auto result = verdict_of(name);
    CHECK(result.at("verdict") == "waiting");
    CHECK(result.at("waiting_for") == nlohmann::json{"rotation_matrix"});
  }
  CHECK(verdict_of("angular_velocity_inertial").at("waiting_for").size() == 2);
  CHECK(verdict_of("kinetic_energy_euler").at("verdict") == "passed");
}
