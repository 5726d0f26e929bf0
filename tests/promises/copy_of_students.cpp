// The copy that students get: what is in it, what is not, and that its commands work.
#include <doctest/doctest.h>
#include "checker/base/formulas.hpp"
#include "checker/base/text.hpp"
#include "checker/data/reference_results.hpp"
#include "tests/support/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace workbook::testing;

const fs::path project = WORKBOOK_ROOT;
const fs::path scratch = WORKBOOK_TEST_SCRATCH;

Outcome run(const std::string& command) { return run_command(command, scratch); }

/// One copy for all tests, drawn with a seed of its own, whose reference results self_check_seeds has made: it takes a
/// while, so where it fails it is made once too.
const fs::path& copy() {
  static const fs::path folder = scratch / "copy";
  static const Outcome made = [] {
    fs::remove_all(scratch);
    fs::create_directories(scratch);
    return run(fmt::format("'{}' handout --seed 3 '{}'", WORKBOOK_TEST_CHECKER, folder.string()));
  }();
  REQUIRE_MESSAGE(made.status == 0, made.said());
  return folder;
}

/// Text without white space, so that only what is written is compared and not how it is laid out.
std::string squeezed(const std::string& text) {
  std::string result;
  for (const unsigned char letter : text) {
    if (std::isspace(letter) == 0) result += static_cast<char>(letter);
  }
  return result;
}

/// The pages of the notes that are in the copy; none where this machine cannot build them.
const std::vector<fs::path>& pages() {
  static const std::vector<fs::path> all = [] {
    const fs::path archive = copy() / "lectures/site/handed_out.zip", folder = scratch / "pages";
    if (!fs::exists(archive)) return std::vector<fs::path>();
    fs::create_directories(folder);
    const Outcome unpacked = run(fmt::format("cd '{}' && cmake -E tar xf '{}'", folder.string(), archive.string()));
    REQUIRE_MESSAGE(unpacked.status == 0, unpacked.said());
    return files_below(folder);
  }();
  return all;
}

/// All files of the copy as it was handed out; of a page what is read there.
const std::map<fs::path, std::string>& texts() {
  static const std::map<fs::path, std::string> all = [] {
    std::map<fs::path, std::string> found;
    for (const fs::path& file : files_below(copy())) found[file] = squeezed(read(file));
    for (const fs::path& page : pages()) {
      const std::string text = read(page);
      found[page] = squeezed(page.extension() == ".html" ? workbook::replaced(text, "<[^>]*>", "") : text);
    }
    return found;
  }();
  return all;
}

/// The solutions of the exercises by name.
std::map<std::string, std::string> solutions() {
  std::map<std::string, std::string> all;
  for (const fs::path& file : files_below(project / "solutions")) {
    const fs::path stub = project / "lectures" / file.parent_path().filename() / "exercises" / file.filename();
    if (fs::exists(stub)) all[file.stem().string()] = read(file);
  }
  return all;
}

/// What stands between the braces of a function.
std::string body_of(const std::string& function, const std::string& source) {
  const std::size_t begin = source.find('{', source.find(" " + function + "("));
  std::size_t depth = 0;
  for (std::size_t at = begin; at < source.size(); ++at) {
    if (source[at] == '{') ++depth;
    if (source[at] == '}' && --depth == 0) return source.substr(begin + 1, at - begin - 1);
  }
  return "";
}

/// Does a squeezed text hold "Vector3dNAME(constVector3d&x){"?
bool defines(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name + "("); at != std::string::npos; at = text.find(name + "(", at + 1)) {
    const std::size_t end = text.find_first_of(";{}()", at + name.size() + 1);
    const bool has_type =
        at > 0 && (std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0 || text[at - 1] == '>');
    if (has_type && end != std::string::npos && text.compare(end, 2, "){") == 0) return true;
  }
  return false;
}

