#include "host-sim/surface/path/region/sampled_region.hpp"

#include <algorithm>
#include <cmath>

namespace sim::surface {
namespace {

/// Returns the gaps between parts from `begin` to `end`.
SliceParts gaps_of(const SliceParts& parts, double begin, double end) {
  SliceParts gaps;
  double from = begin;
  for (const auto& [part_begin, part_end] : parts) {
    if (part_begin > from) gaps.emplace_back(from, part_begin);
    from = std::max(from, part_end);
  }
  if (from < end) gaps.emplace_back(from, end);
  return gaps;
}

}  // namespace

/// Finds the parts of one slice in which the condition holds.
class SampledRegion::Sampler {
 public:
  Sampler(const SampledRegion& region, const Slice& slice) : region_{region}, slice_{slice} {}

  /// Samples a gap, extended by `more_mm` at both ends, and adds the parts in which the condition
  /// holds. These parts are extended by `more_mm` at both ends, too.
  void add_parts(const std::pair<double, double>& gap, double more_mm, SliceParts& parts) {
    const double from = gap.first - more_mm;
    const double length = gap.second + more_mm - from;
    const auto samples = std::max(1, static_cast<int>(std::ceil(length / region_.overlap_mm_)));
    double before = from;
    double begin = from;
    bool was_in = false;
    for (int i = 0; i <= samples; ++i) {
      const double along = from + length * i / samples;
      const bool is_in = holds(along);
      if (is_in && !was_in) begin = i == 0 ? along : border(along, before);
      if (!is_in && was_in) parts.emplace_back(begin - more_mm, border(before, along) + more_mm);
      was_in = is_in;
      before = along;
    }
    if (was_in) parts.emplace_back(begin - more_mm, before + more_mm);
  }

 private:
  [[nodiscard]] bool holds(double along) { return region_.holds(slice_.at(along), memory_); }

  [[nodiscard]] double border(double inside, double outside) {
    constexpr double kNear = 1.0e-6;
    while (std::abs(outside - inside) > kNear) {
      const double middle = 0.5 * (inside + outside);
      (holds(middle) ? inside : outside) = middle;
    }
    return inside;
  }

  const SampledRegion& region_;
  Slice slice_;
  std::size_t memory_ = 0;
};

SliceParts SampledRegion::parts_of(const Slice& slice, double begin, double end) const {
  const Eigen::Vector2d across{-slice.direction.y(), slice.direction.x()};
  SliceParts parts;
  for (const double share : {0.0, 0.5, -0.5, 1.0, -1.0}) {
    const double beside = share * overlap_mm_;
    const double more = overlap_mm_ * std::sqrt(1.0 - share * share);
    const Slice shifted{slice.from + beside * across, slice.direction, slice.length};
    Sampler sampler{*this, shifted};
    for (const auto& gap : gaps_of(parts, begin, end)) sampler.add_parts(gap, more, parts);
    join_parts(parts, 0.0);
  }
  join_parts(parts, 2.0 * overlap_mm_);
  for (auto& [part_begin, part_end] : parts) {
    part_begin = std::max(part_begin, begin);
    part_end = std::min(part_end, end);
  }
  std::erase_if(parts, [](const auto& part) { return part.second <= part.first; });
  return parts;
}

}  // namespace sim::surface
