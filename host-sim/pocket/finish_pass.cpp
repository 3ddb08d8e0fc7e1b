#include "host-sim/pocket/finish_pass.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "host-sim/pocket/axis_entry.hpp"
#include "host-sim/pocket/depth_writer.hpp"
#include "host-sim/pocket/lead_arc.hpp"
#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/owned_boundary.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "host-sim/pocket/wall_ramp.hpp"
#include "planner/pocket/pocket_entry.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::LoopPlace;
using cnc::pocket::Milling;
using cnc::pocket::Use;

/// Greatest radius of an arc that leads to a wall, as a share of the tool's radius.
constexpr double kLeadShare = 1.0;

/// A pass along a wall, with a quarter of a circle before it and another after it.
struct Lead {
  LoopPlace<double> place;
  WideVec2 begin{0.0, 0.0};
  WideVec2 end{0.0, 0.0};
  double bulge = 0.0;
  WideVec2 inwards{0.0, 0.0};  ///< Direction away from the wall, a unit vector.
  /// Length of the lines before `begin` and after `end`, mm; 0: no lines.
  double line_mm = 0.0;
};

/// Returns the arcs of a pass along one loop. The first arc leads from a cleared point to the loop,
/// the last arc from the loop to a cleared point. Returns none where no arcs fit.
std::optional<Lead> lead_to(const OwnedBoundary& walls,
                            std::size_t loop,
                            const FinishOptions& options) {
  const auto plan = cnc::pocket::plan_entry<double>(
      walls.view(),
      walls.nearest(),
      walls.view(),
      loop,
      options.milling,
      {cnc::pocket::EntryKind::kHelix, options.slope, kLeadShare * options.tool_radius_mm});
  if (plan.helix_radius == 0.0) return std::nullopt;
  const double side = options.milling == Milling::kClimb ? 1.0 : -1.0;
  const WideVec2& tangent = plan.place.pose.tangent;
  const WideVec2 centre =
      plan.place.pose.point + side * plan.helix_radius * cnc::left_normal(tangent);
  const Lead lead{plan.place,
                  centre - plan.helix_radius * tangent,
                  centre + plan.helix_radius * tangent,
                  side * kQuarterTurnBulge,
                  side * cnc::left_normal(tangent)};
  constexpr double kRoundingMm = 1.0e-9;
  const double cleared = options.allowance_mm - kRoundingMm;
  if (walls.distance(lead.begin) < cleared || walls.distance(lead.end) < cleared) {
    return std::nullopt;
  }
  return lead;
}

/// Returns the greatest length of the lines at both ends of a lead that fits into the area that
/// roughing has cleared, mm; 0 where no line fits.
double line_length(const Lead& lead, const OwnedArea& area, const FinishOptions& options) {
  constexpr int kHalvings = 3;
  const double cleared = options.tool_radius_mm + options.allowance_mm;
  double length = options.tool_radius_mm;
  for (int i = 0; i <= kHalvings; ++i, length *= 0.5) {
    const WideVec2 line = length * lead.inwards;
    if (fits_in_line(lead.begin + line, lead.begin, *area, cleared) &&
        fits_in_line(lead.end, lead.end + line, *area, cleared)) {
      return length;
    }
  }
  return 0.0;
}

/// Adds lines to a lead. Throws NoPocketPath if there is no lead, or if no line fits.
Lead with_lines(std::optional<Lead> lead,
                const WideVec2& place,
                const OwnedArea& area,
                const FinishOptions& options) {
  if (lead) lead->line_mm = line_length(*lead, area, options);
  if (lead && lead->line_mm > 0.0) return *lead;
  throw NoPocketPath{fmt::format(
      "at {:.3f} {:.3f} there is no space for the lead that G41 and G42 require; leave out "
      "--wear or choose a smaller tool",
      place.x(),
      place.y())};
}

void drive(const OwnedBoundary& walls,
           const Lead& lead,
           const FinishOptions& options,
           PathRows& out) {
  DepthWriter writer{out, options.depth_mm};
  writer.begin_row_in_cleared(lead.begin + lead.line_mm * lead.inwards);
  if (lead.line_mm > 0.0) writer.go(Use::kLeadIn, lead.begin, 0.0, writer.floor_z());
  writer.pass(lead.place.pose.point, lead.bulge);
  // Removes the point at which the revolution begins, because revolve() appends it again.
  out.points.pop_back();
  const double floor = writer.floor_z();
  revolve(walls.view(), lead.place, options.milling, {floor, floor, Use::kPass}, out);
  const WideVec2& touch = lead.place.pose.point;
  out.points.push_back({touch.x(), touch.y(), floor, 0.0, Use::kPass});
  writer.pass(lead.end, lead.bulge);
  if (lead.line_mm > 0.0) {
    writer.go(Use::kLeadOut, lead.end + lead.line_mm * lead.inwards, 0.0, writer.floor_z());
  }
  out.end_row();
}

}  // namespace

PathRows finish_pass(const cnc::contour::ContourView<double>& pocket,
                     const FinishOptions& options) {
  ContourOffset offsetter;
  const OwnedBoundary walls{copy_of(offsetter.offset(pocket, -options.tool_radius_mm))};
  const OwnedArea area{pocket};
  PathRows rows;
  for (std::size_t loop = 0; loop < walls.loops(); ++loop) {
    std::optional<Lead> lead = lead_to(walls, loop, options);
    if (options.has_lead_lines) {
      const WideVec2 place = walls.view().vertices[walls.view().loop_begin(loop)].point();
      lead = with_lines(std::move(lead), place, area, options);
    }
    if (lead) {
      drive(walls, *lead, options, rows);
    } else {
      ramp_along_wall(
          walls.view(),
          loop,
          {.depth_mm = options.depth_mm, .slope = options.slope, .milling = options.milling},
          rows);
    }
  }
  return rows;
}

}  // namespace sim::pocket
