#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/pocket/adaptive_path.hpp"
#include "host-sim/pocket/open_pocket.hpp"
#include "host-sim/pocket/pocket_plan.hpp"

namespace sim::pocket {

enum class Strategy : std::uint8_t {
  kContour,   ///< Passes along the walls, as far apart as nothing is left between them.
  kSpiral,    ///< Spirals from the middle outwards, and loops where none fits.
  kAdaptive,  ///< Crescents that engage no more of the tool than allowed.
  kZigzag,    ///< Lines along X, and passes along the walls.
  kPaper,     ///< Paper 5 as printed: one spiral, for convex pockets without islands.
};

struct StrategyOptions {
  Strategy strategy = Strategy::kContour;
  cnc::pocket::PocketOptions<double> pocket;
  double engagement_deg = 60.0;  ///< Of the tool's circumference, at most; kAdaptive.
  /// What passes along the walls take off after all else, mm, up to the tool's radius; 0: there are
  /// none.
  double finish_mm = 0.0;
  /// These passes have lines at both ends, as FinishOptions has them.
  bool has_lead_lines = false;
  /// What one more level takes off at the floor after the others, mm; 0: there is none.
  double floor_mm = 0.0;
  /// Radius of a larger tool that went before, mm: only the rest is milled; 0: there was none.
  /// kContour, without finish_mm.
  double former_radius_mm = 0.0;
  /// The stock, in plan: pockets with their surroundings are milled from beside it. All but kPaper,
  /// without finish_mm.
  std::optional<StockBox> stock{};
};

/// Returns the margin around the stock with which a strategy mills open pockets, mm: see
/// with_surroundings(). @pre there is a stock
[[nodiscard]] double margin_of(const StrategyOptions& options);

/// The path of a pocket through all its levels, by any strategy.
struct MilledPocket : PathRows {
  std::uint32_t levels = 0;
  std::uint32_t passes =
      0;                    ///< Of each level: passes, loops, lines or, of a rest, parts of passes.
  std::uint32_t links = 0;  ///< Between passes; kContour.
  std::vector<NarrowStretch> narrow;  ///< Of each level; kAdaptive.
};

/// Makes paths of pockets by one strategy.
class StrategyPlanner {
 public:
  explicit StrategyPlanner(const StrategyOptions& options) : options_{options} {}

  /// Takes a depth in place of that of the options. @param depth_mm above 0
  void set_depth(double depth_mm) { options_.pocket.depth = depth_mm; }

  /// Throws NoPocketPath where there is no path, and std::invalid_argument for options out of
  /// range.
  /// @param pocket closed contours that do not cross, with the pocket on their left; with a stock
  /// it
  ///        may be what is around it
  /// @param tool_radius_mm in place of that of the options
  [[nodiscard]] MilledPocket mill(const cnc::contour::ContourView<double>& pocket,
                                  double tool_radius_mm);

 private:
  /// All levels of the depth.
  [[nodiscard]] MilledPocket mill_levels(const cnc::contour::ContourView<double>& pocket);
  [[nodiscard]] MilledPocket rough(const cnc::contour::ContourView<double>& pocket);
  void finish(const cnc::contour::ContourView<double>& pocket, MilledPocket& milled) const;
  [[nodiscard]] MilledPocket mill_contours(const cnc::contour::ContourView<double>& pocket);
  /// Passes without a path of their own.
  [[nodiscard]] PocketPlan passes_of(const cnc::contour::ContourView<double>& pocket,
                                     double stepover_mm);
  [[nodiscard]] MilledPocket mill_spirals(const cnc::contour::ContourView<double>& pocket,
                                          const std::optional<StockBox>& stock);
  /// Mills the plan around the stock together with the pockets that are open to it.
  [[nodiscard]] MilledPocket mill_open(const cnc::contour::ContourView<double>& pocket);
  [[nodiscard]] MilledPocket mill_open_contours(const cnc::contour::ContourView<double>& pocket);
  [[nodiscard]] MilledPocket mill_rest(const cnc::contour::ContourView<double>& pocket,
                                       double former_radius_mm);
  [[nodiscard]] MilledPocket mill_adaptively(const cnc::contour::ContourView<double>& pocket,
                                             const std::optional<StockBox>& stock) const;
  [[nodiscard]] MilledPocket mill_lines(const cnc::contour::ContourView<double>& pocket,
                                        const std::optional<StockBox>& stock) const;
  [[nodiscard]] MilledPocket mill_by_paper(const cnc::contour::ContourView<double>& pocket) const;
  /// The path of one level, as often as there are levels.
  [[nodiscard]] MilledPocket repeated(const PathRows& level) const;
  [[nodiscard]] MilledPocket repeated(const StockParts& level) const;
  [[nodiscard]] WallDrive wall_drive() const;
  [[nodiscard]] double levels() const;
  [[nodiscard]] double step_mm() const { return options_.pocket.depth / levels(); }

  StrategyOptions options_;
  PocketPlanner planner_;
};

}  // namespace sim::pocket
