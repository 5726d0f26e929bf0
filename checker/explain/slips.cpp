#include "checker/explain/slips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

namespace workbook {

namespace {

class Slips {
 public:
  Slips(const SourceText& source, const ExerciseReference& exercise) : source_(source) {
    for (Variant& each : one_token_variants(source, exercise)) of_variant(std::move(each));
    for (at_ = 1; at_ + 2 < source.tokens().size(); ++at_) {
      if (source.tokens()[at_].in_directive) continue;
      sum_that_goes_on();
      remainder();
      second_name();
      quaternion();
      other_method("cwiseInverse", "inverse",
                   "cwiseInverse() takes 1/x of each entry; the inverse matrix is A.inverse().");
      if (token(at_ + 2) == ")" && token(at_ + 3) == ".")
        other_method("colwise", "rowwise",
                     "colwise() has a result for each column; that over all columns is rowwise().");
    }
    for (const Argument& argument : exercise.arguments)
      if (argument.kind == Kind::points)
        other_everywhere(
            "size_for_columns", "size", "cols",
            fmt::format("`{0}.size()` counts all entries: the number of columns is `{0}.cols()`.", argument.name),
            argument.name);
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
  void sum_that_goes_on() {
    const std::string_view sum = token(at_);
    if (token(at_ - 1) != "=" || token(at_ + 1) != ";" || !is(at_ - 2, {")", "]"})) return;
    const std::size_t body = source_.opening_around(at_);
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

  void remainder() {
    if (token(at_) == "fmod" && token(at_ + 1) == "(")
      add("negative_remainder",
          "fmod keeps the sign of its first argument, so that the remainder of a negative number is negative.", at_,
          {replaced(token(at_ - 1) == "::" ? at_ - 2 : at_, at_,
                    "[](double a, double b) { return a - b * std::floor(a / b); } ")});
  }

  /// Vector3d& w = v; w[2] = 0;
  void second_name() {
    if (token(at_) == "&" && token(at_ + 2) == "=" && is_name(at_ - 1) && is_name(at_ + 1) && is_name(at_ + 3) &&
        token(at_ - 2) != "const")
      add("second_name",
          fmt::format("With &, `{}` is no copy but a second name of `{}`: what changes the one changes the other.",
                      token(at_ + 1), token(at_ + 3)),
          at_, {replaced(at_, at_, "")});
  }

  /// Quaterniond(x, y, z, w)
  void quaternion() {
    if (token(at_) != "Quaterniond") return;
    const std::size_t open = is_name(at_ + 1) ? at_ + 2 : at_ + 1;
    if (token(open) != "(") return;
    std::vector<std::size_t> commas;
    for (std::size_t k = open + 1; k < source_.partner_of(open); ++k)
      if (token(k) == "," && source_.opening_around(k) == open) commas.push_back(k);
    if (commas.size() != 3) return;
    const std::size_t first = source_.tokens()[open].offset + 1, last = source_.tokens()[commas[2]].offset,
                      end = source_.tokens()[source_.partner_of(open)].offset;
    const std::string_view text = source_.text();
    add("scalar_last", "Quaterniond takes w first: Quaterniond(w, x, y, z), although coeffs() holds x, y, z, w.", at_,
        {{first, end - first,
          fmt::format("{}, {}", text.substr(last + 1, end - last - 1), text.substr(first, last - first))}});
  }

  void other_method(std::string_view method, const char* other, const char* sentence) {
    if (token(at_) == method && token(at_ - 1) == "." && token(at_ + 1) == "(")
      add("other_method", sentence, at_, {replaced(at_, at_, other)});
  }

  bool is_name(std::size_t index) const {
    const std::string_view text = token(index);
    return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0;
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
  std::size_t at_ = 0;
};

}  // namespace

std::pair<std::vector<Reason>, std::vector<Variant>> slips_of_language(const SourceText& source,
                                                                       const ExerciseReference& exercise) {
  Slips slips(source, exercise);
  return {std::move(slips.reasons), std::move(slips.variants)};
}

}  // namespace workbook
