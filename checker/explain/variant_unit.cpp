// All variants of a file in one translation unit.
#include "checker/explain/variants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace workbook {

namespace {

/// What a switched slip is made of. A number of another variant leaves every value bit by bit as the file has it. How
/// often it is asked for measures the work of a call, on every machine in the same way.
constexpr const char* switches = R"(
extern "C" int workbook_variant;
inline long workbook_work = 0;  // what is left of it
inline bool workbook_is(int variant) {
  if (--workbook_work < 0) throw 0;
  return variant >= 0 && ((workbook_variant & 4095) == variant || (workbook_variant >> 12) == variant + 1);
}
inline bool workbook_is_among(int first, int last) {
  if (--workbook_work < 0) throw 0;
  const int one = workbook_variant & 4095, other = (workbook_variant >> 12) - 1;
  return (one >= first && one <= last) || (other >= first && other <= last);
}
inline bool workbook_reached() { throw 0; }
inline bool workbook_condition(int thrown, int never, int always, int opposite, bool is_so) {
  if (workbook_is(opposite)) is_so = !is_so;
  return workbook_is(never) ? false : workbook_is(always) ? true : is_so && workbook_is(thrown) ? workbook_reached() : is_so;
}
template <class T> auto workbook_value(const T& value) {
  if constexpr (std::is_base_of_v<Eigen::MatrixBase<T>, T>)
    return Eigen::Matrix<typename T::Scalar, T::RowsAtCompileTime, T::ColsAtCompileTime>(value);
  else if constexpr (requires { value.eval(); }) return typename T::PlainObject(value);
  else return value;
}
template <class T> const T& workbook_itself(const T& value) { return value; }
template <class T> double workbook_number(const T& x) {
  if constexpr (std::is_floating_point_v<T>) return static_cast<double>(x);
  else return 1;
}
struct WorkbookTimes {
  double factor;
  WorkbookTimes operator-() const { return {-factor}; }
  WorkbookTimes operator+() const { return *this; }
};
template <class T> auto operator*(WorkbookTimes times, const T& x);
// 0: as it is, 1: one over it, 2: its square, 3: its root, 4: its absolute value, 5: 1 minus it, 6: its transpose, 7: its unit vector,
// 8: √(1 − x²)
struct WorkbookChange { int number; };
template <class T> decltype(auto) operator->*(WorkbookChange change, const T& x) {
  if constexpr (std::is_floating_point_v<T>) {
    const T others[] = {x, 1 / x, x * x, std::sqrt(x), std::abs(x), 1 - x, x, x, std::sqrt(1 - x * x)};
    return T(others[change.number]);
  } else if constexpr (requires { requires std::is_base_of_v<Eigen::MatrixBase<T>, T>; requires T::SizeAtCompileTime > 1; requires std::is_same_v<typename T::Scalar, double>; }) {
    typename T::PlainObject value = x;
    if constexpr (T::RowsAtCompileTime == T::ColsAtCompileTime) { if (change.number == 6) value.transposeInPlace(); }
    if constexpr (T::IsVectorAtCompileTime) { if (change.number == 7) value.normalize(); }
    return value;
  } else return workbook_itself(x);
}
struct WorkbookNegative { WorkbookChange change; };
inline WorkbookNegative operator-(WorkbookChange change) { return {change}; }
template <class T> auto operator->*(WorkbookNegative negative, const T& x) {
  return WorkbookTimes{-1.0} * (negative.change ->* x);
}
// What is added to a number or to a vector.
struct WorkbookTerm {
  double number = 0;
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  int kind = 0;
  WorkbookTerm() = default;
  template <class T> explicit WorkbookTerm(const T& x) {
    if constexpr (std::is_floating_point_v<T>) { number = x; kind = 1; }
    else if constexpr (std::is_same_v<T, Eigen::Vector3d>) { vector = x; kind = 3; }
  }
  WorkbookTerm operator-() const { WorkbookTerm other = *this; other.number *= -1; other.vector *= -1; return other; }
};
template <class T> decltype(auto) operator+(WorkbookTerm term, const T& x) {
  if constexpr (std::is_floating_point_v<T>) return T(term.kind == 1 ? x + static_cast<T>(term.number) : x);
  else if constexpr (requires { requires std::is_base_of_v<Eigen::MatrixBase<T>, T>; requires std::is_same_v<typename T::PlainObject, Eigen::Vector3d>; })
    return Eigen::Vector3d(term.kind == 3 ? Eigen::Vector3d(x + term.vector) : Eigen::Vector3d(x));
  else return workbook_itself(x);
}
template <class T> auto operator*(WorkbookTimes times, const T& x) {
  if constexpr (requires { typename T::DiagonalVectorType; }) {
    typename T::PlainObject value = x;
    value.diagonal() *= times.factor;
    return value;
  } else if constexpr (requires { typename T::PlainObject; }) {
    typename T::PlainObject value = x;
    value *= static_cast<typename T::Scalar>(times.factor);
    return value;
  } else if constexpr (requires { x.coeffs() *= times.factor; }) {  // a quaternion
    T value = x;
    value.coeffs() *= times.factor;
    return value;
  } else if constexpr (requires { static_cast<T>(times.factor * x); }) {
    return static_cast<T>(times.factor * x);
  } else {
    return workbook_itself(x);
  }
}
// A matrix before a vector or another matrix.
struct WorkbookMatrix {
  bool is_so = false;
  Eigen::Matrix3d matrix = {};
  double factor = 1;
};
inline WorkbookMatrix operator*(WorkbookTimes times, WorkbookMatrix matrix) {
  matrix.factor *= times.factor;
  return matrix;
}
template <class T> decltype(auto) operator*(const WorkbookMatrix& matrix, const T& x) {
  if constexpr (requires { requires std::is_base_of_v<Eigen::MatrixBase<T>, T>; requires T::RowsAtCompileTime == 3; requires std::is_same_v<typename T::Scalar, double>; }) {
    typename T::PlainObject value = matrix.factor * x;
    if (matrix.is_so) value = matrix.matrix * value;
    return value;
  } else return WorkbookTimes{matrix.factor} * x;
}
)";

