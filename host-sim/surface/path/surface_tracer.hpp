#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "host-sim/surface/path/path_heights.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "planner/surface/grown.hpp"

namespace sim::surface {

/// Returns the tool that a path follows: one that leaves the allowance, grown by the tolerance.
[[nodiscard]] cnc::surface::GrownTool traced_tool(const RowOptions& options);

/// Room that traces work with, and how many of them have lines because no arcs fit.
struct TraceRoom {
  SliceFitter fitter;
  std::vector<ContourVertex> lines;
  std::size_t without_arcs = 0;
};

/// Makes stretches over a surface, one slice after the other.
class SurfaceTracer {
 public:
  SurfaceTracer(const Mesh& mesh, const RowOptions& options);

  /// Lets stretches from now on mill a layer: only where the tip goes below its top, and no deeper
  /// than its bottom.
  void set_layer(double top_mm, double bottom_mm);

  /// Returns the parts of a slice in which something is under the tool, each as begin and end; the
  /// whole of it where there is a floor.
  [[nodiscard]] std::vector<std::pair<double, double>> parts_over(const Slice& slice) const;

  /// Returns the stretch over a part of a slice. Several threads may trace at once, each in a room
  /// of its own.
  [[nodiscard]] SurfaceStretch trace(
      const Slice& slice, double begin, double end, StretchUse use, TraceRoom& room) const;
  /// The same in the tracer's own room.
  [[nodiscard]] SurfaceStretch trace(const Slice& slice, double begin, double end, StretchUse use) {
    return trace(slice, begin, end, use, room_);
  }

  /// Returns the grown tool, with which heights are found.
  [[nodiscard]] const cnc::surface::Profile& profile() const { return tool_.profile; }

  /// Returns how many stretches have lines because no arcs fit.
  [[nodiscard]] std::size_t without_arcs() const { return room_.without_arcs; }

  /// Returns the exact height of the grown tool's tip, the lowest allowed where nothing is under
  /// it.
  [[nodiscard]] double height(const Eigen::Vector2d& place) const;

  /// Returns the exact height of the grown tool's tip, not raised; cnc::surface::kNoContact where
  /// nothing is under it and there is no floor.
  [[nodiscard]] double touched(const Eigen::Vector2d& place, PathHeights::Hint& hint) const;

  /// Returns the tool that is as much larger as the band.
  [[nodiscard]] const cnc::surface::Profile& grown_tool() const { return tool_.profile; }
  /// Returns by how much a path of the grown tool's tip is raised.
  [[nodiscard]] double lift_mm() const { return lift_mm_; }
  /// Returns how far a path may leave a curve that follows the grown tool's tip as closely as
  /// density() says.
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
  std::optional<double> layer_top_mm_;  ///< Height of the tip; without a layer everything is below.
  double layer_bottom_mm_;              ///< Height of the grown tool's tip.
  SliceDensity density_;
  double band_mm_;
  bool lines_only_;
  TraceRoom room_;
};

}  // namespace sim::surface
