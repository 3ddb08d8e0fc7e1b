#include "host-sim/stock/carver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "tests/support/trials.hpp"

namespace sim::stock {
namespace {

/// Returns the height of the tool's lower surface as in a drawing, widened by `more_mm` to all
/// sides.
double surface_of(const Cutter& cutter, double distance, double more_mm) {
  const double radius = 0.5 * cutter.diameter_mm;
  if (distance > radius + more_mm) return std::numeric_limits<double>::infinity();
  const double r = std::clamp(distance - more_mm, 0.0, radius);
  double height = 0.0;
  if (cutter.kind == CutterKind::kBall) {
    height = radius - std::sqrt(radius * radius - r * r);
  } else if (cutter.kind == CutterKind::kBull) {
    const double corner = cutter.corner_radius_mm;
    const double out = std::max(0.0, r - (radius - corner));
    height = corner - std::sqrt(std::max(0.0, corner * corner - out * out));
  } else if (cutter.kind == CutterKind::kV) {
    const double half_angle = 0.5 * cutter.included_angle_deg * std::numbers::pi / 180.0;
    height = std::max(0.0, r - 0.5 * cutter.tip_diameter_mm) / std::tan(half_angle);
  }
  return height - more_mm;
}

/// A job as a dense sequence of poses of its tool.
struct DenseJob {
  Cutter cutter;
  StockBox box;
  double cell_mm = 0.0;
  std::vector<Stretch> stretches;
  std::vector<Pose> poses;
  double farthest_mm = 0.0;  ///< Greatest distance from any point of the path to the nearest pose,
                             ///< mm.

  /// Returns a bound of the height over a point: a lower bound if `below`, else an upper bound.
  [[nodiscard]] double height(double x, double y, bool below) const {
    double least = box.top;
    for (const Pose& pose : poses) {
      const double distance = std::hypot(x - pose.x_mm, y - pose.y_mm);
      least = std::min(least, pose.z_mm + surface_of(cutter, distance, below ? farthest_mm : 0.0));
    }
    return std::max(least, box.bottom);
  }
};

class RandomJob {
 public:
  explicit RandomJob(std::uint64_t seed) : random_{seed} {}

  DenseJob made() {
    DenseJob job;
    job.cutter = cutter();
    const double x = between(-50.0, 50.0);
    const double y = between(-50.0, 50.0);
    job.box = {x, y, x + between(3.0, 9.0), y + between(3.0, 7.0), 0.0, 0.0};
    job.box.top = between(-20.0, 20.0);
    job.box.bottom = job.box.top - std::round(between(2'000.0, 6'000.0)) / 1'000.0;
    job.cell_mm = between(0.08, 0.4);
    Pose at = pose_near(job.box);
    for (int i = 0; i < 4; ++i) {
      if (chance(0.2)) at = pose_near(job.box);
      const Stretch stretch = stretch_from(at, job.box);
      add_poses(stretch, job);
      job.stretches.push_back(stretch);
      at = stretch.to;
    }
    return job;
  }

  double between(double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(random_);
  }

 private:
  bool chance(double share) { return between(0.0, 1.0) < share; }

  Cutter cutter() {
    Cutter cutter;
    cutter.kind = static_cast<CutterKind>(std::uniform_int_distribution<int>{0, 3}(random_));
    cutter.diameter_mm = chance(0.1) ? between(0.1, 0.5) : between(0.5, 5.0);
    cutter.corner_radius_mm = between(0.02, 0.5) * cutter.diameter_mm;
    cutter.included_angle_deg = between(10.0, 170.0);
    cutter.tip_diameter_mm = chance(0.5) ? 0.0 : between(0.0, 0.6) * cutter.diameter_mm;
    return cutter;
  }

  Pose pose_near(const StockBox& box) {
    return {between(box.x_min - 1.0, box.x_max + 1.0),
            between(box.y_min - 1.0, box.y_max + 1.0),
            between(box.bottom - 1.0, box.top + 1.0)};
  }

  Stretch stretch_from(const Pose& from, const StockBox& box) {
    Pose to = pose_near(box);
    if (chance(0.3)) to.z_mm = from.z_mm;
    if (chance(0.2)) to.x_mm = from.x_mm;
    if (chance(0.2)) to.y_mm = from.y_mm;
    if (chance(0.3)) {
      const double part = between(0.0, 0.2);
      to = {std::lerp(from.x_mm, to.x_mm, part),
            std::lerp(from.y_mm, to.y_mm, part),
            std::lerp(from.z_mm, to.z_mm, part)};
    }
    if (chance(0.15)) to = {from.x_mm, from.y_mm, to.z_mm};
    Stretch stretch{from, to};
    if (chance(0.5)) stretch.side_slack_mm = between(0.0, 0.1);
    if (chance(0.3)) stretch.up_slack_mm = between(0.0, 0.1);
    return stretch;
  }

