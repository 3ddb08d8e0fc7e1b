#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "host-sim/wall/layer/layer_regions.hpp"

namespace sim::wall {

enum class StrokeUse : std::uint8_t {
  kHatch,    ///< A hatch line over the area of a layer.
  kContour,  ///< A line along the walls of a layer.
};

/// A line of the beam's tip at one height, mm. The beam is on over the complete line.
struct Stroke {
  StrokeUse use = StrokeUse::kHatch;
  std::vector<Eigen::Vector2d> places;  ///< Points of the line, at least two.
};

/// Options for the strokes in layers.
struct StrokeOptions {
  double hatch_mm = 0.0;   ///< Distance between hatch lines; 0: no hatch.
  double angle_deg = 0.0;  ///< Direction of the first layer's hatch lines, measured from +X.
  double turn_deg = 0.0;   ///< Rotation of the hatch lines from one layer to the next.
  /// Radius of the beam at its tip. All strokes keep this distance from the walls.
  double waist_mm = 0.0;
  bool has_contour = true;
};

/// Makes the strokes of layers, one layer after another. Hatch lines come first, and the nearest
/// remaining part of a line is always the next stroke. The contours along the walls follow. The
/// borders of the stock are not walls.
class LayerStrokes {
 public:
  /// @param stock rectangle of the stock
  LayerStrokes(const Eigen::AlignedBox2d& stock, const StrokeOptions& options)
      : stock_{stock}, options_{options} {}

  /// Returns the strokes of a layer in the order of burning. The first stroke begins near the end
  /// of the previous layer.
  /// @param number number of the layer, counted from 0 at the top
  /// Throws NoOffset if the areas cannot be offset.
  [[nodiscard]] std::vector<Stroke> strokes_of(const Layer& layer, std::size_t number);

 private:
  void add_hatch(const std::vector<Contour>& areas, double angle_rad, std::vector<Stroke>& strokes);
  void add_contours(const std::vector<Contour>& areas, std::vector<Stroke>& strokes);
  [[nodiscard]] bool is_on_border(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;

  Eigen::AlignedBox2d stock_;
  StrokeOptions options_;
  Eigen::Vector2d here_ = Eigen::Vector2d::Zero();
  ContourOffset offset_;
};

}  // namespace sim::wall
