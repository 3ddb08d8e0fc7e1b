#include "planner/path/pixel_row.hpp"

#include <algorithm>
#include <cmath>

#include "tests/planner/path/row_drive.hpp"

namespace cnc::path {
namespace {

constexpr Tolerance kUsual{.corner_mm = 0.01F};

std::vector<PathPiece> driven(const std::vector<PathItem>& items) {
  RowDrive drive;
  drive.run(items);
  return drive.pieces();
}

double power_of(int pixel) { return 0.001 * ((pixel * 37) % 1000); }

TEST(PixelRow, IsOneElementForAsManyPowersAsItMayHave) {
  PowerPen pen{kUsual};
  for (int i = 0; i < 10 * static_cast<int>(PixelRow::kMaxLines); ++i)
    pen.pixel({0.1}, power_of(i));
  const auto pieces = driven(pen.items);
  EXPECT_EQ(pieces.size(), 10U);
  EXPECT_EQ(stops_in(pieces), 0U);
  expect_sound(pen.items, pieces);
}

TEST(PixelRow, GivesEachPlaceThePowerOfItsLine) {
  PowerPen pen{kUsual};
  pen.pixel({0.25}, 0.5);
  pen.pixel({0.25}, 0.0);
  pen.pixel({0.25}, 0.0);
  pen.pixel({0.25}, 1.0);
  RowDrive drive;
  drive.run(pen.items);
  ASSERT_EQ(drive.driven.size(), 1U);
  for (int i = 0; i < RowDrive::kPlaces; ++i) {
    const double power = drive.driven[0].powers[static_cast<std::size_t>(i)];
    EXPECT_EQ(power, i < 10 ? 0.5 : i < 30 ? 0.0 : 1.0) << i;
  }
}

// A line with several powers between lines that are gathered is driven with its own powers.
TEST(PixelRow, OfALineWithManyPowersHasThemInEqualParts) {
  PowerPen pen{kUsual};
  pen.pixel({0.1}, 0.5);
  pen.pixel({0.1}, 0.25);
  pen.pixel({4.0}, 0.0);
  pen.pixel({4.0}, 0.0);
  pen.pixel({0.1}, 0.75);
  pen.pixel({0.1}, 1.0);
  std::vector<float> powers;
  for (int i = 0; i < 20; ++i) powers.push_back(static_cast<float>(power_of(i)));
  const std::vector<float> back{powers.rbegin(), powers.rend()};
  RowDrive drive;
  drive.run(pen.items, {{2, powers}, {3, back}});
  ASSERT_EQ(drive.driven.size(), 4U);
  EXPECT_EQ(drive.driven[0].powers.front(), 0.5);
  EXPECT_EQ(drive.driven[0].powers.back(), 0.25);
  for (std::size_t i = 0; i < RowDrive::kPlaces; ++i) {
    EXPECT_EQ(drive.driven[1].powers[i], static_cast<double>(powers[i / 2])) << i;
    EXPECT_EQ(drive.driven[2].powers[i], static_cast<double>(back[i / 2])) << i;
  }
  EXPECT_EQ(drive.driven[3].powers.front(), 0.75);
  EXPECT_EQ(drive.driven[3].powers.back(), 1.0);
  EXPECT_EQ(stops_in(drive.pieces()), 0U);
  expect_sound(pen.items, drive.pieces());
}

TEST(PixelRow, OfALineWithManyPowersKnowsTheirParts) {
  PowerPen pen{kUsual};
  pen.pixel({1.6}, 0.0);
  const std::vector<float> speeds{0, 5, 10, 20, 40, 80, 100, 200, 0, 5, 10, 20, 40, 80, 100, 200};
  motion::Pixels pixels;
  PixelRow row{&pixels};
  PathItem item = pen.items[0];
  ASSERT_TRUE(PixelRow::can_be_row(item.request.element, speeds.size()));
  row.become_row(item, {.values = speeds, .least = 10.0F, .full = 100.0F});
  EXPECT_EQ(item.request.row.to_mm, 1.6F);
  for (std::uint32_t i = 0; i < speeds.size(); ++i) {
    const motion::Pixel& pixel = pixels.front();
    EXPECT_EQ(pixel.line, (motion::SourceLine{item.request.line.number, i + 1}));
    EXPECT_NEAR(pixel.end_mm, 0.1F * static_cast<float>(i + 1), 1.0e-6F);
    const float lit = std::clamp(speeds[i], 10.0F, 100.0F) / 100.0F;
    EXPECT_EQ(pixel.duty, speeds[i] > 0.0F ? lit : 0.0F);
    pixels.pop();
  }
  EXPECT_TRUE(pixels.empty());
}

TEST(PixelRow, OfItselfIsALineOfManyPowersAndOfSoManyMillimetres) {
  PathElement line{};
  line.end[0] = Coordinate{100'000'000};
  EXPECT_TRUE(PixelRow::can_be_row(line, PixelRow::kFewestOfARow));
  EXPECT_FALSE(PixelRow::can_be_row(line, PixelRow::kFewestOfARow - 1));
  line.end[1] = Coordinate{10'000'000};
  EXPECT_FALSE(PixelRow::can_be_row(line, 64));
  line.end = {Coordinate{1'000'000}};
  line.bulge = 0.1F;
  EXPECT_FALSE(PixelRow::can_be_row(line, 64));
}

TEST(PixelRow, ReportsTheLineOfThePixelBeingDriven) {
  PowerPen pen{kUsual};
  for (int i = 0; i < 4; ++i) pen.pixel({0.1}, 0.5);
  motion::Pixels pixels;
  PixelRow row{&pixels};
  row.begin(pen.items[0]);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_TRUE(row.add(pen.items[i]));
  row.close();
  const auto block = motion::build_block(row.item().request, path_limits()).value();
  const motion::PathUnits length = motion::length_in_units(block);
  motion::PixelCourse course{&pixels};
  course.begin(block, length);
  for (std::uint32_t line = 1; line <= 4; ++line) {
    EXPECT_EQ(motion::line_of(block, pixels), line);
    course.pass(course.next_change());
  }
  EXPECT_TRUE(pixels.empty());
}

TEST(PixelRow, GathersLinesOfOnePowerOnlyWhereTheyAreOneLine) {
  PowerPen straight{kUsual};
  for (int i = 0; i < 20; ++i) straight.pixel({0.3, 0.1}, 0.5);
  EXPECT_EQ(driven(straight.items).size(), 1U);
  PowerPen circle{kUsual};
  for (int i = 0; i < 20; ++i)
    circle.pixel({0.1 * std::cos(0.004 * i), 0.1 * std::sin(0.004 * i)}, 0.5);
  EXPECT_GE(driven(circle.items).size(), 20U);
}

TEST(PixelRow, EndsWhereAnythingButPowerChanges) {
  const auto rows = [](auto&& change) {
    PowerPen pen{kUsual};
    pen.pixel({0.1}, 0.1);
    pen.pixel({0.1}, 0.2);
    change(pen);
    pen.pixel({0.1}, 0.3);
    pen.pixel({0.1}, 0.4);
    return driven(pen.items).size();
  };
  EXPECT_EQ(rows([](PowerPen&) {}), 1U);
  EXPECT_EQ(rows([](PowerPen& pen) { pen.request().feed_mm_s = 50.0F; }), 2U);
  EXPECT_EQ(rows([](PowerPen& pen) { pen.request().beam.follows_speed = true; }), 2U);
  EXPECT_EQ(rows([](PowerPen& pen) { pen.request().outputs.raise = 1; }), 2U);
  EXPECT_EQ(rows([](PowerPen& pen) {
              pen.pixel({0.0, 30.0}, 0.3);
            }),
            7U)
      << "with two blends in halves";
}

TEST(PixelRow, EndsWhereThePathTurnsBack) {
  PowerPen pen{kUsual};
  pen.pixel({-0.2}, 0.1);
  pen.pixel({0.5}, 0.2);
  pen.pixel({0.1}, 0.3);
  const auto pieces = driven(pen.items);
  EXPECT_EQ(pieces.size(), 2U);
  EXPECT_EQ(stops_in(pieces), 1U);
}

TEST(PixelRow, MayBeWrittenWithThreeDecimalsInAnyDirection) {
  for (int degrees = 0; degrees < 360; degrees += 23) {
    SCOPED_TRACE(degrees);
    const double angle = degrees * std::numbers::pi / 180.0;
    PowerPen pen{kUsual};
    Place last{};
    for (int i = 1; i <= 320; ++i) {
      const Place here{1.0e-3 * std::round(100.0 * i * std::cos(angle)),
                       1.0e-3 * std::round(100.0 * i * std::sin(angle))};
      pen.pixel({here[0] - last[0], here[1] - last[1]}, power_of(i));
      last = here;
    }
    const auto pieces = driven(pen.items);
    EXPECT_LE(pieces.size(), 40U) << "ten rows and the blends between them";
    EXPECT_EQ(stops_in(pieces), 0U);
    EXPECT_LE(farthest(exact(pieces), exact(pen.items), 12), 0.003);
    expect_sound(pen.items, pieces);
  }
}

// Otherwise the bends that come from rounding to three decimals would be corners.
TEST(PixelRow, KeepsToTheNanometreWhereCornersAreStops) {
  PowerPen pen{{}};
  pen.pixel({0.1, 0.001}, 0.1);
  pen.pixel({0.1, 0.0}, 0.2);
  const auto pieces = driven(pen.items);
  EXPECT_EQ(pieces.size(), 2U);
  EXPECT_EQ(stops_in(pieces), 1U);
}

TEST(PixelRow, WaitsWhileThereIsNoRoomForItsPixels) {
  PowerPen pen{kUsual};
  const int enough = 2 * static_cast<int>(motion::Pixels::kMax);
  for (int i = 0; i < enough; ++i) pen.pixel({0.1}, power_of(i));
  motion::Pixels pixels;
  const motion::Limits limits = path_limits();
  const auto stage = std::make_unique<PathStage>(limits, &pixels);
  std::size_t taken = 0;
  std::vector<PathPiece> pieces;
  while (stage->has_room()) {
    stage->put(pen.items[taken++]);
    while (const PathPiece* const piece = stage->next()) pieces.push_back(*piece);
  }
  EXPECT_GE(taken, motion::Pixels::kMax - 2U);
  EXPECT_GE(pieces.size(), 14U);
  EXPECT_LE(pixels.room(), 2U);
  pixels.drop_before(pieces.back().request.row.first);
  EXPECT_TRUE(stage->has_room());
  stage->clear();
  pixels.clear();
  EXPECT_TRUE(stage->empty());
  EXPECT_EQ(pixels.room(), motion::Pixels::kMax);
}

TEST(PixelRow, IsGivenOutUnfinishedWhenItIsNotToWait) {
  PowerPen pen{kUsual};
  for (int i = 0; i < 80; ++i) pen.pixel({0.1}, power_of(i));
  motion::Pixels pixels;
  const motion::Limits limits = path_limits();
  const auto stage = std::make_unique<PathStage>(limits, &pixels);
  std::size_t given = 0;
  for (const PathItem& item : pen.items) {
    stage->put(item);
    while (stage->next() != nullptr) ++given;
  }
  EXPECT_EQ(given, 1U);
  EXPECT_EQ(stage->gathered(), 16U);
  stage->end_row();
  EXPECT_EQ(stage->gathered(), 0U);
  while (stage->next() != nullptr) ++given;
  EXPECT_EQ(given, 2U) << "its successor is known now";
}

}  // namespace
}  // namespace cnc::path
