#include "host-sim/pocket/crescent_driver.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "host-sim/pocket/axis_entry.hpp"
#include "host-sim/pocket/disc_spiral.hpp"
#include "host-sim/pocket/round_return.hpp"
#include "host-sim/pocket/slot_pass.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::Crescent;
using cnc::pocket::ToolCircle;
using cnc::pocket::Use;

constexpr double kDegree = std::numbers::pi / 180.0;
/// Least radius of a circle that gets a crescent, mm. In corners that are not too sharp, only thin
/// stock is left before the tip at this radius.
constexpr double kMinCircleMm = 4.0e-5;
/// Greatest thickness of the stock that crescents leave before a corner, mm, measured between their
/// disc and the disc in the corner. The pass along the wall removes this stock.
constexpr double kThinStockMm = 5.0e-4;
/// Least progress along a course, mm. A smaller step counts as none.
constexpr double kMinProgressMm = 1.0e-7;
/// Greatest length of a narrow dead end that is a corner, not a slot, in tool radii.
constexpr double kCornerLength = 3.0;
/// Greatest length of a narrow corner divided by the radius of its widest circle. In a longer
/// corner, the angle between the walls is less than about 4 degrees. Such a corner is left to the
/// pass along the wall: it would require hundreds of crescents for each halving of its width.
constexpr double kCornerSharpness = 30.0;

/// Returns the radius of circles below which a pocket is narrow, mm.
double narrow_circle(double tool_radius_mm) { return (kNarrowDiameters - 1.0) * tool_radius_mm; }

/// Returns the thickness of the stock between a circle and the circle at the end of its course, mm.
double stock_beyond(const AxisCourse& course, double from, const ToolCircle& circle) {
  return course.length() - from + course.circle_at(course.length()).radius - circle.radius;
}

}  // namespace

CrescentDriver::CrescentDriver(const OwnedArea& area,
                               const AdaptiveOptions& options,
                               AdaptivePath& out)
    : area_{area},
      options_{options},
      limits_{options.tool_radius_mm, options.engagement_deg * kDegree, kMinCircleMm},
      out_{out},
      writer_{out, options.depth_mm} {}

CourseDrive CrescentDriver::drive(const AxisCourse& course,
                                  const ToolCircle& start,
                                  bool is_dead_end) {
  CourseDrive done;
  ToolCircle circle = start;
  double s = 0.0;
  while (s < course.length()) {
    if (is_free(circle)) {
      s = end_of_free(course, s, done);
      circle = course.circle_at(s);
      if (s >= course.length()) break;
    }
    const double slot_end = end_of_slot(course, s, circle, is_dead_end);
    double next = slot_end;
    if (slot_end > s) {
      if (!drive_slot(course, s, slot_end, done)) break;
    } else {
      if (is_dead_end && is_left_to_wall(course, s, circle)) break;
      next = next_crescent(course, s, circle, limits_);
      if (next < s + kMinProgressMm) break;
      if (is_free(course.circle_at(next))) {
        // The next crescent begins on the disc at `next`. The tool does not move there: it stays up
        // until it descends for this crescent.
        done.way_back.push_back(course.circle_at(next));
        take_free_disc(course.circle_at(next));
      } else {
        drive_crescent(circle, course.circle_at(next), done);
      }
    }
    s = next;
    circle = course.circle_at(s);
  }
  done.is_complete = s >= course.length();
  if (is_dead_end && !done.is_complete) list_tip(course, s);
  std::ranges::reverse(done.way_back);
  return done;
}

/// Returns whether the pass along the wall must cut the rest of a dead end after `circle`. It must
/// if only thin stock is left, or if the dead end is a corner that is too sharp for crescents.
bool CrescentDriver::is_left_to_wall(const AxisCourse& course,
                                     double from,
                                     const ToolCircle& circle) const {
  if (stock_beyond(course, from, circle) <= kThinStockMm) return true;
  const bool is_narrow = circle.radius < narrow_circle(limits_.tool_radius_mm);
  return is_narrow && course.length() - from > kCornerSharpness * circle.radius;
}

/// Adds the tip of a dead end, from `from` on, to the narrow stretches if its stock is thicker than
/// kThinStockMm. Where the tip is sharp, the pass along the wall cuts it as a slot.
void CrescentDriver::list_tip(const AxisCourse& course, double from) {
  const ToolCircle begin = course.circle_at(from);
  const ToolCircle end = course.circle_at(course.length());
  const double left_mm = course.length() - from;
  if (stock_beyond(course, from, begin) <= kThinStockMm) return;
  if (begin.radius >= narrow_circle(limits_.tool_radius_mm)) return;
  NarrowStretch tip{{begin.centre}, 2.0 * (end.radius + limits_.tool_radius_mm), left_mm};
  std::ranges::copy(course.places_between(from, course.length()), std::back_inserter(tip.places));
  tip.places.push_back(end.centre);
  out_.narrow.push_back(tip);
}

/// Returns the length along the course up to which the discs from `from` on are free of stock. On
/// this part, the tool stays up.
double CrescentDriver::end_of_free(const AxisCourse& course, double from, CourseDrive& done) {
  const double step = 0.05 * limits_.tool_radius_mm;
  double end = from;
  while (end < course.length()) {
    const double next = std::min(end + step, course.length());
    if (!is_free(course.circle_at(next))) break;
    end = next;
    done.way_back.push_back(course.circle_at(end));
  }
  if (end > from) take_free_disc(course.circle_at(end));
  return end;
}

