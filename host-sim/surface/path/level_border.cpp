#include "host-sim/surface/path/level_border.hpp"

#include <algorithm>
#include <limits>

namespace sim::surface {

LevelBorder::LevelBorder(const pocket::StockBox& box,
                         const std::vector<Contour>& drawn,
                         double inset_mm)
    : box_{box}, inset_mm_{inset_mm} {
  for (const Contour& area : drawn) {
    if (area.loop_ends.empty()) continue;
    drawn_.push_back(std::make_unique<const pocket::OwnedArea>(area.view()));
  }
}

double LevelBorder::beyond(const Eigen::Vector2d& place) const {
  const double depth = std::min(
      {place.x() - box_.x0, box_.x1 - place.x(), place.y() - box_.y0, box_.y1 - place.y()});
  if (drawn_.empty()) return inset_mm_ - depth;
  double drawn = -std::numeric_limits<double>::infinity();
  for (const auto& area : drawn_) drawn = std::max(drawn, (*area)->depth(place));
  return inset_mm_ - std::min(depth, drawn);
}

}  // namespace sim::surface