enum class Form { times, change, whole, term, matrix, step, value, call, method, condition, copy };

/// In the order of VariantKind, up to those that need a copy.
constexpr struct {
  const char* name;
  Form form;
} switched_kinds[] = {{"sign", Form::times},          {"factor", Form::times},
                      {"factor", Form::change},       {"power", Form::change},
                      {"power", Form::whole},         {"term", Form::term},
                      {"factor", Form::matrix},       {"factor", Form::times},
                      {"number", Form::value},        {"index", Form::value},
                      {"name", Form::value},          {"function", Form::call},
                      {"method", Form::method},       {"loop", Form::step},
                      {"guard", Form::value},         {"brackets", Form::copy},
                      {"overwritten", Form::copy},    {"assignment", Form::copy},
                      {"branch", Form::condition},    {"branch_off", Form::condition},
                      {"branch_on", Form::condition}, {"condition", Form::condition}};

Form form_of(const Variant& variant) {
  const auto number = static_cast<std::size_t>(variant.kind);
  return variant.edits.empty() || number >= std::size(switched_kinds) ? Form::copy : switched_kinds[number].form;
}

bool holds(const Edit& line, const Edit& edit) {
  return line.offset <= edit.offset && edit.offset + edit.length <= line.offset + line.length;
}

/// The macros that `edits` change, as they are before a copy and as they are again behind it.
std::pair<std::string, std::string> edited_macros(std::string_view text, const std::vector<Edit>& lines,
                                                  const std::vector<Edit>& edits) {
  std::pair<std::string, std::string> macros;
  for (const Edit& line : lines) {
    std::vector<Edit> here;
    for (Edit edit : edits)
      if (holds(line, edit)) {
        edit.offset -= line.offset;
        here.push_back(std::move(edit));
      }
    const std::string_view written = text.substr(line.offset, line.length);
    const Match defined = search(written, R"(^[ \t]*#[ \t]*define[ \t]+(\w+))");
    if (here.empty() || !defined) continue;
    const std::string forget = fmt::format("#undef {}\n", defined[1]);
    macros.first += fmt::format("{}{}\n", forget, edited(written, here));
    macros.second += fmt::format("{}{}\n", forget, written);
  }
  return macros;
}

}  // namespace

std::string to_string(VariantKind kind) { return switched_kinds[static_cast<std::size_t>(kind)].name; }

/// Text in place of some of the file's, in parts that stand on lines of their own where they belong to variants.
struct VariantUnit::Piece {
  std::size_t offset = 0, length = 0;
  int order = 0;  ///< of what stands at one place
  std::size_t end = 0;
  std::vector<std::pair<std::string, std::set<std::size_t>>> parts = {};
};

