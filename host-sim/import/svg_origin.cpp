#include "host-sim/import/svg_origin.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <string_view>

namespace sim::drawing {

void note_burn(Sketch& sketch, const std::string& svg) {
  // The label of the reference line of Boxes.py is a text such as `100.0mm, burn:0.10mm`.
  constexpr std::string_view kGenerator = "Boxes.py";
  constexpr std::string_view kBurn = "burn:";
  const std::size_t found = svg.find(kBurn);
  if (found == std::string::npos || svg.find(kGenerator) == std::string::npos) return;
  const char* const from = svg.c_str() + found + kBurn.size();
  char* end = nullptr;
  const double burn_mm = std::strtod(from, &end);
  constexpr double kMaxBurnMm = 10.0;
  const bool is_known = end != from && std::string_view{end}.starts_with("mm");
  if (!is_known || !(burn_mm > 0.0) || burn_mm > kMaxBurnMm) return;
  sketch.note(
      fmt::format(
          "drawn by Boxes.py with burn {:g} mm, which allows for a kerf of {:g} mm: "
          "its parts have the right size if they are cut on the lines, not offset from them",
          burn_mm,
          2.0 * burn_mm),
      {},
      "draw it with burn 0, or cut with --layer '*: side=on'");
}

}  // namespace sim::drawing
