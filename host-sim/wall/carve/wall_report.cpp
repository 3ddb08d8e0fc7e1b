#include "host-sim/wall/carve/wall_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace sim::wall {
namespace {

void add_to(WallReport::Figures& figures, const WallLean& lean, double drawn_deg) {
  const double off = lean.angle_deg - drawn_deg;
  ++figures.carved;
  figures.max_off_deg = std::max(figures.max_off_deg, std::abs(off));
  figures.mean_off_deg += (off - figures.mean_off_deg) / static_cast<double>(figures.carved);
}

}  // namespace

WallReport report_walls(const std::vector<DrawnWall>& walls,
                        const std::vector<const Columns*>& blocks) {
  WallReport report;
  report.figures.resize(blocks.size());
  report.text = "# x y z outward_x outward_y drawn_deg";
  for (std::size_t i = 0; i < blocks.size(); ++i) report.text += " carved_deg spread_deg";
  report.text += '\n';
  for (const DrawnWall& wall : walls) {
    const WallPlace& place = wall.place;
    fmt::format_to(std::back_inserter(report.text),
                   "{:.4f} {:.4f} {:.4f} {:.4f} {:.4f} {:.3f}",
                   place.at.x(),
                   place.at.y(),
                   0.5 * (place.low_mm + place.high_mm),
                   place.outward.x(),
                   place.outward.y(),
                   wall.angle_deg);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const std::optional<WallLean> lean = lean_at(*blocks[i], place);
      if (!lean) {
        ++report.figures[i].missing;
        report.text += " - -";
        continue;
      }
      add_to(report.figures[i], *lean, wall.angle_deg);
      fmt::format_to(
          std::back_inserter(report.text), " {:.3f} {:.3f}", lean->angle_deg, lean->spread_deg);
    }
    report.text += '\n';
  }
  return report;
}

}  // namespace sim::wall
