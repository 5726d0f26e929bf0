#include "checker/messages/running.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <optional>
#include <string_view>

namespace workbook::messages {

namespace {

struct Explanation {
  std::string_view fragment;  ///< of the condition as Eigen 3.4 writes it
  const char* sentence;
};

constexpr const char* outside_vector =
    "an index lies outside its vector; a vector of size n has the indices 0 to n - 1";
constexpr const char* outside_block = "a block, segment, head or tail reaches beyond its matrix or vector";
constexpr const char* different_sizes = "two operands of a sum, difference or assignment have different sizes";
constexpr const char* not_its_size =
    "a matrix or vector is given a size that is negative or that its type does not allow";
constexpr const char* square_needed = "inverse, determinant and eigenvalues need a square matrix";
constexpr const char* braces = "the rows in the braces do not have the size of their matrix";

/// The first that fits counts: particular ones stand before general ones.
constexpr Explanation explanations[] = {
    {"Too few coefficients", "too few numbers follow <<; it must fill the whole matrix or vector"},
    {"Too many coefficients", "too many numbers follow << for this matrix or vector"},
    {"Too many rows", "too many numbers follow << for this matrix or vector"},
    {"m_xpr.rows() >= other.rows()", "what follows << is larger than the matrix or vector that it shall fill"},
    {"Cannot comma-initialize", "<< puts numbers into a matrix or vector without entries; give it a size first"},
    {"m_currentBlockRows", "the parts joined by << do not have the same number of rows"},
    {"invalid matrix product",
     "in a matrix product the left factor must have as many columns as the right one has rows"},
    {"aliasing detected during transposition",
     "A = A.transpose() overwrites A while reading it; use A.transposeInPlace() or A.transpose().eval()"},
    {"Aliasing problem detected in inverse", "A = A.inverse() overwrites A while reading it; use A.inverse().eval()"},
    {"transposeInPlace() called on a non-square", "transposeInPlace() needs a square matrix"},
    {"you are using an empty matrix", "an empty matrix or vector has no largest, smallest or mean entry"},
    {"eigenvectors have not been computed",
     "the solver was told to compute eigenvalues only, and is asked for eigenvectors"},
    {"is not initialized", "a decomposition is used before compute() was called"},
    {"invalid number of rows of the right hand side",
     "solve() needs a right-hand side with as many rows as the matrix has"},
    {"non-square matrix", square_needed},
    {"index >= 0 && index < size()", outside_vector},
    {"row >= 0 && row < rows()", "a row or column index lies outside its matrix; indices start at 0"},
    {"(i>=0) && (", "row(i) or col(i) is asked for an i that the matrix does not have; indices start at 0"},
    {"startRow >= 0", outside_block},
    {"RowsAtCompileTime==blockRows", outside_block},
    {"aLhs.rows() == aRhs.rows()", different_sizes},
    {"dst.rows() ==", different_sizes},
    {"dst.rows()==", different_sizes},
    {"does not actually allow one to resize", different_sizes},
    {"list_size ==", braces},
    {"list.size() ==", braces},
    {"other.rows() == 1 || other.cols() == 1", "a matrix of several rows and columns is assigned to a vector"},
    {"RowsAtCompileTime == rows", not_its_size},
    {"rows==RowsAtCompileTime", not_its_size},
    {"SizeAtCompileTime == size", not_its_size},
    {"SizeAtCompileTime == vecSize", not_its_size},
    {"rows >= 0 && cols >= 0", not_its_size},
    {"vecSize >= 0", not_its_size},
    {"a_index <= m_matrix.cols()", "diagonal(i) is asked for a diagonal that the matrix does not have"},
    {"rows() == other.rows()", different_sizes},
    {"rows()==other.rows()", different_sizes},
    {"size() == other.size()", "dot() needs two vectors of the same size"},
    {"this->rows() == 1 && this->cols() == 1", "only a matrix with one entry can be used as a number"},
    {"rows() == cols()", square_needed},
    {"cols() == matrix.rows()", square_needed},
    {"m_lu.rows() == m_lu.cols()", "this decomposition needs a square matrix"},
};

std::string explained(const std::string& condition) {
  for (const Explanation& explanation : explanations)
    if (condition.find(explanation.fragment) != std::string::npos) return explanation.sentence;
  return "";
}

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

std::string shape(long rows, long cols) { return fmt::format("{}×{}", rows, cols); }

/// "a vector of size 3" for one column or one row, else "a 3×4 matrix".
std::string sized(long rows, long cols) {
  if (cols == 1) return fmt::format("a vector of size {}", rows);
  if (rows == 1) return fmt::format("a row vector of size {}", cols);
  return fmt::format("a {} matrix", shape(rows, cols));
}

std::string indices(long size, const std::string& what = "indices") {
  if (size <= 0) return "it is empty";
  return size == 1 ? fmt::format("{} 0 only", what) : fmt::format("{} 0 to {}", what, size - 1);
}

std::string index_outside(long index, long size, const std::string& owner) {
  if (size <= 0) return fmt::format("there is no index {} in an empty {}.", index, owner);
  return fmt::format("index {} is outside the {} of size {} ({}).", index, owner, size, indices(size));
}

std::string row_or_column_outside(const std::string& which, long index, long count, long rows, long cols) {
  return fmt::format("{} {} is outside the {} matrix ({}).", which, index, shape(rows, cols),
                     indices(count, which + "s"));
}

std::string entry_outside(long row, long col, long rows, long cols) {
  if (row < 0 || row >= rows) return row_or_column_outside("row", row, rows, rows, cols);
  return row_or_column_outside("column", col, cols, rows, cols);
}

/// row(i) and col(i).
std::string slice_outside(long i, long rows, long cols, bool is_row) {
  return row_or_column_outside(is_row ? "row" : "column", i, is_row ? rows : cols, rows, cols);
}

std::string block_outside(const std::vector<long>& facts) {
  const long row = facts[0], col = facts[1], height = facts[2], width = facts[3], rows = facts[4], cols = facts[5];
  if (height < 0 || width < 0) return fmt::format("a part of negative size ({}) is asked for.", shape(height, width));
  const bool of_vector = cols == 1 && width == 1 && col == 0;
  const bool of_row_vector = rows == 1 && height == 1 && row == 0;
  if (of_vector || of_row_vector) {
    const long start = of_vector ? row : col, length = of_vector ? height : width, size = of_vector ? rows : cols;
    if (length > size) return fmt::format("{} entries are asked for, but the vector has size {}.", length, size);
    return fmt::format("{} entries from index {} reach outside the vector of size {} ({}).", length, start, size,
                       indices(size));
  }
  return fmt::format("a {} block that begins at ({}, {}) reaches outside the {} matrix.", shape(height, width), row,
                     col, shape(rows, cols));
}

std::string too_few_or_many(const std::string& condition, const std::vector<long>& facts) {
  const long row = facts[0], col = facts[1], height = facts[2], rows = facts[3], cols = facts[4];
  const long room = rows * cols;
  if (has(condition, "Too few coefficients")) {
    // Where blocks are joined, the height of the last row of blocks counts.
    const long given = height == 1 ? row * cols + col : 0;
    if (given > 0)
      return fmt::format("{} number{} after << cannot fill {}: it has {} entries.", given, given == 1 ? "" : "s",
                         sized(rows, cols), room);
    return fmt::format("too few numbers after << to fill {}: it has {} entries.", sized(rows, cols), room);
  }
  if (has(condition, "m_xpr.rows() >= other.rows()"))
    return fmt::format("{} after << is larger than {}, which it shall fill.", sized(height, col), sized(rows, cols));
  if (has(condition, "Cannot comma-initialize"))
    return fmt::format("numbers after << find no room: the matrix or vector has the size {}. Give it a size first.",
                       shape(rows, cols));
  if (has(condition, "Too many"))
    return fmt::format("too many numbers after << for {}: it has {} entries.", sized(rows, cols), room);
  return "";
}

std::string with_facts(const std::string& condition, const std::vector<long>& facts) {
  const auto count = facts.size();
  if (has(condition, "index >= 0 && index < size()") && count == 2) return index_outside(facts[0], facts[1], "vector");
  if (has(condition, "row >= 0 && row < rows()") && count == 4)
    return entry_outside(facts[0], facts[1], facts[2], facts[3]);
  if (has(condition, "(i>=0) && (") && count == 5)
    return slice_outside(facts[0], facts[1], facts[2], facts[3] == 1 && facts[4] != 1);
  if (has(condition, "startRow >= 0") && count == 6) return block_outside(facts);
  if (has(condition, "invalid matrix product") && count == 4)
    return fmt::format("matrix product of a {} by a {}: left columns ({}) must equal right rows ({}).",
                       shape(facts[0], facts[1]), shape(facts[2], facts[3]), facts[1], facts[2]);
  if (has(condition, "aLhs.rows() == aRhs.rows()") && count == 4)
    return fmt::format("{} and {} cannot be combined entry by entry: the sizes {} and {} differ.",
                       sized(facts[0], facts[1]), sized(facts[2], facts[3]), shape(facts[0], facts[1]),
                       shape(facts[2], facts[3]));
  if (has(condition, "size() == other.size()") && count == 2)
    return fmt::format("dot() needs two vectors of the same size; these have {} and {}.", facts[0], facts[1]);
  if (has(condition, "rows==RowsAtCompileTime") && count == 4) {
    if (facts[0] < 0 || facts[1] < 0)
      return fmt::format("a matrix or vector cannot have the size {}.", shape(facts[0], facts[1]));
    return fmt::format("{} does not fit into the fixed size {}.", sized(facts[0], facts[1]),
                       shape(facts[2] < 0 ? facts[0] : facts[2], facts[3] < 0 ? facts[1] : facts[3]));
  }
  if (has(condition, "dst.rows() ==") && count == 4)
    return fmt::format("{} is put into, added to or taken from {}: the sizes {} and {} differ.",
                       sized(facts[2], facts[3]), sized(facts[0], facts[1]), shape(facts[2], facts[3]),
                       shape(facts[0], facts[1]));
  if (has(condition, "a_index <= m_matrix.cols()") && count == 3)
    return fmt::format("a {} matrix has no diagonal({}).", shape(facts[1], facts[2]), facts[0]);
  if (count == 5 && has(condition, "m_xpr")) return too_few_or_many(condition, facts);
  return "";
}

/// "vector", "array", "string" for "… std::vector<_Tp, _Alloc>::operator[](…) [with …]".
std::string container(const std::string& function) {
  const std::string name = function.substr(0, function.find("::operator[]"));
  for (const char* known : {"vector", "array", "basic_string", "span", "deque"})
    if (has(name, std::string(known) + "<")) return std::string(known) == "basic_string" ? "string" : known;
  return "container";
}

struct Domain {
  std::string_view function;
  const char* sentence;
};

constexpr Domain domains[] = {
    {"sqrt", "the root of a negative number is not a number (NaN)."},
    {"acos", "acos is only defined from −1 to 1: of a number beyond, even by rounding, it gives NaN."},
    {"asin", "asin is only defined from −1 to 1: of a number beyond, even by rounding, it gives NaN."},
    {"log", "the logarithm of 0 or of a negative number is infinite or not a number (NaN)."},
    {"log2", "the logarithm of 0 or of a negative number is infinite or not a number (NaN)."},
    {"log10", "the logarithm of 0 or of a negative number is infinite or not a number (NaN)."},
    {"pow",
     "pow has no finite result here: look at a negative base with a broken exponent, and at 0 to a negative "
     "one."},
    {"exp", "exp of so large a number is infinite."},
    {"acosh", "acosh of a number below 1 is not a number (NaN)."},
    {"atanh", "atanh is only defined between −1 and 1."},
    {"fmod", "the remainder of a division by zero is not a number (NaN)."},
    {"sin", "the sine of infinity is not a number (NaN)."},
    {"cos", "the cosine of infinity is not a number (NaN)."},
    {"tan", "the tangent of infinity is not a number (NaN)."},
};

/// The two numbers of "vector::_M_range_check: __n (which is 9) >= this->size() (which is 3)".
std::optional<std::pair<long, long>> range_check(const std::string& text) {
  constexpr std::string_view mark = "(which is ";
  const std::size_t first = text.find(mark);
  const std::size_t second = first == std::string::npos ? first : text.find(mark, first + 1);
  if (second == std::string::npos || !has(text, ">= ")) return std::nullopt;
  const auto number = [&](std::size_t at) -> std::optional<long> {
    long value = 0;
    const auto read = std::from_chars(text.data() + at + mark.size(), text.data() + text.size(), value);
    return read.ec == std::errc() ? std::optional(value) : std::nullopt;
  };
  const std::optional<long> index = number(first);
  const std::optional<long> size = number(second);
  if (!index || !size || *index < *size) return std::nullopt;
  return std::pair{*index, *size};
}

std::string signal_name(int signal) {
  switch (signal) {
    case SIGSEGV:
      return "segmentation fault";
    case SIGABRT:
      return "abort";
    case SIGFPE:
      return "arithmetic exception, such as a whole number divided by zero";
    case SIGILL:
      return "illegal instruction";
    case SIGBUS:
      return "bus error";
    case SIGKILL:
      return "killed";
    case SIGTRAP:
      return "trap";
    default:
      return "unexpected";
  }
}

/// A student's text inside a sentence: on one line, and not for ever.
std::string quoted(std::string text) {
  constexpr std::size_t longest = 120;
  for (char& character : text)
    if (static_cast<unsigned char>(character) < 0x20) character = ' ';
  if (text.size() > longest) {
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // not inside a character
    text = text.substr(0, end) + " …";
  }
  return "“" + text + "”";
}

}  // namespace

std::string eigen_stopped(const std::string& condition) {
  const std::string sentence = explained(condition);
  if (!sentence.empty()) return "Eigen stopped the calculation: " + sentence;
  return "Eigen stopped the calculation, because this does not hold: " + condition;
}

std::string crash(int signal, const std::string& text) {
  if (signal == SIGSEGV && text == stack_is_used_up())
    return "the stack is used up, by calls that never end or by a very large local array";
  const std::string name = fmt::format("signal {} ({})", signal, signal_name(signal));
  if (signal == SIGABRT && !text.empty()) return fmt::format("{}; nobody caught the exception {}", name, quoted(text));
  return name;
}

std::string after_crash(int signal, const std::string& text) {
  if (signal == SIGSEGV && text == stack_is_used_up())
    return "Give the recursion an end that every input reaches, or make the array a std::vector.";
  if (signal == SIGFPE) return "Look for a whole number that is divided by a variable which can be 0.";
  if (signal == SIGABRT && !text.empty())
    return "Look for an exception that leaves a destructor or a function marked noexcept.";
  return "Look for an index beyond the end, a reference to something that is gone, or a recursion without an end.";
}

std::string foreign_exception() { return "something that is not a std::exception"; }

std::string stack_is_used_up() { return "the stack is used up"; }

std::string system_call(Forbidden operation, const std::string& name) {
  const auto with = [&](const char* what) { return fmt::format("{} ({})", what, name); };
  switch (operation) {
    case Forbidden::file:
      return with("open a file");
    case Forbidden::process:
      return with("start a thread or another process");
    case Forbidden::program:
      return with("start another program");
    case Forbidden::network:
      return with("open a connection");
    case Forbidden::signal_others:
      return with("send a signal to another process");
    case Forbidden::spy:
      return with("look into another process");
    case Forbidden::change_files:
      return with("change files or folders");
  }
  return system_call(name);
}

std::string system_call(const std::string& name) { return fmt::format("make the system call {}", name); }
std::string system_call(long number) { return fmt::format("make system call number {}", number); }
std::string writing_a_file() { return "write a file"; }

std::string not_a_reply() { return "what came back is not a reply"; }
std::string reply_to_something_else() { return "a reply came that does not belong to the request"; }
std::string reply_too_early() { return "a reply came before its request was read"; }
std::string reply_of_impossible_shape() { return "a reply has an impossible shape"; }
std::string reply_of_unknown_status() { return "a reply has an unknown status"; }
std::string more_than_one_reply() { return "more came back than one reply"; }
std::string something_after_last_reply() { return "something came back after the last reply"; }
std::string line_closed() { return "the line to the checker was closed"; }

std::string at_no_line(std::string sentence) {
  if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z')
    sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
  return sentence;
}

std::string eigen_assertion(const std::string& condition, const std::vector<long>& facts) {
  if (const std::string exact = with_facts(condition, facts); !exact.empty()) return exact;
  if (const std::string sentence = explained(condition); !sentence.empty()) return sentence + ".";
  return fmt::format("here Eigen asks for something that does not hold: {}.", quoted(condition));
}

std::string library_assertion(const std::string& function, const std::string& condition,
                              const std::vector<long>& sides) {
  const bool is_index = has(function, "::operator[](");
  if (is_index && sides.size() == 2) return index_outside(sides[0], sides[1], container(function));
  if (has(condition, "empty()")) return "an empty container has no first or last element to give.";
  if (has(function, "optional")) return "an optional without a value is asked for its value.";
  if (is_index) return fmt::format("an index is outside its {}.", container(function));
  return fmt::format("a function of the standard library asks for something that does not hold: {}.",
                     quoted(condition));
}

std::string own_assertion(const std::string& condition) {
  return fmt::format("your assertion {} does not hold here.", quoted(condition));
}

std::string thrown(const std::string& text) {
  if (const auto numbers = range_check(text)) {
    const std::string owner = text.starts_with("vector") ? "vector" : text.starts_with("array") ? "array" : "container";
    return index_outside(numbers->first, numbers->second, owner);
  }
  return text.empty() ? "the exception is thrown here." : fmt::format("the exception {} is thrown here.", quoted(text));
}

std::string nobody_caught(const std::string& text) {
  const std::string what = text.empty() ? "an exception" : "the exception " + quoted(text);
  return what + " is thrown here and cannot be caught on its way out: it meets a destructor or noexcept.";
}

std::string whole_number_too_large(long left, const std::string& sign, long right, const std::string& type) {
  std::string name = type;
  std::erase(name, '\'');
  return fmt::format("{} {} {} does not fit into the type {}; calculate in double.", left, sign, right, name);
}

std::string division_by_whole_zero() { return "a whole number is divided by zero."; }

std::string shift(long number, long by) {
  return fmt::format("the bits of {} cannot be shifted by {}. (A power is written with std::pow.)", number, by);
}

std::string array_index(long index, const std::string& type) {
  const std::size_t open = type.find('[');
  long size = 0;
  if (open == std::string::npos ||
      std::from_chars(type.data() + open + 1, type.data() + type.size(), size).ec != std::errc())
    return fmt::format("index {} is outside its array.", index);
  return index_outside(index, size, "array");
}

std::string conversion_to_whole_number() {
  return "a number that no whole number of this type can hold (too large, infinite or NaN) is converted to one.";
}

std::string ends_without_return() { return "the function comes to its end here without a return."; }

std::string recursion_without_end() {
  return "the function calls itself here again and again, until the stack is used up.";
}
std::string stack_used_up() { return "the stack is used up here; a local array may be too large."; }
std::string null_pointer() { return "a pointer or reference to nothing is used here."; }
std::string foreign_memory() {
  return "memory is used here that does not belong to the function: an index beyond an end, or something that is gone.";
}
std::string damaged_memory() {
  return "here memory is found to be damaged: something before wrote beyond its end, or was given back twice.";
}
std::string aborted() { return "the program is aborted here."; }
std::string whole_number_division() {
  return "a division of whole numbers has no result here: by zero, or too large for its type.";
}
std::string trap_instruction() { return "the program stops here, at a place that must not be reached."; }

std::string non_finite(NonFinite reason, const std::string& function) {
  switch (reason) {
    case NonFinite::division_by_zero:
      return "a division by zero gives an infinite value here.";
    case NonFinite::zero_by_zero:
      return "0/0 is not a number (NaN): numerator and denominator are both zero here.";
    case NonFinite::undefined_division:
      return "a division whose result is not a number (NaN): 0/0, or infinity by infinity.";
    case NonFinite::root:
      return "the root of a negative number is not a number (NaN).";
    case NonFinite::too_large:
      return "a number becomes too large here and turns infinite.";
    case NonFinite::from_function:
      for (const Domain& domain : domains)
        if (domain.function == function) return domain.sentence;
      return "a function of <cmath> is given a number here for which it has no finite result.";
    case NonFinite::other:
      break;
  }
  return "the first value that is not a number (NaN) comes into being here.";
}

bool has_domain(const std::string& function) {
  return std::ranges::any_of(domains, [&](const Domain& domain) { return domain.function == function; });
}

std::string never_set_here() {
  return "something is used here that was never given a value: a variable, or an entry of a matrix or vector.";
}

std::string never_set() {
  return "the result depends on something that was never given a value: a variable without = or {}, or a matrix or "
         "vector that is not filled.";
}

std::string entries_never_set(const std::vector<std::string>& entries, std::size_t of) {
  if (entries.size() == of) return "the result is never given a value.";
  constexpr std::size_t most = 3;
  std::string names;
  for (std::size_t n = 0; n < std::min(entries.size(), most); ++n) names += (n == 0 ? "" : ", ") + entries[n];
  if (entries.size() > most)
    return fmt::format("{} and {} more of the result are never given a value.", names, entries.size() - most);
  return fmt::format("{} of the result {} never given a value.", names, entries.size() == 1 ? "is" : "are");
}

std::string still_at_work() { return "the function was still at work here when it was stopped."; }
std::string still_at_work_between(int first_line, int last_line) {
  return fmt::format("the function was still at work in lines {} to {} when it was stopped.", first_line, last_line);
}
std::string still_printing() { return "the function was still printing here when it was stopped."; }
std::string out_of_memory() { return "more memory is asked for here than an exercise may use."; }
std::string forbidden(const std::string& operation) { return fmt::format("here the function tries to {}.", operation); }
std::string program_ended() { return "the program is ended here, before the function returns."; }

}  // namespace workbook::messages
