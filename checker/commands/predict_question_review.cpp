// Learning that lasts: predict asks for results before there is a function, question for the mistake of another one,
// review for an exercise of some time ago.
#include "checker/commands/commands.hpp"
#include "checker/explain/question.hpp"
#include "checker/judging/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <set>

namespace workbook {

namespace {

std::string inputs_text(const ExerciseReference& exercise, const Case& one) {
  std::vector<std::string> inputs;
  for (std::size_t k = 0; k < exercise.arguments.size(); ++k)
    inputs.push_back(
        fmt::format("{} = {}", exercise.arguments[k].name, format_value(one.inputs[k], exercise.arguments[k].kind, 6)));
  return fmt::format("{}", fmt::join(inputs, ", "));
}

constexpr std::string_view answer_letters = "abc";
constexpr std::size_t longest_offered = 150;  // letters of the inputs of a case to be worked out by hand

struct Prediction {
  std::size_t case_index;
  Value value;
};

/// "4=(0, 0, 1.5)": the number of a case and the numbers of the result, row by row. @throws UsageError
Prediction read_prediction(const ExerciseReference& exercise, const std::string& typed) {
  const std::size_t equals = std::min(typed.find('='), typed.size());
  Prediction prediction{find_case(exercise, typed.substr(0, equals)), {}};
  const Case& one = exercise.cases[prediction.case_index];
  std::vector<double> numbers;
  for (const char* at = typed.c_str() + equals; *at != '\0';) {
    char* end = nullptr;
    const double number = std::strtod(at, &end);
    if (end != at) numbers.push_back(number);
    at = end != at ? end : at + 1;
  }
  prediction.value = one.expected;
  const auto rows = static_cast<std::size_t>(one.expected.rows), cols = static_cast<std::size_t>(one.expected.cols);
  if (equals == typed.size() || numbers.size() != rows * cols)
    throw UsageError(fmt::format("A prediction is the number of a case and its {}, for example '{}={}'; '{}' has {}.",
                                 plural(rows * cols, "number"), prediction.case_index + 1,
                                 fmt::join(std::vector<int>(rows * cols, 0), " "), printable(typed), numbers.size()));
  for (std::size_t k = 0; k < numbers.size(); ++k) prediction.value.numbers[k % cols * rows + k / cols] = numbers[k];
  return prediction;
}

/// Worked out by hand, to three digits or so.
bool is_right(const ExerciseReference& exercise, const Prediction& prediction) {
  if (passes(exercise, prediction.case_index, prediction.value)) return true;
  const Value& expected = exercise.cases[prediction.case_index].expected;
  double size = 0, error = 0;
  for (std::size_t k = 0; k < expected.numbers.size(); ++k) {
    size = std::max(size, std::abs(expected.numbers[k]));
    error = std::max(error, std::abs(expected.numbers[k] - prediction.value.numbers[k]));
  }
  return error <= 5e-3 * size;
}

bool returns(const ExerciseReference& exercise, const Misconception& wrong, std::size_t i, const Value& value) {
  return i < wrong.outputs.size() && is_same_answer(exercise, i, wrong.outputs[i], value);
}

/// The wrong functions that would agree with all these, the most ordinary first, which are wrong nearly everywhere.
std::vector<const Misconception*> agreeing(const ExerciseReference& exercise, const std::vector<Prediction>& right) {
  std::vector<const Misconception*> blind;
  for (const Misconception& wrong : exercise.misconceptions)
    if (std::ranges::all_of(right, [&](const Prediction& one) {
          return returns(exercise, wrong, one.case_index, exercise.cases[one.case_index].expected);
        }))
      blind.push_back(&wrong);
  std::ranges::stable_sort(blind, {}, [&](const Misconception* wrong) {
    std::size_t agrees = 0;
    for (std::size_t i = 0; i < exercise.cases.size(); ++i)
      agrees += returns(exercise, *wrong, i, exercise.cases[i].expected) ? 1 : 0;
    return agrees;
  });
  return blind;
}

/// Of the cases that can be worked out by hand the one that shows most of these wrong, and how many.
std::pair<std::size_t, std::size_t> most_telling_case(const ExerciseReference& exercise,
                                                      const std::vector<const Misconception*>& wrong) {
  std::pair<std::size_t, std::size_t> best;
  for (std::size_t i = 0; i < exercise.described_cases(); ++i) {
    if (inputs_text(exercise, exercise.cases[i]).size() > longest_offered) continue;
    const auto shown = static_cast<std::size_t>(std::ranges::count_if(
        wrong, [&](const Misconception* each) { return !returns(exercise, *each, i, exercise.cases[i].expected); }));
    if (shown > best.second) best = {i, shown};
  }
  return best;
}

// --- review

/// Days between looking again, longer each time it goes well (Samani and Pan 2021 give the evidence for spacing).
constexpr std::array days_until_review = {1, 3, 7, 21, 60};

long days_since(const std::string& day, const std::string& today) {
  const auto number = [](const std::string& text) {
    std::tm time{};
    return strptime(text.c_str(), "%Y-%m-%d", &time) == nullptr ? 0 : timegm(&time) / (24L * 3600);
  };
  return number(today) - number(day);
}

struct Due {
  const Exercise* exercise = nullptr;
  long days_over = 0;  ///< negative: not yet
};

/// The exercise that has waited longest over its time, among those of earlier lectures than the last one begun.
Due most_due(const std::vector<Exercise>& exercises, const Progress& progress, const std::string& today) {
  std::string last_lecture;
  for (const Exercise& exercise : exercises)
    if (!progress.of(exercise.name()).verdict.empty()) last_lecture = exercise.lecture();
  Due due;
  for (const Exercise& exercise : exercises) {
    const Practice practice = progress.of(exercise.name());
    if (practice.passed_on.empty() || exercise.lecture() == last_lecture) continue;
    const std::string last = practice.reviews.empty() ? practice.passed_on : practice.reviews.back().day;
    const auto failed = std::find_if(practice.reviews.rbegin(), practice.reviews.rend(),
                                     [](const Review& review) { return review.verdict != "passed"; });
    const auto in_a_row = static_cast<std::size_t>(failed - practice.reviews.rbegin());
    const long over = days_since(last, today) - days_until_review[std::min(in_a_row, days_until_review.size() - 1)];
    if (due.exercise == nullptr || over > due.days_over) due = {&exercise, over};
  }
  return due;
}

/// A check of the file that a review has written; its first verdict counts.
int check_review(const Course& course, const Exercise& exercise, const fs::path& file, Progress& progress) {
  const Console console = Console::of_standard_output();
  CheckContext context(course);
  const std::size_t number = std::max<std::size_t>(progress.of(exercise.name()).reviews.size(), 1);
  const std::uint64_t seed = course.seed() + (course.has_solutions() ? number : 0);
  const CheckResult checked = check_exercise(context, check_task(course, exercise, seed, file));
  fmt::print("{}", terminal_report(checked, course, console, {}));
  if (!checked.is_judged()) return checker_failed;
  if (!checked.is_started()) {
    fmt::print("  {}\n", shown_path(file));
    return something_failed;
  }
  progress.remember_review(exercise.name(), to_string(checked.judgement.verdict));
  if (!checked.judgement.passed()) return stop("\nGo on in {}, then `{}`.", shown_path(file), command("review"));
  const Practice practice = progress.of(exercise.name());
  fmt::print("\nFirst passed on {}. Reviews so far:\n", practice.passed_on);
  for (const Review& review : practice.reviews)
    fmt::print("  {}  {} at the first try\n", review.day, in_words(review.verdict));
  std::error_code ignored;
  fs::remove(file, ignored);
  return all_passed;
}

}  // namespace

std::string due_for_review(const Course& course, const Progress& progress) {
  const std::vector<Exercise> exercises = course.exercises();
  const Due due = most_due(exercises, progress, current_day());
  return due.exercise != nullptr && due.days_over >= 0 ? due.exercise->name() : "";
}

int predict(const Course& course, const Options& options) {
  const Console console = Console::of_standard_output();
  const Exercise exercise = course.find_exercise(options.name);
  CheckContext context(course);
  const ExerciseReference& reference = context.reference(check_task(course, exercise));
  if (options.predictions.empty()) {
    const auto show = [&](std::size_t i, const std::string& name) {
      const std::string text = fmt::format("{:>4}  {}{}", i + 1, name, inputs_text(reference, reference.cases[i]));
      fmt::print("{}\n", console.wrapped(text, 6));
    };
    std::set<std::size_t> shown;
    if (!reference.limits.empty())
      say("What will {} return in these limits? Its formula is not needed, simpler physics is enough:\n\n",
          exercise.name());
    for (const Limit& limit : reference.limits) {
      show(limit.case_index, reference.cases[limit.case_index].name + ": ");
      shown.insert(limit.case_index);
    }
    if (reference.limits.empty())
      say("What will {} return here? Take two or three of these, a limit or a symmetry first, and work "
          "them out before you write the function:\n\n",
          exercise.name());
    else
      say("\nAnd here? Work one or two out before you write the function:\n\n");
    for (std::size_t i = 0; i < reference.described_cases() && shown.size() < 8; ++i)
      if (inputs_text(reference, reference.cases[i]).size() <= longest_offered && shown.insert(i).second) show(i, "");
    say("\nThen: `{}`, with the numbers of the result, row by row.",
        command(fmt::format("predict {} '1=…' '4=…'", exercise.name())));
    return all_passed;
  }
  CheckTask stage = check_task(course, exercise);
  set_stage(stage, Progress(course.progress_file()));
  const bool has_names = stage.stage == CheckTask::last_stage;
  std::vector<Prediction> right;
  for (const std::string& typed : options.predictions) {
    const Prediction prediction = read_prediction(reference, typed);
    const bool holds = is_right(reference, prediction);
    fmt::print("{}case {}: {}\n", console.mark(holds ? "✓" : "✗", holds ? Style::good : Style::bad),
               prediction.case_index + 1, holds ? "right" : "not what comes out");
    const auto limit = std::ranges::find(reference.limits, prediction.case_index, &Limit::case_index);
    if (holds && limit != reference.limits.end()) fmt::print("{}\n", console.wrapped(limit->reason, 2));
    if (holds) right.push_back(prediction);
    const auto mistake = std::ranges::find_if(reference.misconceptions, [&](const Misconception& wrong) {
      return returns(reference, wrong, prediction.case_index, prediction.value);
    });
    if (!holds && has_names && mistake != reference.misconceptions.end())
      fmt::print("{}\n", console.wrapped("A function with this mistake returns it: " + mistake->message, 2));
  }
  const bool are_all_right = right.size() == options.predictions.size();
  const std::vector<const Misconception*> blind = agreeing(reference, right);
  if (right.empty()) return something_failed;
  if (blind.empty()) {
    if (are_all_right)
      say("\nThese tell the function from all {} that are known.",
          plural(reference.misconceptions.size(), "wrong one"));
    return are_all_right ? all_passed : something_failed;
  }
  const std::size_t most = options.all ? blind.size() : 3;
  say("\n{} would return the same.", plural(blind.size(), "known wrong function"));
  for (std::size_t k = 0; has_names && k < std::min(most, blind.size()); ++k)
    fmt::print("{}\n", console.wrapped("- " + blind[k]->message, 2));
  if (has_names && most < blind.size()) fmt::print("  ({} more: --all)\n", blind.size() - most);
  if (const auto [index, count] = most_telling_case(reference, blind); count > 0)
    say("Case {} tells {} from the right one: {}.", index + 1,
        count == blind.size() ? (count == 1 ? "it" : "them all") : fmt::format("{} of them", count),
        inputs_text(reference, reference.cases[index]));
  return something_failed;
}

int question(const Course& course, const Options& options) {
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
  if (options.answer.size() != 1 || choice == std::string_view::npos)
    throw UsageError(fmt::format("An answer is a, b or c, not '{}'.", printable(options.answer)));
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

int review(const Course& course, const Options& /*options*/) {
  Progress progress(course.progress_file());
  const std::vector<Exercise> exercises = course.exercises();
  const fs::path folder = course.progress_file().parent_path() / "review";
  const auto file_of = [&](const Exercise& exercise) { return folder / (exercise.name() + ".cpp"); };
  for (const Exercise& exercise : exercises)
    if (fs::exists(file_of(exercise))) return check_review(course, exercise, file_of(exercise), progress);
  const Due due = most_due(exercises, progress, current_day());
  if (due.exercise == nullptr || due.days_over < 0) {
    say("{}", due.exercise == nullptr ? "Nothing to review yet: exercises of earlier lectures that pass come here."
                                      : fmt::format("Nothing is due today; {} is next, in {}.", due.exercise->name(),
                                                    plural(static_cast<std::size_t>(-due.days_over), "day")));
    return all_passed;
  }
  const Exercise& exercise = *due.exercise;
  const std::string stub = stub_text(exercise, declared_signature(course, exercise));
  write_or_throw(file_of(exercise), stub);
  progress.begin_review(exercise.name());
  const Console console = Console::of_standard_output();
  fmt::print("{}\n{}\n", console.styled(exercise.name(), Style::strong), console.wrapped(exercise.entry->task, 2));
  say("\nYou wrote it on {}. Write it again without looking, in {}, then `{}`.", progress.of(exercise.name()).passed_on,
      shown_path(file_of(exercise)), command("review"));
  return all_passed;
}

}  // namespace workbook
