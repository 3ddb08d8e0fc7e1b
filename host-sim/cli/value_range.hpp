#pragma once

#include <cstdint>

namespace CLI {
class Validator;
}

namespace sim {

/// Returns a check for a number from `least` to `most`, both included. It also refuses text that is
/// no number. Messages and `--help` name the range and the unit.
/// @param unit may be empty
[[nodiscard]] CLI::Validator in_range(double least, double most, const char* unit);

/// Returns a check like in_range(), but for a number without a fraction.
[[nodiscard]] CLI::Validator in_whole_range(std::int64_t least,
                                            std::int64_t most,
                                            const char* unit = "");

/// Returns a check for PORT or ADDRESS:PORT of a socket. It refuses a wrong port with the permitted
/// range.
[[nodiscard]] CLI::Validator port_address();

}  // namespace sim