/// Runs the checker on the copy, with the workers of this build: they are made from the same files.
class CheckerInCopy {
 public:
  explicit CheckerInCopy(fs::path folder = copy()) : folder_(std::move(folder)) {
    const Outcome configured = run(fmt::format("cd '{}' && cmake --preset workbook", folder_.string()));
    REQUIRE_MESSAGE(configured.status == 0, configured.said());
    auto course = nlohmann::json::parse(read(folder_ / "build/workbook/checker/course.json"));
    course["toolchain"] = nlohmann::json::parse(read(WORKBOOK_COURSE)).at("toolchain");
    write(folder_ / "build/course.json", course.dump(2));
  }
  Outcome operator()(const std::string& arguments) const {
    return run(fmt::format("cd '{}' && '{}' --course build/course.json {}", folder_.string(), WORKBOOK_TEST_CHECKER,
                           arguments));
  }

 private:
  fs::path folder_;
};

}  // namespace

TEST_CASE("the copy has everything but the solutions, and both commands") {
  CHECK(!fs::exists(copy() / "solutions"));
  CHECK(!fs::exists(copy() / ".workbook"));
  CHECK(!fs::exists(copy() / ".git"));
  CHECK(!fs::exists(copy() / "build"));
  texts();  // before other tests write into it
  for (const char* part : {"README.md", "LICENSE", "CMakeLists.txt", "CMakePresets.json", "include/rigid", "lectures",
                           ".devcontainer/devcontainer.json", ".github/workflows/check.yml", ".clangd", ".gitignore",
                           ".vscode/tasks.json"})
    CHECK_MESSAGE(fs::exists(copy() / part), part);
  for (const char* command : {"checker/run", "tests/run"})
    CHECK_MESSAGE(access((copy() / command).c_str(), X_OK) == 0, command);
}

TEST_CASE("all that the notes show goes along") {
  const fs::path build = fs::path(WORKBOOK_COURSE).parent_path().parent_path();
  std::size_t figures = 0;
  for (const fs::path& figure : files_below(build / "figures")) {
    if (figure.filename() == "drawn") continue;
    const std::string lecture = figure.parent_path().filename().string();
    CHECK_MESSAGE(fs::exists(copy() / "lectures" / lecture / "handed_out/figures" / figure.filename()),
                  figure.string());
    ++figures;
  }
  CHECK(figures > 16);
  for (const fs::path& printed : files_below(build / "printed"))
    CHECK(read(copy() / "lectures" / printed.stem() / "handed_out/printed.txt") == read(printed));
}

TEST_CASE("A copy holds nothing that computes a graded function: no source.") {
  const auto all = solutions();
  REQUIRE(all.size() == WORKBOOK_EXERCISES);
  // doctest's assertions are lambdas, and C++20 as clang knows it lets none of them use a structured binding.
  for (const auto& solution : all) {
    const std::string& name = solution.first;
    const std::string body = squeezed(body_of(name, solution.second));
    REQUIRE_MESSAGE(body.size() > 10, name);
    for (const auto& copied : texts()) {
      const fs::path& file = copied.first;
      const std::string& text = copied.second;
      CHECK_MESSAGE(!has(text, body), name, " is in ", file.string());
      const bool is_stub = file.filename() == name + ".cpp" && has(file.string(), "exercises");
      if (file.extension() == ".cpp" || file.extension() == ".hpp")
        CHECK_MESSAGE(defines(text, name) == is_stub, name, " in ", file.string());
    }
  }
}

TEST_CASE("A copy holds nothing that computes a graded function: no script, no WebAssembly.") {
  std::string scripts;
  for (const auto& [file, text] : texts()) {
    CHECK_MESSAGE(!holds_webassembly(text), file.string());
    // Pages name the exercises; what computes lies in live.
    if (std::ranges::count(pages(), file) > 0 && file.parent_path().filename() != "live") continue;
    if (file.extension() == ".js" || file.extension() == ".html") scripts += read(file);
  }
  CHECK(has(scripts, "function motion("));
  // The reader's own functions are asked for as yours.NAME.
  for (const auto& solution : solutions())
    for (const workbook::Match& use : workbook::search_all(scripts, R"((\S*\b))" + solution.first + R"(\b)"))
      CHECK_MESSAGE(use[1].ends_with("yours."), use[0]);
}

