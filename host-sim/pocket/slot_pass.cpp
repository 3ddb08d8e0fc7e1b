#include "host-sim/pocket/slot_pass.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host-sim/pocket/round_way.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::AreaDistance;
using cnc::pocket::Use;

/// Returns the arc at a corner with the longest trim that fits. Tries half of the shorter line, a
/// quarter and so on. An arc fits if its middle keeps the tool's radius from the walls. Returns an
/// arc without length if the trim becomes negligibly short, or if the corner is too flat.
Rounding fitting_rounding(const WideVec2& before,
                          const WideVec2& corner,
                          const WideVec2& after,
                          const AreaDistance& area,
                          double tool_radius_mm) {
  constexpr double kExcessMm = 1.0e-7;   // Rounding error of a distance, mm.
  constexpr double kFlatBulge = 2.5e-5;  // Flatter corners get no arc; 0.006°.
  double trim_mm = 0.5 * std::min((corner - before).norm(), (after - corner).norm());
  for (; trim_mm >= kMinTurnMm; trim_mm *= 0.5) {
    Rounding arc = rounding_of(before, corner, after, trim_mm);
    if (std::abs(arc.bulge) < kFlatBulge) break;
    if (area.depth(arc.middle()) >= tool_radius_mm - kExcessMm) return arc;
  }
  return {corner, corner, 0.0};
}

}  // namespace

void pass_lines(DepthWriter& writer,
                const std::vector<WideVec2>& way,
                const AreaDistance& area,
                double tool_radius_mm) {
  const auto pass = [&writer](const WideVec2& to, double bulge) {
    if ((to - writer.place()).norm() > kSamePlaceMm) writer.pass(to, bulge);
  };
  for (std::size_t i = 1; i + 1 < way.size(); ++i) {
    const Rounding arc = fitting_rounding(way[i - 1], way[i], way[i + 1], area, tool_radius_mm);
    pass(arc.start, 0.0);
    pass(arc.end, arc.bulge);
  }
  pass(way.back(), 0.0);
}

void pass_disc(DepthWriter& writer, const cnc::pocket::ToolCircle& disc) {
  const WideVec2 heading = writer.heading();
  const WideVec2 ahead = heading == WideVec2{0.0, 0.0} ? WideVec2{1.0, 0.0} : heading;
  writer.pass(disc.centre + disc.radius * cnc::left_normal(ahead), 1.0);
  writer.circle(Use::kPass, disc.centre);
}

}  // namespace sim::pocket
