#include "host-sim/surface/path/rough_areas.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/surface/path/loop_order.hpp"

namespace sim::surface {
namespace {

/// Returns whether any point of the border or the rows of `lower` is inside `upper`, or outside
/// `upper` by at most `near_mm`.
bool meets(const RoughArea& lower, const pocket::OwnedArea& upper, double near_mm) {
  const auto is_in = [&](const auto& vertex) { return upper->depth(vertex.point()) >= -near_mm; };
  return std::ranges::any_of(lower.locus.vertices, is_in) ||
         std::ranges::any_of(lower.rows.points, is_in);
}

/// Returns the start of each row of an area.
std::vector<Eigen::Vector2d> starts_of(const RoughArea& area) {
  std::vector<Eigen::Vector2d> starts;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : area.rows.row_ends) {
    starts.emplace_back(area.rows.points[begin].point());
    begin = end;
  }
  return starts;
}

}  // namespace

RoughOrder::RoughOrder(std::vector<RoughArea>& areas, const RoughStock& stock, double near_mm)
    : areas_{&areas}, lower_(areas.size()) {
  for (RoughArea& area : areas) area.stock_mm.assign(area.rows.row_ends.size(), stock.top_mm);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const pocket::OwnedArea upper{areas[i].locus.view()};
    for (std::size_t k = i + 1; k < areas.size() && areas[k].level <= areas[i].level + 1; ++k) {
      if (areas[k].level == areas[i].level || !meets(areas[k], upper, near_mm)) continue;
      lower_[i].push_back(k);
      const std::vector<Eigen::Vector2d> starts = starts_of(areas[k]);
      for (std::size_t row = 0; row < starts.size(); ++row) {
        if (upper->depth(starts[row]) < -near_mm) continue;
        areas[k].stock_mm[row] = std::min(stock.top_mm, areas[i].tip_mm + stock.cusp_mm);
      }
    }
  }
}

std::vector<std::size_t> RoughOrder::order() const {
  std::vector<LevelLoop> loops;
  for (const RoughArea& area : *areas_) {
    loops.push_back({.level = area.level,
                     .level_mm = area.tip_mm,
                     .places = starts_of(area),
                     .is_closed = true});
  }
  std::vector<std::size_t> taken;
  if (loops.empty()) return taken;
  LoopOrder order{loops, lower_};
  Eigen::Vector2d here = loops.front().places.front();
  while (const auto next = order.take_next(here)) {
    taken.push_back(*next);
    here = (*areas_)[*next].rows.points.back().point();
  }
  return taken;
}

}  // namespace sim::surface
