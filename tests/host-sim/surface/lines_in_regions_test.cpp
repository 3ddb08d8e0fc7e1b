#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "host-sim/surface/path/parallel_path.hpp"
#include "host-sim/surface/path/waterline_path.hpp"
#include "tests/host-sim/surface/path_judge.hpp"
#include "tests/host-sim/surface/random_hills.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A disc, as from a drawing, or its complement.
class Disc final : public MilledRegion {
 public:
  Disc(const Vector2d& middle, double radius, bool is_hole)
      : middle_{middle}, radius_{radius}, is_hole_{is_hole} {}

  /// Returns the distance of a point from the region, if it is outside.
  [[nodiscard]] double outside(const Vector2d& place) const {
    const double beyond = (place - middle_).norm() - radius_;
    return is_hole_ ? -beyond : beyond;
  }
  [[nodiscard]] SliceParts parts_of(const Slice& slice, double begin, double end) const override {
    const double foot = slice.direction.dot(middle_ - slice.from);
    const double beside = (slice.at(foot) - middle_).norm();
    const double half = beside < radius_ ? std::sqrt(radius_ * radius_ - beside * beside) : 0.0;
    SliceParts parts{{std::max(begin, foot - half), std::min(end, foot + half)}};
    if (is_hole_)
      parts = {{begin, std::min(end, foot - half)}, {std::max(begin, foot + half), end}};
    if (is_hole_ && half == 0.0) parts = {{begin, end}};
    std::erase_if(parts, [](const auto& part) { return part.second <= part.first; });
    return parts;
  }
  [[nodiscard]] bool bars_links() const override { return true; }

 private:
  Vector2d middle_;
  double radius_;
  bool is_hole_;
};

/// Length of the motions below `top`, which are those at the surface, and the length within a disc.
struct Lengths {
  double all = 0.0;
  double within = 0.0;
  double farthest_out = -1.0e9;
};

Lengths lengths_of(const SurfacePath& path, const RowOptions& options, const Disc& disc) {
  constexpr double kPitch = 0.02;
  Lengths lengths;
  Vector3d before = Vector3d::Constant(1.0e9);
  for_places(text_of(path, options), kPitch, [&](const Vector3d& tip) {
    const double step = (tip - before).norm();
    before = tip;
    lengths.farthest_out = std::max(lengths.farthest_out, disc.outside(tip.head<2>()));
    if (step > 2.0 * kPitch) return;
    lengths.all += step;
    if (disc.outside(tip.head<2>()) < 0.0) lengths.within += step;
  });
  return lengths;
}

TEST(LinesInRegions, StayInThemAndMillMostOfThem) {
  const proof::Trials trials{30};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Mesh mesh = random_waves(random, 14, 0.8);
    RowOptions options;
    options.tool = {.radius_mm = 1.0, .flat_mm = 0.0, .corner_mm = 1.0};
    options.tolerance_mm = 0.01;
    options.step_mm = random.between(0.3, 0.6);
    const bool is_level = random.chance(0.5);
    const auto made = [&] {
      return is_level ? waterline_path(mesh, options) : parallel_path(mesh, options);
    };
    const Vector2d middle{random.between(3.0, 7.0), random.between(3.0, 7.0)};
    const auto disc = std::make_shared<Disc>(middle, random.between(2.0, 4.0), random.chance(0.4));
    const Lengths whole = lengths_of(made(), options, *disc);
    options.regions = {disc};
    const Lengths cut = lengths_of(made(), options, *disc);
    // Between two points of a line, an arc may leave the region by its height.
    EXPECT_LT(cut.farthest_out, 0.01);
    // Lines end before the border of the region by less than the distance of their points.
    EXPECT_GT(cut.all, 0.75 * whole.within);
    EXPECT_LT(cut.all, 1.1 * whole.within + 1.0);
  }
}

}  // namespace
}  // namespace sim::surface