/// Returns the end of the narrow stretch that begins at `from`, or `from` if no narrow stretch
/// begins there.
double CrescentDriver::end_of_slot(const AxisCourse& course,
                                   double from,
                                   const ToolCircle& circle,
                                   bool is_dead_end) const {
  const double narrow = narrow_circle(limits_.tool_radius_mm);
  if (circle.radius >= narrow) return from;
  const double step = 0.05 * limits_.tool_radius_mm;
  double low = from;
  double high = from;
  do {
    low = high;
    high = std::min(low + step, course.length());
  } while (high < course.length() && course.circle_at(high).radius < narrow);
  if (course.circle_at(high).radius < narrow) {
    const bool is_corner = course.length() - from <= kCornerLength * limits_.tool_radius_mm;
    return is_dead_end && is_corner ? from : course.length();
  }
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (course.circle_at(middle).radius < narrow ? low : high) = middle;
  }
  return high;
}

/// Drives along the axis and clears the disc at the end. Returns false if the slot is curved and as
/// wide as the tool, because then no line fits into it.
bool CrescentDriver::drive_slot(const AxisCourse& course,
                                double from,
                                double to,
                                CourseDrive& done) {
  const double radius = limits_.tool_radius_mm;
  const ToolCircle begin = course.circle_at(from);
  const ToolCircle end = course.circle_at(to);
  std::vector<WideVec2> places{begin.centre};
  std::ranges::copy(course.places_between(from, to), std::back_inserter(places));
  places.push_back(end.centre);
  const std::vector<WideVec2> way =
      fitting_way(places, *area_, radius, std::numeric_limits<double>::infinity());
  if (way.size() < 2) return false;
  if (is_up_) come_down(begin);
  go_back_round(writer_,
                begin,
                {begin.centre, (way[1] - way[0]).normalized()},
                std::min(kTurnOfTool * radius, kTurnOfCircle * begin.radius));
  pass_lines(writer_, way, *area_, radius);
  NarrowStretch stretch{way, 2.0 * (begin.radius + radius), way_length(way)};
  for (const WideVec2& place : way) {
    const double depth_mm = area_->depth(place);
    done.way_back.push_back({place, std::max(0.0, depth_mm - radius)});
    stretch.width_mm = std::min(stretch.width_mm, 2.0 * depth_mm);
  }
  out_.narrow.push_back(stretch);
  if ((way.back() - end.centre).norm() > kSamePlaceMm) return false;
  if (end.radius >= kMinCircleMm) pass_disc(writer_, end);
  circles_.push_back(end);
  return true;
}

void CrescentDriver::drive_crescent(const ToolCircle& from,
                                    const ToolCircle& to,
                                    CourseDrive& done) {
  const Crescent crescent = crescent_between(from, to);
  if (is_up_) come_down(from);
  if (crescent.exists) {
    const WideVec2 outwards = (crescent.begin - to.centre) / to.radius;
    go_back_round(writer_,
                  from,
                  {crescent.begin, cnc::left_normal(outwards)},
                  std::min({kTurnOfTool * limits_.tool_radius_mm,
                            kTurnOfCircle * from.radius,
                            kTurnOfCircle * to.radius}));
    writer_.light_pass(crescent.middle, crescent.bulge);
    writer_.light_pass(crescent.end, crescent.bulge);
  } else {
    // The disc is cleared already. Its centre is in both circles.
    writer_.go_back(to.centre);
  }
  done.way_back.push_back(to);
  circles_.push_back(to);
}

void CrescentDriver::drive_back(const std::vector<ToolCircle>& way) {
  go_through_round(writer_, way, kTurnOfTool * limits_.tool_radius_mm);
}

void CrescentDriver::take_free_disc(const ToolCircle& circle) {
  circles_.push_back(circle);
  is_up_ = true;
}

/// Tolerates the skin of the stock: a disc that just touches a wall of a part reaches into the
/// skin. A disc that reaches farther is not free.
bool CrescentDriver::is_free(const ToolCircle& circle) const {
  constexpr double kSkins = 1.5;
  if (!options_.stock) return false;
  const double reach_mm = circle.radius + limits_.tool_radius_mm;
  return gap_to(*options_.stock, circle.centre) >= reach_mm - kSkins * kStockSkinMm;
}

void CrescentDriver::come_down(const ToolCircle& circle) {
  writer_.begin_row_in_cleared(circle.centre);
  is_up_ = false;
}

void CrescentDriver::open_disc(const ToolCircle& circle, const std::vector<WideVec2>& way) {
  enter_stock(circle, way, options_, writer_);
  open_by_spiral(circle, limits_, writer_);
  circles_.push_back(circle);
  // The entire part is hardly wider than the tool.
  if (circle.radius < narrow_circle(limits_.tool_radius_mm)) {
    out_.narrow.push_back({{circle.centre}, 2.0 * (circle.radius + limits_.tool_radius_mm), 0.0});
  }
}

}  // namespace sim::pocket
