#include "checker/explain/slips.hpp"

#include "checker/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace workbook {

namespace {

// Of each pattern $1 is what stands in ( ) or { }, with these, and $2 what is changed.
const std::string brackets = R"((?(DEFINE)([({](?:[^(){}]|(?1))*[)}])))";
#define ANY R"((?:[^(){},;]|(?1))+)"        // between commas
#define PART R"(\s*((?:[^(){},;]|(?1))+))"  // the same, as a group

/// What is written, and what was meant, with $2, $3, ... of the pattern.
struct Slip {
  const char* name = "";
  const char* pattern = "";
  const char* change = "";  ///< in the place of $2
  const char* sentence = "";
};

constexpr Slip slip_table[] = {
    {"negative_remainder", R"(((?:std\s*::\s*)?\bfmod)\s*\()",
     "[](double a, double b) { return a - b * std::floor(a / b); } ",
     "fmod keeps the sign of its first argument, so that the remainder of a negative number is negative."},
    {"second_name", R"((?:^|[;{}])\s*(?!const\b)[\w:]+\s*(&)\s*(\w+)\s*=\s*([A-Za-z]\w*))", "",
     "With &, `$3` is no copy but a second name of `$4`: what changes the one changes the other."},
    {"scalar_last", R"(\bQuaterniond(?:\s+\w+)?\s*\(()" PART "," PART "," PART "," PART R"()\))", "$6, $3, $4, $5",
     "Quaterniond takes w first: Quaterniond(w, x, y, z), although coeffs() holds x, y, z, w."},
    {"size_in_bytes", R"((sizeof\s*\(\s*(\w+)\s*\)\s*/\s*sizeof\s*(?1)))", "$3.size()",
     "sizeof counts the bytes of the object, not its entries: these are `$3.size()`."},
    {"columns_for_rows", R"(\bMap\s*<\s*(?:const\s+)?(Matrix3d))", "Eigen::Matrix<double, 3, 3, Eigen::RowMajor>",
     "Eigen reads a matrix column by column: numbers that stand side by side become columns."},
    {"columns_for_rows", R"(<<(?=\s*[A-Za-z])()" PART "," PART "," PART R"();)",
     "($3).transpose(), ($4).transpose(), ($5).transpose()",
     "With << these stand side by side, as columns: rows are a.transpose(), b.transpose(), ..."},
    {"copied_element", R"(\bfor\s*\([^;&()]*\w\s+(\w+)\s*:(?!:))", "&$2",
     "`$2` is a copy of each element, which the list does not notice: write & before `$2`."},
    {"copied_part",
     R"(\b((?:Vector|Matrix)[23X]d)\s+(\w+)\s*=\s*(\w+)\s*\.\s*(?:col|row|block|head|tail|segment|diagonal)\b)", "auto",
     "`$3` is a copy of a part of `$4`: what changes the one does not change the other. With auto, `$3` is this part "
     "itself."},
    {"one_too_far", R"(\bseq\s*\()" ANY "," PART R"(\))", "$2 - 1",
     "The end of seq(first, last) belongs to the sequence, unlike that of a slice in Python."},
    {"end_and_step", R"(\bintegrate_(?:adaptive|const)\s*\((?:)" ANY R"(,){4}()" PART "," PART R"()[,)])", "$4, $3",
     "After the start comes the end, and then the step: these two are exchanged."},
    {"other_method", R"(\.\s*(cwiseInverse)\s*\()", "inverse",
     "cwiseInverse() takes 1/x of each entry; the inverse matrix is A.inverse()."},
    {"other_method", R"(\.\s*(colwise)\s*\(\s*\)\s*\.)", "rowwise",
     "colwise() has a result for each column; that over all columns is rowwise()."},
};
#undef ANY
#undef PART

class Slips {
 public:
  Slips(const SourceText& source, const ExerciseReference& exercise) : source_(source) {
    for (Variant& each : one_token_variants(source, exercise)) of_variant(std::move(each));
    for (const Slip& slip : slip_table)
      for (const Match& read : search_all(source.text(), brackets + std::string(slip.pattern)))
        add(slip.name, read.fill(slip.sentence), source.place_of(read.offsets[2]),
            {{read.offsets[2], read[2].size(), read.fill(slip.change)}});
    for (std::size_t k = 2; k + 2 < source.tokens().size(); ++k) sum_that_goes_on(k);
    for (const Argument& argument : exercise.arguments)
      if (argument.kind == Kind::points)
        for (const auto& [method, what] : {std::pair{"size", "counts all entries"}, {"rows", "is 3"}})
          other_everywhere(
              "size_for_columns", method, "cols",
              fmt::format("`{0}.{1}()` {2}: the number of columns is `{0}.cols()`.", argument.name, method, what),
              argument.name);
    other_everywhere(
        "other_method", "resize", "conservativeResize",
        "resize() drops what a matrix holds: give it its size before the loop, or use conservativeResize().");
    sizes_for_ends();
    other_everywhere("rows_for_columns", "row", "col",
                     "Here, and wherever else row() stands, col() is right: rows are mixed up with columns.");
    other_everywhere("rows_for_columns", "col", "row",
                     "Here, and wherever else col() stands, row() is right: rows are mixed up with columns.");
  }

  std::vector<Reason> reasons;
  std::vector<Variant> variants;

