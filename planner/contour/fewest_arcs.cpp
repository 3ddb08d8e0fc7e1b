#include "planner/contour/fewest_arcs.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::contour {
namespace {

/// Returns `v`, turned to the left by about `by` radians. The exact angle is twice the arc tangent
/// of half of `by`.
WideVec2 turned_about(const WideVec2& v, double by) {
  const double t = 0.5 * by;
  const double scale = 1.0 / (1.0 + t * t);
  return scale * ((1.0 - t * t) * v + (2.0 * t) * left_normal(v));
}

constexpr double kAnyValue = -1.0e30;

}  // namespace

int FewestArcs::variants(std::size_t index) const {
  return index == 0 && options_->start == FitEnd::kFree ? 9 : 1;
}

FewestArcs::Launches FewestArcs::launches(std::size_t index) const {
  constexpr int kTrials = 24;
  constexpr int kSteps = 28;
  if (index > 0) {
    const FitLink& before = links_[index - 1];
    return {.index = index, .range = {before.start.sample, before.reach, kTrials, kSteps}};
  }
  if (options_->start == FitEnd::kTangent) return {.range = {0.0, 0.0, 2, 0}};
  return {.range = {-1.0, 1.0, 2 * kTrials + 1, kSteps}};
}

BandStart FewestArcs::launch(const Launches& from, double at) const {
  if (from.index > 0) {
    return band_->start_on(links_[from.index - 1].circle(), std::min(at, band_->last() - 1.0e-6));
  }
  const WayPoint& start = band_->sample(0).point;
  if (options_->start == FitEnd::kTangent) return {start.place, start.tangent, 0.0};
  // Greatest angle between the first arc and the curve's tangent, radians. The cube below makes the
  // search denser near the tangent.
  constexpr double kWidest = 0.8;
  const double across = options_->start == FitEnd::kFree
                            ? 0.25 * static_cast<double>(from.variant - 4) * 0.999999
                            : 0.0;
  return {start.place + across * band_->tolerance_mm() * left_normal(start.tangent),
          turned_about(start.tangent, kWidest * at * at * at),
          0.0};
}

template <typename Function>
void FewestArcs::for_best(std::size_t index,
                          double enough,
                          const Function& function,
                          LeastValue& best,
                          int& variant) const {
  Launches from = launches(index);
  for (int i = 0; i < variants(index) && best.value > enough; ++i) {
    from.variant = i;
    const LeastValue found =
        least_value(from.range, enough, [&](double at) { return function(launch(from, at)); });
    if (found.value >= best.value) continue;
    best = found;
    variant = i;
  }
}

bool FewestArcs::extend(std::size_t index) {
  LeastValue best{.value = 1.0};
  int variant = 0;
  const auto shortfall = [&](const BandStart& start) { return -band_->farthest(start).sample; };
  for_best(index, -band_->last(), shortfall, best, variant);
  if (best.value > 0.0) return false;
  Launches from = launches(index);
  from.variant = variant;
  const BandStart start = launch(from, best.at);
  const BandReach reach = band_->farthest(start);
  links_[index] = {.start = start, .curvature = reach.curvature, .reach = reach.sample};
  constexpr double kProgress = 1.0e-3;
  const double before = index > 0 ? links_[index - 1].reach : 0.0;
  return reach.sample > before + kProgress;
}

double FewestArcs::next_reach(std::size_t index) const {
  constexpr int kTrials = 6;
  const Launches next = launches(index + 1);
  double reach = 0.0;
  for (int i = 0; i < kTrials; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kTrials - 1);
    const double at = next.range.high - share * share * (next.range.high - next.range.low);
    reach = std::max(reach, band_->farthest(launch(next, at)).sample);
  }
  return reach;
}

/// Replaces an arc after which no arc can continue. Where the curve turns sharply, within a length
/// of a few tolerances, the arc with the greatest reach may end in a direction from which no other
/// arc continues. An arc that stops earlier, in the middle of the allowed curvatures, may have a
/// successor. Tries a grid of such arcs and takes the arc whose successor has the greatest reach.
bool FewestArcs::give_way(std::size_t index) {
  constexpr int kStops = 24;
  const FitLink stuck = links_[index];
  FitLink best = stuck;
  double farthest = stuck.reach + 1.0e-3;
  Launches from = launches(index);
  const double stride =
      (from.range.high - from.range.low) / static_cast<double>(from.range.looks - 1);
  for (int variant = 0; variant < variants(index); ++variant) {
    from.variant = variant;
    for (int look = 0; look < from.range.looks; ++look) {
      const BandStart start = launch(from, from.range.low + stride * static_cast<double>(look));
      for (int i = 1; i <= kStops; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(kStops);
        const BandReach reach =
            band_->farthest(start, start.sample + share * (stuck.reach - start.sample));
        links_[index] = {.start = start, .curvature = reach.curvature, .reach = reach.sample};
        const double next = reach.sample > start.sample ? next_reach(index) : 0.0;
        if (next <= farthest) continue;
        farthest = next;
        best = links_[index];
      }
    }
  }
  links_[index] = best;
  return farthest > stuck.reach + 1.0e-3;
}

