#include "checker/base/text.hpp"

#include <sodium.h>
#include <boost/algorithm/string/replace.hpp>
#include <boost/locale/utf.hpp>
#include <boost/regex.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace workbook {

namespace {

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

/// Control characters could drive the terminal; bidirectional ones could show a text in another order than it has.
bool is_unsafe(boost::locale::utf::code_point point) {
  const bool is_control = (point < 0x20 && point != '\n' && point != '\t') || (point >= 0x7f && point < 0xa0);
  const bool is_bidirectional = (point >= 0x202a && point <= 0x202e) || (point >= 0x2066 && point <= 0x2069) ||
                                point == 0x200e || point == 0x200f || point == 0x61c;
  return is_control || is_bidirectional;
}

/// Levenshtein's distance: letters to insert, delete or replace.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

// "." ends at a line, and "^" and "$" are those of the text.
const auto whole_text = boost::match_not_dot_newline | boost::match_single_line;

const boost::regex& regex_of(std::string_view pattern) {
  thread_local std::map<std::string, boost::regex, std::less<>> made;  // the tests search in several threads
  const auto known = made.find(pattern);
  if (known != made.end()) return known->second;
  return made.emplace(pattern, boost::regex(boost::replace_all_copy(std::string(pattern), "[^]", "[\\s\\S]")))
      .first->second;
}

Match match_of(const boost::cmatch& found) {
  Match match;
  for (std::size_t i = 0; i < found.size(); ++i) {
    match.groups.push_back(found.str(i));
    match.offsets.push_back(static_cast<std::size_t>(found.position(i)));
  }
  return match;
}

}  // namespace

std::string printable(std::string_view text) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  std::string result;
  result.reserve(text.size());
  for (const char* next = text.begin(); next != text.end();) {
    const char* const begin = next;
    const boost::locale::utf::code_point point = Utf8::decode(next, text.end());
    if (point == boost::locale::utf::incomplete) break;  // cut in the middle of a character
    if (point == boost::locale::utf::illegal) next = begin + 1;
    if (point == boost::locale::utf::illegal || is_unsafe(point)) {
      result += '?';
    } else {
      result.append(begin, next);
    }
  }
  return result;
}

std::string cut(std::string_view text, std::size_t bytes) {
  std::size_t end = std::min(text.size(), bytes);
  while (end > 0 && end < text.size() && continues_character(text[end])) --end;
  return std::string(text.substr(0, end));
}

std::size_t display_width(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continues_character));
}

std::string shortened(const std::string& text, std::size_t width) {
  if (text.size() <= width || display_width(text) <= width) return text;
  std::size_t end = 0;
  for (std::size_t columns = 0; end < text.size(); ++end) {
    if (!continues_character(text[end]) && ++columns >= width) break;
  }
  return width == 0 ? "" : text.substr(0, end) + "…";
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, display_width(text)), ' ');
}

std::string padded_left(const std::string& text, std::size_t width) {
  return padded("", width - std::min(width, display_width(text))) + text;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.emplace_back(line);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

std::vector<std::string> wrapped_lines(std::string_view text, std::size_t width, std::size_t indent) {
  const std::string margin(indent, ' ');
  std::vector<std::string> result;
  for (const std::string& source : lines_of(text)) {
    std::string line = margin;
    std::istringstream words(source);
    for (std::string word; words >> word;) {
      const bool is_first = line.size() == indent;
      if (!is_first && display_width(line) + 1 + display_width(word) > width) {
        result.push_back(std::exchange(line, margin + word));
      } else {
        line += (is_first ? "" : " ") + word;
      }
    }
    result.push_back(line.size() == indent ? "" : line);
  }
  return result;
}

std::string plural(std::size_t count, const std::string& noun, const std::string& nouns) {
  return fmt::format("{} {}", count, count == 1 ? noun : nouns.empty() ? noun + "s" : nouns);
}

std::string listed(const std::vector<std::string>& words) {
  if (words.size() < 2) return words.empty() ? "" : words.front();
  return fmt::format("{} and {}", fmt::join(words.begin(), words.end() - 1, ", "), words.back());
}

std::string capitalized(std::string sentence) {
  if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z') sentence[0] = static_cast<char>(sentence[0] - 32);
  return sentence;
}

std::string without_full_stop(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

std::string superscript(int exponent) {
  static constexpr std::array digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string raised;
  for (const char digit : std::to_string(exponent)) raised += digit == '-' ? "⁻" : digits.at(digit - '0');
  return raised;
}

std::string Match::fill(std::string sentence, char mark) const {
  for (std::size_t i = 1; i < groups.size(); ++i) boost::replace_all(sentence, fmt::format("{}{}", mark, i), groups[i]);
  return sentence;
}

Match search(std::string_view text, std::string_view pattern) {
  boost::cmatch found;
  const bool is_there =
      boost::regex_search(text.data(), text.data() + text.size(), found, regex_of(pattern), whole_text);
  return is_there ? match_of(found) : Match();
}

std::vector<Match> search_all(std::string_view text, std::string_view pattern) {
  std::vector<Match> all;
  for (boost::cregex_iterator next(text.data(), text.data() + text.size(), regex_of(pattern), whole_text), end;
       next != end; ++next)
    all.push_back(match_of(*next));
  return all;
}

std::string replaced(std::string_view text, std::string_view pattern, const std::string& replacement) {
  std::string result;
  boost::regex_replace(std::back_inserter(result), text.data(), text.data() + text.size(), regex_of(pattern),
                       replacement, whole_text);
  return result;
}

std::string base64(std::string_view bytes) {
  constexpr int variant = sodium_base64_VARIANT_ORIGINAL;
  std::string text(sodium_base64_encoded_len(bytes.size(), variant), '\0');
  sodium_bin2base64(text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                    variant);
  text.pop_back();  // the null at its end
  return text;
}

std::string from_base64(std::string_view text) {
  std::string bytes(text.size() / 4 * 3, '\0');
  std::size_t size = 0;
  if (sodium_base642bin(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), text.data(), text.size(), nullptr,
                        &size, nullptr, sodium_base64_VARIANT_ORIGINAL) != 0)
    throw std::invalid_argument("This is not base64.");
  bytes.resize(size);
  return bytes;
}

std::string fingerprint(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  return fmt::format("{:016x}", hash);
}

std::string shell_quoted(const std::string& word) {
  const bool is_plain = !word.empty() && std::ranges::all_of(word, [](unsigned char letter) {
    return std::isalnum(letter) || std::string_view("_-./+:=@%,").find(static_cast<char>(letter)) != std::string::npos;
  });
  if (is_plain) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

std::string did_you_mean(const std::string& typed, const std::vector<std::string>& known) {
  std::string best;
  std::size_t fewest = std::max<std::size_t>(2, typed.size() / 3) + 1;
  for (const std::string& name : known) {
    const bool continued = typed.size() >= 4 && name.find(typed) != std::string::npos;
    const std::size_t changes = continued ? 1 : distance(typed, name);
    if (changes < fewest) {
      fewest = changes;
      best = name;
    }
  }
  return best;
}

std::string environment(const char* variable, const char* otherwise) {
  const char* const value = std::getenv(variable);
  return value == nullptr || *value == '\0' ? otherwise : value;
}

std::string command(const std::string& arguments) {
  return environment("WORKBOOK_PROGRAM", "checker") + " " + arguments;
}

}  // namespace workbook
