// What is changed in a file where a mistake in its code is fixed.
#include "checker/base/text.hpp"
#include "checker/explain/variants.hpp"

#include <algorithm>

namespace workbook {

namespace {

/// The first token on that line with this text, at or after the column.
const Token* token_at(const SourceText& source, const Reason& finding, std::string_view text) {
  for (const Token& token : source.tokens()) {
    const Place place = source.place_of(token.offset);
    if (place.line == finding.line && place.column + static_cast<int>(token.text.size()) > finding.column &&
        token.text == text)
      return &token;
  }
  return nullptr;
}

/// The type of the variable that is set on that line, as double; abs of the C library as that of C++.
std::vector<Edit> wider_type(const SourceText& source, const Reason& finding) {
  const std::vector<Token>& tokens = source.tokens();
  const auto is_narrow = [](std::string_view text) { return is_one_of(text, {"int", "float", "long", "unsigned"}); };
  const auto as_double = [](const Token& type) { return std::vector<Edit>{{type.offset, type.text.size(), "double"}}; };
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    if (source.place_of(tokens[k].offset).line != finding.line) continue;
    const bool is_called = k + 1 < tokens.size() && tokens[k + 1].text == "(" && k > 0;
    if (tokens[k].text == "abs" && is_called && tokens[k - 1].text != "::") return {{tokens[k].offset, 0, "std::"}};
    if (finding.fix == Fix::as_double && is_narrow(tokens[k].text)) return as_double(tokens[k]);
    if (k == 0 || !is_one_of(tokens[k].text, {"=", "+=", "-=", "*=", "/="})) continue;
    // Where is what stands to the left declared?
    for (std::size_t d = k; d-- > 1;) {
      if (tokens[d].text != tokens[k - 1].text) continue;
      std::size_t type = d - 1;
      const auto is_whole = [&](std::size_t at) { return is_narrow(tokens[at].text) || tokens[at].text == "auto"; };
      while (type > 0 && !is_one_of(tokens[type].text, {";", "{", "}", "("}) && !is_whole(type)) --type;
      const bool is_loop_variable = type >= 2 && tokens[type - 1].text == "(" && tokens[type - 2].text == "for";
      if (is_whole(type) && !is_loop_variable) return as_double(tokens[type]);
    }
  }
  return {};
}

/// What a function or lambda returns whose result is `auto`, as values; nothing for a variable.
std::vector<Edit> returned_values(const SourceText& source, const Token& word) {
  const std::vector<Token>& tokens = source.tokens();
  auto open = static_cast<std::size_t>(&word - tokens.data());
  while (open < tokens.size() && !is_one_of(tokens[open].text, {"{", ";"})) ++open;
  std::vector<Edit> edits;
  if (open >= tokens.size() || tokens[open].text == ";") return edits;
  for (std::size_t k = open; k < std::min(source.partner_of(open), tokens.size()); ++k)
    if (tokens[k].text == "return")
      if (const std::size_t end = source.text().find(';', tokens[k].offset); end != std::string_view::npos) {
        edits.push_back({tokens[k].offset + tokens[k].text.size(), 0, " workbook_value("});
        edits.push_back({end, 0, ")"});
      }
  return edits;
}

/// `1 / 2` as `1.0 / 2`, `0,5` as `0.5`, `3.14` as π, `int` and `float` as `double`, `auto x = a;` as a value.
std::vector<Edit> edits_of(const SourceText& source, const Reason& mistake) {
  const auto in_place_of = [&](std::string_view text, const char* replacement) -> std::vector<Edit> {
    const Token* token = token_at(source, mistake, text);
    if (token == nullptr) return {};
    return {{token->offset, token->text.size(), replacement}};
  };
  switch (mistake.fix) {
    case Fix::none:
    case Fix::when_all_right:
      return {};
    case Fix::real_quotient:
      return in_place_of("/", "* 1.0 /");
    case Fix::decimal_point:
      return in_place_of(",", ".");
    case Fix::by_reference:
      return {{source.offset_of({mistake.line, mistake.column}), 0, "& "}};
    case Fix::compound: {
      const Token* sign = token_at(source, mistake, "=");
      if (sign == nullptr) return {};
      return {{sign->offset, 2, std::string(source.text().substr(sign->offset + 1, 1)) + "="}};
    }
    case Fix::not_static:
      return in_place_of("static", "");
    case Fix::as_double:
    case Fix::wider_type:
      return wider_type(source, mistake);
    case Fix::exact_pi:
      for (const Token& token : source.tokens())
        if (token.offset == source.offset_of({mistake.line, mistake.column}))
          return {{token.offset, token.text.size(), "3.14159265358979323846"}};
      return {};
    case Fix::no_noalias: {
      const Token* word = token_at(source, mistake, "noalias");
      const std::size_t end = word == nullptr ? std::string_view::npos : source.text().find(')', word->offset);
      if (end == std::string_view::npos || word->offset == 0) return {};
      return {{word->offset - 1, end + 1 - (word->offset - 1), ""}};
    }
    case Fix::as_value: {
      const Token* word = token_at(source, {.line = mistake.line}, "auto");
      if (word == nullptr) return {};
      if (std::vector<Edit> of_returns = returned_values(source, *word); !of_returns.empty()) return of_returns;
      const std::size_t equals = source.text().find('=', word->offset), end = source.text().find(';', word->offset);
      if (equals == std::string_view::npos || end == std::string_view::npos || equals > end) return {};
      return {{equals + 1, 0, " workbook_value("}, {end, 0, ")"}};
    }
  }
  return {};
}

}  // namespace

std::vector<Variant> fixed_variants(const SourceText& source, const std::vector<Reason>& findings) {
  std::vector<Variant> variants;
  for (const Reason& finding : findings) {
    std::vector<Edit> fix = edits_of(source, finding);
    if (!fix.empty())
      variants.push_back({VariantKind::fix, finding.name, {finding.line, finding.column}, std::move(fix)});
  }
  if (variants.size() < 2) return variants;
  Variant all{VariantKind::all_fixes, "", {}, {}};
  for (const Variant& each : variants)
    for (const Edit& edit : each.edits)
      if (std::ranges::find(all.edits, edit.offset, &Edit::offset) == all.edits.end()) all.edits.push_back(edit);
  variants.push_back(std::move(all));
  return variants;
}

}  // namespace workbook
