#include "checker/judging/answers.hpp"

#include <algorithm>

namespace workbook {

bool is_complete(const Value& value) {
  return value.rows >= 0 && value.cols >= 0 &&
         value.numbers.size() == static_cast<std::size_t>(value.rows) * static_cast<std::size_t>(value.cols);
}

bool has_usable_value(const Reply& reply, const Case& one) {
  return reply.ending == Ending::returned && reply.value.has_shape_of(one.expected) && is_complete(reply.value);
}

Answers answers_of(const ExerciseReference& exercise, const std::vector<Reply>& replies) {
  Answers answers(exercise.cases.size());
  for (std::size_t i = 0; i < std::min(answers.size(), replies.size()); ++i) {
    if (has_usable_value(replies[i], exercise.cases[i])) answers[i] = replies[i].value;
  }
  return answers;
}

std::vector<std::size_t> deciding_cases(const ExerciseReference& exercise) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (exercise.cases[i].deciding) indices.push_back(i);
  }
  return indices;
}

bool all_deciding_cases_answered(const ExerciseReference& exercise, const Answers& answers) {
  const auto deciding = deciding_cases(exercise);
  return !deciding.empty() &&
         std::ranges::all_of(deciding, [&](std::size_t i) { return i < answers.size() && answers[i].has_value(); });
}

}  // namespace workbook