TEST_CASE("every exercise of the copy is as at the beginning, also when it has been solved here") {
  for (const auto& [name, source] : solutions()) {
    for (const fs::path& file : files_below(copy() / "lectures")) {
      if (file.filename() != name + ".cpp") continue;
      CHECK_MESSAGE(has(read(file), "throw NotStarted{}"), file.string());
    }
  }
}

TEST_CASE("A copy holds nothing that computes a graded function: no program.") {
  // The copy's programs are built from the same files as these.
  std::size_t count = 1;
  std::string binaries = fmt::format("'{}'", WORKBOOK_TEST_CHECKER);
  for (const fs::path& file : files_below(fs::path(WORKBOOK_COURSE).parent_path() / "toolchain")) {
    if (file.extension() != ".o") continue;
    binaries += fmt::format(" '{}'", file.string());
    ++count;
  }
  CHECK(count > WORKBOOK_EXERCISES);
  const Outcome symbols = run("nm --demangle --defined-only " + binaries);
  CHECK_MESSAGE(symbols.status == 0, symbols.err);
  CHECK(has(symbols.out, "main"));
  for (const auto& solution : solutions())
    CHECK_MESSAGE(!has(symbols.out, "rigid::" + solution.first + "("), solution.first);
}

TEST_CASE("in the copy the notes are pages without derivations, from the first build on") {
  if (pages().empty()) {
    const fs::path build = fs::path(WORKBOOK_COURSE).parent_path().parent_path();
    CHECK_MESSAGE(!fs::exists(build / "notes/html"), "this machine can build the pages, and the copy has none");
    return;
  }
  for (const fs::path& page : pages())
    CHECK_MESSAGE(workbook::search_all(read(page), R"(id="exercise_\w+_derivation")").empty(), page.string());
  const CheckerInCopy checker;
  const Outcome unpacked = run(fmt::format("cd '{}' && cmake --build build/workbook --target notes", copy().string()));
  REQUIRE_MESSAGE(unpacked.status == 0, unpacked.said());
  const std::string page = (copy() / "build/workbook/notes/html/lecture_03_inertia_tensor.html").string();
  CHECK(fs::exists(page));
  const fs::path wrong = scratch / "inertia_of_points.cpp";
  write(wrong,
        "#include <rigid/inertia_tensor.hpp>\n"
        "Eigen::Matrix3d rigid::inertia_of_points(const Eigen::VectorXd& m, const Eigen::Matrix3Xd& r) {\n"
        "  return r * m.asDiagonal() * r.transpose();\n}\n");
  const Outcome told = checker("check inertia_of_points --file " + wrong.string());
  CHECK_MESSAGE(has(told.said(), "Read   file://" + page), told.said());
}

TEST_CASE("in the copy the checker works with the reference results as data") {
  const CheckerInCopy checker;
  CHECK(has(checker("").said(), "Next: "));
  CHECK(checker("hint inertia_of_points").status == 0);
  const Outcome stub = checker("check inertia_of_points");
  CHECK_MESSAGE(has(stub.said(), "not started"), stub.said());
  const fs::path file = copy() / "lectures/03_inertia_tensor/exercises/inertia_of_points.cpp";
  fs::copy_file(project / "solutions/03_inertia_tensor/inertia_of_points.cpp", file,
                fs::copy_options::overwrite_existing);
  const Outcome right = checker("check inertia_of_points");
  CHECK_MESSAGE(right.status == 0, right.said());

  CHECK(has(read(copy() / ".workbook/progress.json"), "inertia_of_points"));  // it counts, although the seed is not 1
  CHECK(checker("check inertia_of_points --json").json().at("seed") == 3);
  CHECK(checker("check inertia_of_points --seed 3").status == 0);
  const Outcome other_seed = checker("check inertia_of_points --seed 1");
  CHECK(other_seed.status == 3);
  CHECK(has(other_seed.said(), "has reference results for seed 3 only"));
  const Outcome again = checker("handout elsewhere");
  CHECK(again.status == 2);
  CHECK(has(again.said(), "it has no solutions, so no other copy can be made from it"));

  // A student's own files beside the exercises, and solved exercises, are nothing to complain about.
  write(copy() / "lectures/03_inertia_tensor/my notes.txt", "I = sum m (r^2 1 - r r)\n");
  const Outcome in_order = checker("self-check");
  CHECK_MESSAGE(in_order.status == 0, in_order.said());
  CHECK(checker("reset inertia_of_points").status == 0);
}