 private:
  std::string_view token(std::size_t index) const {
    return index < source_.tokens().size() ? source_.tokens()[index].text : std::string_view();
  }
  bool is(std::size_t index, std::initializer_list<std::string_view> texts) const {
    return std::ranges::find(texts, token(index)) != texts.end();
  }
  Edit replaced(std::size_t first, std::size_t last, std::string text) const {
    const std::size_t begin = source_.tokens()[first].offset;
    return {begin, source_.tokens()[last].offset + token(last).size() - begin, std::move(text)};
  }

  void add(const char* name, const std::string& sentence, Place place, std::vector<Edit> edits,
           Fix fix = Fix::when_all_right) {
    reasons.push_back(source_.reason(place, name, sentence, Weight::cause, fix));
    variants.push_back({VariantKind::fix, name, place, std::move(edits)});
  }
  void add(const char* name, const std::string& sentence, std::size_t at, std::vector<Edit> edits) {
    add(name, sentence, source_.place_of(source_.tokens()[at].offset), std::move(edits));
  }

  void of_variant(Variant each) {
    const auto tell = [&](const char* name, const std::string& sentence, Fix fix = Fix::when_all_right) {
      add(name, sentence, each.place, std::move(each.edits), fix);
    };
    if (each.kind == VariantKind::division && each.words.empty())
      tell("integer_division",
           "Whole numbers are divided here, and what follows the decimal point is dropped: make one of them a double.",
           Fix::real_quotient);
    else if (each.kind == VariantKind::division)
      tell("divisor", "a / b * c is (a / b) * c: to divide by the product, write a / (b * c).");
    else if (each.words == brackets_before_method_words)
      tell("method_brackets",
           "A method belongs to what stands directly before its dot, and comes before * and +: put brackets around all "
           "that it is meant for.");
    else if (each.kind == VariantKind::overwritten && is_used_in_next_statement(each))
      tell("overwritten",
           "The line above has changed this variable, and here the value from before is needed: keep that in a "
           "variable of its own.");
  }

  /// x = c * x - s * y; y = s * x + c * y;
  bool is_used_in_next_statement(const Variant& variant) const {
    const std::size_t begin = variant.edits[0].offset, use = variant.edits[1].offset;
    const std::string_view between = source_.text().substr(begin, use - begin);
    const std::string_view name = source_.text().substr(use, variant.edits[1].length);
    return std::ranges::count(between, ';') == 1 && between.find(name, name.size()) < between.find(';');
  }

  /// double sum = 0; for (…) { for (…) sum += …; R(i, j) = sum; }
  void sum_that_goes_on(std::size_t at) {
    const std::string_view sum = token(at);
    if (token(at - 1) != "=" || token(at + 1) != ";" || !is(at - 2, {")", "]"})) return;
    const std::size_t body = source_.opening_around(at);
    const std::size_t head = body > 0 && token(body - 1) == ")" ? source_.partner_of(body - 1) : 0;
    if (token(body) != "{" || head == 0 || token(head - 1) != "for") return;
    bool is_added_to = false;
    for (std::size_t k = body; k < source_.partner_of(body); ++k) {
      if (token(k) == sum && is(k + 1, {"=", ".", "("})) return;  // it begins anew
      is_added_to = is_added_to || (token(k) == sum && is(k + 1, {"+=", "-="}));
    }
    if (is_added_to)
      add("sum_that_goes_on",
          fmt::format("`{}` still holds what the turns of this loop before have added: let it begin anew in each.",
                      sum),
          head - 1, {{source_.tokens()[body].offset + 1, 0, fmt::format(" {} *= 0;", sum)}});
  }

  /// v.segment(0, 1) for the components 0 and 1
  void sizes_for_ends() {
    std::vector<Edit> edits;
    std::size_t found = 0;
    for (std::size_t k = 1; k + 4 < source_.tokens().size(); ++k) {
      const std::optional<int> first = whole_number(k + 1), last = whole_number(k + 3);
      if (token(k - 1) != "segment" || token(k) != "(" || token(k + 4) != ")" || !first || !last || *last < *first)
        continue;
      if (edits.empty()) found = k - 1;
      edits.push_back(replaced(k + 3, k + 3, std::to_string(*last - *first + 1)));
    }
    if (!edits.empty())
      add("size_for_end", "The last number of segment() is a size, not an end: segment(first, how many).", found,
          edits);
  }
  std::optional<int> whole_number(std::size_t index) const {
    const std::string_view text = token(index);
    int number = 0;
    const bool is_whole =
        std::from_chars(text.data(), text.data() + text.size(), number).ptr == text.data() + text.size();
    return is_whole && !text.empty() ? std::optional(number) : std::nullopt;
  }

  /// Where it is exchanged wherever it is called, or called of one object.
  void other_everywhere(const char* name, std::string_view method, const char* other, const std::string& sentence,
                        std::string_view object = "") {
    std::vector<Edit> edits;
    std::size_t first = 0;
    for (std::size_t k = 2; k + 1 < source_.tokens().size(); ++k) {
      if (token(k) != method || token(k - 1) != "." || token(k + 1) != "(") continue;
      if (!object.empty() && token(k - 2) != object) continue;
      if (edits.empty()) first = k;
      edits.push_back(replaced(k, k, other));
    }
    if (!edits.empty()) add(name, sentence, first, edits);
  }

  const SourceText& source_;
};

}  // namespace

std::pair<std::vector<Reason>, std::vector<Variant>> slips_of_language(const SourceText& source,
                                                                       const ExerciseReference& exercise) {
  Slips slips(source, exercise);
  return {std::move(slips.reasons), std::move(slips.variants)};
}

}  // namespace workbook
