#include "planner/pocket/pocket_path.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "tests/planner/pocket/path_bench.hpp"
#include "tests/support/trials.hpp"

namespace cnc::pocket {
namespace {

/// Results of the check of a path.
struct PathVerdict {
  std::string complaint;  ///< Empty if the path is correct.
  std::size_t kinks = 0;  ///< Number of joints of passes away from the wall at which the tangents
                          ///< differ.
};

/// Checks a path with its own computation of distances and angles.
class PathCheck {
 public:
  PathCheck(PocketBench& pocket,
            const ToolPathView<double>& path,
            const PocketOptions<double>& options)
      : pocket_{pocket}, path_{path}, options_{options}, radius_{options.clearing.tool_radius} {
    wall_.add(pocket.pocket());
    for (std::size_t i = 0; i < pocket.passes().size(); ++i) {
      const bool at_wall = pocket.passes().note(i).parent == contour::kNone;
      if (at_wall) locus_.add(pocket.passes().loops(i));
    }
  }

  PathVerdict run(proof::Random& random, int points) {
    for_each_element(path_, [this](const auto& from, const auto& to) { check_element(from, to); });
    for (std::size_t row = 0; row < path_.row_ends.size(); ++row) check_row(row);
    check_stock(random, points);
    return verdict_;
  }

 private:
  void complain(const std::string& text) {
    if (verdict_.complaint.empty()) verdict_.complaint = text;
  }

  void check_element(const PathPoint<double>& from, const PathPoint<double>& to) {
    if (std::abs(from.bulge) > 1.0 + 1.0e-9) complain("more than half a turn");
    const double length = flat_length(from, to);
    const double drop = from.z - to.z;
    const double slope = options_.entry.slope;
    if (from.use == Use::kPass && drop != 0.0) complain("a pass that changes its depth");
    if (drop < -1.0e-12 || to.z < -options_.depth - 1.0e-12) complain("a way up, or too deep");
    if (from.use == Use::kEntry && options_.entry.kind != EntryKind::kPlunge &&
        drop > slope * length * (1.0 + 1.0e-9) + 1.0e-12) {
      complain("too steep");
    }
    if (length == 0.0) return;
    const contour::exact::PlainArc arc{arc_of(from, to)};
    for (const double share : {0.0, 0.13, 0.37, 0.5, 0.71, 0.93}) {
      const WideVec2 place = arc.at(share);
      if (wall_.distance(place) < radius_ - 1.0e-7) complain("gouges the wall");
    }
    if (!wall_.encloses(arc.at(0.4))) complain("is outside of the pocket");
  }

  void check_row(std::size_t row) {
    const std::uint32_t first = path_.row_begin(row);
    const std::uint32_t end = path_.row_ends[row];
    if (end - first < 2) return complain("an empty row");
    for (std::uint32_t i = first; i + 2 < end; ++i) {
      const auto& a = path_.points[i];
      const auto& b = path_.points[i + 1];
      const auto& c = path_.points[i + 2];
      const bool is_short = flat_length(a, b) < 1.0e-4 || flat_length(b, c) < 1.0e-4;
      if (is_short || kink_between(a, b, c) < 0.01) continue;
      // Corners are allowed only at the wall.
      if (locus_.distance(b.point()) > 1.0e-6) ++verdict_.kinks;
    }
  }

  void check_stock(proof::Random& random, int points) {
    const double level = options_.depth / std::ceil(options_.depth / options_.depth_step - 1.0e-6);
    for (double z = -level; z > -options_.depth - 0.5 * level; z -= level) {
      PocketOracle oracle = oracle_with_locus();
      for_each_element(path_, [&](const auto& from, const auto& to) {
        if (std::abs(from.z - z) < 1.0e-9 && from.z == to.z)
          oracle.add_pass_element(arc_of(from, to));
      });
      const double far = oracle.farthest(random, points);
      if (far > radius_ + 1.0e-6) {
        complain("leaves " + std::to_string(far - radius_) + " mm at " + std::to_string(z));
      }
    }
  }

  [[nodiscard]] PocketOracle oracle_with_locus() {
    PocketOracle oracle{pocket_.pocket(), {}, radius_};
    for (std::size_t i = 0; i < pocket_.passes().size(); ++i) {
      if (pocket_.passes().note(i).parent == contour::kNone) {
        oracle.add_locus(pocket_.passes().loops(i));
      }
    }
    return oracle;
  }

