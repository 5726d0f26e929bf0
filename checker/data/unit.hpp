/// @file
/// Units as exponents of kilogram, metre, second and radian, so that a change of units can be computed and tested.
#pragma once

#include <string>

namespace workbook {

struct Unit {
  int kilogram = 0;
  int metre = 0;
  int second = 0;
  int radian = 0;          ///< carried for the labels only: an angle has no dimension
  bool is_torque = false;  ///< for the label only: N m, where an energy is in J

  constexpr bool operator==(Unit other) const {
    return kilogram == other.kilogram && metre == other.metre && second == other.second && radian == other.radian;
  }
  constexpr Unit operator*(Unit other) const {
    return {kilogram + other.kilogram, metre + other.metre, second + other.second, radian + other.radian};
  }
  constexpr Unit operator/(Unit other) const {
    return {kilogram - other.kilogram, metre - other.metre, second - other.second, radian - other.radian};
  }
};

namespace units {
inline constexpr Unit none{};
inline constexpr Unit kilogram{.kilogram = 1};
inline constexpr Unit metre{.metre = 1};
inline constexpr Unit second{.second = 1};
inline constexpr Unit radian{.radian = 1};
inline constexpr Unit radian_per_second = radian / second;
inline constexpr Unit radian_per_second_squared = radian / second / second;
inline constexpr Unit metre_per_second = metre / second;
inline constexpr Unit metre_per_second_squared = metre / second / second;
inline constexpr Unit newton = kilogram * metre / second / second;
inline constexpr Unit newton_metre{.kilogram = 1, .metre = 2, .second = -2, .is_torque = true};
inline constexpr Unit joule = newton * metre;
inline constexpr Unit moment_of_inertia = kilogram * metre * metre;
inline constexpr Unit angular_momentum = moment_of_inertia / second;
}  // namespace units

/// "kg m²/s", "rad/s", "1/s", "N", "N m", "J"; "" for a pure number.
std::string to_string(Unit unit);

}  // namespace workbook
