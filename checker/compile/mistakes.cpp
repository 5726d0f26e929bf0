#include "checker/compile/diagnostics.hpp"

#include "checker/base/text.hpp"

#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>

namespace workbook {
namespace {

constexpr std::size_t longest_for_patterns = 1500;
constexpr std::size_t most_warnings = 100;

/// With <number>, <matrix> and the like written out.
std::string whole_pattern(std::string pattern) {
  const std::string number = "(?:(?:long |unsigned |short )*(?:double|float|int|char|bool|long))";
  const std::string matrix = "(?:(?:Row)?(?:Vector|Matrix)\\w+|(?:[\\dn]+×[\\dn]+ )?(?:row vector|vector|matrix))";
  const std::string list = "(?:std::(?:vector|array)<|double(?: \\(&\\))? ?\\[|double\\*)[^']*";
  for (const auto& [kind, type] : {std::pair{"<number>", number}, std::pair{"<matrix>", "(" + matrix + ")"},
                                   std::pair{"<value>", "(" + number + "|" + matrix + ")"}, std::pair{"<list>", list},
                                   std::pair{"<type>", std::string("([^']*?)")}})
    boost::replace_all(pattern, kind, "'(?:const )?" + type + "&*'");
  return pattern;
}

/// Where else the file declares a name that is not known at a place; "" if nowhere.
std::string elsewhere(const SourceText& source, Place place, const std::string& name) {
  const std::vector<Token>& tokens = source.tokens();
  for (std::size_t k = 1; k + 1 < tokens.size(); ++k) {
    const int line = source.place_of(tokens[k].offset).line;
    const std::string around = fmt::format("{} {}", tokens[k - 1].text, tokens[k + 1].text);
    const bool is_parameter{search(tokens[k + 1].text, "^[,)]$")};
    if (tokens[k].text != name || line == place.line || (is_parameter && line > place.line)) continue;
    const std::size_t head = source.opening_around(k);
    if (head > 0 && tokens[head - 1].text == "for" && line < place.line &&
        tokens[source.partner_of(head) + 1].text != "{")
      return fmt::format("it belongs to the for of line {}, which has no braces, and so only one statement.", line);
    if (search(around, R"(^(?!return|else|case|throw|new|goto|and|or|not)[A-Za-z_]\w* [(=;,{)]$)"))
      return line > place.line
                 ? fmt::format("it is declared below, in line {}; move that up.", line)
                 : fmt::format("it was declared in line {}, in a block, loop or function that has ended.", line);
  }
  return "";
}

/// The { that is not closed before a line that is indented no further than its own, although its block begins further
/// in; and that line, 0 if there is none.
std::pair<std::size_t, int> unclosed_by_indentation(const SourceText& source) {
  const std::vector<Token>& tokens = source.tokens();
  std::vector<std::pair<std::size_t, int>> open;  // each { and the indentation of its line
  int indentation = 0;
  bool of_namespace = false;
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    const std::string_view text = tokens[k].text;
    const Place place = source.place_of(tokens[k].offset);
    const bool begins_line = k == 0 || source.place_of(tokens[k - 1].offset).line < place.line;
    const bool begins_statement = k > 0 && search(tokens[k - 1].text, "^[;{}]$");
    if (begins_line) indentation = place.column;
    if (begins_line && begins_statement && text != "}" && !tokens[k].in_directive && !open.empty() &&
        open.back().second >= indentation) {
      if (open.back().first + 1 != k) return {open.back().first, place.line};
      open.back().second = 0;  // its block is not indented
    }
    if (text == "namespace" || text == ";") of_namespace = text == "namespace";
    if (text == "{") open.emplace_back(k, of_namespace ? 0 : indentation);
    if (text == "{") of_namespace = false;
    if (text == "}" && !open.empty()) open.pop_back();
  }
  return {};
}

/// The statement at a place where it goes on in other lines, in one line and without comments; "" if it does not.
std::string long_statement(const SourceText& source, Place place) {
  constexpr std::ptrdiff_t most = 200;
  const std::vector<Token>& tokens = source.tokens();
  const auto is_end = [](const Token& token) { return token.text == ";" || token.text == "{" || token.text == "}"; };
  const auto at = std::ranges::lower_bound(tokens, source.offset_of(place), {}, &Token::offset);
  const auto first = std::find_if(std::make_reverse_iterator(at), tokens.rend(), is_end).base();
  std::string statement;
  int open = 0;
  for (auto token = first; token != tokens.end() && token - first < most; ++token) {
    open += token->text == "(" || token->text == "[" ? 1 : token->text == ")" || token->text == "]" ? -1 : 0;
    const bool is_apart = token != first && std::prev(token)->offset + std::prev(token)->text.size() < token->offset;
    statement += (is_apart ? " " : "") + std::string(token->is_literal() ? "\"\"" : token->text);
    if (token >= at && open <= 0 && is_end(*token))
      return source.place_of(token->offset).line == source.place_of(first->offset).line ? "" : statement;
  }
  return "";
}

/// The first mistake of the table that explains what was said.
std::optional<Reason> recognized(const std::vector<MessageMistake>& table, const Diagnostic& said, Place place,
                                 const SourceText& source, const std::string& signature) {
  const auto plain = [](std::string_view text) { return cut(in_plain_words(text), longest_for_patterns); };
  const std::string message = (said.is_error ? "" : said.option + ": ") + plain(said.text) + "\nin " +
                              said.header.substr(said.header.rfind('/') + 1) + "\n" + plain(said.notes) + "\n" +
                              plain(said.context) + "\nraw: " + cut(said.text, longest_for_patterns);
  const std::string marked_code = source.marked_code(place);
  const std::string readings[] = {marked_code, boost::erase_first_copy(marked_code, "@"),
                                  said.is_error ? long_statement(source, place) : ""};
  for (const MessageMistake& mistake : table) {
    const Match in_message = search(message, whole_pattern(mistake.message));
    if (!in_message) continue;
    Match in_code;
    for (const std::string& code : readings)
      if (!in_code) in_code = search(code, mistake.code);
    if (!in_code) continue;
    std::string sentence = mistake.sentence;
    const bool of_member = sentence.find("$member") != std::string::npos;
    const std::string wrong = (of_member ? ";." : ";") + in_message[1] + "=";
    const std::size_t at = spellings.find(wrong);
    if ((of_member || sentence.find("$right") != std::string::npos) && at == std::string_view::npos) continue;
    const std::string_view right = at == std::string_view::npos ? "" : spellings.substr(at + wrong.size());
    for (const char* word : {"$right", "$member"}) boost::replace_all(sentence, word, right.substr(0, right.find(';')));
    sentence = in_code.fill(in_message.fill(sentence), '%');
    // Compilers choose from all names of the system.
    const Match guess = search(sentence, R"(^There is no .*; did you mean `(\w+)`)");
    if (guess && spellings.find("=" + guess[1] + ";") == std::string_view::npos &&
        !search(signature, "\\b" + guess[1] + "\\b") &&
        std::ranges::find(source.tokens(), guess[1], &Token::text) == source.tokens().end())
      continue;
    boost::replace_all(sentence, "$contract", signature);
    if (sentence.ends_with("$elsewhere")) {
      const std::string there = elsewhere(source, place, in_message[1]);
      if (there.empty()) continue;
      boost::replace_all(sentence, "$elsewhere", there);
    }
    if (sentence.find("$unclosed") != std::string::npos) {
      const auto [brace, line] = unclosed_by_indentation(source);
      if (line == 0) continue;
      boost::replace_all(sentence, "$unclosed", std::to_string(line));
      place = source.place_of(source.tokens()[brace].offset);
    }
    return source.reason(place, mistake.name, sentence, mistake.weight, mistake.fix);
  }
  return std::nullopt;
}

/// What is missing before a token belongs after the one before it, which may stand on an earlier line.
Place place_to_show(const Diagnostic& error, const SourceText& source) {
  const auto next = std::ranges::lower_bound(source.tokens(), source.offset_of(error.place), {}, &Token::offset);
  const bool is_unfinished = next != source.tokens().begin() && search(std::prev(next)->text, "^[-+*/=(,]$");
  const bool noticed_late =
      is_unfinished || (error.text.find("before") != std::string::npos &&
                        (error.text.find(';') < 20 || error.text.starts_with("expected initializer")));
  if (!noticed_late || next == source.tokens().begin()) return error.place;
  const Place after = source.place_of((next - 1)->offset + (next - 1)->text.size());
  return after.line < error.place.line ? after : error.place;
}

/// What spoils a file wherever the compiler notices it.
std::optional<Reason> misplaced(const SourceText& source) {
  const std::vector<Token>& tokens = source.tokens();
  const auto text = [&](std::size_t k) { return k < tokens.size() ? tokens[k].text : std::string_view(";"); };
  const auto at = [&](std::size_t k, const char* name, const char* sentence) {
    return source.reason(source.place_of(tokens[k].offset), name, sentence);
  };
  std::vector<bool> are_types;  // of the open braces
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    if (tokens[k].in_directive) {
      if (text(k) == "#" && text(k + 1) == "include" && !are_types.empty())
        return at(k, "include_in_braces",
                  "This #include is inside braces: write it at the top of the file, before namespace rigid {.");
      const bool is_last = k + 1 == tokens.size() || !tokens[k + 1].in_directive || text(k + 1) == "#";
      if ((is_last && text(k) == ";") || (k >= 2 && text(k) == "=" && text(k - 2) == "define"))
        return at(k, "misused_macro",
                  "A #define has no ; at its end and no =: better write constexpr double NAME = 0.5;");
    } else if (text(k) == "{") {
      are_types.push_back(k >= 2 && search(text(k - 2), "^(struct|class)$"));
    } else if (text(k) == "}" && !are_types.empty()) {
      const bool is_declared = search(text(k + 1), "^[;*]$") || search(text(k + 2), R"(^[;,=\[{]$)");
      if (are_types.back() && !is_declared)
        return at(k, "missing_semicolon", "After the } that ends a struct or class stands a ;");
      are_types.pop_back();
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Reason> first_error(std::vector<Diagnostic> found, const SourceText& source,
                                  const std::string& signature) {
  for (Diagnostic& one : found) {  // clang does not say which token it met
    const auto met = std::ranges::lower_bound(source.tokens(), source.offset_of(one.place), {}, &Token::offset);
    const bool is_end = met == source.tokens().end();
    boost::replace_all(one.text, "before @token",
                       is_end ? "at end of input" : fmt::format("before '{}' token", met->text));
    if (!is_end) boost::replace_all(one.text, "@sign", met->text);
  }
  const auto is_placed_error = [](const Diagnostic& one) { return one.is_error && one.place.line > 0; };
  auto first = std::ranges::find_if(found, is_placed_error);
  if (first == found.end()) first = std::ranges::find_if(found, &Diagnostic::is_error);
  if (first == found.end()) return std::nullopt;
  if (std::optional<Reason> reason = misplaced(source)) return reason;
  // What Eigen asserts says more than what follows from it, unless it follows from the spelling itself; and a name that
  // is not known says more than what clang misses behind it.
  std::vector<const char*> kinds = {"^stray", first->text.starts_with("expected") ? "^stray" : "^static assertion", ""};
  if (first->text.starts_with("expected ';'")) kinds.insert(kinds.end() - 1, "was not declared");
  for (const char* kind : kinds)
    for (auto next = first; next != found.end(); ++next)
      if (is_placed_error(*next) && next->place.line == first->place.line && search(next->text, kind))
        if (auto finding = recognized(error_table, *next, place_to_show(*next, source), source, signature))
          return finding;
  constexpr std::size_t longest = 300;
  const std::string text = in_plain_words(first->text);
  return source.reason(first->place, "compiler_error",
                       "The compiler says: " + cut(text, longest) + (text.size() > longest ? " …" : "."));
}

std::vector<Reason> warned_mistakes(const std::vector<Diagnostic>& found, const SourceText& source) {
  std::vector<Reason> mistakes;
  for (std::size_t i = 0; i < std::min(found.size(), most_warnings); ++i)
    if (!found[i].is_error && found[i].header.empty() && found[i].place.line > 0)
      if (std::optional<Reason> finding = recognized(warning_table, found[i], found[i].place, source, ""))
        if (!finding->name.empty()) mistakes.push_back(std::move(*finding));
  return mistakes;
}

}  // namespace workbook
