#include "checker/report/reports.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace workbook {

namespace {

using Lines = std::vector<std::string>;
using Indices = std::vector<std::size_t>;
/// True for a number of a value that is to be marked.
using NumberTest = std::function<bool(std::size_t number)>;

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

// --- numbers in aligned columns

/// Numbers in rows and columns, those outside the tolerance with a mark in front.
struct Table {
  std::string title = {};        ///< above the labels
  Lines headings = {};           ///< one per column of numbers, or none
  Lines labels = {};             ///< one per row, or none
  std::vector<Lines> rows = {};  ///< numbers, aligned on the decimal point column by column
  Lines endings = {};            ///< one per row, or none: units
  std::function<bool(std::size_t row, std::size_t col)> is_marked = {};  ///< without it there is no room for marks

  /// Every entry below its column's heading; no line ends with a blank.
  Lines lines() const {
    if (rows.empty()) return {};
    const std::size_t heading = headings.empty() ? 0 : 1;
    const std::size_t label_width = std::max(widest(labels), display_width(title));
    Lines text(rows.size() + heading, std::string(label_width, ' '));
    if (heading > 0) text.front() = padded(title, label_width);
    for (std::size_t row = 0; row < labels.size(); ++row) text[row + heading] = padded_left(labels[row], label_width);
    for (std::size_t col = 0; col < rows.front().size(); ++col) {
      const Lines cells = column(col);
      const char* const gap = col == 0 && label_width == 0 ? "" : is_marked ? " " : "  ";  // a mark is a gap too
      for (std::size_t row = 0; row < text.size(); ++row) text[row] += gap + cells[row];
    }
    for (std::size_t row = 0; row < endings.size(); ++row) text[row + heading] += " " + endings[row];
    std::ranges::transform(text, text.begin(), without_trailing_blanks);
    return text;
  }

 private:
  /// One column of numbers with its heading on top, all of one width.
  Lines column(std::size_t col) const {
    Lines cells;
    for (const Lines& row : rows) cells.push_back(row.at(col));
    cells = aligned_on_point(cells);
    for (std::size_t row = 0; is_marked && row < cells.size(); ++row)
      cells[row].insert(0, is_marked(row, col) ? "≠ " : "  ");
    if (!headings.empty()) cells.insert(cells.begin(), (is_marked ? "  " : "") + headings.at(col));
    for (std::string& cell : cells) cell = padded(cell, widest(cells));
    return cells;
  }
};

/// The columns [first_col, first_col + 3) of a value of three rows.
Lines matrix_lines(const Value& value, std::size_t first_col, int digits, const NumberTest& is_marked = {}) {
  Table table{.rows = std::vector(3, Lines(3))};
  const auto number_at = [first_col](std::size_t row, std::size_t col) { return 3 * (first_col + col) + row; };
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t col = 0; col < 3; ++col)
      table.rows[row][col] = number_text(value.numbers.at(number_at(row, col)), digits);
  if (is_marked) table.is_marked = [&](std::size_t row, std::size_t col) { return is_marked(number_at(row, col)); };
  return table.lines();
}

/// Blocks of lines below a title beside each other as long as they fit on the page, each row of blocks below the one
/// before.
Lines side_by_side(const std::vector<Lines>& blocks, std::size_t indent, const Page& page, std::size_t gap = 3) {
  Lines result;
  Lines band;  // blocks that stand beside each other
  const auto finish_band = [&] {
    for (const std::string& line : band) result.push_back(without_trailing_blanks(std::string(indent, ' ') + line));
    band.clear();
  };
  for (const Lines& lines : blocks) {
    if (page.is_linear || indent + widest(band) + gap + widest(lines) > page.width) finish_band();
    const std::size_t start = band.empty() ? 0 : widest(band) + gap;
    band.resize(std::max(band.size(), lines.size()));
    for (std::size_t row = 0; row < lines.size(); ++row) band[row] = padded(band[row], start) + lines[row];
  }
  finish_band();
  return result;
}

// --- what went in

