#include "planner/kerf/table_image.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "planner/base/crc32.hpp"
#include "planner/kerf/csp_1n.hpp"
#include "tests/planner/kerf/random_table.hpp"
#include "tests/support/trials.hpp"

namespace cnc::kerf {
namespace {

using Bytes = std::vector<std::byte>;

Bytes image_of(const TableView<float>& table) {
  std::array<std::byte, table_image::kMaxBytes> image{};
  const std::size_t size = write_image(table, image).value();
  return {image.begin(), image.begin() + static_cast<std::ptrdiff_t>(size)};
}

void sum_up(Bytes& image) {
  Crc32 crc;
  crc.add(std::span{image}.first(image.size() - 4));
  for (std::size_t i = 0; i < 4; ++i) {
    image[image.size() - 4 + i] = static_cast<std::byte>(crc.value() >> (8 * i));
  }
}

TableError fault_of(const Bytes& image) {
  StoredTable table;
  const auto fault = read_image(image, table);
  EXPECT_TRUE(fault);
  return fault ? fault->error : TableError::kBadName;
}

template <typename List>
bool same(const List& a, const List& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

void expect_same(const TableView<float>& a, const TableView<float>& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.unit, b.unit);
  EXPECT_TRUE(same(a.rows, b.rows));
  EXPECT_TRUE(same(a.bands, b.bands));
  EXPECT_TRUE(same(a.points, b.points));
}

TEST(KerfTableImage, IsReadAsItWasWritten) {
  StoredTable table;
  const Bytes image = image_of(kCsp1nPhysical<float>);
  EXPECT_EQ(image.size(), 28U + 4 * 16 + 16 * 16 + 4);
  ASSERT_FALSE(read_image(image, table));
  EXPECT_EQ(name_in_image(image), "CSP 1N J/mm");
  expect_same(table.view(), kCsp1nPhysical<float>);
}

TEST(KerfTableImage, OfAnyTableIsReadAsItWasWritten) {
  const proof::Trials trials{3000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE("KERFLINE_SEED=" + std::to_string(seed));
    proof::Random random{seed};
    const OwnedTable<float> written = in_single(RandomTable{random}.next());
    StoredTable read;
    ASSERT_FALSE(read_image(image_of(written.view()), read));
    expect_same(read.view(), written.view());
  }
}

TEST(KerfTableImage, NoticesEveryWrongBit) {
  const Bytes sound = image_of(kCsp1n<float>);
  for (std::size_t bit = 0; bit < 8 * sound.size(); ++bit) {
    Bytes image = sound;
    image[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    StoredTable table;
    EXPECT_TRUE(read_image(image, table)) << bit;
  }
}

TEST(KerfTableImage, OfAnotherLengthIsNone) {
  const Bytes sound = image_of(kCsp1n<float>);
  for (std::size_t size = 0; size < sound.size(); ++size) {
    StoredTable table;
    EXPECT_TRUE(read_image(std::span{sound}.first(size), table)) << size;
  }
  Bytes longer = sound;
  longer.push_back(std::byte{0});
  EXPECT_EQ(fault_of(longer), TableError::kBadSize);
}

/// If its checksum is recomputed, an image with any change is either a sound table or refused.
TEST(KerfTableImage, OfNonsenseIsNeverATableThatCannotBeLookedUp) {
  const proof::Trials trials{20'000};
  std::size_t taken = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE("KERFLINE_SEED=" + std::to_string(seed));
    proof::Random random{seed};
    Bytes image = image_of(in_single(RandomTable{random}.next()).view());
    const std::size_t changes = 1 + random.below(3);
    for (std::size_t i = 0; i < changes; ++i) {
      image[random.below(image.size())] = static_cast<std::byte>(random.bits());
    }
    sum_up(image);
    StoredTable table;
    if (read_image(image, table)) continue;
    ++taken;
    ASSERT_FALSE(find_fault(table.view()));
    for (const Row<float>& row : table.view().rows) {
      for (const Band& band : table.view().bands_of(row)) {
        const auto kerf =
            kerf_width(table.view(), {row.thickness_um, band.power_mw, band.max_um_min});
        ASSERT_TRUE(kerf.ok());
        ASSERT_GT(kerf.value(), 0.0F);
        ASSERT_LE(kerf.value(), 10.0F);
      }
    }
  }
  if (trials.judges_shares()) {
    EXPECT_GT(taken, trials.count() / 20);
  }
}

TEST(KerfTableImage, SaysWhatItIsNot) {
  Bytes image = image_of(kCsp1n<float>);
  image[0] = std::byte{'X'};
  EXPECT_EQ(fault_of(image), TableError::kNotATable);
  image = image_of(kCsp1n<float>);
  image[3] = std::byte{2};
  EXPECT_EQ(fault_of(image), TableError::kOtherVersion);
  image = image_of(kCsp1n<float>);
  image[6] = std::byte{2};
  sum_up(image);
  EXPECT_EQ(fault_of(image), TableError::kNotATable);
}

OwnedTable<float> table_of_thicknesses(std::size_t count) {
  OwnedTable<float> table;
  for (std::size_t i = 0; i < count; ++i) {
    const auto n = static_cast<std::uint16_t>(i);
    table.rows.push_back({1000U + n, {0.0F, 0.3F}, false, n, 1});
    table.bands.push_back({1000, 5000, 9000, 0, 0});
  }
  return table;
}

TEST(KerfTableImage, SaysHowMuchDoesNotFit) {
  std::array<std::byte, table_image::kMaxBytes> image{};
  EXPECT_TRUE(write_image(table_of_thicknesses(8).view(), image).ok());
  const auto nine = write_image(table_of_thicknesses(9).view(), image);
  ASSERT_FALSE(nine.ok());
  EXPECT_EQ(nine.error().error, TableError::kTooManyRows);
  EXPECT_EQ(nine.error().count, 9);
  EXPECT_EQ(nine.error().capacity, 8);
  // The controller gives the same answer for an image from another source.
  Bytes other = image_of(table_of_thicknesses(8).view());
  other[7] = std::byte{9};
  EXPECT_EQ(fault_of(other), TableError::kTooManyRows);
  other = image_of(table_of_thicknesses(8).view());
  other[8] = std::byte{41};
  EXPECT_EQ(fault_of(other), TableError::kTooManyBands);
  other = image_of(table_of_thicknesses(8).view());
  other[9] = std::byte{49};
  EXPECT_EQ(fault_of(other), TableError::kTooManyPoints);
}

TEST(KerfTableImage, RefusesTablesThatCannotBeLookedUp) {
  const auto error_of = [](const OwnedTable<float>& table) {
    std::array<std::byte, table_image::kMaxBytes> image{};
    return write_image(table.view(), image).error().error;
  };
  OwnedTable<float> table = table_of_thicknesses(2);
  table.name = "a, b";
  EXPECT_EQ(error_of(table), TableError::kBadName);
  table = table_of_thicknesses(2);
  table.rows[1].thickness_um = 1000;
  EXPECT_EQ(error_of(table), TableError::kThicknessNotRising);
  table = table_of_thicknesses(2);
  table.bands[1].min_um_min = 9001;
  EXPECT_EQ(error_of(table), TableError::kBadSpeeds);
  table = table_of_thicknesses(2);
  table.rows[1].law.slope = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(error_of(table), TableError::kBadKerf);
  table = table_of_thicknesses(2);
  table.rows[1].law.slope = -0.6F;  // The width is 0 at Q = 0.5.
  table.bands[1].power_mw = 5000;
  EXPECT_EQ(error_of(table), TableError::kBadKerf);
  table = table_of_thicknesses(2);
  table.rows[1].first_band = 0;
  EXPECT_EQ(error_of(table), TableError::kBadShape);
  table = table_of_thicknesses(2);
  table.rows[0].bands = 2;
  table.rows.pop_back();
  EXPECT_EQ(error_of(table), TableError::kPowerNotRising);
  table = table_of_thicknesses(2);
  table.rows[1].measured = true;
  EXPECT_EQ(error_of(table), TableError::kBadPoints);
  EXPECT_EQ(error_of(OwnedTable<float>{}), TableError::kNoRows);
}

}  // namespace
}  // namespace cnc::kerf