std::vector<VariantUnit::Piece> VariantUnit::pieces_of(const SourceText& source,
                                                       const std::vector<Variant>& variants) const {
  struct SamePlace {
    std::vector<std::pair<std::size_t, const Edit*>> edits = {};
    std::set<std::size_t> all = {};
  };
  const std::string_view text = source.text();
  std::map<std::tuple<Form, std::size_t, std::size_t>, SamePlace> groups;
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const Form form = form_of(variants[k]);
    if (form == Form::copy) continue;
    for (const Edit& edit : variants[k].edits) {
      std::size_t offset = edit.offset, end = edit.offset + edit.length;
      if (form == Form::times || form == Form::change || form == Form::term || form == Form::matrix) offset = end;
      // With its std::, which belongs to the function.
      if (form == Form::call && text.substr(0, offset).ends_with("std::")) offset -= 5;
      SamePlace& group = groups[{form, offset, end}];
      group.edits.emplace_back(k, &edit);
      group.all.insert(k);
    }
  }
  std::vector<Piece> pieces;
  for (const auto& [key, of_key] : groups) {
    const SamePlace& group = of_key;  // clang 14 lets no lambda capture a name of a structured binding
    const auto [form, begin, end] = key;
    const std::size_t offset = begin;
    const std::string original(text.substr(offset, end - offset));
    const auto number_of = [&](VariantKind kind) {
      const auto found =
          std::ranges::find_if(group.edits, [&](const auto& each) { return variants[each.first].kind == kind; });
      return found == group.edits.end() ? -1 : static_cast<int>(found->first);
    };
    Piece piece{offset, end - offset, 5, end, {}};
    // Mostly none of them is asked for.
    const auto none = fmt::format("!workbook_is_among({}, {}) ? ", *group.all.begin(), *group.all.rbegin());
    const auto choose = [&](const std::string& before, const auto& words_of, const std::string& otherwise,
                            const char* behind) {
      piece.parts.emplace_back(before, std::set<std::size_t>{});
      piece.parts.emplace_back(none + otherwise + " :", group.all);
      for (const auto& [k, edit] : group.edits)
        piece.parts.emplace_back(fmt::format("workbook_is({}) ? {} :", k, words_of(*edit)), std::set{k});
      piece.parts.emplace_back(otherwise + behind, group.all);
    };
    const auto choose_number = [&](const auto& number_of_edit, const char* otherwise) {
      std::string chain = fmt::format("{}{} : ", none, otherwise);
      for (const auto& [k, edit] : group.edits)
        chain += fmt::format("workbook_is({}) ? {} : ", k, number_of_edit(k, *edit));
      return chain + otherwise;
    };
    switch (form) {
      case Form::times: {
        const auto factor = [&](std::size_t k, const Edit& edit) {
          return variants[k].kind == VariantKind::sign ? "-1.0"
                                                       : edit.replacement.substr(0, edit.replacement.rfind('*'));
        };
        piece.order = 1;
        piece.parts = {{fmt::format(" WorkbookTimes{{{}}} * ", choose_number(factor, "1.0")), group.all}};
        break;
      }
      case Form::change:
      case Form::whole: {
        const bool is_whole = form == Form::whole;
        if (is_whole) pieces.push_back({end, 0, -1, 0, {{")", {}}}});
        piece = {offset, 0, is_whole ? -1 : 3, end, {}};
        const auto number = choose_number([](std::size_t, const Edit& edit) { return edit.replacement; }, "0");
        piece.parts = {{fmt::format(" WorkbookChange{{{}}} ->* {}", number, is_whole ? "(" : ""), group.all}};
        break;
      }
      case Form::term:
        choose(
            " (", [](const Edit& edit) { return edit.replacement; }, "WorkbookTerm()", ") + ");
        piece.order = 0;
        break;
      case Form::matrix:
        choose(
            " (", [](const Edit& edit) { return edit.replacement; }, "WorkbookMatrix()", ") * ");
        piece.order = 2;
        break;
      case Form::step:
        piece.order = 0;
        piece.parts = {{fmt::format(" ({}) + ",
                                    choose_number([](std::size_t, const Edit& edit) { return edit.replacement; }, "0")),
                        group.all}};
        break;
      case Form::value:
        choose(
            "(", [](const Edit& edit) { return edit.replacement; }, original, ")");
        break;
      case Form::call: {
        const bool has_prefix = original.starts_with("std::");
        choose(
            "[](const auto&... x) { return ",
            [&](const Edit& edit) {
              const bool is_whole = edit.replacement.empty() || edit.replacement.starts_with("std::") ||
                                    edit.replacement.starts_with("[") || edit.offset == offset;
              return fmt::format("{}{}(x...)", is_whole || !has_prefix ? "" : "std::",
                                 edit.replacement.empty() ? "workbook_itself" : edit.replacement);
            },
            original + "(x...)", "; }");
        break;
      }
      case Form::method: {
        Piece head{group.edits.front().second->operand, 0, 4, end, {}};
        std::swap(head.parts, piece.parts);
        choose(
            "[](const auto& value, const auto&... x) { return ",
            [](const Edit& edit) {
              const std::string method = edit.replacement.substr(0, edit.replacement.find('('));
              return fmt::format("workbook_value(value{})", method.empty() ? "" : method + "(x...)");
            },
            fmt::format("workbook_value(value{}(x...))", original.substr(0, original.find('('))), "; }(");
        std::swap(head.parts, piece.parts);
        piece.parts = {{original.ends_with(')') ? ")" : ", ", {}}};
        pieces.push_back(std::move(head));
        break;
      }
      case Form::condition:
        pieces.push_back({offset,
                          0,
                          4,
                          end,
                          {{fmt::format("workbook_condition({}, {}, {}, {}, static_cast<bool>(",
                                        number_of(VariantKind::branch), number_of(VariantKind::branch_off),
                                        number_of(VariantKind::branch_on), number_of(VariantKind::branch_opposite)),
                            group.all}}});
        piece = {end, 0, -1, end - offset, {{"))", {}}}};
        break;
      case Form::copy:
        break;
    }
    pieces.push_back(std::move(piece));
  }
  // What is switched is no constant expression; most constants need not be one.
  const std::vector<Token>& tokens = source.tokens();
  for (std::size_t k = 1; k < tokens.size(); ++k)
    if (tokens[k].text == "constexpr" && !tokens[k].in_directive && tokens[k - 1].text != "if")
      pieces.push_back({tokens[k].offset, tokens[k].text.size(), 5, 0, {{"const", {}}}});
  std::ranges::sort(pieces, [](const Piece& one, const Piece& other) {
    return std::tuple(one.offset, one.order, -static_cast<long>(one.end)) <
           std::tuple(other.offset, other.order, -static_cast<long>(other.end));
  });
  return pieces;
}