  PocketBench& pocket_;
  ToolPathView<double> path_;
  PocketOptions<double> options_;
  double radius_;
  PlainContour wall_;
  PlainContour locus_;
  PathVerdict verdict_;
};

double length_at_depth(const ToolPathView<double>& path) {
  double sum = 0.0;
  for_each_element(path, [&](const auto& from, const auto& to) {
    if (from.use != Use::kEntry) sum += flat_length(from, to);
  });
  return sum;
}

TEST(PocketPath, OfThePapersPocketIsOneRowOfEightPassesAndSevenLinks) {
  PocketBench pocket;
  PathBench bench{pocket.paper()};
  auto options = usual_options(5.0);
  options.depth = 2.0;
  options.depth_step = 2.0;
  const auto report = bench.write(options);
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report.value().passes, 8U);
  EXPECT_EQ(report.value().links, 7U);
  EXPECT_EQ(report.value().rows, 1U);
  proof::Random random{1};
  const PathVerdict verdict = PathCheck{pocket, bench.path(), options}.run(random, 5000);
  EXPECT_EQ(verdict.complaint, "");
  EXPECT_EQ(verdict.kinks, 0U);
  std::printf("%.1f mm with links\n", length_at_depth(bench.path()));
  EXPECT_LT(length_at_depth(bench.path()), 1.05 * 2146.0);
}

TEST(PocketPath, HasEqualLevels) {
  PocketBench pocket;
  PathBench bench{pocket.paper()};
  auto options = usual_options(5.0);
  options.depth = 10.0;
  options.depth_step = 4.0;
  const auto report = bench.write(options);
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report.value().levels, 3U);
  EXPECT_EQ(report.value().rows, 3U);
  for (std::size_t row = 0; row < 3; ++row) {
    const auto above = static_cast<double>(row);
    const auto& path = bench.path();
    EXPECT_NEAR(path.points[path.row_begin(row)].z, -10.0 / 3.0 * above, 1.0e-12);
    EXPECT_NEAR(path.points[path.row_ends[row] - 1].z, -10.0 / 3.0 * (above + 1.0), 1.0e-12);
  }
  options.depth_step = 5.0;
  EXPECT_EQ(bench.write(options).value().levels, 2U);
}

// In climb milling the pocket is on the left of the path; in conventional milling it is on the
// right.
TEST(PocketPath, ConventionalMillingRunsTheOtherWay) {
  for (const Milling milling : {Milling::kClimb, Milling::kConventional}) {
    PocketBench pocket;
    PathBench bench{pocket.rectangle(0, 0, 60, 60)};
    auto options = usual_options(5.0);
    options.milling = milling;
    ASSERT_TRUE(bench.write(options).ok());
    double twice_area = 0.0;
    for_each_element(bench.path(), [&](const auto& from, const auto& to) {
      twice_area += cross(from.point(), to.point());
    });
    EXPECT_EQ(twice_area > 0.0, milling == Milling::kClimb);
    proof::Random random{1};
    EXPECT_EQ(PathCheck(pocket, bench.path(), options).run(random, 500).complaint, "");
  }
}

TEST(PocketPath, RampsAndPlungesWhereAsked) {
  for (const EntryKind kind : {EntryKind::kRamp, EntryKind::kPlunge, EntryKind::kHelix}) {
    PocketBench pocket;
    PathBench bench{pocket.rectangle(0, 0, 60, 40)};
    auto options = usual_options(5.0);
    options.entry.kind = kind;
    ASSERT_TRUE(bench.write(options).ok());
    proof::Random random{1};
    EXPECT_EQ(PathCheck(pocket, bench.path(), options).run(random, 500).complaint, "");
    const auto& first = bench.path().points[0];
    const auto& second = bench.path().points[1];
    EXPECT_EQ(first.use, Use::kEntry);
    EXPECT_EQ(std::abs(first.bulge) == 1.0, kind == EntryKind::kHelix);
    EXPECT_EQ(first.point() == second.point(), kind == EntryKind::kPlunge);
  }
}

TEST(PocketPath, ReportsWhatItCannotDo) {
  PocketBench pocket;
  PathBench bench{pocket.rectangle(0, 0, 60, 40)};
  auto options = usual_options(5.0);
  options.depth = 0.0;
  EXPECT_EQ(bench.write(options).error().fault, PocketFault::kOptionOutOfRange);
  options = usual_options(5.0);
  options.entry.slope = 0.0;
  EXPECT_EQ(bench.write(options).error().fault, PocketFault::kOptionOutOfRange);
  options = usual_options(25.0);
  EXPECT_EQ(bench.write(options).error().fault, PocketFault::kToolTooLarge);
  options = usual_options(5.0);
  options.clearing.stepover = -1.0;
  EXPECT_EQ(bench.write(options).error().fault, PocketFault::kClearing);
}

TEST(PocketPath, OfRandomPocketsClearsEveryLevelWithoutAGouge) {
  std::size_t rows = 0;
  std::size_t links = 0;
  for (const std::uint64_t seed : proof::Trials{100}) {
    proof::Random random{seed};
    PocketBench pocket;
    const double radius = add_random_pocket(pocket, random);
    PathBench bench{pocket};
    auto options = usual_options(radius);
    if (random.chance(0.5)) options.milling = Milling::kConventional;
    if (random.chance(0.3)) options.entry.kind = EntryKind::kRamp;
    if (random.chance(0.3)) options.clearing.stepover = random.between(0.5, 2.0) * radius;
    const auto report = bench.write(options);
    if (!report.ok()) {
      const bool is_small = report.error().fault == PocketFault::kToolTooLarge ||
                            report.error().fault == PocketFault::kNoEntry;
      EXPECT_TRUE(is_small) << static_cast<int>(report.error().fault) << " KERFLINE_SEED=" << seed;
      continue;
    }
    const PathVerdict verdict = PathCheck{pocket, bench.path(), options}.run(random, 100);
    EXPECT_EQ(verdict.complaint, "") << "KERFLINE_SEED=" << seed;
    EXPECT_EQ(verdict.kinks, 0U) << "KERFLINE_SEED=" << seed;
    rows += report.value().rows;
    links += report.value().links;
  }
  std::printf("%zu rows, %zu links\n", rows, links);
}

}  // namespace
}  // namespace cnc::pocket
