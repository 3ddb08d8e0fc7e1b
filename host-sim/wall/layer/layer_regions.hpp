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

/// The stock from which a part is cut, and the layers in which it is cut. Lengths are mm.
struct LayerOptions {
  double layer_mm = 0.0;   ///< Depth of a layer, above 0.
  double margin_mm = 0.0;  ///< Distance by which the stock is larger than the part on all sides.
  double above_mm = 0.0;   ///< Distance by which the stock is higher than the part.
  /// Depth of cutting from the top of the stock; 0: down to the bottom of the part.
  double depth_mm = 0.0;
};

/// The areas from which material is removed down to one height.
struct Layer {
  double height_mm = 0.0;  ///< Height of the layer's floor, where the beam's tip is.
  /// Connected areas. The material to remove is on the left of their loops.
  std::vector<Contour> areas;
};

/// Computes the layers of a stock around a part, from the top down.
///
/// A layer is the rectangle of the stock without the shadow of the part at and above the layer's
/// height. So material below an overhang remains. Heights up to half a micrometre above a floor
/// count as on the floor. Points are on a grid of a nanometre, or on a coarser grid for parts
/// larger than 1 m.
class LayerRegions {
 public:
  /// Throws std::invalid_argument for more than kMaxLayers layers.
  /// @param part must outlive this object
  LayerRegions(const surface::Mesh& part, const LayerOptions& options);
  LayerRegions(const LayerRegions&) = delete;
  LayerRegions& operator=(const LayerRegions&) = delete;
  ~LayerRegions();

  static constexpr std::size_t kMaxLayers = 100'000;

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const Eigen::AlignedBox2d& stock() const { return stock_; }
  [[nodiscard]] double top_mm() const { return top_mm_; }

  /// Returns the next layer. The layer may have no areas.
  /// @pre fewer than count() layers were returned
  [[nodiscard]] Layer next();

  /// Returns the undercut of the layers that next() has returned so far.
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
