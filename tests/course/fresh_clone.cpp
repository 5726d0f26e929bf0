// A clone of the workbook with a small course, in a folder whose name has a space: the first check, a lecture and an
// exercise written by an author, and the same folder copied.
#include <doctest/doctest.h>
#include "tests/support/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace workbook::testing;

const fs::path project = WORKBOOK_ROOT;
const fs::path scratch = WORKBOOK_TEST_SCRATCH;

/// Types a command in a folder.
Outcome run(const fs::path& folder, const std::string& command) {
  return run_command(fmt::format("cd '{}' && WORKBOOK_SKIP_PACKAGES=1 {}", folder.string(), command), scratch);
}

std::string verdict(const fs::path& folder, const std::string& exercise) {
  const Outcome outcome = run(folder, "./checker/run check --json " + exercise);
  INFO(outcome.err);
  const auto document = nlohmann::json::parse(outcome.out, nullptr, false);
  REQUIRE(!document.is_discarded());
  return document.at("results").at(0).at("verdict");
}

bool is_said_once(const std::string& text, const std::string& words) {
  return has(text, words) && text.find(words) == text.rfind(words);
}

/// All that is not the course, and the small course.
fs::path clone(const std::string& name) {
  fs::path folder = scratch / name;
  const fs::path course = project / "tests/program/course";
  fs::create_directories(folder / "include/rigid");
  for (const char* part :
       {"CMakeLists.txt", "CMakePresets.json", "checker", "include/rigid/vocabulary.hpp", "lectures/CMakeLists.txt",
        "lectures/live", "lectures/site", "lectures/support", "solutions/CMakeLists.txt", "solutions/judging"}) {
    fs::create_directories((folder / part).parent_path());
    fs::copy(project / part, folder / part, fs::copy_options::recursive);
  }
  for (const auto& file : fs::directory_iterator(project / "lectures"))
    if (file.path().extension() == ".cmake") fs::copy(file, folder / "lectures" / file.path().filename());
  fs::copy(course, folder, fs::copy_options::recursive);
  write(folder / "tests/CMakeLists.txt", "# The tests are those of the workbook.\n");
  return folder;
}

constexpr const char* period_judging =
    R"cpp(#include "rigid/pendulums.hpp"
#include "solutions/judging/judging.hpp"

          void judge_pendulum_period(workbook::judging::Lecture& lecture) {
            using namespace workbook::judging;
            auto& e = lecture.exercise(&rigid::pendulum_period, {{"length", metre}, {"g", m_per_s2}}, {"T", second});
            e.worked("a metre on Earth", 1, 9.81);
            e.random("a pendulum", 8, [](Random& random) { return std::tuple{random.uniform(0.5, 3), random.uniform(1.5, 12)}; });
            e.wrong_output("The factor 2π is missing.", "no_two_pi", times(1 / (2 * pi)));
            e.wrong("Length and gravity have changed places.", "inverted",
                    [](double length, double g) { return 2 * pi * std::sqrt(g / length); });
            e.wrong("The root is missing.", "no_root", [](double length, double g) { return 2 * pi * length / g; });
            e.route("from the frequency", [](double length, double g) { return 2 * pi / std::sqrt(g / length); });
            e.route("by powers", [](double length, double g) { return 2 * pi * std::pow(length, 0.5) * std::pow(g, -0.5); });
            e.route("squared", [](double length, double g) { return std::sqrt(4 * pi * pi * length / g); });
            e.sweep({"Period", "length (m)", "T (s)"}, {{"T"}}, {0.5, 3}, [](double length) {
  return std::tuple{length, 9.81}; });
          }
    )cpp";

void solve_as_author(const fs::path& folder) {
  const fs::path solution = folder / "solutions/02_pendulums/pendulum_period.cpp";
  write(solution,
        "#include \"rigid/pendulums.hpp\"\n\n#include <cmath>\n#include <numbers>\n\nnamespace rigid {\n\n"
        "double pendulum_period(double length, double g) {\n"
        "  return 2 * std::numbers::pi * std::sqrt(length / g);\n}\n\n}  // namespace rigid\n");
  write(folder / "solutions/02_pendulums/judging/pendulum_period.cpp", period_judging);
  write(folder / "solutions/02_pendulums/derivations/pendulum_period.md", "# The period\n\nBy the energy.\n");
}

}  // namespace

