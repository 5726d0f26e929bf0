#include "checker/base/printable.hpp"

#include <boost/locale/utf.hpp>

namespace workbook {

std::string printable(std::string_view text) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  std::string result;
  result.reserve(text.size());
  for (const char* next = text.begin(); next != text.end();) {
    const char* const begin = next;
    const boost::locale::utf::code_point point = Utf8::decode(next, text.end());
    if (point == boost::locale::utf::incomplete) break;  // cut in the middle of a letter
    if (point == boost::locale::utf::illegal) {
      next = begin + 1;
      result += '?';
      continue;
    }
    const bool control = (point < 0x20 && point != '\n' && point != '\t') || (point >= 0x7f && point < 0xa0);
    if (control)
      result += '?';
    else
      result.append(begin, next);
  }
  return result;
}

}  // namespace workbook
