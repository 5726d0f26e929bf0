#include "checker/commands/on_demand/options.hpp"
#include "checker/compile/compile.hpp"

#include <set>

namespace workbook {

int live(const Course& course, const std::string& lecture) {
  // What the figures take, as lectures/live/live.js has it.
  const std::string script = read_file(course.lectures() / lecture / "live.js").value_or("");
  std::set<std::string> called;
  for (const Match& call : search_all(script, R"(yours\.(\w+))")) called.insert(call[1]);
  if (called.empty()) return stop("{} has no live figures.", lecture);

  const ProgressSummary summary = summary_of(course, Progress(course.progress_file()));
  std::string includes, entries, files;
  std::vector<std::string> own;
  for (const Exercise& exercise : summary.exercises) {
    if (!summary.passes(exercise) || called.erase(exercise.name()) == 0) continue;
    own.push_back(exercise.name());
    includes += fmt::format("#include <rigid/{}.hpp>\n", exercise.card->contract);
    entries += fmt::format("    {{\"{0}\", [](const double* numbers) {{ return call(&rigid::{0}, numbers); }}}},\n",
                           exercise.name());
  }
  if (own.empty())
    return stop("The live figures of {} take {}; none of these passes yet.", lecture, fmt::join(called, ", "));
  // With what they call in turn.
  const auto file_of = [&](const Exercise& exercise) { return course.student_file(exercise); };
  const fs::path folder = course.build().directory / "live/student";
  for (const Submission& file : own_functions(fmt::format("{}", fmt::join(own, " ")), course.exercises(), file_of)) {
    fs::path compiled = file.path;
    if (!file.own_names.empty()) {
      std::string before;
      for (const Card& card : course.cards()) before += fmt::format("#include <rigid/{}.hpp>\n", card.contract);
      compiled = folder / file.path.filename();
      write_or_throw(compiled, before + renaming(file) + file.text);
    }
    files += fmt::format("\"{}\"\n", compiled.string());
  }
  const std::string list = "#include \"lectures/live/functions.hpp\"\n" + includes +
                           "void workbook::throw_eigen_error(const char*) { __builtin_trap(); }\n"
                           "const std::vector<workbook::live::Function> workbook::live::functions{\n" +
                           entries + "};\n";
  for (const auto& [name, text] : {std::pair{"functions.cpp", list}, {"files.rsp", files}})
    write_or_throw(folder / name, text);
  const FinishedProgram built = make(course.build(), {"notes", "live_of_the_student"});
  if (!built.succeeded())
    throw std::runtime_error(fmt::format("{}\nThe live figures could not be built on your functions.", built.output));
  std::string pages;
  for (const auto& page : fs::directory_iterator(course.notes_folder()))
    if (read_file(page.path()).value_or("").find(fmt::format("data-lecture=\"{}\"", lecture)) != std::string::npos)
      pages += fmt::format("  {}?yours\n", file_address(page.path()));
  say("Computed with your {}:", fmt::join(own, ", "));
  fmt::print("{}", pages);
  if (!called.empty()) say("The figures also take these, once they pass: {}.", fmt::join(called, ", "));
  return all_passed;
}

}  // namespace workbook
