#include "host-sim/cut/own_costs.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/cut/controller_clock.hpp"
#include "host-sim/cut/job_clock.hpp"
#include "host-sim/cut/leg_cost.hpp"

namespace sim::cut {
namespace {

/// Greatest number of strokes that are compared for all cuts together, and greatest number of
/// motions that are planned. Work up to these limits takes some seconds.
constexpr std::size_t kStrokes = 1'000'000;
constexpr std::size_t kMotions = 200'000;
/// Greatest number of motions that are planned under a limit of jerk. It is smaller, because each
/// of these motions is planned for several windows.
constexpr std::size_t kMotionsUnderJerk = 20'000;
/// Distance within which two beginnings count as the same, mm.
constexpr double kSamePlace = 1.0e-6;

bool has_jerk(const cnc::order::RapidLimits& limits) {
  return limits.jerk_mm_s3[0] > 0.0 || limits.jerk_mm_s3[1] > 0.0;
}

bool are_equal(const std::array<double, 2>& limits) { return limits[0] == limits[1]; }

bool beam_is_on(const Stroke& stroke) { return has_beam(stroke.purpose); }

std::int64_t millionths(double value) { return std::llround(1.0e6 * value); }

/// Returns the angle from one direction to another, radians, −π…π.
double turn_angle(const Place& from, const Place& to) {
  return std::atan2(drawing::cross(from, to), drawing::dot(from, to));
}

/// Combines numbers to one number of 64 bits (FNV-1a over whole words).
class Digest {
 public:
  void add(std::int64_t number) {
    constexpr std::uint64_t kPrime = 1'099'511'628'211U;
    value_ = (value_ ^ static_cast<std::uint64_t>(number)) * kPrime;
    value_ ^= value_ >> 29U;
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14'695'981'039'346'656'037U;
};

}  // namespace

OwnCosts::OwnCosts(const OrderWish& machine)
    : machine_{machine},
      is_even_{are_equal(machine.limits.rate_mm_s) &&
               are_equal(machine.limits.acceleration_mm_s2) &&
               are_equal(machine.limits.jerk_mm_s3)},
      strokes_left_{kStrokes},
      motions_left_{has_jerk(machine.limits) ? kMotionsUnderJerk : kMotions} {}

/// Returns a digest of the shapes and settings that determine the time of the strokes. If both axes
/// have the same limits, strokes that are turned by quarter turns have the same digest.
std::uint64_t OwnCosts::digest_of(const std::vector<Stroke>& strokes,
                                  const LayerPlan& layer) const {
  constexpr std::int64_t kQuarterTurn = 1'570'796;
  Digest digest;
  const std::int64_t angle = millionths(turn_angle({1.0, 0.0}, tangent_at(strokes.front(), 0.0)));
  digest.add(is_even_ ? (angle + 4 * kQuarterTurn) % kQuarterTurn : angle);
  Place before = tangent_at(strokes.front(), 0.0);
  for (const Stroke& stroke : strokes) {
    digest.add(millionths(turn_angle(before, tangent_at(stroke, 0.0))));
    digest.add(millionths(length_of(stroke)));
    digest.add(millionths(std::atan(stroke.bulge)));
    digest.add(millionths(feed_of(stroke, layer)));
    digest.add(millionths(stroke.dwell_s));
    digest.add(beam_is_on(stroke) ? 1 : 0);
    before = tangent_at(stroke, 1.0);
  }
  return digest.value();
}

/// Returns the time of the strokes, s. A rapid that arrives from the side comes first. So the cut
/// begins at rest, and the planner knows the whole cut when it begins.
double OwnCosts::time_of(const std::vector<Stroke>& strokes, const LayerPlan& layer) {
  constexpr double kRapidMm = 100.0;
  const Place& entry = strokes.front().from;
  const Place aside = entry + kRapidMm * right_of(tangent_at(strokes.front(), 0.0));
  OrderWish machine = machine_;
  machine.from = aside;
  ControllerClock clock{machine};
  clock.move({aside, entry}, 0.0, false);
  for (const Stroke& stroke : strokes) {
    if (stroke.dwell_s > 0.0) clock.rest();
    clock.move(stroke, feed_of(stroke, layer), beam_is_on(stroke));
  }
  const std::vector<double> times = clock.finish();
  double seconds = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i) seconds += times[i];
  return seconds;
}

void OwnCosts::find(UnbegunCut& cut, const LayerPlan& layer, const StrokesOf& strokes_of) {
  if (cut.beginnings.size() < 2) return;
  const std::size_t about = cut.beginnings.size() * (cut.path.strokes().size() + 2);
  if (strokes_left_ < about) return;
  strokes_left_ -= about;
  std::vector<double> times;
  for (const Beginning& beginning : cut.beginnings) {
    const std::vector<Stroke> strokes = strokes_of(beginning);
    const auto [known, is_new] = known_s_.try_emplace(digest_of(strokes, layer), 0.0);
    if (is_new) {
      if (motions_left_ < strokes.size()) {
        known_s_.erase(known);
        return;
      }
      motions_left_ -= strokes.size();
      known->second = time_of(strokes, layer);
    }
    times.push_back(known->second);
  }
  const double least = *std::ranges::min_element(times);
  const double mm_per_s = RapidCost{machine_.limits}.mm_per_s();
  for (const double time : times) cut.own_cost.push_back(mm_per_s * (time - least));
}

double own_cost_at(const UnbegunCut& cut, const Beginning& beginning) {
  if (cut.own_cost.empty()) return 0.0;
  const std::size_t stroke = cut.path.stroke_at(beginning.way_mm);
  const double from = cut.path.way_to(stroke) + kSamePlace;
  const double to = cut.path.way_to(stroke + 1) - kSamePlace;
  double nearest = to - from;
  double cost = -1.0;
  for (std::size_t i = 0; i < cut.own_cost.size(); ++i) {
    const Beginning& listed = cut.beginnings[i];
    const double away = std::abs(listed.way_mm - beginning.way_mm);
    if (away < kSamePlace && listed.is_backwards == beginning.is_backwards) return cut.own_cost[i];
    if (listed.way_mm < from || listed.way_mm > to || away >= nearest) continue;
    nearest = away;
    cost = cut.own_cost[i];
  }
  return cost >= 0.0 ? cost : *std::ranges::max_element(cut.own_cost);
}

}  // namespace sim::cut
