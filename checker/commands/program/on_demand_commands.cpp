// What commands take whose code is built when one of them is typed for the first time: arguments are checked before.
#include "checker/commands/on_demand/options.hpp"

namespace workbook {

namespace {

/// @throws UsageError where no page can be written
void require_page(const fs::path& file) {
  std::error_code ignored;
  const bool is_other = file.empty() || (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored));
  // An older page is replaced by a file that is written beside it.
  const std::string trouble = is_other ? "not an ordinary file" : place_trouble(free_name(file));
  if (!trouble.empty())
    throw UsageError(fmt::format("The page cannot be written to {} ({}); give --html another file.",
                                 shell_quoted(printable(file.string())), trouble));
}

Parameter assignment_parameter(std::optional<fs::path>& file) {
  return {"--assignment", "FILE",
          &file,          "JSON: what is graded and what it is worth",
          false,          [&](const Course&) { require_file(*file, "what is graded, in JSON,"); }};
}

}  // namespace

Command report_command() {
  const auto options = std::make_shared<ReportOptions>();
  return {"report",
          students,
          "Write one page about your work, to hand in or to read\n\nThe page needs no other file: verdicts, reasons, "
          "plots, your files, and what to read next.",
          {"report --html report.html", "report --html inertia.html 03 --name 'YOUR NAME'"},
          {names_parameter(options->names),
           {"--html", "FILE", &options->html, "the page to write; an older one is replaced", true,
            [options](const Course&) { require_page(options->html); }},
           {"--name", "TEXT", &options->student, "whose page it is"},
           own_file_parameter(options->file),
           seed_parameter(options->seed)},
          with_options(options, &report),
          no_help_in_exam(options->names)};
}

Command figures_command() {
  const auto options = std::make_shared<FiguresOptions>();
  return {"figures",
          students,
          "Redraw the figures of a lecture with your own functions\n\nA figure that needs a function you have not "
          "started is left out, and the function is named.",
          {"figures 03"},
          {lecture_parameter(options->lecture),
           place_parameter("--out", "FOLDER", options->out, "the folder for the pictures"),
           {"--seconds", "NUMBER", &options->seconds, "time limit of one figure", false, {}, {1, 3600}}},
          with_options(options, &figures)};
}

Command live_command() {
  const auto options = std::make_shared<std::string>();
  return {
      "live",
      students,
      "Build the live figures of a lecture on your own functions\n\nThe figures that move take those of your functions "
      "that pass, instead of computing the same themselves. They are compiled for the browser, which needs the package "
      "emscripten; then open one of the pages that are named.",
      {"live 06"},
      {lecture_parameter(*options)},
      with_options(options, &live)};
}

Command examples_command() {
  const auto options = std::make_shared<std::string>();
  return {
      "examples",
      students,
      "Run the worked examples of a lecture on your own functions\n\nShows which of them hold, which need a function "
      "that is not started, and for the others the check that failed, with both numbers.",
      {"examples 03"},
      {lecture_parameter(*options)},
      with_options(options, &examples)};
}

Command try_command() {
  const auto options = std::make_shared<TryOptions>();
  return {
      "try",
      students,
      "Run a program of your own that calls your functions\n\nWithout a file it is lectures/try.cpp, which the first "
      "time is written for you. Only the functions that it names are compiled with it. With --case it shows every "
      "variable of your function at this case, line by line, and the result beside the expected one; that needs gdb.",
      {"try", "try drafts/spin.cpp", "try --case 3 euler_equations"},
      {{"FILE", "", &options->file, "a program with main(), in C++; with --case an exercise"},
       {"--case", "CASE", &options->case_name, "every variable of your function at this case, by number or name"}},
      with_options(options, &try_out),
      [options](const Course& course) {
        if (!options->case_name && options->file) require_file(*options->file, "a program in C++ with main()");
        if (!options->case_name) return;
        if (!options->file)
          throw UsageError(fmt::format("--case needs an exercise: `{}`.", command("try --case 3 EXERCISE")));
        std::string name = options->file->string();
        exercise_parameter(name).require(course);
        options->file = name;
      }};
}