TEST_CASE("editors find how every exercise of the copy is compiled") {
  const CheckerInCopy checker;
  const std::string commands = read(copy() / "build/workbook/compile_commands.json");
  for (const auto& solution : solutions())
    CHECK_MESSAGE(has(commands, "/" + solution.first + ".cpp\""), solution.first);
  CHECK(has(read(copy() / ".clangd"), "CompilationDatabase: build/workbook"));
}

TEST_CASE("in the copy a lost exercise does not stop the set-up, and can be put back") {
  const CheckerInCopy checker;
  const fs::path file = copy() / "lectures/03_inertia_tensor/exercises/kinetic_energy.cpp";
  fs::remove(file);
  const Outcome configured = run(fmt::format("cd '{}' && cmake --preset workbook", copy().string()));
  CHECK_MESSAGE(configured.status == 0, configured.said());
  CHECK(has(checker("check kinetic_energy").said(), "reset kinetic_energy"));
  CHECK(checker("reset kinetic_energy").status == 0);
  CHECK(has(read(file), "throw NotStarted{}"));
}

TEST_CASE("Solutions and derivations are locked in a copy, and a right function opens them.") {
  const CheckerInCopy checker;
  for (const fs::path& derivation : files_below(project / "solutions")) {
    if (derivation.extension() != ".md") continue;
    const std::string lecture = derivation.parent_path().parent_path().filename(), name = derivation.stem();
    CHECK_MESSAGE(fs::exists(copy() / "lectures" / lecture / "handed_out" / (name + ".locked")), name);
    // Displayed formulas may stand folded in the notes.
    std::string text = read(derivation);
    for (std::size_t begin = 0; (begin = text.find("\\f[")) != std::string::npos;)
      text.erase(begin, text.find("\\f]", begin) + 3 - begin);
    const std::string sentence = squeezed(text.substr(text.size() / 2, 60));
    for (const auto& copied : texts()) CHECK_MESSAGE(!has(copied.second, sentence), copied.first.string());
  }
  // Names of routes and of small bugs would tell parts of a solution.
  for (const fs::path& data : files_below(copy() / "lectures"))
    if (data.filename() == "reference.json")
      for (const auto& exercise : workbook::read_reference_results(data).exercises) {
        CHECK(exercise.adequacy.survivors.empty());
        for (const auto& route : exercise.routes) CHECK_MESSAGE(route.name.starts_with("route "), route.name);
      }
  const Outcome before = checker("solution inertia_rate");
  CHECK(before.status == 1);
  fs::copy_file(project / "solutions/03_inertia_tensor/inertia_rate.cpp",
                copy() / "lectures/03_inertia_tensor/exercises/inertia_rate.cpp", fs::copy_options::overwrite_existing);
  const Outcome after = checker("solution inertia_rate");
  CHECK_MESSAGE(after.status == 0, after.said());
  const std::string derivation = read(project / "solutions/03_inertia_tensor/derivations/inertia_rate.md");
  // Without the mark of its heading.
  CHECK(has(squeezed(after.out), squeezed(workbook::with_readable_formulas(derivation)).substr(1)));
  CHECK(checker("reset inertia_rate").status == 0);
}

