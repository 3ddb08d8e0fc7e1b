#include "host-sim/pocket/owned_area.hpp"

#include <stdexcept>

namespace sim::pocket {
namespace {

cnc::pocket::DistanceSizes sizes_of(const cnc::contour::ContourView<double>& area) {
  return {area.vertices.size(), area.loop_ends.size()};
}

}  // namespace

OwnedArea::OwnedArea(const cnc::contour::ContourView<double>& area)
    : vertices_(sizes_of(area).elements()),
      elements_(sizes_of(area).elements()),
      boxes_(sizes_of(area).boxes()),
      loop_ends_(sizes_of(area).loops),
      distance_{{{vertices_.data(), vertices_.size()},
                 {elements_.data(), elements_.size()},
                 {boxes_.data(), boxes_.size()},
                 {loop_ends_.data(), loop_ends_.size()}}} {
  if (!distance_.read(area)) {
    throw std::invalid_argument{
        "a coordinate or a bulge of the pocket is not finite; correct the drawing"};
  }
}

}  // namespace sim::pocket