TEST_CASE("a fresh clone checks, grows by a lecture, and is built where it lies") {
  fs::remove_all(scratch);
  const fs::path first = clone("first clone");

  // The first check makes what it needs in one build, and no more.
  const Outcome checked = run(first, "./checker/run check spring_energy --file solutions/01_springs/spring_energy.cpp");
  CHECK_MESSAGE(checked.status == 0, checked.err);
  CHECK_MESSAGE(is_said_once(checked.err, "Building "), checked.err);
  CHECK(verdict(first, "spring_energy") == "not_started");
  CHECK(!fs::exists(first / "build/workbook/printed"));
  CHECK(!fs::exists(first / "build/workbook/checker/toolchain/diagnostic/prelude.hpp.gch"));

  // Where there is no checker yet and the judging does not build, the checker does, and says whose fault it is.
  const fs::path judging = first / "solutions/01_springs/judging/spring_energy.cpp";
  const std::string text = read(judging);
  fs::remove(first / "build/workbook/checker/checker");
  write(judging, text + "int broken(\n");
  CHECK(verdict(first, "spring_energy --file solutions/01_springs/spring_energy.cpp") == "checker_error");
  write(judging, text);

  // A lecture and an exercise from their skeletons build at once.
  const Outcome lecture = run(first, "./checker/run new lecture 02_pendulums");
  CHECK_MESSAGE(lecture.status == 0, lecture.err);
  const Outcome exercise = run(first,
                               "./checker/run new exercise pendulum_period --lecture 02 --signature "
                               "'double pendulum_period(double length, double g)'");
  CHECK_MESSAGE(exercise.status == 0, exercise.err);
  CHECK(verdict(first, "pendulum_period") == "not_started");
  const Outcome unfinished = run(first, "./checker/run self-check --seeds 1 pendulum_period");
  CHECK(unfinished.status == 1);
  CHECK_MESSAGE(has(unfinished.out, "solutions/02_pendulums/judging/pendulum_period.cpp: "), unfinished.out);

  // An author writes it, and a student solves it.
  solve_as_author(first);
  const Outcome unrecorded = run(first, "./checker/run self-check --seeds 1 02");
  CHECK_MESSAGE(has(unrecorded.out, "self-check --record pendulum_period"), (unrecorded.out + unrecorded.err));
  CHECK(run(first, "./checker/run self-check --record 02").status == 0);
  const Outcome green = run(first, "./checker/run self-check --seeds 2 02");
  CHECK_MESSAGE(green.status == 0, (green.out + green.err));
  const fs::path answer = "lectures/02_pendulums/exercises/pendulum_period.cpp";
  fs::copy_file(first / "solutions/02_pendulums/pendulum_period.cpp", first / answer,
                fs::copy_options::overwrite_existing);
  CHECK(verdict(first, "pendulum_period") == "passed");

  // The worked examples of a lecture are built with the exercises that they call, and with no others.
  write(first / "lectures/01_springs/worked_examples.cpp",
        "#include <rigid/springs.hpp>\n\n#include <doctest/doctest.h>\n\n"
        "TEST_CASE(\"energy\") { CHECK(rigid::spring_energy(2, {3, 0, 0}) == 9); }\n");
  const Outcome not_started = run(first, "./checker/run examples 01");
  CHECK_MESSAGE(has(not_started.out, "needs spring_energy (not started)"), not_started.said());
  fs::copy_file(first / "solutions/01_springs/spring_energy.cpp",
                first / "lectures/01_springs/exercises/spring_energy.cpp", fs::copy_options::overwrite_existing);
  const Outcome examples = run(first, "./checker/run examples 01");
  CHECK_MESSAGE(has(examples.out, "1 of 1 worked examples of 01_springs hold"), examples.said());
  const fs::path objects = first / "build/workbook/lectures/CMakeFiles/exercises_of_the_student.dir";
  CHECK(fs::exists(objects / "01_springs/exercises/spring_energy.cpp.o"));
  CHECK(!fs::exists(objects / "02_pendulums/exercises/pendulum_period.cpp.o"));

  // Refused with a sentence, and nothing written.
  for (const char* refused : {"lecture 02_pendulums", "lecture pendulums",
                              "exercise pendulum_period --lecture 01 --signature 'double pendulum_period(double x)'",
                              "exercise other --lecture 01 --signature 'float other(double x)'"})
    CHECK_MESSAGE(run(first, std::string("./checker/run new ") + refused).status == 2, refused);
  CHECK(!fs::exists(first / "lectures/01_springs/exercises/other.cpp"));

  // A copy, as a folder that was moved, is built where it is now: it grades its own files, not those it was copied
  // from.
  const fs::path copy = scratch / "a copy";
  REQUIRE(run(scratch, fmt::format("cp -a '{}' '{}'", first.string(), copy.string())).status == 0);
  const Outcome built = run(copy, "bash checker/setup.sh build/workbook toolchain");
  CHECK_MESSAGE(built.status == 0, built.err);
  const auto course = nlohmann::json::parse(read(copy / "build/workbook/checker/course.json"));
  CHECK(course.at("root") == copy.string());
  CHECK(!has(read(copy / "build/workbook/build.ninja"), first.string()));
}

TEST_CASE("a folder that cannot be written is named in one sentence") {
  const fs::path folder = clone("read only");
  write(folder / "build", "a file where the folder should be\n");
  const Outcome outcome = run(folder, "./checker/run check spring_energy");
  CHECK(outcome.status == 3);
  CHECK_MESSAGE(is_said_once(outcome.err, "cannot be written"), outcome.err);
}