TEST_CASE("A newer release leaves what a student has written.") {
  const fs::path student = scratch / "student", mine = "lectures/07_euler_angles/exercises/line_of_nodes.cpp";
  fs::remove_all(student);
  for (const fs::path& file : files_below(copy())) {
    const fs::path name = file.lexically_relative(copy());
    if (*name.begin() == "build" || *name.begin() == ".workbook") continue;
    fs::create_directories((student / name).parent_path());
    fs::copy_file(file, student / name);
  }
  write(student / mine, "// mine\n");
  write(student / "lectures/07_euler_angles/notes.md", "# of the first release\n");
  const fs::path assignment = scratch / "week3.json";
  write(assignment, R"({"title": "Week 3", "exercises": ["07"], "due": "2027-03-01T23:59:00Z"})");
  const Outcome made = run(fmt::format("'{}' handout --assignment '{}' --update '{}' --message 'Week 3 begins'",
                                       WORKBOOK_TEST_CHECKER, assignment.string(), copy().string()));
  REQUIRE_MESSAGE(made.status == 0, made.said());
  CHECK(has(made.out, "Release 2, before 1"));
  CHECK(has(made.out, "seed 3"));

  const CheckerInCopy checker;
  CHECK(has(checker("").out, "Week 3, due 2027-03-01T23:59:00Z: 0 of "));
  const Outcome updated = CheckerInCopy(student)(fmt::format("update '{}'", copy().string()));
  REQUIRE_MESSAGE(updated.status == 0, updated.said());
  CHECK(has(updated.out, "Week 3 begins"));
  CHECK(read(student / mine) == "// mine\n");
  CHECK(read(student / "lectures/assignment.json") == read(assignment));
  CHECK(read(student / "lectures/07_euler_angles/notes.md") == "# of the first release\n");  // not new here
}

