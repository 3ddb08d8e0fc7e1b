#include "host-sim/report/duration_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sim {

std::string duration_text(double seconds) {
  if (!(seconds < 3599.95)) {
    const long long whole = std::llround(std::min(seconds, 1e12));
    return fmt::format("{} h {:02} min {:02} s", whole / 3600, whole / 60 % 60, whole % 60);
  }
  const long long tenths = std::llround(10.0 * seconds);
  const double rest = static_cast<double>(tenths % 600) / 10.0;
  if (tenths < 600) return fmt::format("{:.1f} s", rest);
  return fmt::format("{} min {:04.1f} s", tenths / 600, rest);
}

}  // namespace sim
