#pragma once

#include <string>

namespace sim {

/// Returns a duration in readable form: `12.3 s`, `1 min 02.3 s`, `2 h 05 min 01 s`.
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace sim