std::size_t FewestArcs::run() {
  std::size_t count = 0;
  do {
    if (count + 2 > links_.size()) {
      out_of_room_ = true;
      return 0;
    }
    const double before = count > 0 ? links_[count - 1].reach : 0.0;
    if (!extend(count)) {
      if (count == 0 || !give_way(count - 1) || !extend(count)) return 0;
      if (links_[count].reach <= before) return 0;
    }
    ++count;
  } while (links_[count - 1].reach < band_->last());
  if (options_->end == FitEnd::kFree) return count;
  const std::size_t last_ones = options_->end == FitEnd::kTangent ? 2 : 1;
  for (std::size_t kept = count > last_ones ? count - last_ones : 0; kept <= count; ++kept) {
    if (kept + last_ones > links_.size()) break;
    const std::size_t whole = finish(kept);
    if (whole > 0) return whole;
  }
  return 0;
}

std::size_t FewestArcs::finish(std::size_t index) {
  return options_->end == FitEnd::kTangent ? finish_with_tangent(index) : finish_at_place(index);
}

double FewestArcs::arc_to_end(const BandStart& start, double* curvature) const {
  const WideVec2 q =
      band_->sample(static_cast<std::size_t>(band_->last())).point.place - start.place;
  const double square = q.squaredNorm();
  if (!(square > 0.0 && q.dot(start.tangent) > 0.0)) return ToleranceBand::kNoFit;
  *curvature = 2.0 * cross(start.tangent, q) / square;
  return band_->deviation(start.circle(*curvature), start.sample, band_->last() + 1.0);
}

std::size_t FewestArcs::finish_at_place(std::size_t index) {
  LeastValue best{};
  int variant = 0;
  double curvature = 0.0;
  const auto deviation = [&](const BandStart& start) { return arc_to_end(start, &curvature); };
  for_best(index, kAnyValue, deviation, best, variant);
  if (best.value > band_->tolerance_mm()) return 0;
  Launches from = launches(index);
  from.variant = variant;
  const BandStart start = launch(from, best.at);
  (void)arc_to_end(start, &curvature);
  links_[index] = {.start = start, .curvature = curvature, .reach = band_->last()};
  return index + 1;
}

/// Returns the greatest deviation of the samples after `from` from the biarc, mm; any value above
/// `bound` if the deviation exceeds `bound`.
/// @param worst number of the sample that is checked first; set to the sample with the greatest
///     deviation found
double FewestArcs::deviation(const BiarcGauge& gauge,
                             double from,
                             double bound,
                             std::size_t& worst) const {
  const auto at = [&](std::size_t i) {
    const WayPoint& point = band_->sample(i).point;
    return ToleranceBand::distance(gauge.beside(point.place), point);
  };
  const auto first = static_cast<std::size_t>(from) + 1;
  const auto last = static_cast<std::size_t>(band_->last());
  const double enough = std::min(bound, 100.0 * band_->tolerance_mm());
  // The biarcs of one search have their greatest deviation at about the same sample, so that sample
  // is checked first.
  if (bound == enough && worst >= first && worst < last) {
    const double found = at(worst);
    if (found > bound) return found;
  }
  double greatest = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    const double found = at(i);
    if (!(found > greatest)) continue;
    greatest = found;
    worst = i;
    if (greatest > enough) break;
  }
  return greatest;
}

LeastValue FewestArcs::biarc_to_end(const BandStart& start) const {
  const WayPoint& end = band_->sample(static_cast<std::size_t>(band_->last())).point;
  const WideBiarcEnds ends{start.place, start.tangent, end.place, end.tangent};
  constexpr SearchRange kShares{.low = 0.02, .high = 0.98, .looks = 9, .steps = 14};
  std::size_t worst = 0;
  return least_value(kShares, kAnyValue, [&](double share, double bound) {
    const auto biarc = make_biarc(ends, share);
    if (!biarc.ok()) return ToleranceBand::kNoFit;
    return deviation(BiarcGauge{ends, biarc.value()}, start.sample, bound, worst);
  });
}

std::size_t FewestArcs::finish_with_tangent(std::size_t index) {
  LeastValue best{};
  int variant = 0;
  const auto deviation = [&](const BandStart& start) { return biarc_to_end(start).value; };
  for_best(index, 0.98 * band_->tolerance_mm(), deviation, best, variant);
  if (best.value > band_->tolerance_mm()) return 0;
  Launches from = launches(index);
  from.variant = variant;
  const BandStart start = launch(from, best.at);
  append_biarc(index, start, biarc_to_end(start).at);
  return index + 2;
}

void FewestArcs::append_biarc(std::size_t index, const BandStart& start, double share) {
  const auto last = static_cast<std::size_t>(band_->last());
  const WayPoint& end = band_->sample(last).point;
  const WideBiarcEnds ends{start.place, start.tangent, end.place, end.tangent};
  const WideBiarc biarc = make_biarc(ends, share).value();
  const BiarcGauge gauge{ends, biarc};
  const auto ahead = [&](std::size_t i) {
    return (band_->sample(i).point.place - biarc.joint).dot(biarc.joint_tangent);
  };
  std::size_t i = static_cast<std::size_t>(start.sample) + 1;
  while (i < last && ahead(i) < 0.0) ++i;
  const double after = ahead(i);
  const double before = ahead(i - 1);
  const double part = after > before ? after / (after - before) : 0.0;
  const double sample = std::max(start.sample, static_cast<double>(i) - std::clamp(part, 0.0, 1.0));
  links_[index] = {.start = start, .curvature = gauge.first().curvature, .reach = sample};
  links_[index + 1] = {.start = {biarc.joint, biarc.joint_tangent, sample},
                       .curvature = gauge.second().curvature,
                       .reach = band_->last()};
}

}  // namespace cnc::contour