TEST_CASE("what is exported for another system grades there, with the marks of grade, and holds no solution") {
  const fs::path folder = scratch / "exported", class_folder = folder / "class", student = class_folder / "ada";
  fs::remove_all(folder);
  const auto answer = [&](const std::string& name, const std::string& text) { write(student / (name + ".cpp"), text); };
  answer("kinetic_energy", solutions().at("kinetic_energy"));
  answer("inertia_of_points", "int main() {}\n");
  write(
      folder / "week 3.json",
      R"({"title": "Week \"3\"", "exercises": [{"name": "inertia_of_points", "points": 2}, {"name": "kinetic_energy", "points": 3}]})");
  const auto checker = [&](const std::string& arguments) {
    return run(fmt::format("cd '{}' && '{}' {}", folder.string(), WORKBOOK_TEST_CHECKER, arguments));
  };
  CHECK(checker("export moodle --out x.zip").status == 2);
  for (const auto& [system, file] :
       {std::pair{"gradescope", "a.zip"}, {"autolab", "b.tar"}, {"prairielearn", "c.zip"}, {"classroom50", "d.zip"}}) {
    const Outcome made = checker(fmt::format("export {} --seed 3 --assignment 'week 3.json' --out {}", system, file));
    REQUIRE_MESSAGE(made.status == 0, made.said());
    REQUIRE(run(fmt::format("cd '{0}' && mkdir {1} && cd {1} && cmake -E tar xf ../{2}", folder.string(), system, file))
                .status == 0);
  }
  for (const fs::path& file : files_below(folder / "gradescope"))
    CHECK_MESSAGE(file.lexically_relative(folder / "gradescope/workbook").begin()->string() != "solutions", file);

  // The workbook is that of this build: it is made from the same files.
  const fs::path workbook = folder / "gradescope/workbook";
  write(workbook / "build/workbook/checker/checker",
        fmt::format("#!/bin/sh\nexec '{}' \"$@\"\n", WORKBOOK_TEST_CHECKER));
  fs::permissions(workbook / "build/workbook/checker/checker",
                  fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec);
  const std::string with_workbook = fmt::format("WORKBOOK='{}' ", workbook.string());

  const fs::path autograder = folder / "autograder";
  fs::create_directories(autograder);
  fs::rename(folder / "gradescope", autograder / "source");
  fs::create_directory_symlink(autograder / "source", folder / "gradescope");
  fs::copy_file(autograder / "source/run_autograder", autograder / "run_autograder");
  fs::copy(student, autograder / "submission");
  const Outcome gradescope = run(fmt::format("cd '{}' && ./run_autograder", autograder.string()));
  REQUIRE_MESSAGE(gradescope.status == 0, gradescope.said());
  const auto results = nlohmann::json::parse(read(autograder / "results/results.json"));
  CHECK(results.at("score") == 3);
  CHECK(results.at("tests").at(0).at("status") == "failed");
  CHECK(results.at("tests").at(1).at("score") == 3);

  const fs::path lab = folder / "autolab/week3";
  CHECK(fs::exists(lab / "week3.rb"));
  CHECK(read(lab / "week3.yml").find("display_name: \"Week \\\"3\\\"\"") != std::string::npos);
  fs::rename(lab / "autograde-Makefile", lab / "Makefile");
  run(fmt::format("cd '{}' && cmake -E tar cf '{}' --format=zip .", student.string(), (lab / "handin.zip").string()));
  const Outcome autolab = run(fmt::format("cd '{}' && {} make -s", lab.string(), with_workbook));
  REQUIRE_MESSAGE(autolab.status == 0, autolab.said());
  CHECK(nlohmann::json::parse(workbook::lines_of(autolab.out).back()) ==
        nlohmann::json::parse(R"({"scores": {"inertia_of_points": 0.0, "kinetic_energy": 3.0}})"));

  const fs::path question = folder / "prairielearn/questions/week3";
  const auto info = nlohmann::json::parse(read(question / "info.json"));
  CHECK(info.at("title") == "Week \"3\"");
  // What PrairieLearn's schema of questions knows, and needs.
  CHECK(workbook::search(info.at("uuid").get<std::string>(), "^[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}$"));
  const std::string of_a_question =
                        " uuid type title topic tags gradingMethod singleVariant showCorrectAnswer partialCredit "
                        "externalGradingOptions ",
                    of_grading = " enabled image entrypoint serverFilesCourse timeout enableNetworking environment ";
  for (const auto& [key, unused] : info.items()) CHECK_MESSAGE(has(of_a_question, " " + key + " "), key);
  for (const auto& [key, unused] : info.at("externalGradingOptions").items())
    CHECK_MESSAGE(has(of_grading, " " + key + " "), key);
  CHECK(info.at("type") == "v3");
  CHECK(info.at("gradingMethod") == "External");
  const std::string grade = (workbook / "checker/grading/containers/grade.sh").string();
  const Outcome prairielearn =
      run(fmt::format("'{}' prairielearn '{}' '{}' '{}'", grade, student.string(), (question / "tests/cases").string(),
                      (folder / "results.json").string()));
  REQUIRE_MESSAGE(prairielearn.status == 0, prairielearn.said());
  CHECK(nlohmann::json::parse(read(folder / "results.json")).at("score").get<double>() == doctest::Approx(0.6));

  if (run("command -v python3").status == 0) {
    const Outcome classroom50 = run(
        fmt::format("cd '{}' && {} CLASSROOM=c ASSIGNMENT=week3 OWNER=ada COMMIT_URL=u python3 '{}'", student.string(),
                    with_workbook, (folder / "classroom50/autograders/week3/autograder.py").string()));
    REQUIRE_MESSAGE(classroom50.status == 0, classroom50.said());
    CHECK(nlohmann::json::parse(read(student / "result.json")).at("score") == 300);
  }

  // An error of the checker is no zero.
  write(workbook / "build/workbook/checker/checker", "#!/bin/sh\nexit 3\n");
  CHECK(run(fmt::format("cd '{}' && rm results/* && ./run_autograder", autograder.string())).status == 3);
  CHECK(!fs::exists(autograder / "results/results.json"));
}
