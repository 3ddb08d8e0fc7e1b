#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "host-sim/wall/layer/layer_regions.hpp"

namespace sim::wall {

enum class StrokeUse : std::uint8_t {
  kHatch,    ///< Over the area of a layer.
  kContour,  ///< Along its walls.
};

/// A line of the beam's tip at one height, mm: a beam that is on all along.
struct Stroke {
  StrokeUse use = StrokeUse::kHatch;
  std::vector<Eigen::Vector2d> places;  ///< Two at least.
};

/// How the layers are filled.
struct StrokeOptions {
  double hatch_mm = 0.0;   ///< Distance of hatch lines; 0: none.
  double angle_deg = 0.0;  ///< Direction of the first layer's lines from X.
  double turn_deg = 0.0;   ///< By which the lines of each layer turn from those of the one before.
  double waist_mm = 0.0;   ///< Radius of the beam at its tip, by which all stays off the walls.
  bool has_contour = true;
};

/// Lays the strokes of layers, one layer after the other: first the hatch, the nearest part of a
/// line next, then the contours along the walls. The borders of the stock are no walls.
class LayerStrokes {
 public:
  /// @param stock rectangle of the stock
  LayerStrokes(const Eigen::AlignedBox2d& stock, const StrokeOptions& options)
      : stock_{stock}, options_{options} {}

  /// Returns the strokes of a layer in the order in which they are burnt, from where the last layer
  /// ended on.
  /// @param number of the layer, from 0 at the top
  /// Throws NoOffset where the areas cannot be offset.
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