void VariantUnit::append(std::string_view text, const std::set<std::size_t>& variants) {
  const auto begin_line = [&](const std::set<std::size_t>& of) {
    text_ += '\n';
    variants_at_[++line_] = of;
  };
  if (!variants.empty()) begin_line(variants);
  text_ += text;
  line_ += static_cast<int>(std::ranges::count(text, '\n'));
  if (!variants.empty()) begin_line({});
}

VariantUnit::VariantUnit(const SourceText& source, const std::vector<Variant>& variants,
                         const ExerciseReference& exercise) {
  // Lines of the preprocessor stand once, before all copies: headers must not be read inside a namespace.
  const std::string_view text = source.text();
  std::vector<Edit> without_directives;
  std::size_t at = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  if (at > 0) without_directives.push_back({0, at, ""});
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::size_t first = text.find_first_not_of(" \t", at);
    if (first < end && text[first] == '#') {
      append(std::string(text.substr(at, end - at)) + "\n");
      without_directives.push_back({at, end - at, ""});
    }
    at = end + 1;
  }
  append(switches);
  std::string table, names;
  const auto begin_copy = [&](const std::string& name) {
    append(
        fmt::format("namespace {} {{ namespace rigid {{ using namespace ::rigid; {}; }}\n", name, exercise.signature));
  };
  std::vector<Piece> pieces = pieces_of(source, variants);
  for (const Edit& edit : without_directives) pieces.push_back({edit.offset, edit.length, -2, 0, {}});
  std::ranges::stable_sort(pieces, {}, &Piece::offset);
  begin_copy("switched");
  std::size_t done = 0;
  for (const Piece& piece : pieces) {
    append(text.substr(done, piece.offset - done));
    for (const auto& [part, of] : piece.parts) append(part, of);
    done = piece.offset + piece.length;
  }
  append(text.substr(done));
  append("\n}\n");
  for (std::size_t k = 0; k <= variants.size(); ++k) {
    std::string name = "switched";
    if (k < variants.size() && form_of(variants[k]) == Form::copy) {
      const auto [macros, undone] = edited_macros(text, without_directives, variants[k].edits);
      std::vector<Edit> edits = without_directives;
      std::ranges::copy_if(variants[k].edits, std::back_inserter(edits), [&](const Edit& edit) {
        return std::ranges::none_of(without_directives, [&](const Edit& line) { return holds(line, edit); });
      });
      name = fmt::format("variant_{}", k);
      begin_copy(name);
      append(macros + edited(text, edits), {k});
      append("}\n" + undone);
    }
    table += fmt::format("{}&{}::rigid::{}", table.empty() ? "" : ", ", name, exercise.name);
  }
  for (const Argument& argument : exercise.arguments) names += (names.empty() ? "" : ", ") + argument.name;
  append(
      fmt::format("namespace rigid {{\n{} {{\n  static constexpr decltype(&::rigid::{}) variants[] = {{{}}};\n"
                  "  workbook_work = workbook_variant >> 12 < {} ? {} : 1L << ((workbook_variant >> 12) - {});\n"
                  "  return variants[workbook_variant & 4095]({});\n}}\n}}\n",
                  exercise.signature, exercise.name, table, first_limit, most_work, first_limit, names));
}

std::set<std::size_t> VariantUnit::variants_at(int line) const {
  // What is wrong with a part may be said of what follows it.
  for (auto at = variants_at_.upper_bound(line); at != variants_at_.begin();)
    if (--at; !at->second.empty()) return at->second;
  return {};
}

}  // namespace workbook
