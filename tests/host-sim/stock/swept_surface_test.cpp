#include "host-sim/stock/swept_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "tests/support/trials.hpp"

namespace sim::stock {
namespace {

/// mm: what the rounding of doubles may cost in this range of coordinates.
constexpr double kRounding = 1.0e-9;

/// Random tools and the paths of ramps, helices and plunges: short and long, gentle and steep.
class RandomSweep {
 public:
  explicit RandomSweep(std::uint64_t seed) : random_{seed} {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(random_);
  }
  bool chance(double share) { return between(0.0, 1.0) < share; }

  Cutter cutter() {
    Cutter cutter;
    cutter.kind = static_cast<CutterKind>(std::uniform_int_distribution<int>{0, 3}(random_));
    cutter.diameter_mm = between(0.5, 5.0);
    cutter.corner_radius_mm = between(0.05, 0.5) * cutter.diameter_mm;
    cutter.included_angle_deg = between(20.0, 160.0);
    cutter.tip_diameter_mm = chance(0.5) ? 0.0 : between(0.0, 0.6) * cutter.diameter_mm;
    return cutter;
  }

  Pose next_pose(const Pose& from) {
    const double length = chance(0.1) ? 0.0 : between(0.05, chance(0.5) ? 0.5 : 4.0);
    const double direction = chance(0.2) ? 0.0 : between(-3.2, 3.2);
    const double climb = chance(0.2) ? 0.0 : between(-1.0, 1.0) * (chance(0.5) ? 0.1 : 2.0);
    const double rise = length > 0.0 ? climb * length : climb;
    return {from.x_mm + length * std::cos(direction),
            from.y_mm + length * std::sin(direction),
            from.z_mm + rise};
  }

 private:
  std::mt19937_64 random_;
};

/// A sweep with the plain way to its height: the least over all poses, by thirds, as the height is
/// convex over the poses that reach a point.
struct PlainSweep {
  Profile profile;
  Pose from;
  Pose to;

  [[nodiscard]] Pose pose(double part) const {
    return {std::lerp(from.x_mm, to.x_mm, part),
            std::lerp(from.y_mm, to.y_mm, part),
            std::lerp(from.z_mm, to.z_mm, part)};
  }

  [[nodiscard]] double height_of(double part, double x, double y) const {
    const Pose at = pose(part);
    const double distance = std::hypot(x - at.x_mm, y - at.y_mm);
    if (distance > profile.radius_mm) return SweptSurface::kNowhere;
    return at.z_mm + height_at(profile, distance);
  }

  [[nodiscard]] double height(double x, double y) const {
    const double dx = to.x_mm - from.x_mm;
    const double dy = to.y_mm - from.y_mm;
    const double square = dx * dx + dy * dy;
    if (square == 0.0) return std::min(height_of(0.0, x, y), height_of(1.0, x, y));
    const double foot = ((x - from.x_mm) * dx + (y - from.y_mm) * dy) / square;
    const double off = ((x - from.x_mm) * dy - (y - from.y_mm) * dx) / std::sqrt(square);
    const double reach_squared = profile.radius_mm * profile.radius_mm - off * off;
    if (reach_squared < 0.0) return SweptSurface::kNowhere;
    const double reach = std::sqrt(reach_squared / square);
    double low = std::max(0.0, foot - reach);
    double high = std::min(1.0, foot + reach);
    if (low > high) return SweptSurface::kNowhere;
    double least = std::min(height_of(low, x, y), height_of(high, x, y));
    for (int i = 0; i < 80; ++i) {
      const double a = low + (high - low) / 3.0;
      const double b = high - (high - low) / 3.0;
      const double height_a = height_of(a, x, y);
      const double height_b = height_of(b, x, y);
      least = std::min({least, height_a, height_b});
      (height_a < height_b ? high : low) = height_a < height_b ? b : a;
    }
    return least;
  }
};

struct Case {
  PlainSweep plain;
  SweptSurface surface;
};

Case random_case(RandomSweep& random) {
  const Pose from{random.between(-9.0, 9.0), random.between(-9.0, 9.0), random.between(-3.0, 0.0)};
  const Pose to = random.next_pose(from);
  const double slack = random.chance(0.5) ? 0.0 : random.between(0.0, 0.05);
  const Profile exact = profile_of(random.cutter());
  const Profile profile =
      random.chance(0.5) ? surely_taken(exact, slack, slack) : possibly_taken(exact, slack, slack);
  const double ceiling = random.chance(0.5) ? 1'000.0 : from.z_mm + random.between(0.05, 2.0);
  const SweptSurface surface{profile, from, to, ceiling};
  PlainSweep plain{profile, from, to};
  plain.profile.radius_mm = surface.radius_mm();
  return {plain, surface};
}

/// A point in the plan of a sweep or near it.
Pose point_near(const PlainSweep& plain, RandomSweep& random) {
  const Pose at = plain.pose(random.between(0.0, 1.0));
  const double far = 1.1 * plain.profile.radius_mm;
  return {at.x_mm + random.between(-far, far), at.y_mm + random.between(-far, far), 0.0};
}

TEST(SweptSurface, HeightIsThatOfTheLowestPose) {
  // The table of poses is coarsest at the rim that a ceiling leaves.
  constexpr double kTableMm = 0.1;
  for (const std::uint64_t seed : proof::Trials{1'000}) {
    RandomSweep random{seed};
    const auto [plain, surface] = random_case(random);
    if (surface.is_empty()) continue;
    for (int i = 0; i < 50; ++i) {
      const auto [x, y, unused] = point_near(plain, random);
      const double least = plain.height(x, y);
      const double height = surface.height(x, y);
      ASSERT_GE(height, least - kRounding) << "seed " << seed << " at " << x << ' ' << y;
      if (least > 100.0) continue;
      ASSERT_LE(height, least + kTableMm) << "seed " << seed << " at " << x << ' ' << y;
    }
  }
}

TEST(SweptSurface, LeastOverIsNoGreaterThanAnyHeightInTheRectangle) {
  for (const std::uint64_t seed : proof::Trials{1'000}) {
    RandomSweep random{seed};
    const auto [plain, surface] = random_case(random);
    if (surface.is_empty()) continue;
    const double half_x = random.between(0.01, 0.2);
    const double half_y = random.between(0.01, 0.2);
    for (int i = 0; i < 50; ++i) {
      const auto [x, y, unused] = point_near(plain, random);
      const double enough = random.between(-4.0, 2.0);
      const double greatest = surface.least_over(x, y, half_x, half_y, SweptSurface::kNowhere);
      const double bound = surface.least_over(x, y, half_x, half_y, enough);
      ASSERT_LE(bound, greatest) << "seed " << seed;
      ASSERT_GE(bound, std::min(enough, greatest)) << "seed " << seed;
      for (int j = 0; j < 12; ++j) {
        const bool at_corner = j < 4;
        const double across = at_corner ? (j % 2 == 0 ? -1.0 : 1.0) : random.between(-1.0, 1.0);
        const double up = at_corner ? (j < 2 ? -1.0 : 1.0) : random.between(-1.0, 1.0);
        ASSERT_LE(greatest, plain.height(x + across * half_x, y + up * half_y) + kRounding)
            << "seed " << seed << " round " << x << ' ' << y;
      }
    }
  }
}

}  // namespace
}  // namespace sim::stock
