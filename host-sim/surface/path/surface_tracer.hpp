#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "host-sim/surface/path/path_heights.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "planner/surface/grown.hpp"

namespace sim::surface {

/// Returns the tool for which the heights of a path are computed: the tool of the options, grown by
/// the allowance and the tolerance.
[[nodiscard]] cnc::surface::GrownTool traced_tool(const RowOptions& options);

/// Working memory of traces, and the number of pieces that became lines because no arcs are within
/// the tolerance.
struct TraceRoom {
  SliceFitter fitter;
  std::vector<ContourVertex> lines;
  std::size_t without_arcs = 0;
};

/// Traces stretches over a surface, one slice after another.
class SurfaceTracer {
 public:
  SurfaceTracer(const Mesh& mesh, const RowOptions& options);

  /// Limits the following stretches to a layer. They exist only where the tip goes below the
  /// layer's top, and they go no deeper than its bottom.
  void set_layer(double top_mm, double bottom_mm);

  /// Returns begin and end of each part of a slice in which something is under the tool; the
  /// complete slice if there is a floor.
  [[nodiscard]] std::vector<std::pair<double, double>> parts_over(const Slice& slice) const;

  /// Returns the stretch over a part of a slice. Several threads may trace at the same time, each
  /// with a separate `room`.
  [[nodiscard]] SurfaceStretch trace(
      const Slice& slice, double begin, double end, StretchUse use, TraceRoom& room) const;
  /// Returns the stretch over a part of a slice, traced with the working memory of this object.
  [[nodiscard]] SurfaceStretch trace(const Slice& slice, double begin, double end, StretchUse use) {
    return trace(slice, begin, end, use, room_);
  }

  /// Returns the profile of the grown tool, for which heights are computed.
  [[nodiscard]] const cnc::surface::Profile& profile() const { return tool_.profile; }

  /// Returns the number of pieces that became lines because no arcs are within the tolerance.
  [[nodiscard]] std::size_t without_arcs() const { return room_.without_arcs; }

  /// Returns the exact height of the grown tool's tip, plus lift_mm(); the lowest allowed height if
  /// nothing is under the tip.
  [[nodiscard]] double height(const Eigen::Vector2d& place) const;

  /// Returns the exact height of the grown tool's tip without lift_mm(). Returns
  /// cnc::surface::kNoContact if nothing is under the tip and there is no floor.
  [[nodiscard]] double touched(const Eigen::Vector2d& place, PathHeights::Hint& hint) const;

  /// Returns the profile of the grown tool, see traced_tool().
  [[nodiscard]] const cnc::surface::Profile& grown_tool() const { return tool_.profile; }
  /// Returns the height by which the path is above the heights of the grown tool's tip.
  [[nodiscard]] double lift_mm() const { return lift_mm_; }
  /// Returns the greatest deviation of a path from a curve that follows the grown tool's tip as
  /// closely as density() requires.
  [[nodiscard]] double band_mm() const { return band_mm_; }
  [[nodiscard]] const SliceDensity& density() const { return density_; }

 private:
  [[nodiscard]] bool is_over(const Eigen::Vector2d& place, PathHeights::Hint& hint) const;
  [[nodiscard]] double border(const Slice& slice, double over, double beside) const;

  cnc::surface::GrownTool tool_;
  double lift_mm_;
  PathHeights heights_;
  bool has_floor_;
  double lowest_mm_;
  /// Top of the layer, as height of the tip; empty without a layer.
  std::optional<double> layer_top_mm_;
  double layer_bottom_mm_;  ///< Bottom of the layer, as height of the grown tool's tip.
  SliceDensity density_;
  double band_mm_;
  bool lines_only_;
  TraceRoom room_;
};

}  // namespace sim::surface
