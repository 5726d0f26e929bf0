#include "checker/judging/failure_text.hpp"

#include "checker/judging/comparison.hpp"
#include "checker/judging/input_text.hpp"
#include "checker/judging/text_blocks.hpp"
#include "checker/judging/value_tables.hpp"
#include "checker/judging/value_text.hpp"
#include "checker/messages/failures.hpp"
#include "checker/messages/judging.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>

namespace workbook {

namespace {

constexpr std::size_t indent = 2;
constexpr int difference_digits = 3;

std::vector<std::size_t> first_indices(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

std::vector<std::string> inputs_section(const ExerciseReference& exercise, const Case& one, const Page& page) {
  std::vector<std::string> lines = {messages::inputs_heading()};
  for (std::size_t a = 0; a < one.inputs.size(); ++a) {
    append(lines, indented(input_lines(exercise.arguments.at(a), one.inputs[a], page), indent));
  }
  return lines;
}

/// Everything that is shown of one result.
struct Result {
  const ExerciseReference& exercise;
  Value expected;
  std::optional<Value> actual;
  std::optional<Deviation> difference;  ///< where entries are compared one by one
  int digits = 6;

  bool differs(std::size_t number) const { return difference && !difference->is_within(number); }
};

int digits_needed(const Result& result) {
  int digits = 6;
  if (!result.difference) return digits;
  for (std::size_t n = 0; n < result.expected.numbers.size(); ++n) {
    if (!result.differs(n)) continue;
    digits = std::max(digits, digits_to_tell_apart(result.expected.numbers[n], result.actual->numbers[n]));
  }
  return digits;
}

std::string common_unit(const ExerciseReference& exercise) {
  return exercise.result_units.size() == 1 ? to_string(exercise.result_units.front()) : "";
}

/// "2" for a component of a vector, "column 1   2" for one of a list of columns.
std::string component_label(Kind kind, std::size_t number) {
  if (is_vector(kind)) return std::to_string(number + 1);
  if (kind != Kind::points) return "";
  const std::size_t row = number % 3;
  return row == 0 ? messages::column(number / 3 + 1) + "   1" : std::to_string(row + 1);
}

/// The numbers to show: all of them, or of a long list the columns that differ.
std::vector<std::size_t> shown_numbers(const Result& result) {
  std::vector<std::size_t> shown = first_indices(result.expected.numbers.size());
  if (shown.size() <= most_rows) return shown;
  const std::size_t rows = result.exercise.result_kind == Kind::points ? 3 : 1;
  if (result.difference && !result.difference->is_within()) {
    std::erase_if(shown, [&](std::size_t n) {
      const std::size_t top = n - n % rows;
      return std::ranges::none_of(first_indices(rows), [&](std::size_t row) { return result.differs(top + row); });
    });
  }
  shown.resize(std::min(shown.size(), most_rows));
  return shown;
}

/// Expected, yours and difference of one number after the other, only those that differ, where columns do not fit.
std::vector<std::string> lines_below_each_other(const Result& result) {
  std::vector<std::size_t> shown = first_indices(result.expected.numbers.size());
  const std::size_t total = shown.size();
  if (result.difference && !result.difference->is_within())
    std::erase_if(shown, [&](std::size_t n) { return !result.differs(n); });
  const std::size_t agreeing = total - shown.size();
  const std::size_t left = shown.size() - std::min(shown.size(), most_rows);
  shown.resize(shown.size() - left);
  std::vector<std::string> lines;
  for (std::size_t n : shown) {
    if (total > 1) lines.push_back("  " + entry_name(result.expected, result.exercise.result_kind, n));
    Table table;
    table.labels = {messages::expected_heading()};
    table.rows = {{number_text(result.expected.numbers[n], result.digits)}};
    if (result.actual) {
      table.labels.push_back(messages::yours_heading());
      table.rows.push_back({number_text(result.actual->numbers[n], result.digits)});
    }
    if (result.difference) {
      table.labels.push_back(messages::difference_heading());
      table.rows.push_back({number_text(result.difference->difference.numbers[n], difference_digits)});
    }
    table.is_marked = [&](std::size_t row, std::size_t) { return row == 1 && result.differs(n); };
    append(lines, indented(table_lines(table), total > 1 ? 2 * indent : indent));
  }
  if (left > 0) lines.push_back("  " + messages::more_numbers(left));
  if (agreeing > 0) lines.push_back("  " + messages::other_numbers_agree(agreeing));
  return lines;
}

/// Numbers, vectors and points: a line for each number.
std::vector<std::string> component_lines(const Result& result) {
  Table table;
  table.headings = {messages::expected_heading()};
  if (result.actual) table.headings.push_back(messages::yours_heading());
  if (result.difference) table.headings.push_back(messages::difference_heading());

  const std::vector<std::size_t> shown = shown_numbers(result);
  for (std::size_t n : shown) {
    const std::string label = component_label(result.exercise.result_kind, n);
    if (!label.empty()) table.labels.push_back(label);
    std::vector<std::string> row = {number_text(result.expected.numbers[n], result.digits)};
    if (result.actual) row.push_back(number_text(result.actual->numbers[n], result.digits));
    if (result.difference) row.push_back(number_text(result.difference->difference.numbers[n], difference_digits));
    table.rows.push_back(std::move(row));
    if (result.exercise.result_units.size() > 1) table.endings.push_back(to_string(result.exercise.result_units.at(n)));
  }
  table.is_marked = [&](std::size_t row, std::size_t col) { return col == 1 && result.differs(shown[row]); };

  std::vector<std::string> lines = indented(table_lines(table), indent);
  if (shown.empty()) lines.push_back("  " + messages::empty_list());
  if (shown.size() < result.expected.numbers.size()) {
    lines.push_back("  " + messages::more_numbers(result.expected.numbers.size() - shown.size()));
  }
  return lines;
}

/// The columns [first_col, first_col + 3): expected, yours and difference as blocks.
std::vector<std::string> matrix_lines(const Result& result, std::size_t first_col, const Page& page) {
  const NumberTest differs = [&](std::size_t number) { return result.differs(number); };
  const NumberTest nothing_differs = [](std::size_t) { return false; };
  const auto block = [&](const std::string& title, const Value& value, int digits, const NumberTest& is_marked) {
    return Block{std::string(indent, ' ') + title, table_lines(matrix_table(value, first_col, digits, is_marked))};
  };
  std::vector<Block> blocks = {block(messages::expected_heading(), result.expected, result.digits, nothing_differs)};
  if (result.actual) blocks.push_back(block(messages::yours_heading(), *result.actual, result.digits, differs));
  if (result.difference)
    blocks.push_back(block(messages::difference_heading(), result.difference->difference, difference_digits, differs));
  return side_by_side(blocks, 0, page);
}

std::vector<std::string> lines_beside_each_other(const Result& result, const Page& page) {
  switch (result.exercise.result_kind) {
    case Kind::matrix3:
      return matrix_lines(result, 0, page);
    case Kind::matrices: {
      std::vector<std::string> lines;
      for (std::size_t col = 0; col + 3 <= static_cast<std::size_t>(result.expected.cols); col += 3) {
        lines.push_back("  " + messages::matrix(col / 3 + 1));
        append(lines, matrix_lines(result, col, page));
      }
      return lines;
    }
    case Kind::number:
    case Kind::integer:
    case Kind::vector2:
    case Kind::vector3:
    case Kind::vector:
    case Kind::points:
      return component_lines(result);
  }
  return {};
}

std::vector<std::string> result_lines(const Result& result, const Page& page) {
  std::vector<std::string> lines = lines_beside_each_other(result, page);
  const bool fits = page.width >= page_width || widest(lines) <= page.width;
  return (fits && !page.is_linear) || result.expected.numbers.empty() ? lines : lines_below_each_other(result);
}

/// Rounding errors of right numbers would only draw the eye.
Deviation without_rounding_errors(Deviation deviation) {
  for (std::size_t n = 0; n < deviation.allowed.size(); ++n) {
    if (deviation.is_within(n)) deviation.difference.numbers[n] = 0.0;
  }
  return deviation;
}

/// What is tested of the answer as a whole, where it does not hold.
std::vector<std::string> whole_deviation_lines(const Deviation& deviation, const Page& page) {
  const bool is_sentence = deviation.meaning.ends_with('.');
  std::vector<std::string> lines =
      wrapped(is_sentence ? deviation.meaning : messages::zero_for_a_right_answer(deviation.meaning), 0, page);
  const NumberTest differs = [&](std::size_t number) { return !deviation.is_within(number); };
  if (deviation.kind == Kind::matrix3) {
    append(lines, table_lines(matrix_table(deviation.difference, 0, difference_digits, differs)));
    return lines;
  }

  std::vector<std::size_t> beyond = first_indices(deviation.difference.numbers.size());
  std::erase_if(beyond, [&](std::size_t number) { return !differs(number); });
  Table table;
  for (std::size_t n : beyond) {
    if (table.rows.size() == most_rows) break;
    if (deviation.kind == Kind::vector) table.labels.push_back(messages::column_is_off_by(n + 1));
    table.rows.push_back({number_text(deviation.difference.numbers[n], difference_digits)});
  }
  table.is_marked = [](std::size_t, std::size_t) { return true; };
  append(lines, table_lines(table));
  if (beyond.size() > most_rows) lines.push_back(messages::more_columns(beyond.size() - most_rows));
  return lines;
}

/// The deviations that explain the failure: differing entries speak for themselves, and what follows from them is left
/// out.
std::vector<Deviation> telling_deviations(std::vector<Deviation> all) {
  std::erase_if(all, [](const Deviation& deviation) { return deviation.is_within(); });
  if (!all.empty() && all.front().is_entrywise) all.resize(1);
  return all;
}

std::vector<std::string> result_section(const ExerciseReference& exercise, const FirstFailure& failure,
                                        const Page& page) {
  const Case& one = exercise.cases.at(failure.case_index);
  Result result{exercise, one.expected, failure.actual, std::nullopt};
  std::vector<Deviation> measured;
  if (failure.actual) {
    result.expected = nearest_expected(exercise, failure.case_index, *failure.actual);
    measured = deviations(exercise, failure.case_index, *failure.actual);
    if (measured.front().is_entrywise) result.difference = without_rounding_errors(measured.front());
  }
  result.digits = digits_needed(result);

  std::vector<std::string> lines = {messages::result_heading(exercise.result_name, in_brackets(common_unit(exercise)))};
  append(lines, result_lines(result, page));
  if (!failure.actual) {
    lines.push_back("  " + messages::no_value_to_show());
    return lines;
  }
  if (exercise.comparison == Comparison::up_to_sign) {
    lines.push_back("  " + messages::expected_up_to_sign());
  }
  const std::vector<Deviation> telling = telling_deviations(std::move(measured));
  for (const Deviation& deviation : telling) {
    if (deviation.is_entrywise) continue;
    lines.push_back("");
    append(lines, whole_deviation_lines(without_rounding_errors(deviation), page));
  }
  // How much an equation or a sum is off says little about the size of the error.
  if (!telling.empty() && telling.front().is_entrywise) {
    lines.push_back("");
    append(lines, wrapped(messages::error_size(telling.front().relative_size(), one.tolerance), 0, page));
  }
  return lines;
}

}  // namespace

std::vector<std::string> describe_failure(const ExerciseReference& exercise, const Judgement& judgement,
                                          const Page& page) {
  if (!judgement.first_failure) return {};
  const Case& one = exercise.cases.at(judgement.first_failure->case_index);
  std::vector<std::string> lines = {messages::case_heading(one.name)};
  append(lines, {""});
  append(lines, inputs_section(exercise, one, page));
  append(lines, {""});
  append(lines, result_section(exercise, *judgement.first_failure, page));
  return lines;
}

}  // namespace workbook