Lines input_lines(const Argument& argument, const Value& value, const Page& page) {
  const std::string unit = to_string(argument.unit);
  const auto on_one_line = [&](const char* sign, int digits) {
    return fmt::format("{} {} {}{}{}", argument.name, sign, format_value(value, argument.kind, digits),
                       unit.empty() ? "" : " ", unit);
  };
  const auto fits = [&](const std::string& line) {
    return (page.is_brief || argument.kind != Kind::matrices) && block_indent + display_width(line) <= page.width;
  };
  const std::string line = on_one_line("=", all_digits);
  const bool is_number = argument.kind == Kind::number || argument.kind == Kind::integer;
  if (fits(line) || is_number || value.cols == 0) return {line};
  if (page.is_brief)
    for (const int digits : {6, 4})
      if (const std::string rounded = on_one_line("≈", digits); fits(rounded)) return {rounded};

  Lines lines = {argument.name + in_brackets(unit)};
  const auto cols = static_cast<std::size_t>(value.cols);
  if (is_vector(argument.kind)) {
    Lines texts;
    for (double number : value.numbers) texts.push_back(number_text(number, all_digits));
    std::vector<Lines> blocks;
    for (const std::string& text : aligned_on_point(texts)) blocks.push_back({text});
    append(lines, side_by_side(blocks, block_indent, {.width = page.width}, 2));
  } else if (argument.kind == Kind::points) {
    const std::size_t shown = std::min(cols, page.is_brief ? page.most_rows / 2 : page.most_rows);
    if (shown == 1 && cols > 1) {
      const Value first{value.rows, 1, {value.numbers.begin(), value.numbers.begin() + value.rows}};
      return {fmt::format("{} = {} columns, the first {}{}{}", argument.name, cols, format_value(first, Kind::vector),
                          unit.empty() ? "" : " ", unit)};
    }
    lines.front() += ", column by column";
    Table table;
    for (std::size_t col = 0; col < shown; ++col) {
      table.labels.push_back(std::to_string(col));
      Lines& row = table.rows.emplace_back();
      for (int k = 0; k < value.rows; ++k) row.push_back(number_text(value.at(k, static_cast<int>(col)), all_digits));
    }
    append(lines, indented(table.lines()));
    if (shown < cols) lines.push_back("  " + more(cols - shown, "column"));
  } else if (argument.kind == Kind::matrices) {
    std::vector<Lines> blocks;
    for (std::size_t m = 0; m < cols / 3; ++m) {
      blocks.push_back({fmt::format("matrix [{}]", m)});
      append(blocks.back(), matrix_lines(value, 3 * m, all_digits));
    }
    append(lines, side_by_side(blocks, block_indent, page));
  } else {
    append(lines, indented(matrix_lines(value, 0, all_digits)));
  }
  return lines;
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
  std::string title = {};                    ///< name and unit where they stand among the headings of columns

  std::size_t size() const { return expected.numbers.size(); }
  bool differs(std::size_t number) const { return difference && !difference->is_within(number); }
  bool differs_anywhere() const { return difference && !difference->is_within(); }
  Lines row(std::size_t number) const {
    Lines texts;
    for (const Column& one : columns) texts.push_back(number_text(one.value.numbers[number], one.digits));
    return texts;
  }
};

/// As in code: "[1]" for a component of a vector, "column 0   1" for one of a list of columns.
std::string component_label(Kind kind, std::size_t number) {
  if (is_vector(kind)) return fmt::format("[{}]", number);
  if (kind != Kind::points) return "";
  const std::size_t row = number % 3;
  return row == 0 ? fmt::format("column {}   0", number / 3) : std::to_string(row);
}

/// Expected, yours and difference of one number after the other, only those that differ, where columns do not fit.
Lines lines_below_each_other(const Result& result, const Page& page) {
  Indices shown = first_indices(result.size());
  if (result.differs_anywhere()) std::erase_if(shown, [&](std::size_t n) { return !result.differs(n); });
  const std::size_t agreeing = result.size() - shown.size();
  const std::size_t left = shown.size() - std::min(shown.size(), page.most_rows);
  shown.resize(shown.size() - left);
  Lines lines;
  for (std::size_t n : shown) {
    if (result.size() > 1) lines.push_back("  " + entry_name(result.expected, result.exercise.result_kind, n));
    Table table;
    for (const Result::Column& one : result.columns) {
      table.labels.emplace_back(one.title);
      table.rows.push_back({number_text(one.value.numbers[n], one.digits)});
    }
    table.is_marked = [&](std::size_t row, std::size_t) { return row == 1 && result.differs(n); };
    append(lines, indented(table.lines(), result.size() > 1 ? 2 * block_indent : block_indent));
  }
  if (left > 0) lines.push_back("  " + more(left, "number"));
  if (agreeing == 1) lines.emplace_back("  (the other number agrees)");
  if (agreeing > 1) lines.push_back(fmt::format("  (the other {} numbers agree)", agreeing));
  return lines;
}

