#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/mesh.hpp"

namespace sim::wall {

class FallingShadow;
struct Undercut;

/// The stock that a part is cut from, and the layers by which it is. Lengths are mm.
struct LayerOptions {
  double layer_mm = 0.0;   ///< Depth of a layer, above 0.
  double margin_mm = 0.0;  ///< By which the stock is larger than the part to all sides.
  double above_mm = 0.0;   ///< By which the stock is higher than the part.
  double depth_mm = 0.0;   ///< From the top of the stock; 0: as deep as the part.
};

/// The areas that are removed down to one height.
struct Layer {
  double height_mm = 0.0;      ///< Height of the layer's floor, where the beam's tip is.
  std::vector<Contour> areas;  ///< Connected areas, material to remove on the left of their loops.
};

/// The layers of a stock around a part, from the top down.
///
/// A layer is the rectangle of the stock without the part at that height, and without all of the
/// part above it: material below an overhang stays. Heights up to half a micrometre above a floor
/// count as on it. Places are on a grid of a nanometre, on a coarser one for parts above 1 m.
class LayerRegions {
 public:
  /// Throws std::invalid_argument for more than kMostLayers. @param part must outlive this
  LayerRegions(const surface::Mesh& part, const LayerOptions& options);
  LayerRegions(const LayerRegions&) = delete;
  LayerRegions& operator=(const LayerRegions&) = delete;
  ~LayerRegions();

  static constexpr std::size_t kMostLayers = 100'000;

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const Eigen::AlignedBox2d& stock() const { return stock_; }
  [[nodiscard]] double top_mm() const { return top_mm_; }

  /// Returns the next layer, whose areas may be none. @pre fewer than count() were returned
  [[nodiscard]] Layer next();

  /// Returns how much the layers so far leave below overhangs.
  [[nodiscard]] Undercut undercut() const;

 private:
  LayerOptions options_;
  Eigen::AlignedBox2d stock_;
  double top_mm_ = 0.0;
  std::size_t count_ = 0;
  std::size_t done_ = 0;
  std::unique_ptr<FallingShadow> shadow_;
};

}  // namespace sim::wall
