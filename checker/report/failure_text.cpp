#include "checker/report/reports.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace workbook {

namespace {

using Lines = std::vector<std::string>;
using Indices = std::vector<std::size_t>;

constexpr std::size_t block_indent = 2;
constexpr int difference_digits = 3;

Indices first_indices(std::size_t count) {
  Indices indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  return indices;
}

std::string in_brackets(const std::string& unit) { return unit.empty() ? "" : " [" + unit + "]"; }

std::string more(std::size_t count, const std::string& noun) {
  return fmt::format("({} not shown)", plural(count, "more " + noun));
}

std::string without_trailing_blanks(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

void append(Lines& lines, Lines more) { std::ranges::move(more, std::back_inserter(lines)); }

Lines indented(Lines lines, std::size_t depth = block_indent) {
  for (std::string& line : lines) line.insert(0, depth, ' ');
  return lines;
}

// --- what went in

/// As one types it, with all digits. A brief page has one line for it, if need be with rounded numbers, or the
/// beginning of a long list.
Lines input_lines(const Argument& argument, const Value& value, const Page& page) {
  const std::string unit = to_string(argument.unit), ending = unit.empty() ? "" : " " + unit;
  const std::size_t width = page.width - block_indent;
  const auto text = [&](const char* sign, int digits) {
    return fmt::format("{} {} {}{}", argument.name, sign, format_value(value, argument.kind, digits), ending);
  };
  if (!page.is_brief && value.numbers.size() <= 9 * page.most_rows)
    return wrapped_lines(text("=", all_digits), page.width, block_indent);
  for (const int digits : {all_digits, 6, 4, 3})
    if (std::string line = text(digits == all_digits ? "=" : "≈", digits);
        display_width(line) <= width || value.numbers.size() == 1)
      return indented({line});
  if (argument.kind == Kind::matrix3) return wrapped_lines(text("≈", 4), page.width, block_indent);
  const auto [kind, per_element, elements] = is_vector(argument.kind)        ? std::tuple(Kind::number, 1, "numbers")
                                             : argument.kind == Kind::points ? std::tuple(Kind::vector, 3, "columns")
                                                                             : std::tuple(Kind::matrix3, 9, "matrices");
  const Value first{
      std::min(per_element, 3), per_element == 9 ? 3 : 1, {value.numbers.begin(), value.numbers.begin() + per_element}};
  const std::string line =
      fmt::format("{} = {} {}, the first {}{}", argument.name, value.numbers.size() / first.numbers.size(), elements,
                  format_value(first, kind, 4), ending);
  return indented({shortened(line, width)});
}

// --- what came out

/// Everything that is shown of one result: a column each for what is expected, yours and the difference.
struct Result {
  struct Column {
    const char* title;
    Value value;
    int digits;
  };

  const ExerciseReference& exercise;
  Value expected;
  std::vector<Column> columns = {};
  std::optional<Deviation> difference = {};  ///< where entries are compared one by one

  std::size_t size() const { return expected.numbers.size(); }
  bool differs(std::size_t number) const { return difference && !difference->is_within(number); }
  bool differs_anywhere() const { return difference && !difference->is_within(); }

  /// The numbers to be told one by one: those that differ, where not all can be shown or others say nothing.
  Indices told(const Page& page) const {
    Indices shown = first_indices(size());
    const bool is_matrix = exercise.result_kind == Kind::matrix3 || exercise.result_kind == Kind::matrices;
    const bool is_long = size() > page.most_rows || is_matrix || page.is_linear;
    if (is_long && differs_anywhere()) std::erase_if(shown, [&](std::size_t n) { return !differs(n); });
    if (shown.size() > page.most_rows + 1) shown.resize(page.most_rows);  // a line instead of one more says less
    return shown;
  }
  /// How many of the rest agree, or are too many.
  Lines untold(const Indices& shown) const {
    const std::size_t left = size() - shown.size();
    const auto wrong = static_cast<std::size_t>(
        std::ranges::count_if(first_indices(size()), [&](std::size_t n) { return differs(n); }));
    if (left == 0) return {};
    if (wrong > 0 && wrong == shown.size())
      return {left == 1 ? "  (the other number agrees)" : fmt::format("  (the other {} numbers agree)", left)};
    return {"  " + more(left, "number")};
  }
};

/// As in code: "[1]" for a component of a vector, "(2,0)" for an entry.
std::string component_label(Kind kind, std::size_t number) {
  if (is_vector(kind)) return fmt::format("[{}]", number);
  if (kind == Kind::number || kind == Kind::integer) return "";
  const std::string entry = fmt::format("({},{})", number % 3, number / 3 % (kind == Kind::points ? number + 1 : 3));
  return kind == Kind::matrices ? fmt::format("[{}]{}", number / 9, entry) : entry;
}

/// A line for each number, its digits below each other and a mark in front of what differs.
Lines lines_of_table(const Result& result, const Page& page, const std::string& title, std::size_t columns) {
  const Indices shown = result.told(page);
  Lines labels;
  for (const std::size_t n : shown) labels.push_back(component_label(result.exercise.result_kind, n));
  const std::size_t label_width = std::max(widest(labels), display_width(title));
  Lines lines = {padded(title, label_width)};
  for (const std::string& label : labels) lines.push_back(padded_left(label, label_width));
  for (std::size_t k = 0; k < columns; ++k) {
    const Result::Column& column = result.columns[k];
    Lines cells;
    for (const std::size_t n : shown) cells.push_back(number_text(column.value.numbers[n], column.digits));
    cells = aligned_on_point(cells);
    for (std::size_t row = 0; row < shown.size(); ++row)
      cells[row].insert(0, k == 1 && result.differs(shown[row]) ? "≠ " : "  ");
    cells.insert(cells.begin(), fmt::format("  {}", column.title));
    const std::size_t width = widest(cells);
    for (std::size_t row = 0; row < lines.size(); ++row)
      lines[row] += (k == 0 && label_width == 0 ? "" : " ") + padded(cells[row], width);
  }
  for (std::size_t row = 0; row < shown.size() && result.exercise.result_units.size() > 1; ++row)
    lines[row + 1] += " " + to_string(result.exercise.result_units.at(shown[row]));
  std::ranges::transform(lines, lines.begin(), without_trailing_blanks);
  lines = indented(lines);
  append(lines, result.untold(shown));
  return lines;
}

/// A sentence for each number, for screen readers and narrow terminals.
Lines lines_of_sentences(const Result& result, const Page& page) {
  const Indices shown = result.told(page);
  Lines lines;
  for (const std::size_t n : shown) {
    Lines parts;
    for (const Result::Column& one : result.columns)
      parts.push_back(fmt::format("{} {}{}", one.title, parts.size() == 1 && result.differs(n) ? "≠ " : "",
                                  number_text(one.value.numbers[n], one.digits)));
    const std::string name =
        result.size() > 1 ? entry_name(result.expected, result.exercise.result_kind, n) + ": " : "";
    append(lines, wrapped_lines(fmt::format("{}{}", name, fmt::join(parts, ", ")), page.width, block_indent));
  }
  append(lines, result.untold(shown));
  return lines;
}

/// In the first way that fits: in columns, without the difference on a narrow terminal, as sentences.
Lines result_lines(const Result& result, const Page& page, const std::string& title) {
  const std::string above = "Result " + title;
  if (result.size() == 0) return {above, "  an empty list"};
  const std::size_t fewest = std::min<std::size_t>(2, result.columns.size());
  for (std::size_t columns = result.columns.size(); columns >= fewest && !page.is_linear; --columns)
    for (const std::string& beside : {title, std::string()}) {
      Lines lines = lines_of_table(result, page, beside, columns);
      if (beside.empty()) lines.insert(lines.begin(), above);
      if (widest(lines) <= page.width) return lines;
    }
  Lines lines = {above};
  append(lines, lines_of_sentences(result, page));
  return lines;
}

/// Rounding errors of right numbers would only draw the eye.
Deviation without_rounding_errors(Deviation deviation) {
  for (std::size_t n = 0; n < deviation.allowed.size(); ++n)
    if (deviation.is_within(n)) deviation.difference.numbers[n] = 0.0;
  return deviation;
}

/// What is tested of the answer as a whole, where it does not hold, and by how much.
std::string whole_deviation(const Deviation& deviation) {
  if (deviation.meaning.ends_with('.')) return deviation.meaning;
  const std::vector<double>& numbers = deviation.difference.numbers;
  const std::size_t worst = std::ranges::max(
      first_indices(numbers.size()), {}, [&](std::size_t n) { return std::abs(numbers[n]) / deviation.allowed[n]; });
  return fmt::format("{}: zero for a right answer, here {}{}{}.", deviation.meaning, numbers.size() > 1 ? "up to " : "",
                     number_text(numbers.size() > 1 ? std::abs(numbers[worst]) : numbers[worst], difference_digits),
                     deviation.kind == Kind::vector ? fmt::format(" in column {}", worst) : "");
}

Lines result_section(const ExerciseReference& exercise, std::size_t case_index, const std::optional<Value>& actual,
                     const Page& page) {
  Result result{exercise, exercise.cases[case_index].expected};
  std::vector<Deviation> measured;
  int digits = 6;
  if (actual) {
    result.expected = nearest_expected(exercise, case_index, *actual);
    measured = deviations(exercise, case_index, *actual);
    if (measured.front().is_entrywise) result.difference = without_rounding_errors(measured.front());
    for (std::size_t n = 0; n < result.size(); ++n)
      if (result.differs(n))
        digits = std::max(digits, digits_to_tell_apart(result.expected.numbers[n], actual->numbers[n]));
  }
  result.columns.push_back({"expected", result.expected, digits});
  if (actual) result.columns.push_back({"yours", *actual, digits});
  if (result.difference && exercise.result_kind != Kind::integer)
    result.columns.push_back({"difference", result.difference->difference, difference_digits});

  const std::string unit = exercise.result_units.size() == 1 ? to_string(exercise.result_units.front()) : "";
  Lines lines = result_lines(result, page, exercise.result_name + in_brackets(unit));
  if (!actual) lines.emplace_back("  No value of yours can be shown.");
  if (actual && exercise.comparison == Comparison::up_to_sign)
    append(lines, wrapped_lines("Expected is this value or its negative, whichever is nearer to yours.", page.width,
                                block_indent));
  // Differing entries speak for themselves, and what follows from them is left out.
  if (result.differs_anywhere()) return lines;
  for (const Deviation& deviation : measured)
    if (!deviation.is_entrywise && !deviation.is_within() && deviation.difference.is_finite())
      append(lines, wrapped_lines(whole_deviation(deviation), page.width));
  return lines;
}

/// Where two entries of a case hold each other's value; else "".
std::string exchanged_entries(const ExerciseReference& exercise, std::size_t case_index, Value actual) {
  for (std::size_t n = 0; n < actual.numbers.size(); ++n)
    for (std::size_t m = n + 1; m < actual.numbers.size(); ++m) {
      std::swap(actual.numbers[n], actual.numbers[m]);
      const bool is_right = passes(exercise, case_index, actual);
      std::swap(actual.numbers[n], actual.numbers[m]);
      if (is_right)
        return fmt::format("Here {} and {} hold each other's value.", entry_name(actual, exercise.result_kind, n),
                           entry_name(actual, exercise.result_kind, m));
    }
  return "";
}

/// The number whose error is largest in its natural size, where entries are compared one by one.
std::string worst_entry(const ExerciseReference& exercise, std::size_t case_index, const Value& actual) {
  const Deviation deviation = deviations(exercise, case_index, actual).front();
  if (!deviation.is_entrywise || !actual.is_finite() || exercise.result_kind == Kind::integer) return "";
  const std::size_t worst = std::ranges::max(first_indices(actual.numbers.size()), {}, [&](std::size_t n) {
    return std::abs(deviation.difference.numbers[n]) / deviation.allowed[n];
  });
  const double expected = nearest_expected(exercise, case_index, actual).numbers[worst];
  const double yours = actual.numbers[worst];
  const std::string entry = capitalized(entry_name(actual, exercise.result_kind, worst));
  if (std::abs(yours) <= deviation.allowed[worst] || std::abs(expected) <= deviation.allowed[worst])
    return fmt::format("{} is {} where {} is expected.", entry, number_text(yours, 4), number_text(expected, 4));
  if (yours / expected > 1.5 || yours / expected < 0.5)
    return fmt::format("{} is {} times the expected value.", entry, coefficient_text(yours / expected));
  return fmt::format("{} is off by {:.2g} % of the expected value.", entry, 100 * std::abs(yours / expected - 1));
}

}  // namespace

std::size_t widest(const std::vector<std::string>& lines) {
  std::size_t width = 0;
  for (const std::string& text : lines) width = std::max(width, display_width(text));
  return width;
}

std::vector<std::string> describe_case(const ExerciseReference& exercise, std::size_t case_index,
                                       const std::optional<Value>& actual, const Page& page) {
  const Case& one = exercise.cases.at(case_index);
  std::vector<Lines> each;
  for (std::size_t a = 0; a < one.inputs.size(); ++a)
    each.push_back(input_lines(exercise.arguments.at(a), one.inputs[a], page));
  const auto beside_each_other = [&] {
    Lines lines;
    bool may_join = false;  // short ones
    for (const Lines& input : each) {
      const bool is_short = input.size() == 1 && !page.is_linear;
      if (is_short && may_join && display_width(lines.back()) + display_width(input.front()) < page.width)
        lines.back() += " " + input.front();
      else
        append(lines, input);
      may_join = is_short;
    }
    return lines;
  };
  Lines inputs = beside_each_other();
  // Where there is too little room, long results give way, then inputs.
  Lines result = result_section(exercise, case_index, actual, page);
  Page shorter = page;
  for (const std::size_t rows : {6, 3, 1})
    if ((rows > 1 ? 1 + inputs.size() : 2) + result.size() > page.most_lines) {
      shorter.most_rows = rows;
      result = result_section(exercise, case_index, actual, shorter);
    }
  for (Lines left_out; 1 + inputs.size() + result.size() > page.most_lines && left_out.size() < each.size();) {
    const auto size = [](const Lines& input) {
      return std::pair(input.size(), input.empty() ? 0 : input.front().size());
    };
    const auto longest = std::ranges::max_element(each, {}, size);
    left_out.push_back(exercise.arguments[static_cast<std::size_t>(longest - each.begin())].name);
    longest->clear();
    inputs = beside_each_other();
    inputs.push_back(left_out.size() == each.size() ? "  (inputs not shown)"
                     : left_out.size() > 2          ? "  (further inputs not shown)"
                                                    : fmt::format("  ({} not shown)", fmt::join(left_out, ", ")));
  }
  Lines lines = {fmt::format("Case {} “{}”", case_index + 1, one.name)};
  append(lines, std::move(inputs));
  append(lines, std::move(result));
  return lines;
}

std::vector<std::string> on_real_data(const CheckResult& checked) {
  std::vector<std::string> sentences;
  for (std::size_t k = 0; k < checked.observation.measured.size(); ++k) {
    const ExerciseReference& exercise = *checked.reference;
    const Measured& real = exercise.measured[k];
    const Reply& reply = checked.observation.measured[k];
    const std::vector<PlotComponent>& components = exercise.sweep.components;
    std::vector<std::string> parts;
    for (const PlotComponent& each : components) {
      const auto n = static_cast<std::size_t>(each.col * reply.value.rows + each.row);
      if (reply.ending != Ending::returned || components.size() != reply.value.numbers.size()) break;
      const double number = reply.value.numbers.at(n), error = real.errors.empty() ? 0 : real.errors.at(n);
      const int decimals = error > 0 ? std::max(0, 1 - static_cast<int>(std::floor(std::log10(error)))) : 0;
      const std::string unit = to_string(exercise.result_units[exercise.result_units.size() == 1 ? 0 : n]);
      parts.push_back(fmt::format(
          "{} = {}{}{}", each.name,
          error > 0 ? fmt::format("{:.{}f} ± {:.{}f}", number, decimals, error, decimals) : number_text(number, 4),
          unit.empty() ? "" : " ", unit));
    }
    if (parts.empty())
      parts.push_back(reply.ending == Ending::returned ? fmt::format("{} = {}", exercise.result_name,
                                                                     format_value(reply.value, exercise.result_kind, 4))
                                                       : "no result");
    sentences.push_back(fmt::format("on {}: {}.", real.name, fmt::join(parts, ", ")));
  }
  return sentences;
}

std::string error_size(const ExerciseReference& exercise, const std::vector<std::size_t>& failing,
                       const Answers& answers) {
  double largest = 0.0, largest_of_itself = 0.0;
  double times_allowed = 0.0;
  for (const std::size_t i : failing) {
    if (!answers.at(i)) return "";
    const Deviation deviation = deviations(exercise, i, *answers[i]).front();
    // How much an equation or a sum is off says little about the size of the error.
    if (!deviation.is_entrywise || deviation.is_within() || !deviation.difference.is_finite()) return "";
    largest = std::max(largest, deviation.relative_size());
    times_allowed = std::max(times_allowed, deviation.relative_size() / deviation.tolerance);
    for (std::size_t n = 0; n < answers[i]->numbers.size(); ++n) {
      const double yours = std::abs(answers[i]->numbers[n]), error = std::abs(deviation.difference.numbers[n]);
      if (!deviation.is_within(n)) largest_of_itself = std::max(largest_of_itself, error / std::max(yours, error));
    }
  }
  if (failing.empty() || largest == 0) return "";
  // Against the numbers themselves: a small one may be lost as a whole.
  if (largest >= 1e-2 || largest_of_itself >= 1e-2) {
    const std::string exchanged = exchanged_entries(exercise, failing.front(), *answers[failing.front()]);
    return exchanged.empty() ? worst_entry(exercise, failing.front(), *answers[failing.front()]) : exchanged;
  }
  const std::string part = fmt::format("At every failing case the error is below 1 part in 10{} of the result",
                                       superscript(static_cast<int>(std::floor(-std::log10(largest)))));
  if (largest >= 1e-6) return part + ": too large for rounding, so look for an approximation or a rounded constant.";
  return fmt::format("{}, {:.{}f} times what is allowed: digits are lost, as with float or 3.14159.", part,
                     times_allowed, times_allowed < 10 ? 1 : 0);
}

}  // namespace workbook
