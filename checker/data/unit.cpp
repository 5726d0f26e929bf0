#include "checker/data/unit.hpp"

#include "checker/base/text.hpp"

#include <array>
#include <cstdlib>
#include <utility>

namespace workbook {

std::string to_string(Unit unit) {
  if (unit == units::newton) return "N";
  if (unit == units::joule) return unit.is_torque ? "N m" : "J";
  const std::array<std::pair<const char*, int>, 4> powers = {
      {{"kg", unit.kilogram}, {"m", unit.metre}, {"rad", unit.radian}, {"s", unit.second}}};

  std::string above;
  std::string below;
  int factors_below = 0;
  for (const auto& [symbol, exponent] : powers) {
    if (exponent == 0) continue;
    std::string& side = exponent > 0 ? above : below;
    if (!side.empty()) side += ' ';
    side += symbol;
    if (std::abs(exponent) != 1) side += superscript(std::abs(exponent));
    if (exponent < 0) ++factors_below;
  }

  if (below.empty()) return above;
  if (factors_below > 1) below = "(" + below + ")";
  return (above.empty() ? "1" : above) + "/" + below;
}

}  // namespace workbook
