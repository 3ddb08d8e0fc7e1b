#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/pocket/adaptive_path.hpp"
#include "host-sim/pocket/open_pocket.hpp"
#include "host-sim/pocket/pocket_plan.hpp"

namespace sim::pocket {

enum class Strategy : std::uint8_t {
  kContour,   ///< Passes along the walls, as far apart as possible without stock left between them.
  kSpiral,    ///< Spirals from the middle outwards, and loops where no spiral fits.
  kAdaptive,  ///< Crescents with limited engagement.
  kZigzag,    ///< Lines along X, and passes along the walls.
  kPaper,     ///< Paper 5 as printed: one spiral, for convex pockets without islands.
};

struct StrategyOptions {
  Strategy strategy = Strategy::kContour;
  cnc::pocket::PocketOptions<double> pocket;
  /// Greatest engagement of the tool, degrees; for kAdaptive.
  double engagement_deg = 60.0;
  /// Allowance that the passes along the walls remove at the end, mm, up to the tool's radius. At
  /// 0, there are no such passes.
  double finish_mm = 0.0;
  /// Whether the passes along the walls have lines at both ends; see FinishOptions.
  bool has_lead_lines = false;
  /// Thickness of the last level, which is removed at the floor after all other levels, mm. At 0,
  /// there is no such level.
  double floor_mm = 0.0;
  /// Radius of a larger tool that was used before, mm. Only the stock that this tool has left is
  /// milled. 0: no tool was used before. Allowed for kContour, without `finish_mm`.
  double former_radius_mm = 0.0;
  /// Outline of the stock. If it is set, pockets with their surroundings are milled from outside of
  /// the stock. Allowed for all strategies except kPaper, without `finish_mm`.
  std::optional<StockBox> stock{};
};

/// Returns the margin around the stock that a strategy requires for open pockets, mm; see
/// with_surroundings().
/// @pre `options.stock` has a value
[[nodiscard]] double margin_of(const StrategyOptions& options);

/// The path of a pocket through all its levels, by any strategy.
struct MilledPocket : PathRows {
  std::uint32_t levels = 0;
  /// Number of passes, loops, lines or (after a former tool) parts on each level.
  std::uint32_t passes = 0;
  std::uint32_t links = 0;            ///< Number of links between passes; for kContour and kSpiral.
  std::vector<NarrowStretch> narrow;  ///< Narrow stretches of each level; for kAdaptive.
};

/// Makes paths of pockets by one strategy.
class StrategyPlanner {
 public:
  explicit StrategyPlanner(const StrategyOptions& options) : options_{options} {}

  /// Sets the depth, which replaces the depth in the options. @param depth_mm above 0
  void set_depth(double depth_mm) { options_.pocket.depth = depth_mm; }

  /// Makes the path of a pocket. Throws NoPocketPath if there is no path, and std::invalid_argument
  /// for options out of range.
  /// @param pocket closed contours that do not cross, with the pocket on their left; with a stock,
  /// it may be the surroundings of the stock
  /// @param tool_radius_mm replaces the radius of the options
  [[nodiscard]] MilledPocket mill(const cnc::contour::ContourView<double>& pocket,
                                  double tool_radius_mm);

 private:
  /// Makes all levels down to the depth.
  [[nodiscard]] MilledPocket mill_levels(const cnc::contour::ContourView<double>& pocket);
  [[nodiscard]] MilledPocket rough(const cnc::contour::ContourView<double>& pocket);
  void finish(const cnc::contour::ContourView<double>& pocket, MilledPocket& milled) const;
  [[nodiscard]] MilledPocket mill_contours(const cnc::contour::ContourView<double>& pocket);
  /// Returns the passes of a pocket, without their path.
  [[nodiscard]] PocketPlan passes_of(const cnc::contour::ContourView<double>& pocket,
                                     double stepover_mm);
  [[nodiscard]] MilledPocket mill_spirals(const cnc::contour::ContourView<double>& pocket,
                                          const std::optional<StockBox>& stock);
  /// Mills the surroundings of the stock, including the pockets that are open to them.
  [[nodiscard]] MilledPocket mill_open(const cnc::contour::ContourView<double>& pocket);
  [[nodiscard]] MilledPocket mill_open_contours(const cnc::contour::ContourView<double>& pocket);
  [[nodiscard]] MilledPocket mill_rest(const cnc::contour::ContourView<double>& pocket,
                                       double former_radius_mm);
  [[nodiscard]] MilledPocket mill_adaptively(const cnc::contour::ContourView<double>& pocket,
                                             const std::optional<StockBox>& stock) const;
  [[nodiscard]] MilledPocket mill_lines(const cnc::contour::ContourView<double>& pocket,
                                        const std::optional<StockBox>& stock) const;
  [[nodiscard]] MilledPocket mill_by_paper(const cnc::contour::ContourView<double>& pocket) const;
  /// Returns the path of one level, repeated for all levels.
  [[nodiscard]] MilledPocket repeated(const PathRows& level) const;
  [[nodiscard]] MilledPocket repeated(const StockParts& level) const;
  [[nodiscard]] WallDrive wall_drive() const;
  [[nodiscard]] double levels() const;
  [[nodiscard]] double step_mm() const { return options_.pocket.depth / levels(); }

  StrategyOptions options_;
  PocketPlanner planner_;
};

}  // namespace sim::pocket
