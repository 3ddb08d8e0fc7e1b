#include "host-sim/pocket/strategy.hpp"

#include <algorithm>
#include <utility>

#include "host-sim/pocket/finish_pass.hpp"
#include "host-sim/pocket/fitting_radius.hpp"
#include "host-sim/pocket/paper_path.hpp"
#include "host-sim/pocket/rest_path.hpp"
#include "host-sim/pocket/spiral_path.hpp"
#include "host-sim/pocket/zigzag.hpp"

namespace sim::pocket {

double margin_of(const StrategyOptions& options) {
  // Margins in tool radii. The tool moves beyond the edge by slightly more than its diameter.
  // Crescents begin in discs that are twice as wide as the tool.
  constexpr double kOfLoops = 2.5;
  constexpr double kOfCrescents = 4.0;
  const double radius_mm = options.pocket.clearing.tool_radius;
  switch (options.strategy) {
    case Strategy::kAdaptive:
      return kOfCrescents * radius_mm;
    case Strategy::kSpiral:
    case Strategy::kZigzag:
      return kOfLoops * radius_mm;
    default:
      return margin_around(*options.stock, radius_mm);
  }
}

MilledPocket StrategyPlanner::mill(const cnc::contour::ContourView<double>& pocket,
                                   double tool_radius_mm) {
  options_.pocket.clearing.tool_radius = tool_radius_mm;
  const double depth_mm = options_.pocket.depth;
  const double floor_mm = options_.floor_mm;
  if (floor_mm == 0.0 || depth_mm <= floor_mm) return mill_levels(pocket);
  set_depth(depth_mm - floor_mm);
  MilledPocket milled = mill_levels(pocket);
  set_depth(floor_mm);
  const MilledPocket floor = mill_levels(pocket);
  set_depth(depth_mm);
  milled.append(floor, floor_mm - depth_mm);
  milled.levels += floor.levels;
  return milled;
}

MilledPocket StrategyPlanner::mill_levels(const cnc::contour::ContourView<double>& pocket) {
  const double tool_radius_mm = options_.pocket.clearing.tool_radius;
  const bool is_open = options_.stock && is_around(pocket, *options_.stock);
  if (is_open) return mill_open(pocket);
  ContourOffset offsetter;
  if (options_.former_radius_mm > 0.0) {
    const double former_mm = fitting_radius(pocket, options_.former_radius_mm, offsetter);
    // If the former tool fits nowhere, all stock is left, as without a former tool.
    if (former_mm > 0.0) return mill_rest(pocket, former_mm);
  }
  if (options_.finish_mm == 0.0) return rough(pocket);
  const Contour within = copy_of(offsetter.offset(pocket, -options_.finish_mm));
  MilledPocket milled;
  // If only the passes along the walls fit, the path consists of these passes.
  if (offsetter.offset(within.view(), -tool_radius_mm).loop_ends.size() > 0) {
    milled = rough(within.view());
  }
  finish(pocket, milled);
  return milled;
}

/// Appends the passes along the walls, from the highest level to the lowest.
void StrategyPlanner::finish(const cnc::contour::ContourView<double>& pocket,
                             MilledPocket& milled) const {
  const PathRows level = finish_pass(pocket,
                                     {.tool_radius_mm = options_.pocket.clearing.tool_radius,
                                      .allowance_mm = options_.finish_mm,
                                      .depth_mm = step_mm(),
                                      .slope = options_.pocket.entry.slope,
                                      .milling = options_.pocket.milling,
                                      .has_lead_lines = options_.has_lead_lines});
  const MilledPocket walls = repeated(level);
  milled.append(walls);
  milled.levels = walls.levels;
}

MilledPocket StrategyPlanner::rough(const cnc::contour::ContourView<double>& pocket) {
  switch (options_.strategy) {
    case Strategy::kContour:
      return mill_contours(pocket);
    case Strategy::kSpiral:
      return mill_spirals(pocket, std::nullopt);
    case Strategy::kAdaptive:
      return mill_adaptively(pocket, std::nullopt);
    case Strategy::kZigzag:
      return mill_lines(pocket, std::nullopt);
    case Strategy::kPaper:
      break;
  }
  return mill_by_paper(pocket);
}

double StrategyPlanner::levels() const {
  return cnc::pocket::level_count(options_.pocket.depth, options_.pocket.depth_step);
}

MilledPocket StrategyPlanner::repeated(const PathRows& level) const {
  MilledPocket milled;
  milled.levels = static_cast<std::uint32_t>(levels());
  for (std::uint32_t i = 0; i < milled.levels; ++i) milled.append(level, -step_mm() * i);
  return milled;
}

MilledPocket StrategyPlanner::mill_contours(const cnc::contour::ContourView<double>& pocket) {
  PocketPlan plan = planner_.plan(pocket, options_.pocket);
  MilledPocket milled;
  milled.points = std::move(plan.points);
  milled.row_ends = std::move(plan.row_ends);
  milled.levels = plan.report.levels;
  milled.passes = plan.report.passes;
  milled.links = plan.report.links;
  return milled;
}

PocketPlan StrategyPlanner::passes_of(const cnc::contour::ContourView<double>& pocket,
                                      double stepover_mm) {
  cnc::pocket::PocketOptions<double> wanted = options_.pocket;
  wanted.clearing.stepover = stepover_mm;
  // Only the passes are used. Therefore one level of the path is enough, and entries may plunge.
  wanted.depth = step_mm();
  wanted.entry.kind = cnc::pocket::EntryKind::kPlunge;
  return planner_.plan(pocket, wanted);
}

MilledPocket StrategyPlanner::mill_spirals(const cnc::contour::ContourView<double>& pocket,
                                           const std::optional<StockBox>& stock) {
  const auto& clearing = options_.pocket.clearing;
  const double widest_mm = widest_spiral_mm(clearing.tool_radius, clearing.corner_radius);
  const double stepover_mm = std::min(clearing.stepover, widest_mm);
  const PocketPlan plan = passes_of(pocket, stepover_mm);
  const SpiralOptions options{.tool_radius_mm = clearing.tool_radius,
                              .depth_mm = step_mm(),
                              .entry = options_.pocket.entry,
                              .milling = options_.pocket.milling,
                              .stepover_mm = stepover_mm};
  const SpiralPath path =
      stock ? open_spiral_path(pocket, *stock, plan, options) : spiral_path(plan, options);
  MilledPocket milled = repeated(path);
  milled.passes = path.turns + path.loops;
  milled.links = path.links;
  return milled;
}

WallDrive StrategyPlanner::wall_drive() const {
  return {.depth_mm = step_mm(),
          .slope = options_.pocket.entry.slope,
          .plunges = options_.pocket.entry.kind == cnc::pocket::EntryKind::kPlunge,
          .milling = options_.pocket.milling};
}

MilledPocket StrategyPlanner::repeated(const StockParts& level) const {
  MilledPocket milled = repeated(static_cast<const PathRows&>(level));
  milled.passes = level.parts;
  return milled;
}

MilledPocket StrategyPlanner::mill_open(const cnc::contour::ContourView<double>& pocket) {
  switch (options_.strategy) {
    case Strategy::kSpiral:
      return mill_spirals(pocket, options_.stock);
    case Strategy::kAdaptive:
      return mill_adaptively(pocket, options_.stock);
    case Strategy::kZigzag:
      return mill_lines(pocket, options_.stock);
    default:
      return mill_open_contours(pocket);
  }
}

MilledPocket StrategyPlanner::mill_open_contours(const cnc::contour::ContourView<double>& pocket) {
  const auto& clearing = options_.pocket.clearing;
  return repeated(open_path(pocket,
                            *options_.stock,
                            passes_of(pocket, clearing.stepover).passes,
                            {.tool_radius_mm = clearing.tool_radius, .drive = wall_drive()}));
}

MilledPocket StrategyPlanner::mill_rest(const cnc::contour::ContourView<double>& pocket,
                                        double former_radius_mm) {
  const auto& clearing = options_.pocket.clearing;
  return repeated(rest_path(pocket,
                            former_radius_mm,
                            passes_of(pocket, clearing.stepover).passes,
                            {.tool_radius_mm = clearing.tool_radius, .drive = wall_drive()}));
}

MilledPocket StrategyPlanner::mill_adaptively(const cnc::contour::ContourView<double>& pocket,
                                              const std::optional<StockBox>& stock) const {
  const AdaptivePath path = adaptive_path(pocket,
                                          {.tool_radius_mm = options_.pocket.clearing.tool_radius,
                                           .engagement_deg = options_.engagement_deg,
                                           .depth_mm = step_mm(),
                                           .entry = options_.pocket.entry.kind,
                                           .slope = options_.pocket.entry.slope,
                                           .stock = stock});
  MilledPocket milled = repeated(path);
  milled.narrow = path.narrow;
  return milled;
}

MilledPocket StrategyPlanner::mill_lines(const cnc::contour::ContourView<double>& pocket,
                                         const std::optional<StockBox>& stock) const {
  const bool plunges = options_.pocket.entry.kind == cnc::pocket::EntryKind::kPlunge;
  const double radius_mm = options_.pocket.clearing.tool_radius;
  // In a slot, the tool's radius is reduced slightly (see fitting_radius()), so the stepover may
  // exceed the tool's diameter.
  const double stepover_mm = std::min(options_.pocket.clearing.stepover, 2.0 * radius_mm);
  const Zigzag path = zigzag_path(pocket,
                                  {.tool_radius_mm = radius_mm,
                                   .stepover_mm = stepover_mm,
                                   .turn_radius_mm = options_.pocket.clearing.corner_radius,
                                   .depth_mm = step_mm(),
                                   .slope = options_.pocket.entry.slope,
                                   .plunges = plunges,
                                   .stock = stock});
  MilledPocket milled = repeated(path);
  milled.passes = path.lines;
  return milled;
}

MilledPocket StrategyPlanner::mill_by_paper(const cnc::contour::ContourView<double>& pocket) const {
  const PaperPath path = paper_path(pocket, options_.pocket.clearing.tool_radius, step_mm());
  MilledPocket milled = repeated(path);
  milled.passes = path.loops;
  return milled;
}

}  // namespace sim::pocket
