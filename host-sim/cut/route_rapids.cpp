#include "host-sim/cut/route_rapids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "host-sim/cut/cut_name.hpp"
#include "host-sim/cut/rapid_router.hpp"
#include "host-sim/cut/rapid_way.hpp"
#include "host-sim/cut/share_lines.hpp"

namespace sim::cut {
namespace {

using SharedArea = std::shared_ptr<const LoopArea>;

/// Distance within which two points count as one, mm, because of rounding in the drawing.
constexpr double kJoined = 1.0e-3;

bool frees(const Cut& cut) {
  return std::ranges::none_of(cut.strokes,
                              [](const Stroke& stroke) { return stroke.purpose == Purpose::kTab; });
}

/// Returns the area that each cut frees; null if a cut frees none. The area of a hole extends to
/// the edge of the part, half a kerf beyond the cut. The area of a part ends at the path of the
/// beam.
std::vector<SharedArea> freed_by(const CutPlan& plan) {
  const std::vector<Cut>& cuts = plan.cuts;
  std::vector<SharedArea> areas(cuts.size());
  const std::vector<SharedLoop> closed = loops_closed_by(cuts);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    if (!frees(cuts[i]) || is_engraved(plan.plan_of(cuts[i]).settings.side)) continue;
    std::vector<Stroke> loop = closed[i] ? *closed[i] : loop_of_cut(cuts[i]);
    const bool is_waste = cuts[i].area_mm2 < 0.0;
    const double skin = is_waste ? 0.5 * plan.plan_of(cuts[i]).condition.kerf_mm : 0.0;
    if (length_of(loop) > kJoined) {
      areas[i] = std::make_shared<LoopArea>(std::move(loop), skin);
    }
  }
  return areas;
}

/// Returns a cell size, mm, with which most areas are in few cells.
double cell_for(const std::vector<SharedArea>& areas) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const SharedArea& area : areas) {
    if (!area) continue;
    const LoopArea::Box& box = area->box();
    sum += std::sqrt((box.x1 - box.x0) * (box.y1 - box.y0));
    ++count;
  }
  return count == 0 ? 1.0 : std::max(sum / static_cast<double>(count), 0.1);
}

double widest_half_kerf(const CutPlan& plan) {
  double widest = 0.0;
  for (const Cut& cut : plan.cuts) {
    widest = std::max(widest, 0.5 * plan.plan_of(cut).condition.kerf_mm);
  }
  return widest;
}

Place lowest_of(const std::vector<Cut>& cuts) {
  Place lowest{0.0, 0.0};
  for (const Cut& cut : cuts) {
    for (const Stroke& stroke : cut.strokes) lowest = lowest.cwiseMin(stroke.to);
  }
  return lowest;
}

/// Returns, for each cut, the numbers of the cuts whose areas become free after it. Usually this is
/// only the cut itself. The area of a closed cut on its line is held until the last cut that begins
/// inside it.
std::vector<std::vector<std::uint32_t>> releases(const CutPlan& plan,
                                                 const std::vector<SharedArea>& areas,
                                                 double cell_mm) {
  const std::vector<Cut>& cuts = plan.cuts;
  std::vector<std::size_t> free_after(cuts.size());
  FreedAreas on_line{cell_mm};
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const Place& start = cuts[i].start();
    on_line.visit_near(box_between(start, start), [&](std::uint32_t number, const LoopArea& area) {
      if (area.contains(start) && area.distance_to_loop(start) > kJoined) free_after[number] = i;
      return false;
    });
    free_after[i] = i;
    const bool is_on_line = plan.plan_of(cuts[i]).settings.side == Side::kOn;
    if (areas[i] && is_on_line) on_line.add(static_cast<std::uint32_t>(i), areas[i]);
  }
  std::vector<std::vector<std::uint32_t>> released(cuts.size());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    if (areas[i]) released[free_after[i]].push_back(static_cast<std::uint32_t>(i));
  }
  return released;
}

/// Returns a closed row in which arcs replace the corner loops that were left out. The arcs are
/// tangential to both adjacent edges.
std::vector<Stroke> with_corners_closed(const std::vector<Stroke>& row) {
  std::vector<Stroke> closed;
  for (std::size_t i = 0; i < row.size(); ++i) {
    closed.push_back(row[i]);
    const Stroke& next = row[i + 1 < row.size() ? i + 1 : 0];
    if (drawing::distance(row[i].to, next.from) < kJoined) continue;
    const Place arriving = tangent_at(row[i], 1.0);
    const Place leaving = tangent_at(next, 0.0);
    const double turn =
        std::atan2(drawing::cross(arriving, leaving), drawing::dot(arriving, leaving));
    closed.push_back({row[i].to, next.from, std::tan(0.25 * turn)});
  }
  return closed;
}

/// Routes one rapid after the other around the areas that are free at the time of the rapid.
class Routing {
 public:
  Routing(CutPlan& plan, const drawing::Drawing& drawn, const AvoidanceRules& rules)
      : plan_{plan},
        drawn_{drawn},
        lift_mm_{rules.lift_mm},
        areas_{freed_by(plan)},
        released_{releases(plan, areas_, cell_for(areas_))},
        freed_{cell_for(areas_)},
        router_{freed_,
                {.clearance_mm = widest_half_kerf(plan) + rules.margin_mm,
                 .depth_mm = std::clamp(0.25 * widest_half_kerf(plan), 1.0e-4, 0.01),
                 .lowest = lowest_of(plan.cuts)}} {}

