#include "host-sim/wall/layer/layer_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "host-sim/wall/layer/falling_shadow.hpp"
#include "host-sim/wall/least_tilt.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector3d;

/// Height above a floor, mm, up to which a point of the part counts as on the floor.
constexpr double kFloorMm = 0.5 * kTouchMm;

}  // namespace

LayerRegions::LayerRegions(const surface::Mesh& part, const LayerOptions& options)
    : options_{options} {
  double bottom = std::numeric_limits<double>::infinity();
  top_mm_ = -bottom;
  for (const Vector3d& point : part.points) {
    stock_.extend(point.head<2>());
    bottom = std::min(bottom, point.z());
    top_mm_ = std::max(top_mm_, point.z());
  }
  stock_.min().array() -= options.margin_mm;
  stock_.max().array() += options.margin_mm;
  top_mm_ += options.above_mm;
  const double deepest = top_mm_ - bottom;
  const double depth = options.depth_mm > 0.0 ? std::min(options.depth_mm, deepest) : deepest;
  const double layers = std::floor((depth + kFloorMm) / options.layer_mm);
  if (layers > static_cast<double>(kMaxLayers)) {
    throw std::invalid_argument(
        fmt::format("--layer: {:g} mm are {:.0f} layers in {:g} mm, more than {}; give a thicker "
                    "layer or a --depth",
                    options.layer_mm,
                    layers,
                    depth,
                    kMaxLayers));
  }
  count_ = static_cast<std::size_t>(layers);
  shadow_ = std::make_unique<FallingShadow>(part, stock_);
}

LayerRegions::~LayerRegions() = default;

Layer LayerRegions::next() {
  ++done_;
  const double height = top_mm_ - options_.layer_mm * static_cast<double>(done_);
  return {.height_mm = height, .areas = shadow_->lower_to(height + kFloorMm)};
}

Undercut LayerRegions::undercut() const { return shadow_->undercut(); }

}  // namespace sim::wall