  /// The tool oscillates within the slack.
  void add_poses(const Stretch& stretch, DenseJob& job) {
    constexpr int kPoses = 300;
    const double phase = between(0.0, 6.0);
    const double waves = between(0.0, 6.0);
    Pose before{};
    for (int i = 0; i <= kPoses; ++i) {
      const double part = i / static_cast<double>(kPoses);
      const double angle = phase + waves * part;
      const double side = stretch.side_slack_mm * std::sin(1.7 * angle);
      const Pose pose{std::lerp(stretch.from.x_mm, stretch.to.x_mm, part) + side * std::cos(phase),
                      std::lerp(stretch.from.y_mm, stretch.to.y_mm, part) + side * std::sin(phase),
                      std::lerp(stretch.from.z_mm, stretch.to.z_mm, part) +
                          stretch.up_slack_mm * std::cos(angle)};
      if (i > 0) {
        job.farthest_mm = std::max(
            job.farthest_mm,
            std::hypot(pose.x_mm - before.x_mm, pose.y_mm - before.y_mm, pose.z_mm - before.z_mm));
      }
      job.poses.push_back(pose);
      before = pose;
    }
  }

  std::mt19937_64 random_;
};

TEST(Carver, BoundsTheTrueHeightAtEveryPointOfEachCell) {
  for (const std::uint64_t seed : proof::Trials{800}) {
    RandomJob random{seed};
    const DenseJob job = random.made();
    ASSERT_EQ(fault_of(job.cutter), "");
    Stock stock{job.box, job.cell_mm};
    Carver carver{stock, job.cutter};
    for (const Stretch& stretch : job.stretches) carver.sweep(stretch);
    for (int row = 0; row < stock.rows(); ++row) {
      for (int column = 0; column < stock.columns(); ++column) {
        const Cell cell = stock.cell(column, row);
        ASSERT_LE(cell.lower_nm, cell.upper_nm);
        // For the upper bound, corners are the hardest points.
        const bool at_corner = (row + column) % 3 == 0;
        const double x =
            job.box.x_min +
            stock.cell_x_mm() * (column + (at_corner ? 1.0 : random.between(0.0, 1.0)));
        const double y = job.box.y_min +
                         stock.cell_y_mm() * (row + (at_corner ? 1.0 : random.between(0.0, 1.0)));
        const double above = job.box.top + cell.upper_nm / kNmPerMm;
        const double below = job.box.top + cell.lower_nm / kNmPerMm;
        ASSERT_LE(below, job.height(x, y, false) + 1.0e-9)
            << "seed " << seed << " at " << x << ' ' << y;
        ASSERT_GE(above, job.height(x, y, true) - 1.0e-9)
            << "seed " << seed << " at " << x << ' ' << y;
      }
    }
  }
}

/// Returns the volume that dense poses remove, by the heights at the centres of the cells.
double removed_by_poses(const DenseJob& job, const Stock& stock) {
  double sum = 0.0;
  for (int row = 0; row < stock.rows(); ++row) {
    for (int column = 0; column < stock.columns(); ++column) {
      const double x = job.box.x_min + stock.cell_x_mm() * (column + 0.5);
      const double y = job.box.y_min + stock.cell_y_mm() * (row + 0.5);
      sum += job.box.top - job.height(x, y, false);
    }
  }
  return sum * stock.cell_x_mm() * stock.cell_y_mm();
}

// Bounds that are far apart would be valid, too, but useless.
TEST(Carver, BoundsThatAreNear) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    RandomJob random{seed};
    DenseJob job = random.made();
    job.cell_mm = 0.05;
    for (Stretch& stretch : job.stretches) stretch.side_slack_mm = stretch.up_slack_mm = 0.0;
    Stock stock{job.box, job.cell_mm};
    Carver carver{stock, job.cutter};
    double way = 0.0;
    for (const Stretch& stretch : job.stretches) {
      carver.sweep(stretch);
      way += std::hypot(stretch.to.x_mm - stretch.from.x_mm, stretch.to.y_mm - stretch.from.y_mm);
    }
    // There are two walls along each stretch and around its ends, a cell or two wide; floors may be
    // steep.
    const double height = job.box.top - job.box.bottom;
    const double walls = 4.0 * (2.0 * way + 12.0 * job.cutter.diameter_mm);
    EXPECT_LE(stock.removed().max_mm3 - stock.removed().min_mm3, walls * height * job.cell_mm)
        << "seed " << seed;
  }
}

TEST(Carver, CountsWhatASweepSurelyRemoves) {
  for (const std::uint64_t seed : proof::Trials{100}) {
    RandomJob random{seed};
    const DenseJob job = random.made();
    Stock stock{job.box, job.cell_mm};
    Carver carver{stock, job.cutter};
    double sure = 0.0;
    for (const Stretch& stretch : job.stretches) sure += carver.sweep(stretch);
    EXPECT_LE(sure, stock.removed().min_mm3 + 1.0e-9) << "seed " << seed;
    // Centres represent complete cells here, which is exact enough to detect a wrong sum.
    const double removed = removed_by_poses(job, stock);
    EXPECT_LE(sure, 1.02 * removed + 0.05) << "seed " << seed;
  }
}

}  // namespace
}  // namespace sim::stock