  void run() {
    for (std::size_t i = 0; i <= plan_.cuts.size(); ++i) {
      if (i != 0) {
        for (const std::uint32_t number : released_[i - 1]) freed_.add(number, areas_[number]);
      }
      route(i);
      if (i != 0) {
        for (const std::uint32_t number : released_[i - 1]) drop_inside(number);
      }
    }
  }

 private:
  void route(std::size_t i) {
    const bool is_last = i == plan_.cuts.size();
    std::vector<Place>& corners = is_last ? plan_.way_home : plan_.cuts[i].approach;
    double& lift = is_last ? plan_.lift_home_mm : plan_.cuts[i].lift_mm;
    corners.clear();
    lift = 0.0;
    const std::vector<Place> straight = rapid_before(plan_, i);
    if (drawing::distance(straight.front(), straight.back()) < kJoined) return;
    const auto just_cut = i == 0 ? std::nullopt : just_freed(released_[i - 1], straight.front());
    const std::vector<Place> way = router_.find(straight.front(), straight.back(), just_cut);
    if (way.empty()) return lift_or_tell(i, lift);
    corners.assign(way.begin() + 1, way.end() - 1);
    if (corners.empty()) return;
    ++plan_.safety.led_round;
    double length = -drawing::distance(way.front(), way.back());
    for (std::size_t k = 1; k < way.size(); ++k) {
      length += drawing::distance(way[k - 1], way[k]);
    }
    plan_.safety.longer_mm += length;
  }

  /// Returns the area that the last cut freed. If it freed several, returns the largest one that
  /// contains the beam. If none contains the beam, returns the first one.
  [[nodiscard]] std::optional<std::uint32_t> just_freed(const std::vector<std::uint32_t>& released,
                                                        const Place& beam) const {
    std::optional<std::uint32_t> found;
    double largest_mm = 0.0;
    for (const std::uint32_t number : released) {
      const LoopArea& area = *areas_[number];
      const double width_mm = area.box().x1 - area.box().x0;
      const bool is_around = area.contains(beam) && area.distance_to_loop(beam) > kJoined;
      if (found && (!is_around || width_mm < largest_mm)) continue;
      found = number;
      largest_mm = is_around ? width_mm : 0.0;
    }
    return found;
  }

  void lift_or_tell(std::size_t i, double& lift) {
    if (lift_mm_ > 0.0) {
      lift = lift_mm_;
      ++plan_.safety.lifted;
      return;
    }
    ++plan_.safety.no_way;
    const bool is_last = i == plan_.cuts.size();
    const Cut& named = plan_.cuts[is_last ? i - 1 : i];
    const auto name = [this](std::size_t cut) {
      return fmt::format("cut {}, {}", cut + 1, entity_of(plan_.cuts[cut], drawn_).name);
    };
    plan_.faults.push_back(
        {drawing::FaultKind::kCrossing,
         entity_of(named, drawn_),
         is_last ? beam_end(named) : rapid_end(named),
         fmt::format("no rapid leads here from {} to {} around the freed areas",
                     i == 0 ? std::string{"zero"} : name(i - 1),
                     is_last ? std::string{"zero"} : name(i)),
         "lift the head with --lift, hold the parts with tabs, or leave out --avoid-freed"});
  }

  /// Removes freed areas that are inside another freed area, because a rapid that avoids the outer
  /// area avoids them, too.
  void drop_inside(std::uint32_t number) {
    const LoopArea& outer = *areas_[number];
    std::vector<std::uint32_t> inside;
    freed_.visit_near(outer.box(), [&](std::uint32_t other, const LoopArea& area) {
      const Place& place = area.strokes().front().from;
      if (other != number && outer.contains(place) && outer.distance_to_loop(place) > kJoined) {
        inside.push_back(other);
      }
      return false;
    });
    for (const std::uint32_t other : inside) freed_.remove(other);
  }

  CutPlan& plan_;
  const drawing::Drawing& drawn_;
  double lift_mm_;
  std::vector<SharedArea> areas_;
  /// For each cut, the numbers of the areas that become free after it.
  std::vector<std::vector<std::uint32_t>> released_;
  FreedAreas freed_;
  RapidRouter router_;
};

}  // namespace

std::vector<Stroke> loop_of_cut(const Cut& cut) {
  std::vector<Stroke> loop;
  bool has_loops = false;
  for (const Stroke& stroke : cut.strokes) {
    const bool is_edge = stroke.purpose == Purpose::kContour || stroke.purpose == Purpose::kTab;
    if (is_edge) loop.push_back(stroke);
    has_loops = has_loops || stroke.purpose == Purpose::kCornerLoop;
  }
  const auto is_closed = [&loop] {
    return !loop.empty() && drawing::distance(loop.front().from, loop.back().to) < kJoined;
  };
  // Without a lead, the pierce is the first piece of the edge.
  const Stroke& first = cut.strokes.front();
  if (!is_closed() && first.purpose == Purpose::kPierce) loop.insert(loop.begin(), first);
  if (has_loops) loop = with_corners_closed(loop);
  return is_closed() ? loop : std::vector<Stroke>{};
}

void route_rapids(CutPlan& plan, const drawing::Drawing& drawn, const AvoidanceRules& rules) {
  plan.safety.avoids_freed = true;
  Routing{plan, drawn, rules}.run();
}

}  // namespace sim::cut
