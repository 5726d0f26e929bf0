#include "checker/base/superscript.hpp"

#include <array>

namespace workbook {

std::string superscript(int exponent) {
  static constexpr std::array<const char*, 10> raised_digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string raised;
  for (char character : std::to_string(exponent)) {
    raised += character == '-' ? "⁻" : raised_digits[static_cast<std::size_t>(character - '0')];
  }
  return raised;
}

}  // namespace workbook
