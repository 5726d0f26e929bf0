/// @file
/// Asks a witness: one process, one call of the student's function, and everything that was seen of it.
#pragma once

#include "checker/data/value.hpp"
#include "checker/sandbox/sandbox.hpp"
#include "checker/worker/instrumented/sighting.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace workbook {

/// What fills the memory that the function never set.
enum class Paint : std::uint64_t {
  zero = 0,
  as_in_judging = 0xfefefefefefefefe,  ///< GCC's -ftrivial-auto-var-init=pattern
  signalling = 0x7ff4ab1e'7ff4ab1e     ///< as a double: a NaN that traps at its first use in arithmetic
};

/// True for a number that is still as Paint::signalling left it. Every calculation changes it.
bool is_painted(double number);

struct LookLimits {
  std::chrono::duration<double> time{5.0};
  std::chrono::duration<double> between_questions{0.05};
  int questions = 0;  ///< how often to ask where the call is, at the end of the time; 0: not at all
  std::size_t output_bytes = std::size_t{256} << 10;
  SandboxLimits sandbox;
};

struct Look {
  std::vector<sightings::Sighting> sightings;  ///< in the order of time
  std::optional<Value> result;
  bool out_of_time = false;
  bool too_much_output = false;

  /// The sighting that ended the call; nullptr if nothing is known of the end.
  const sightings::Sighting* end() const;
  bool operator==(const Look& other) const;  ///< did the call end in the same way, bit by bit?
};

/// Never believes the student's code: anything but well-formed sightings makes an empty look.
/// @throws LaunchError, SandboxError
Look run_look(const std::filesystem::path& witness, const std::vector<Value>& inputs, Paint paint,
              sightings::Traps traps, const LookLimits& limits = {});

}  // namespace workbook
