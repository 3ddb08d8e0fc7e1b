#include "host-sim/cut/shared_stretch.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/cut/segment_distance.hpp"

namespace sim::cut {
namespace {

/// Least length of a stretch or a gap, mm. Shorter ones are only rounding.
constexpr double kShortest = 1.0e-3;
/// Number of intervals between the points at which the distance of two strokes is measured. Between
/// lines, the distance is greatest at an end. Between arcs, it changes smoothly, with the sine of
/// the angle along the arc.
constexpr int kLooks = 8;

bool runs_back(const Stroke& stroke, const Stroke& other, double share) {
  const double beside = nearest_share(other, place_at(stroke, share));
  return drawing::dot(tangent_at(stroke, share), tangent_at(other, beside)) < 0.0;
}

}  // namespace

std::optional<SharedStretch> shared_stretch(const Stroke& stroke,
                                            const Stroke& other,
                                            double tolerance_mm) {
  if ((stroke.bulge == 0.0) != (other.bulge == 0.0)) return std::nullopt;
  const double length = length_of(stroke);
  const double from = nearest_share(stroke, other.to);
  const double to = nearest_share(stroke, other.from);
  SharedStretch shared{length * from, length * to};
  if (shared.to_mm - shared.from_mm < kShortest) return std::nullopt;
  for (int k = 0; k <= kLooks; ++k) {
    const Place place = place_at(stroke, from + (to - from) * k / kLooks);
    shared.off_mm = std::max(shared.off_mm, distance_to(other, place));
  }
  if (shared.off_mm > tolerance_mm) return std::nullopt;
  if (!runs_back(stroke, other, 0.5 * (from + to))) return std::nullopt;
  return shared;
}

void join_stretches(std::vector<SharedStretch>& stretches) {
  std::ranges::sort(stretches, {}, &SharedStretch::from_mm);
  std::vector<SharedStretch> joined;
  for (const SharedStretch& next : stretches) {
    if (joined.empty() || next.from_mm > joined.back().to_mm + kShortest) {
      joined.push_back(next);
      continue;
    }
    joined.back().to_mm = std::max(joined.back().to_mm, next.to_mm);
    joined.back().off_mm = std::max(joined.back().off_mm, next.off_mm);
  }
  stretches = std::move(joined);
}

std::vector<std::vector<Stroke>> rests_of_open(const MeasuredRow& path,
                                               const std::vector<SharedStretch>& stretches) {
  std::vector<std::vector<Stroke>> rests;
  double from_mm = 0.0;
  const auto keep_to = [&](double to_mm) {
    if (to_mm - from_mm >= kShortest) rests.push_back(path.stretch(from_mm, to_mm));
  };
  for (const SharedStretch& stretch : stretches) {
    keep_to(stretch.from_mm);
    from_mm = stretch.to_mm;
  }
  keep_to(path.length());
  return rests;
}

std::vector<std::vector<Stroke>> rests_between(const MeasuredRow& path,
                                               const std::vector<SharedStretch>& stretches) {
  std::vector<std::vector<Stroke>> rests;
  const auto keep = [&rests](std::vector<Stroke> rest) {
    if (length_of(rest) >= kShortest) rests.push_back(std::move(rest));
  };
  for (std::size_t i = 1; i < stretches.size(); ++i) {
    keep(path.stretch(stretches[i - 1].to_mm, stretches[i].from_mm));
  }
  // The last rest contains the end of the closed path, which is also its start.
  std::vector<Stroke> around = path.stretch(stretches.back().to_mm, path.length());
  const std::vector<Stroke> first = path.stretch(0.0, stretches.front().from_mm);
  around.insert(around.end(), first.begin(), first.end());
  keep(std::move(around));
  return rests;
}

}  // namespace sim::cut
