#include "checker/report/failure_text.hpp"

#include "checker/base/text.hpp"
#include "checker/judging/comparison.hpp"
#include "checker/judging/value_text.hpp"
#include "checker/report/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace workbook {

namespace {

constexpr std::size_t block_indent = 2;
constexpr int difference_digits = 3;

std::vector<std::size_t> first_indices(std::size_t count) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

std::string in_brackets(const std::string& unit) { return unit.empty() ? "" : " [" + unit + "]"; }

std::string more(std::size_t count, const std::string& noun) {
  return fmt::format("({} more {}{} not shown)", count, noun, count == 1 ? "" : "s");
}

std::string after_blank(const std::string& unit) { return unit.empty() ? "" : " " + unit; }

Lines vector_lines(const std::string& name, const std::string& unit, const Value& value, const Page& page) {
  const std::string line = fmt::format("{} = {}{}", name, format_value(value, Kind::vector), after_blank(unit));
  if (block_indent + display_width(line) <= page.width) return {line};
  Lines texts;
  for (double number : value.numbers) texts.push_back(number_text(number, all_digits));
  Lines lines = {name + in_brackets(unit)};
  append(lines, wrapped_in_columns(aligned_on_point(texts), block_indent, page));
  return lines;
}

Lines input_lines(const Argument& argument, const Value& value, const Page& page) {
  const std::string unit = to_string(argument.unit);
  if (is_vector(argument.kind)) return vector_lines(argument.name, unit, value, page);
  if (argument.kind == Kind::number || argument.kind == Kind::integer || value.cols == 0) {
    return {fmt::format("{} = {}{}", argument.name, format_value(value, argument.kind), after_blank(unit))};
  }

  Lines lines = {argument.name + in_brackets(unit)};
  const auto cols = static_cast<std::size_t>(value.cols);
  switch (argument.kind) {
    case Kind::points: {
      lines.front() = argument.name + in_brackets(unit) + ", column by column";
      const std::size_t shown = std::min(cols, page.most_rows);
      Table table;
      for (std::size_t col = 0; col < shown; ++col) {
        table.labels.push_back(std::to_string(col + 1));
        table.rows.emplace_back();
        for (int row = 0; row < value.rows; ++row)
          table.rows.back().push_back(number_text(value.at(row, static_cast<int>(col)), all_digits));
      }
      append(lines, indented(table.lines(), block_indent));
      if (shown < cols) lines.push_back("  " + more(cols - shown, "column"));
      break;
    }
    case Kind::matrices: {
      std::vector<Block> blocks;
      for (std::size_t m = 0; m < cols / 3; ++m) {
        blocks.push_back({fmt::format("matrix {}", m + 1), matrix_table(value, 3 * m, all_digits).lines()});
      }
      append(lines, side_by_side(blocks, block_indent, page));
      break;
    }
    default:
      append(lines, indented(matrix_table(value, 0, all_digits).lines(), block_indent));
  }
  return lines;
}

Lines inputs_section(const ExerciseReference& exercise, const Case& one, const Page& page) {
  Lines lines;
  for (std::size_t a = 0; a < one.inputs.size(); ++a) {
    append(lines, indented(input_lines(exercise.arguments.at(a), one.inputs[a], page), block_indent));
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
  return row == 0 ? fmt::format("column {}   1", number / 3 + 1) : std::to_string(row + 1);
}

/// The numbers to show: all of them, or of a long list the columns that differ.
std::vector<std::size_t> shown_numbers(const Result& result, const Page& page) {
  std::vector<std::size_t> shown = first_indices(result.expected.numbers.size());
  if (shown.size() <= page.most_rows) return shown;
  const std::size_t rows = result.exercise.result_kind == Kind::points ? 3 : 1;
  if (result.difference && !result.difference->is_within()) {
    std::erase_if(shown, [&](std::size_t n) {
      const std::size_t top = n - n % rows;
      return std::ranges::none_of(first_indices(rows), [&](std::size_t row) { return result.differs(top + row); });
    });
  }
  shown.resize(std::min(shown.size(), page.most_rows));
  return shown;
}

/// Expected, yours and difference of one number after the other, only those that differ, where columns do not fit.
Lines lines_below_each_other(const Result& result, const Page& page) {
  std::vector<std::size_t> shown = first_indices(result.expected.numbers.size());
  const std::size_t total = shown.size();
  if (result.difference && !result.difference->is_within())
    std::erase_if(shown, [&](std::size_t n) { return !result.differs(n); });
  const std::size_t agreeing = total - shown.size();
  const std::size_t left = shown.size() - std::min(shown.size(), page.most_rows);
  shown.resize(shown.size() - left);
  Lines lines;
  for (std::size_t n : shown) {
    if (total > 1) lines.push_back("  " + entry_name(result.expected, result.exercise.result_kind, n));
    Table table;
    table.labels = {"expected"};
    table.rows = {{number_text(result.expected.numbers[n], result.digits)}};
    if (result.actual) {
      table.labels.push_back("yours");
      table.rows.push_back({number_text(result.actual->numbers[n], result.digits)});
    }
    if (result.difference) {
      table.labels.push_back("difference");
      table.rows.push_back({number_text(result.difference->difference.numbers[n], difference_digits)});
    }
    table.is_marked = [&](std::size_t row, std::size_t) { return row == 1 && result.differs(n); };
    append(lines, indented(table.lines(), total > 1 ? 2 * block_indent : block_indent));
  }
  if (left > 0) lines.push_back("  " + more(left, "number"));
  if (agreeing > 0)
    lines.push_back(
        "  " + (agreeing == 1 ? "(the other number agrees)" : fmt::format("(the other {} numbers agree)", agreeing)));
  return lines;
}

/// Numbers, vectors and points: a line for each number.
Lines component_lines(const Result& result, const Page& page) {
  Table table;
  table.headings = {"expected"};
  if (result.actual) table.headings.push_back("yours");
  if (result.difference) table.headings.push_back("difference");

  const std::vector<std::size_t> shown = shown_numbers(result, page);
  for (std::size_t n : shown) {
    const std::string label = component_label(result.exercise.result_kind, n);
    if (!label.empty()) table.labels.push_back(label);
    Lines row = {number_text(result.expected.numbers[n], result.digits)};
    if (result.actual) row.push_back(number_text(result.actual->numbers[n], result.digits));
    if (result.difference) row.push_back(number_text(result.difference->difference.numbers[n], difference_digits));
    table.rows.push_back(std::move(row));
    if (result.exercise.result_units.size() > 1) table.endings.push_back(to_string(result.exercise.result_units.at(n)));
  }
  table.is_marked = [&](std::size_t row, std::size_t col) { return col == 1 && result.differs(shown[row]); };

  Lines lines = indented(table.lines(), block_indent);
  if (shown.empty()) lines.push_back("  an empty list");
  if (shown.size() < result.expected.numbers.size()) {
    lines.push_back("  " + more(result.expected.numbers.size() - shown.size(), "number"));
  }
  return lines;
}

/// The columns [first_col, first_col + 3): expected, yours and difference as blocks.
Lines matrix_lines(const Result& result, std::size_t first_col, const Page& page) {
  const NumberTest differs = [&](std::size_t number) { return result.differs(number); };
  const NumberTest nothing_differs = [](std::size_t) { return false; };
  const auto block = [&](const std::string& title, const Value& value, int digits, const NumberTest& is_marked) {
    return Block{std::string(block_indent, ' ') + title, matrix_table(value, first_col, digits, is_marked).lines()};
  };
  std::vector<Block> blocks = {block("expected", result.expected, result.digits, nothing_differs)};
  if (result.actual) blocks.push_back(block("yours", *result.actual, result.digits, differs));
  if (result.difference)
    blocks.push_back(block("difference", result.difference->difference, difference_digits, differs));
  return side_by_side(blocks, 0, page);
}

Lines lines_beside_each_other(const Result& result, const Page& page) {
  switch (result.exercise.result_kind) {
    case Kind::matrix3:
      return matrix_lines(result, 0, page);
    case Kind::matrices: {
      Lines lines;
      for (std::size_t col = 0; col + 3 <= static_cast<std::size_t>(result.expected.cols); col += 3) {
        lines.push_back("  " + fmt::format("matrix {}", col / 3 + 1));
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
      return component_lines(result, page);
  }
  return {};
}

Lines result_lines(const Result& result, const Page& page) {
  Lines lines = lines_beside_each_other(result, page);
  const bool fits = page.width >= Page().width || widest(lines) <= page.width;
  return (fits && !page.is_linear) || result.expected.numbers.empty() ? lines : lines_below_each_other(result, page);
}

/// Rounding errors of right numbers would only draw the eye.
Deviation without_rounding_errors(Deviation deviation) {
  for (std::size_t n = 0; n < deviation.allowed.size(); ++n) {
    if (deviation.is_within(n)) deviation.difference.numbers[n] = 0.0;
  }
  return deviation;
}

/// What is tested of the answer as a whole, where it does not hold.
Lines whole_deviation_lines(const Deviation& deviation, const Page& page) {
  const bool is_sentence = deviation.meaning.ends_with('.');
  Lines lines =
      wrapped_lines(is_sentence ? deviation.meaning : deviation.meaning + ": zero for a right answer.", page.width);
  const NumberTest differs = [&](std::size_t number) { return !deviation.is_within(number); };
  if (deviation.kind == Kind::matrix3) {
    append(lines, matrix_table(deviation.difference, 0, difference_digits, differs).lines());
    return lines;
  }

  std::vector<std::size_t> beyond = first_indices(deviation.difference.numbers.size());
  std::erase_if(beyond, [&](std::size_t number) { return !differs(number); });
  Table table;
  for (std::size_t n : beyond) {
    if (table.rows.size() == page.most_rows) break;
    if (deviation.kind == Kind::vector) table.labels.push_back(fmt::format("column {} is off by", n + 1));
    table.rows.push_back({number_text(deviation.difference.numbers[n], difference_digits)});
  }
  table.is_marked = [](std::size_t, std::size_t) { return true; };
  append(lines, table.lines());
  if (beyond.size() > page.most_rows) lines.push_back(more(beyond.size() - page.most_rows, "column"));
  return lines;
}

/// The deviations that explain the failure: differing entries speak for themselves, and what follows from them is left
/// out.
std::vector<Deviation> telling_deviations(std::vector<Deviation> all) {
  std::erase_if(all, [](const Deviation& deviation) { return deviation.is_within(); });
  if (!all.empty() && all.front().is_entrywise) all.resize(1);
  return all;
}

Lines result_section(const ExerciseReference& exercise, std::size_t case_index, const std::optional<Value>& actual,
                     const Page& page) {
  Result result{exercise, exercise.cases[case_index].expected, actual, std::nullopt};
  std::vector<Deviation> measured;
  if (actual) {
    result.expected = nearest_expected(exercise, case_index, *actual);
    measured = deviations(exercise, case_index, *actual);
    if (measured.front().is_entrywise) result.difference = without_rounding_errors(measured.front());
  }
  result.digits = digits_needed(result);

  Lines lines = {"Result " + exercise.result_name + in_brackets(common_unit(exercise))};
  append(lines, result_lines(result, page));
  if (!actual) lines.push_back("  No value of yours can be shown.");
  if (actual && exercise.comparison == Comparison::up_to_sign)
    lines.push_back("  Expected is this value or its negative, whichever is nearer to yours.");
  for (const Deviation& deviation : telling_deviations(std::move(measured))) {
    if (!deviation.is_entrywise) append(lines, whole_deviation_lines(without_rounding_errors(deviation), page));
  }
  return lines;
}

/// The number whose error is largest in its natural size, where entries are compared one by one.
std::string worst_entry(const ExerciseReference& exercise, std::size_t case_index, const Value& actual) {
  const Deviation deviation = deviations(exercise, case_index, actual).front();
  if (!deviation.is_entrywise || !actual.is_finite()) return "";
  std::size_t worst = 0;
  const auto size = [&](std::size_t n) { return std::abs(deviation.difference.numbers[n]) / deviation.allowed[n]; };
  for (std::size_t n = 1; n < actual.numbers.size(); ++n) worst = size(n) > size(worst) ? n : worst;
  const double expected = nearest_expected(exercise, case_index, actual).numbers[worst];
  const double yours = actual.numbers[worst];
  const std::string entry = capitalized(entry_name(actual, exercise.result_kind, worst));
  if (std::abs(yours) <= deviation.allowed[worst] || std::abs(expected) <= deviation.allowed[worst])
    return fmt::format("{} is {} where {} is expected.", entry, number_text(yours, 4), number_text(expected, 4));
  if (yours / expected < 0 || yours / expected > 1.5 || yours / expected < 0.5)
    return fmt::format("{} is {} times the expected value.", entry, coefficient_text(yours / expected));
  return fmt::format("{} is off by {:.2g} % of the expected value.", entry, 100 * std::abs(yours / expected - 1));
}

}  // namespace

Lines describe_case(const ExerciseReference& exercise, std::size_t case_index, const std::optional<Value>& actual,
                    const Page& page) {
  const Case& one = exercise.cases.at(case_index);
  Lines lines = {fmt::format("Case {} “{}”", case_index + 1, one.name)};
  append(lines, inputs_section(exercise, one, page));
  append(lines, result_section(exercise, case_index, actual, page));
  return lines;
}

std::string error_size(const ExerciseReference& exercise, const std::vector<std::size_t>& failing,
                       const Answers& answers) {
  double largest = 0.0;
  double times_allowed = 0.0;
  for (const std::size_t i : failing) {
    if (!answers.at(i)) return "";
    for (const Deviation& deviation : deviations(exercise, i, *answers[i])) {
      // How much an equation or a sum is off says little about the size of the error.
      if (!deviation.is_entrywise || deviation.is_within() || !deviation.difference.is_finite()) return "";
      largest = std::max(largest, deviation.relative_size());
      times_allowed = std::max(times_allowed, deviation.relative_size() / deviation.tolerance);
      break;
    }
  }
  if (failing.empty() || largest == 0) return "";
  if (largest >= 1e-2) return worst_entry(exercise, failing.front(), *answers[failing.front()]);
  const std::string part = fmt::format("At every failing case the error is below 1 part in 10{} of the result",
                                       superscript(static_cast<int>(std::floor(-std::log10(largest)))));
  if (largest >= 1e-6) return part + ": too large for rounding, so look for an approximation or a rounded constant.";
  return fmt::format("{}, {:.{}f} times what is allowed: digits are lost, as with float or 3.14159.", part,
                     times_allowed, times_allowed < 10 ? 1 : 0);
}

}  // namespace workbook