Command debug_command() {
  const auto options = std::make_shared<DebugOptions>();
  return {
      "debug",
      students,
      "Step through your function with gdb\n\nStops where your function begins, at the first case that fails, or at "
      "the given one. Vectors and matrices are shown as numbers, and computed with as in C++: `info args`, `next`, "
      "`print 2*I*omega`, "
      "`print I(0,1)`, `print omega.dot(L)`. At the end of the case stand the expected result and yours.",
      {"debug euler_equations", "debug euler_equations --case 4"},
      {exercise_parameter(options->name),
       {"--case", "CASE", &options->case_name, "stop at this case, by number or name"},
       {"--build-only", "", &options->build_only, "only build the program, for an editor's debugger"}},
      with_options(options, &debug),
      no_help_in_exam(options->name)};
}

Command handout_command() {
  const auto options = std::make_shared<HandoutOptions>();
  return {
      "handout",
      instructors,
      "Write the copy of the workbook that students get\n\nThe copy has no solutions: reference results, printed "
      "numbers and figures are data, and every exercise is back at the beginning. Students type the same commands "
      "in it. With --seed all random cases are others, this year's for example. With --update an earlier copy "
      "becomes the next release, with a change log; students get it by `update`.",
      {"handout ../phy711-students", "handout ../phy711-2027 --seed 2027 --assignment week3.json",
       "handout ../phy711-2027 --update --message 'Hints of lecture 03 corrected'"},
      {place_parameter("FOLDER", "", options->out, "a new folder for the copy, or an earlier copy to --update", true),
       {"--update", "", &options->update, "bring FOLDER, an earlier copy, to a new release"},
       {"--message", "TEXT", &options->message, "what is new, for the change log"},
       seed_parameter(options->seed),
       assignment_parameter(options->assignment)},
      with_options(options, &handout)};
}

Command grade_command() {
  const auto options = std::make_shared<GradeOptions>();
  return {
      "grade",
      instructors,
      "Grade a class\n\nSUBMISSIONS is what Gradescope, Moodle, Canvas or GitHub Classroom export, or holds a folder "
      "or "
      "a zip file per student, or files called ID_EXERCISE.cpp. Only files with the names of exercises are read. The "
      "roster may be a table of your own, Moodle's grading worksheet, which is written back with marks and comments, "
      "or the gradebook of Canvas. FOLDER gets class.html, class.json, tables for spreadsheets, Moodle and Canvas, and "
      "for every student a page, JSON, and results for other autograders. What is judged is kept there: a run that was "
      "stopped goes on, and of a class that was "
      "graded before only what is new is judged; whose mark has changed, and why, is printed. The first run draws "
      "cases that nobody knows, unless --seed says which; FOLDER keeps them for the next.",
      {"grade submissions --out grades", "grade submissions --who --roster class.csv",
       "grade week3.zip --out week3 --roster class.csv --assignment week3.json",
       "grade submissions --out part1 --shard 1/2 --seed 740296", "grade submissions --out grades --merge part1 part2"},
      {{"SUBMISSIONS", "", &options->submissions, "what was handed in: a folder or a zip file", true,
        [options](const Course&) {
          std::error_code ignored;
          if (!fs::exists(options->submissions, ignored))
            throw UsageError(fmt::format("There is no {}.", printable(options->submissions.string())));
        }},
       place_parameter("--out", "FOLDER", options->out, "the folder for all results; the next run goes on in it"),
       {"--who", "", &options->who, "only say who has handed in what: nothing is judged or written"},
       {"--roster", "FILE", &options->roster, "CSV with the column id, or the table of a learning system", false,
        [options](const Course&) { require_file(*options->roster, "a table in CSV"); }},
       assignment_parameter(options->assignment),
       {"--overrides", "FILE", &options->overrides, "CSV: points, excuses, due dates and comments by hand"},
       {"--attempts", "WHICH", &options->attempts, "last or best: each folder in a student's is an attempt"},
       seed_parameter(options->seed),
       {"--copy", "FOLDER", &options->copy, "the copy that students have, if it was drawn with a seed of its own"},
       {"--reference",
        "FILE",
        &options->references,
        "judge by these reference results, made before, of one seed",
        false,
        {},
        {},
        "--seed"},
       {"--only", "VERDICT", &options->only, "judge once more what had this verdict, wrong_value for example"},
       {"--with-missing", "", &options->with_missing, "rows of all students in the tables, whatever was not read"},
       {"--shard", "K/N", &options->shard, "only judge the K-th of N parts of the class; --merge joins them"},
       {"--merge", "FOLDER", &options->merged, "take over what was judged in these folders, of parts for example"},
       {"--explain-minutes", "NUMBER", &options->explain_minutes,
        "of each student's submission, for the reasons of failures"},
       {"--allow-reduced", "", &options->allow_reduced, "be content with the sandbox that `doctor` calls reduced"}},
      with_options(options, &grade)};
}

