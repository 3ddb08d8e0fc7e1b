#include "host-sim/surface/path/loop_leads.hpp"

#include <cmath>
#include <numbers>

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

ContourVertex vertex_at(const Vector2d& place, double bulge = 0.0) {
  return {.x = place.x(), .y = place.y(), .bulge = bulge};
}

}  // namespace

LoopLeads::LoopLeads(const SurfaceTracer& tracer,
                     const PlanGrid& grid,
                     const RowOptions& options,
                     double lift_mm)
    : tracer_{&tracer},
      grid_{&grid},
      left_{options.direction != cnc::pocket::Milling::kConventional ? 1.0 : -1.0},
      lines_only_{options.lines_only},
      lift_mm_{lift_mm},
      regions_{&options.regions} {}

bool LoopLeads::is_free(const Vector2d& place, double level_mm) const {
  if (!grid_->holds(place)) return false;
  const double height = tracer_->touched(place, hint_);
  return height != cnc::surface::kNoContact && height <= level_mm;
}

bool LoopLeads::is_in_regions(const Vector2d& from, const Vector2d& to) const {
  return from == to || lets_link_through(*regions_, slice_between(from, to));
}

std::optional<SurfaceStretch> LoopLeads::lead_in(const LoopEnd& start) const {
  return lead(start, -1.0);
}

std::optional<SurfaceStretch> LoopLeads::lead_out(const LoopEnd& end) const {
  return lead(end, 1.0);
}

std::optional<SurfaceStretch> LoopLeads::lead(const LoopEnd& end, double sense) const {
  constexpr double kRightAngle = 0.5 * std::numbers::pi;
  const Vector2d to_low = left_ * Vector2d{-end.tangent.y(), end.tangent.x()};
  // Points of the lead are checked at an offset of half the band to the low side, because the line
  // may leave the level set by the band.
  const Vector2d beside = 0.5 * tracer_->band_mm() * to_low;
  for (const double share : {0.25, 0.125, 0.0625}) {
    const double radius = share * tracer_->grown_tool().radius_mm;
    const auto place_after = [&](double share_of_way) -> Vector2d {
      const double angle = kRightAngle * share_of_way;
      const double along = lines_only_ ? share_of_way : std::sin(angle);
      const double beyond = lines_only_ ? share_of_way : 1.0 - std::cos(angle);
      return end.place + radius * (sense * along * end.tangent + beyond * to_low);
    };
    const auto looks =
        static_cast<int>(std::ceil(kRightAngle * radius / tracer_->density().pitch_mm)) + 1;
    bool is_clear = true;
    for (int i = 0; i <= looks && is_clear; ++i) {
      const double share_of_way = static_cast<double>(i) / looks;
      is_clear = is_free(place_after(share_of_way) + beside, end.level_mm);
    }
    const Vector2d away = place_after(1.0);
    // The lead is inside the triangle of its two ends and `corner`. So the region check uses the
    // triangle's sides at this corner.
    const Vector2d corner = end.place + sense * radius * end.tangent;
    if (!is_clear || !is_in_regions(end.place, corner) || !is_in_regions(corner, away)) continue;
    const double bulge = lines_only_ ? 0.0 : left_ * std::tan(0.25 * kRightAngle);
    SurfaceStretch stretch{
        .plane = LevelPlane{end.level_mm + lift_mm_}, .use = StretchUse::kLink, .vertices = {}};
    if (sense > 0.0) {
      stretch.vertices = {vertex_at(end.place, bulge), vertex_at(away)};
    } else {
      stretch.vertices = {vertex_at(away, bulge), vertex_at(end.place)};
    }
    return stretch;
  }
  return std::nullopt;
}

std::optional<SurfaceStretch> LoopLeads::way_between(const Vector3d& from,
                                                     const Vector3d& to) const {
  constexpr double kMaxRadii = 1.5;
  constexpr double kMinWay = 1.0e-6;
  const double length = (to - from).head<2>().norm();
  if (length > kMaxRadii * tracer_->grown_tool().radius_mm || to.z() > from.z()) return {};
  if (!is_in_regions(from.head<2>(), to.head<2>())) return {};
  const auto looks = static_cast<int>(std::ceil(length / tracer_->density().pitch_mm)) + 1;
  for (int i = 0; i <= looks; ++i) {
    const Vector3d tip = from + (to - from) * i / looks;
    if (!is_free(tip.head<2>(), tip.z() - lift_mm_)) return {};
  }
  Slice slice{.from = from.head<2>()};
  if (length > kMinWay) slice = slice_between(from.head<2>(), to.head<2>());
  return SurfaceStretch{
      .plane = slice,
      .use = StretchUse::kLink,
      .vertices = {vertex_at({0.0, from.z()}), vertex_at({slice.length, to.z()})}};
}

}  // namespace sim::surface
