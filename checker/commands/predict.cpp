#include "checker/commands/commands.hpp"
#include "checker/judging/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace workbook {

namespace {

constexpr std::size_t longest_offered = 150;  // letters of the inputs of a case to be worked out by hand

struct PredictOptions {
  std::string name;
  std::vector<std::string> predictions;  ///< "4=0 0 1.5": a case and the numbers of the result
  bool all = false;
};

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

int predict(const Course& course, const PredictOptions& options) {
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

}  // namespace

std::string inputs_text(const ExerciseReference& exercise, const Case& one) {
  std::vector<std::string> inputs;
  for (std::size_t k = 0; k < exercise.arguments.size(); ++k)
    inputs.push_back(
        fmt::format("{} = {}", exercise.arguments[k].name, format_value(one.inputs[k], exercise.arguments[k].kind, 6)));
  return fmt::format("{}", fmt::join(inputs, ", "));
}

Command predict_command() {
  const auto options = std::make_shared<PredictOptions>();
  return {"predict",
          students,
          "Say what a function will return before you write it\n\nWithout predictions it shows cases to choose from. "
          "Each prediction is judged, and the wrong functions that would agree with all of them are told: examples are "
          "good that can tell these from the right one.",
          {"predict euler_equations", "predict euler_equations '1=0 0 0' '4=0.1 -0.2 0'"},
          {exercise_parameter(options->name),
           {"PREDICTION", "", &options->predictions, "a case and the numbers of its result: '4=0 0 1.5'"},
           {"--all", "", &options->all, "name every mistake that a prediction does not show, not three"}},
          with_options(options, &predict),
          no_help_in_exam(options->name)};
}

}  // namespace workbook
