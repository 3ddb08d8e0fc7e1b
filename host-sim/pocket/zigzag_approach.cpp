#include "host-sim/pocket/zigzag_approach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host-sim/cut/stroke.hpp"
#include "host-sim/pocket/lead_arc.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using Curve = cnc::contour::Curve<double>;

/// Greatest distance between candidate points on the wall, as a share of the tool's radius.
constexpr double kPlaceDistance = 0.25;
/// Candidate radii of arcs to the wall, as shares of the tool's radius, the best first.
constexpr std::array kArcShares{0.25, 0.125};

/// An arc from a point next to the stock to the wall.
struct WallEntry {
  WideVec2 from{0.0, 0.0};
  BoundaryPlace on_wall;
  double bulge = 0.0;
};

/// Searches along the wall for a point that the tool can reach from a point next to the stock.
class WallEntrySearch {
 public:
  /// @param is_backwards whether the search follows the wall with the area on the right
  WallEntrySearch(const OwnedArea& area,
                  const StockBox& stock,
                  double tool_radius_mm,
                  bool is_backwards)
      : area_{area}, stock_{stock}, radius_mm_{tool_radius_mm}, is_backwards_{is_backwards} {}

  /// Returns the last entry before a point, in the direction in which the search follows the wall.
  [[nodiscard]] std::optional<WallEntry> before(const BoundaryPlace& end) const {
    std::uint32_t element = end.element;
    do {
      const Curve& curve = area_->element(element);
      const bool is_first = element == end.element;
      if (auto entry = last_on(element, is_first ? end.place : end_of(curve))) return entry;
      element = is_backwards_ ? area_->next(element) : area_->previous(element);
    } while (element != end.element);
    return std::nullopt;
  }

 private:
  [[nodiscard]] WideVec2 begin_of(const Curve& curve) const {
    return is_backwards_ ? curve.end : curve.start;
  }
  [[nodiscard]] WideVec2 end_of(const Curve& curve) const {
    return is_backwards_ ? curve.start : curve.end;
  }

  /// Returns the last entry on an element before the point `end` of the element.
  [[nodiscard]] std::optional<WallEntry> last_on(std::uint32_t element, const WideVec2& end) const {
    const Curve& curve = area_->element(element);
    const WideVec2 begin = begin_of(curve);
    const double bulge =
        is_backwards_ ? -curve.bulge_between(end, begin) : curve.bulge_between(begin, end);
    const cut::Stroke part{.from = begin, .to = end, .bulge = bulge};
    const double length = cut::length_of(part);
    const double places = std::ceil(length / (kPlaceDistance * radius_mm_));
    for (double i = places - 1.0; i > 0.0; i -= 1.0) {
      const WideVec2 place = cut::place_at(part, i / places);
      if (!is_idle(stock_, place, radius_mm_)) continue;
      if (auto entry = entry_at({element, place})) return entry;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<WallEntry> entry_at(const BoundaryPlace& on_wall) const {
    // Side of the path on which the area is: 1 for left, −1 for right.
    const double side = is_backwards_ ? -1.0 : 1.0;
    const WideVec2 forwards = side * area_->element(on_wall.element).tangent_at(on_wall.place);
    for (const double share : kArcShares) {
      const double radius = share * radius_mm_;
      const WideVec2 centre = on_wall.place + side * radius * cnc::left_normal(forwards);
      const WideVec2 from = centre - radius * forwards;
      constexpr double kRoundingMm = 1.0e-9;
      const bool fits = area_->depth(centre) >= radius - kRoundingMm;
      if (fits && is_beside(stock_, from, radius_mm_)) {
        return WallEntry{from, on_wall, side * kQuarterTurnBulge};
      }
    }
    return std::nullopt;
  }

  const OwnedArea& area_;
  const StockBox& stock_;
  double radius_mm_;
  bool is_backwards_;
};

}  // namespace

std::optional<ZigzagApproach> approach_along_wall(const TurnSpace& space,
                                                  const StockBox& stock,
                                                  double tool_radius_mm,
                                                  const Stretch& line,
                                                  double y_mm,
                                                  Side side) {
  const auto meeting = fillet_at(space, line, y_mm, side, false);
  if (!meeting) return std::nullopt;
  const bool is_backwards = side == Side::kLeft;
  const WallEntrySearch search{space.rounded, stock, tool_radius_mm, is_backwards};
  const auto entry = search.before(meeting->on_wall);
  if (!entry) return std::nullopt;
  const auto along = way_along(space.rounded,
                               entry->on_wall,
                               meeting->on_wall,
                               is_backwards,
                               std::numeric_limits<double>::infinity());
  if (!along) return std::nullopt;
  ZigzagApproach approach{entry->from, {}, meeting->on_line.x()};
  approach.way.push_back({entry->on_wall.place, entry->bulge});
  approach.way.insert(approach.way.end(), along->begin(), along->end());
  approach.way.push_back({meeting->on_line, meeting->bulge});
  const bool has_corners = space.radius_mm > 0.0 &&
                           !is_smooth(space, entry->from, WideVec2{0.0, 0.0}, approach.way, side);
  if (has_corners) return std::nullopt;
  WideVec2 at = approach.from;
  for (const WayElement& element : approach.way) {
    const cut::Stroke stroke{.from = at, .to = element.to, .bulge = element.bulge};
    approach.length_mm += cut::length_of(stroke);
    at = element.to;
  }
  return approach;
}

}  // namespace sim::pocket
