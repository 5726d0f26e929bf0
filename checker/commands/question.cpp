#include "checker/explain/question.hpp"
#include "checker/commands/commands.hpp"

namespace workbook {

namespace {

constexpr std::string_view answer_letters = "abc";

struct QuestionOptions {
  std::string name;
  std::string answer;  ///< "a", "b" or "c"; "": show the question
};

int question(const Course& course, const QuestionOptions& options) {
  const Console console = Console::of_standard_output();
  const Exercise exercise = course.find_exercise(options.name);
  Progress progress(course.progress_file());
  if (!progress.passed(exercise.name(), file_fingerprint(course.student_file(exercise))))
    return stop("The question on {} comes when yours passes: `{}`.", exercise.name(),
                command("check " + exercise.name()));
  CheckContext context(course);
  const ExerciseReference& reference = context.reference(check_task(course, exercise));
  const std::optional<Question> asked = question_on(reference);
  if (!asked) {
    fmt::print("There is no question on {}.\n", exercise.name());
    return all_passed;
  }
  const Case& one = reference.cases[asked->case_index];
  const auto mistake = [&](std::size_t choice) -> const Misconception& {
    return reference.misconceptions[asked->choices.at(choice)];
  };
  const auto given = [&](std::size_t choice) {
    return format_value(mistake(choice).outputs[asked->case_index], reference.result_kind, 4);
  };
  if (options.answer.empty()) {
    say("Another {} was called with {} and returned {}. Right is {}. Which of "
        "these would the checker say about it?\n\n",
        exercise.name(), inputs_text(reference, one), given(asked->right),
        format_value(one.expected, reference.result_kind, 4));
    for (std::size_t k = 0; k < asked->choices.size(); ++k)
      fmt::print("{}\n", console.wrapped(fmt::format("{}  {}", answer_letters[k], mistake(k).message), 3));
    fmt::print("\nYour answer: {}\n", command(fmt::format("question {} a, b or c", exercise.name())));
    return all_passed;
  }
  const std::size_t choice = answer_letters.find(options.answer);
  progress.remember_answer(exercise.name(), choice == asked->right);
  if (choice == asked->right) {
    fmt::print("{}Right.\n", console.mark("✓", Style::good));
  } else {
    fmt::print("{}{}\n", console.mark("✗", Style::bad),
               console.wrapped(fmt::format("No: with that mistake it would have returned {}.", given(choice))));
  }
  warn(progress);
  return choice == asked->right ? all_passed : something_failed;
}

}  // namespace

Command question_command() {
  const auto options = std::make_shared<QuestionOptions>();
  return {
      "question",
      students,
      "Answer a question on an exercise that passes\n\nShows what another function returned, and three mistakes, one "
      "of which it made. Your first answer is kept for the report page.",
      {"question euler_equations", "question euler_equations b"},
      {exercise_parameter(options->name),
       {"ANSWER", "", &options->answer, "a, b or c; none: show the question", false,
        [options](const Course&) {
          if (options->answer.size() != 1 || answer_letters.find(options->answer) == std::string_view::npos)
            throw UsageError(fmt::format("An answer is a, b or c, not '{}'.", printable(options->answer)));
        }}},
      with_options(options, &question),
      no_help_in_exam(options->name)};
}

}  // namespace workbook
