#include "host-sim/wall/carve/columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host-sim/surface/read_surface.hpp"
#include "host-sim/wall/carve/carved_mesh.hpp"
#include "host-sim/wall/carve/section.hpp"
#include "host-sim/wall/solid_check.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::wall {
namespace {

constexpr stock::StockBox kBoard{0.0, 0.0, 3.0, 2.0, 1.0, 0.0};

HeightRange random_range(proof::Random& random) {
  const double low = random.between(-0.1, 1.0);
  return {low, low + random.magnitude(0.01, 0.5)};
}

/// Returns the volume that the facets of a closed mesh enclose.
double volume_of(const surface::Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.facets) {
    sum += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c]));
  }
  return sum / 6.0;
}

TEST(Columns, LeaveWhatNoRangeTook) {
  const proof::Trials trials{3000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    Columns columns{kBoard, 1.0};
    std::vector<HeightRange> taken;
    for (std::size_t i = random.below(12); i > 0; --i) {
      taken.push_back(random_range(random));
      columns.remove(1, 1, taken.back());
    }
    double top = 2.0;
    columns.each_range(1, 1, [&top](const HeightRange& range) {
      EXPECT_LT(range.low, range.high);
      EXPECT_LT(range.high, top);
      top = range.low;
    });
    for (int i = 0; i < 100; ++i) {
      const double z = random.between(0.0, 1.0);
      const bool is_taken = std::ranges::any_of(
          taken, [z](const HeightRange& range) { return z > range.low && z < range.high; });
      EXPECT_EQ(columns.has(1, 1, z), !is_taken) << z;
      EXPECT_TRUE(columns.has(0, 1, z));
    }
  }
}

TEST(Columns, AreRefusedWithoutVolumeAndBeyondTheirMemory) {
  EXPECT_EQ(Columns::fault_of(kBoard, 0.001), "");
  EXPECT_NE(Columns::fault_of({0.0, 0.0, 0.0, 1.0, 1.0, 0.0}, 0.1), "");
  EXPECT_NE(Columns::fault_of({0.0, 0.0, 1.0, 1.0, 0.0, 0.0}, 0.1), "");
  EXPECT_NE(Columns::fault_of({0.0, 0.0, 100.0, 1.0, 1.0, 0.0}, 0.001), "");
}

TEST(CarvedMesh, EnclosesWhatIsLeft) {
  const proof::Trials trials{200};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    Columns columns{kBoard, random.between(0.2, 1.0)};
    for (std::size_t i = random.below(60); i > 0; --i) {
      columns.remove(static_cast<int>(random.below(static_cast<std::size_t>(columns.columns()))),
                     static_cast<int>(random.below(static_cast<std::size_t>(columns.rows()))),
                     random_range(random));
    }
    double height = 0.0;
    for (int row = 0; row < columns.rows(); ++row) {
      for (int column = 0; column < columns.columns(); ++column) {
        columns.each_range(
            column, row, [&height](const HeightRange& range) { height += range.high - range.low; });
      }
    }
    const ScratchFile file{random.chance(0.5) ? ".stl" : ".ply"};
    write_carved(file.path(), columns);
    const surface::Mesh mesh = surface::read_surface(file.text(), "carved", {}).mesh;
    EXPECT_NO_THROW(require_solid(mesh, "carved"));
    EXPECT_NEAR(volume_of(mesh), height * columns.cell_x_mm() * columns.cell_y_mm(), 1.0e-5);
  }
}

TEST(Section, HasTheRangesOfTheColumnsBelowIt) {
  Columns columns{kBoard, 1.0};
  columns.remove(1, 0, {0.25, 0.5});
  columns.remove(2, 0, {-1.0, 2.0});
  const std::vector<SectionBar> bars = section_of(columns, {{-1.0, 0.5}, {4.0, 0.5}});
  ASSERT_EQ(bars.size(), 3U);
  EXPECT_DOUBLE_EQ(bars[0].from_mm, 1.0);
  EXPECT_DOUBLE_EQ(bars[0].until_mm, 2.0);
  EXPECT_DOUBLE_EQ(bars[1].until_mm, 3.0);
  EXPECT_EQ(bars[1].range.low, 0.5);
  EXPECT_EQ(bars[2].range.high, 0.25);
}

TEST(Section, CutsTheFacetsThatItPasses) {
  const surface::Mesh mesh{{{0, 0, 0}, {2, 0, 0}, {0, 2, 2}}, {{0, 1, 2}}};
  const auto lines = section_of(mesh, {{-1.0, 1.0}, {3.0, 1.0}});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0][0].x(), 1.0, 1.0e-12);
  EXPECT_NEAR(lines[0][1].x(), 2.0, 1.0e-12);
  EXPECT_NEAR(lines[0][0].y(), 1.0, 1.0e-12);
  EXPECT_TRUE(section_of(mesh, {{-1.0, 3.0}, {3.0, 3.0}}).empty());
  // The ends are those of the section.
  const auto part = section_of(mesh, {{0.5, 1.0}, {3.0, 1.0}});
  ASSERT_EQ(part.size(), 1U);
  EXPECT_NEAR(part[0][0].x(), 0.0, 1.0e-12);
}

}  // namespace
}  // namespace sim::wall