/// Numbers, vectors and points: a line for each number; of a long list only for the columns that differ.
Lines component_lines(const Result& result, const Page& page) {
  Indices shown = first_indices(result.size());
  const std::size_t rows = result.exercise.result_kind == Kind::points ? 3 : 1;
  if (shown.size() > page.most_rows) {
    if (result.differs_anywhere())
      std::erase_if(shown, [&](std::size_t n) {
        const std::size_t top = n - n % rows;
        return std::ranges::none_of(first_indices(rows), [&](std::size_t row) { return result.differs(top + row); });
      });
    shown.resize(std::min(shown.size(), page.most_rows));
  }
  Table table{.title = result.title};
  for (const Result::Column& one : result.columns) table.headings.emplace_back(one.title);
  for (std::size_t n : shown) {
    const std::string label = component_label(result.exercise.result_kind, n);
    if (!label.empty()) table.labels.push_back(label);
    table.rows.push_back(result.row(n));
    if (result.exercise.result_units.size() > 1) table.endings.push_back(to_string(result.exercise.result_units.at(n)));
  }
  table.is_marked = [&](std::size_t row, std::size_t col) { return col == 1 && result.differs(shown[row]); };
  Lines lines = indented(table.lines());
  if (shown.empty()) lines.emplace_back("  an empty list");
  if (shown.size() < result.size()) lines.push_back("  " + more(result.size() - shown.size(), "number"));
  return lines;
}

/// Matrices: expected, yours and difference as blocks.
Lines lines_beside_each_other(const Result& result, const Page& page) {
  const Kind kind = result.exercise.result_kind;
  if (kind != Kind::matrix3 && kind != Kind::matrices) return component_lines(result, page);
  Lines lines;
  for (std::size_t col = 0; col + 3 <= static_cast<std::size_t>(result.expected.cols); col += 3) {
    if (kind == Kind::matrices) lines.push_back(fmt::format("  matrix [{}]", col / 3));
    std::vector<Lines> blocks;
    for (const Result::Column& one : result.columns) {
      const bool is_expected = blocks.empty();
      blocks.push_back(
          {"  " + std::string(one.title) + (is_expected && !result.title.empty() ? " " + result.title : "")});
      append(blocks.back(), matrix_lines(one.value, col, one.digits,
                                         [&](std::size_t n) { return !is_expected && result.differs(n); }));
    }
    Lines band = side_by_side(blocks, 0, page);
    if (page.is_brief && result.difference && band.size() > blocks.front().size()) {
      blocks.pop_back();  // the marks tell where they differ
      band = side_by_side(blocks, 0, page);
    }
    append(lines, band);
  }
  return lines;
}

/// Rounding errors of right numbers would only draw the eye.
Deviation without_rounding_errors(Deviation deviation) {
  for (std::size_t n = 0; n < deviation.allowed.size(); ++n)
    if (deviation.is_within(n)) deviation.difference.numbers[n] = 0.0;
  return deviation;
}

