#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "host-sim/surface/path/path_heights.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "planner/surface/grown.hpp"

namespace sim::surface {

/// Returns the tool that a path follows: the tool of the options, enlarged by the allowance and
/// grown by the tolerance.
[[nodiscard]] cnc::surface::GrownTool traced_tool(const RowOptions& options);

/// Working memory of traces, and the number of stretches that are lines because no arcs fit.
struct TraceRoom {
  SliceFitter fitter;
  std::vector<ContourVertex> lines;
  std::size_t without_arcs = 0;
};

/// Traces stretches over a surface, one slice after another.
class SurfaceTracer {
 public:
  SurfaceTracer(const Mesh& mesh, const RowOptions& options);

  /// Limits the following stretches to a layer: they exist only where the tip goes below its top,
  /// and go no deeper than its bottom.
  void set_layer(double top_mm, double bottom_mm);

  /// Returns begin and end of each part of a slice in which something is under the tool; the whole
  /// slice if there is a floor.
  [[nodiscard]] std::vector<std::pair<double, double>> parts_over(const Slice& slice) const;

  /// Returns the stretch over a part of a slice. Several threads may trace at once, each with its
  /// own `room`.
  [[nodiscard]] SurfaceStretch trace(
      const Slice& slice, double begin, double end, StretchUse use, TraceRoom& room) const;
  /// Returns the stretch, traced with the tracer's own working memory.
  [[nodiscard]] SurfaceStretch trace(const Slice& slice, double begin, double end, StretchUse use) {
    return trace(slice, begin, end, use, room_);
  }

  /// Returns the grown tool, with which heights are computed.
  [[nodiscard]] const cnc::surface::Profile& profile() const { return tool_.profile; }

  /// Returns the number of stretches that are lines because no arcs fit.
  [[nodiscard]] std::size_t without_arcs() const { return room_.without_arcs; }

  /// Returns the exact height of the grown tool's tip, raised; the lowest allowed height if nothing
  /// is under the tip.
  [[nodiscard]] double height(const Eigen::Vector2d& place) const;

  /// Returns the exact height of the grown tool's tip, not raised. Returns cnc::surface::kNoContact
  /// if nothing is under the tip and there is no floor.
  [[nodiscard]] double touched(const Eigen::Vector2d& place, PathHeights::Hint& hint) const;

  /// Returns the grown tool, which is larger by the tolerance than the tool that leaves the
  /// allowance.
  [[nodiscard]] const cnc::surface::Profile& grown_tool() const { return tool_.profile; }
  /// Returns the height by which a path of the grown tool's tip is raised.
  [[nodiscard]] double lift_mm() const { return lift_mm_; }
  /// Returns the distance by which a path may leave a curve that follows the grown tool's tip as
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
  /// Top of the layer, as height of the tip; without a layer there is no upper limit.
  std::optional<double> layer_top_mm_;
  double layer_bottom_mm_;  ///< Bottom of the layer, as height of the grown tool's tip.
  SliceDensity density_;
  double band_mm_;
  bool lines_only_;
  TraceRoom room_;
};

}  // namespace sim::surface