Command export_command() {
  const auto options = std::make_shared<ExportOptions>();
  return {
      "export",
      instructors,
      "Write what another system needs to grade an assignment itself\n\nFor Gradescope an autograder, for Autolab an "
      "assessment, for PrairieLearn a question, for Classroom 50 an autograder: with cases of their own, which are "
      "drawn anew unless --seed says which, and no solutions. What to do with it is printed.",
      {"export gradescope --assignment week3.json --out week3.zip",
       "export autolab --assignment week3.json --out week3.tar --image registry.example.org/workbook"},
      {{"SYSTEM", "", &options->system, "gradescope, autolab, prairielearn or classroom50", true},
       place_parameter("--out", "FILE", options->out, "the file to write: zip or tar, as its name ends", true),
       assignment_parameter(options->assignment),
       seed_parameter(options->seed),
       {"--image", "NAME", &options->image, "the image with the workbook, where a system takes one"}},
      with_options(options, &export_recipe)};
}

Command self_check_command() {
  const auto options = std::make_shared<SelfCheckOptions>();
  return {
      "self-check",
      authors,
      "Check the workbook itself\n\nTries every stub, solution, right route, wrong answer, hint and pointer of the "
      "course, and names the file and the fix for everything that is wrong.",
      {"self-check --seeds 20", "self-check 03", "self-check --prove 03", "self-check --record slow_precession"},
      {names_parameter(options->names),
       {"--seeds", "NUMBER", &options->seeds, "how many seeds to try, from 1 on, at most 1000", false, {}, {1, 1000}},
       {"--quick", "", &options->quick, "run no solution: texts, cases and routes only"},
       {"--prove", "", &options->prove,
        "do the cases find all bugs? Typical ones, beside the record, and of exercises that are named every small "
        "change of their solutions"},
       {"--record", "", &options->record, "try typical bugs and write the record, judging/adequacy.json"}},
      with_options(options, &self_check)};
}

Command new_lecture_command() {
  const auto options = std::make_shared<NewOptions>();
  return {"new lecture",
          authors,
          "Write the skeleton of a lecture",
          {},
          {{"folder", "FOLDER", &options->name, "NN_topic; the number says where in the course it stands", true}},
          with_options(options, &new_lecture)};
}

Command new_exercise_command() {
  const auto options = std::make_shared<NewOptions>();
  return {"new exercise",
          authors,
          "Write the skeleton of an exercise",
          {},
          {{"name", "NAME", &options->name, "the name of its function", true},
           {"--lecture", "LECTURE", &options->lecture, "its lecture", true},
           {"--signature", "TEXT", &options->signature, "its declaration: 'Vector3d f(const Matrix3d& I, double t)'",
            true}},
          with_options(options, &new_exercise)};
}

}  // namespace workbook