/// What is tested of the answer as a whole, where it does not hold.
Lines whole_deviation_lines(const Deviation& deviation, const Page& page) {
  const bool is_sentence = deviation.meaning.ends_with('.');
  Lines lines =
      wrapped_lines(is_sentence ? deviation.meaning : deviation.meaning + ": zero for a right answer.", page.width);
  const std::vector<double>& numbers = deviation.difference.numbers;
  const bool is_number = numbers.size() == 1;
  if (page.is_brief && !is_sentence && (is_number || deviation.kind == Kind::matrix3) &&
      deviation.difference.is_finite()) {
    double largest = 0;
    for (const double number : numbers) largest = std::max(largest, std::abs(number));
    return wrapped_lines(
        fmt::format("{}: zero for a right answer, here {}{}.", deviation.meaning, is_number ? "" : "up to ",
                    number_text(is_number ? numbers.front() : largest, difference_digits)),
        page.width);
  }
  if (deviation.kind == Kind::matrix3) {
    append(lines, matrix_lines(deviation.difference, 0, difference_digits,
                               [&](std::size_t number) { return !deviation.is_within(number); }));
    return lines;
  }
  Indices beyond = first_indices(deviation.difference.numbers.size());
  std::erase_if(beyond, [&](std::size_t number) { return deviation.is_within(number); });
  Table table;
  table.is_marked = [](std::size_t, std::size_t) { return true; };
  for (std::size_t n : beyond) {
    if (table.rows.size() == page.most_rows) break;
    if (deviation.kind == Kind::vector) table.labels.push_back(fmt::format("column {} is off by", n));
    table.rows.push_back({number_text(deviation.difference.numbers[n], difference_digits)});
  }
  append(lines, table.lines());
  if (beyond.size() > page.most_rows) lines.push_back(more(beyond.size() - page.most_rows, "column"));
  return lines;
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
  if (result.difference) result.columns.push_back({"difference", result.difference->difference, difference_digits});

  const std::string unit = exercise.result_units.size() == 1 ? to_string(exercise.result_units.front()) : "";
  const std::string title = exercise.result_name + in_brackets(unit);
  Lines lines = {"Result " + title};
  if (!page.is_linear && exercise.result_kind != Kind::matrices && result.size() > 0) result.title = title;
  Lines wide = lines_beside_each_other(result, page);
  if (!result.title.empty() && widest(wide) <= page.width) {
    lines = wide;
  } else {
    result.title.clear();
    wide = lines_beside_each_other(result, page);
    const bool fits = !page.is_linear && (page.width >= Page().width || widest(wide) <= page.width);
    append(lines, fits || result.size() == 0 ? wide : lines_below_each_other(result, page));
  }
  if (!actual) lines.emplace_back("  No value of yours can be shown.");
  if (actual && exercise.comparison == Comparison::up_to_sign)
    lines.emplace_back("  Expected is this value or its negative, whichever is nearer to yours.");
  // Differing entries speak for themselves, and what follows from them is left out.
  if (result.differs_anywhere()) return lines;
  for (const Deviation& deviation : measured)
    if (!deviation.is_entrywise && !deviation.is_within())
      append(lines, whole_deviation_lines(without_rounding_errors(deviation), page));
  return lines;
}

/// The number whose error is largest in its natural size, where entries are compared one by one.
std::string worst_entry(const ExerciseReference& exercise, std::size_t case_index, const Value& actual) {
  const Deviation deviation = deviations(exercise, case_index, actual).front();
  if (!deviation.is_entrywise || !actual.is_finite()) return "";
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
  Lines lines = {fmt::format("Case {} “{}”", case_index + 1, one.name)};
  bool may_join = false;  // short inputs stand beside each other
  for (std::size_t a = 0; a < one.inputs.size(); ++a) {
    Lines input = indented(input_lines(exercise.arguments.at(a), one.inputs[a], page));
    const bool is_short = input.size() == 1 && !page.is_linear;
    if (is_short && may_join && display_width(lines.back()) + display_width(input.front()) < page.width)
      lines.back() += " " + input.front();
    else
      append(lines, std::move(input));
    may_join = is_short;
  }
  append(lines, result_section(exercise, case_index, actual, page));
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
  if (largest >= 1e-2 || largest_of_itself >= 1e-2)
    return worst_entry(exercise, failing.front(), *answers[failing.front()]);
  const std::string part = fmt::format("At every failing case the error is below 1 part in 10{} of the result",
                                       superscript(static_cast<int>(std::floor(-std::log10(largest)))));
  if (largest >= 1e-6) return part + ": too large for rounding, so look for an approximation or a rounded constant.";
  return fmt::format("{}, {:.{}f} times what is allowed: digits are lost, as with float or 3.14159.", part,
                     times_allowed, times_allowed < 10 ? 1 : 0);
}

}  // namespace workbook
