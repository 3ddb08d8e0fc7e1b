#include "planner/path/welder.hpp"

#include "tests/planner/path/path_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::path {
namespace {

constexpr Tolerance kHundredths{.corner_mm = 0.01F, .weld_mm = 0.01F};

void draw_polygon(Pen& pen, double radius, int edges) {
  Place at{radius};
  for (int i = 1; i <= edges; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / edges;
    const Place to{radius * std::cos(angle), radius * std::sin(angle)};
    Place travel{};
    for (std::size_t axis = 0; axis < 2; ++axis) travel[axis] = to[axis] - at[axis];
    pen.line(travel);
    at = to;
  }
}

void expect_within(const Pen& pen, const std::vector<PathPiece>& pieces, double tolerance) {
  const auto path = exact(pen.items);
  const auto driven = exact(pieces);
  EXPECT_LE(farthest(path, driven, 5), tolerance);
  EXPECT_LE(farthest(driven, path, 60), tolerance);
}

TEST(Welding, MakesThreeArcsOfACircleOf720Chords) {
  Pen pen{kHundredths};
  draw_polygon(pen, 20.0, 720);
  const auto pieces = staged(pen.items);
  EXPECT_EQ(pieces.size(), 3U);
  EXPECT_EQ(stops_in(pieces), 0U);
  for (const PathPiece& piece : pieces) {
    EXPECT_NEAR(ExactElement{piece.request.element}.radius(), 20.0, 0.005);
  }
  expect_within(pen, pieces, 0.01);
  expect_sound(pen.items, pieces);
}

TEST(Welding, BearsPlacesRoundedToAMicrometre) {
  Pen pen{kHundredths};
  pen.grid_nm = 1000;
  draw_polygon(pen, 20.0, 720);
  const auto pieces = staged(pen.items);
  EXPECT_LE(pieces.size(), 8U);
  EXPECT_EQ(stops_in(pieces), 0U);
  expect_within(pen, pieces, 0.02);
  expect_sound(pen.items, pieces);
}

TEST(Welding, LeavesAPolygonThatIsMeant) {
  Pen pen{kHundredths};
  draw_polygon(pen, 20.0, 12);
  const auto pieces = staged(pen.items);
  EXPECT_EQ(pieces.size(), 23U) << "twelve edges, eleven corners";
  expect_within(pen, pieces, 0.01);
}

TEST(Welding, MakesOneLineOfManyInARow) {
  Pen pen{kHundredths};
  for (int i = 0; i < 500; ++i) pen.line({0.08, 0.06});
  const auto pieces = staged(pen.items);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].request.element.bulge, 0.0F);
  EXPECT_EQ(pieces[0].request.element.end, pen.items.back().request.element.end);
}

TEST(Welding, MakesFewArcsOfACircleInSpace) {
  Pen pen{kHundredths};
  constexpr int kEdges = 720;
  const Place first = sum_of({}, 20.0 / std::sqrt(3.0), {1.0, 1.0, 1.0});
  const Place second = sum_of({}, 20.0 / std::sqrt(2.0), {1.0, -1.0, 0.0});
  Place at = first;
  for (int i = 1; i <= kEdges; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kEdges;
    const Place to = sum_of(sum_of({}, std::cos(angle), first), std::sin(angle), second);
    pen.line(sum_of(to, -1.0, at));
    at = to;
  }
  const auto pieces = staged(pen.items);
  EXPECT_LE(pieces.size(), 5U);
  EXPECT_EQ(stops_in(pieces), 0U);
  expect_within(pen, pieces, 0.01);
  expect_sound(pen.items, pieces);
}

TEST(Welding, MakesOneLineOfManyInARowInSpace) {
  Pen pen{kHundredths};
  for (int i = 0; i < 500; ++i) pen.line({0.08, 0.06, 0.02});
  const auto pieces = staged(pen.items);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].request.element.bulge, 0.0F);
}

TEST(Welding, OfAHelixOfChordsIsWithinTheTolerance) {
  Pen pen{kHundredths};
  for (int i = 0; i < 1000; ++i) {
    const double angle = 0.01 * i;
    pen.line({0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.02});
  }
  const auto pieces = staged(pen.items);
  EXPECT_LE(pieces.size(), 60U);
  EXPECT_EQ(stops_in(pieces), 0U);
  expect_within(pen, pieces, 0.02);
  expect_sound(pen.items, pieces);
}

TEST(Welding, IsOfOneFeedAndBeamAndNotAcrossOutputs) {
  Pen pen{kHundredths};
  for (int i = 0; i < 30; ++i) {
    if (i == 10) pen.request().beam = {.duty = 0.5F};
    if (i == 20) pen.request().outputs = {.raise = 1};
    pen.line({0.1});
  }
  const auto pieces = staged(pen.items);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(stops_in(pieces), 0U);
  EXPECT_EQ(pieces[1].request.beam.duty, 0.5F);
  EXPECT_TRUE(pieces[2].request.outputs.any());
  EXPECT_EQ(pieces[2].request.element.start, pen.items[20].request.element.start);
}

TEST(Welding, IsNotAskedForWithoutQ) {
  Pen pen{{.corner_mm = 0.01F}};
  for (int i = 0; i < 30; ++i) pen.line({0.1});
  EXPECT_EQ(staged(pen.items).size(), 30U);
}

TEST(Welding, KeepsSharpCorners) {
  Pen pen{kHundredths};
  for (int i = 0; i < 30; ++i) pen.line({0.1});
  for (int i = 0; i < 30; ++i) pen.line({0.0, 0.1});
  const auto pieces = staged(pen.items);
  EXPECT_LE(pieces.size(), 3U);
  expect_within(pen, pieces, 0.01);
}

// All points are near one line, but the chain extends beyond its end point.
TEST(Welding, DrivesAHairpinNarrowerThanTheToleranceToItsTip) {
  Pen pen{kHundredths};
  for (int i = 0; i < 50; ++i) pen.line({0.1});
  for (int i = 1; i <= 5; ++i) {
    const double heading = std::numbers::pi / 6.0 * i;
    pen.line({0.001 * std::cos(heading), 0.001 * std::sin(heading)});
  }
  for (int i = 0; i < 30; ++i) pen.line({-0.1});
  const auto pieces = staged(pen.items);
  expect_within(pen, pieces, 0.02);
  expect_sound(pen.items, pieces);
}

// All points are near one line, but the chain extends beyond its start.
TEST(Welding, DrivesAHairpinBehindTheStartToItsTip) {
  Pen pen{{.corner_mm = 0.0F, .weld_mm = 0.02F}};
  for (int i = 0; i < 5; ++i) pen.line({-0.01});
  for (int i = 0; i < 10; ++i) pen.line({0.01, 0.001});
  for (int i = 0; i < 50; ++i) pen.line({-0.01});
  const auto pieces = staged(pen.items);
  expect_within(pen, pieces, 0.02);
  expect_sound(pen.items, pieces);
}

TEST(Welding, CountsTheMiddlesOfChordsToo) {
  for (const int edges : {30, 50, 70, 100, 150}) {
    SCOPED_TRACE(edges);
    Pen pen{{.corner_mm = 0.0F, .weld_mm = 0.02F}};
    draw_polygon(pen, 20.0, edges);
    expect_within(pen, staged(pen.items), 0.02);
  }
}

TEST(Welding, GoesOnWhereItWasFlushed) {
  const motion::Limits limits = path_limits();
  const auto stage = std::make_unique<PathStage>(limits);
  Pen pen{kHundredths};
  draw_polygon(pen, 20.0, 720);
  std::vector<PathPiece> pieces;
  const auto take = [&] {
    while (const PathPiece* const piece = stage->next()) pieces.push_back(*piece);
  };
  for (std::size_t i = 0; i < pen.items.size(); ++i) {
    for (int turn = 0; turn < 50 && !stage->has_room(); ++turn) take();
    stage->put(pen.items[i]);
    take();
    for (int turn = 0; i % 100 == 99 && turn < 50; ++turn) {
      stage->flush();
      take();
    }
    if (i % 100 != 99) continue;
    EXPECT_TRUE(stage->empty());
    EXPECT_EQ(pieces.back().request.element.end, pen.items[i].request.element.end);
  }
  for (int turn = 0; turn < 50; ++turn) {
    stage->flush();
    take();
  }
  expect_within(pen, pieces, 0.02);
  expect_sound(pen.items, pieces);
}

/// Draws a smooth curve as short lines, with noise, corners and repeated points.
void draw_curve(proof::Random& random, Pen& pen) {
  double heading = random.between(-3.0, 3.0);
  double bend = 0.0;
  const double step = random.magnitude(0.002, 1.0);
  const double noise = random.chance(0.5) ? 0.0 : step * random.magnitude(1.0e-4, 0.3);
  const double swing = random.magnitude(1.0e-4, 0.5);
  const double sharp = random.chance(0.5) ? 0.0 : 0.03;
  const std::size_t count = 10 + random.below(250);
  for (std::size_t i = 0; i < count; ++i) {
    bend = 0.95 * bend + swing * random.between(-0.1, 0.1);
    heading += bend;
    if (random.chance(sharp)) heading += random.between(-3.1, 3.1);
    const double length = step * (random.chance(0.05) ? 1.0e-3 : random.between(0.3, 1.0));
    const double x = length * std::cos(heading) + noise * random.between(-1.0, 1.0);
    const double y = length * std::sin(heading) + noise * random.between(-1.0, 1.0);
    pen.line({x, y});
  }
}

/// Draws a curve in space: the heading turns about all axes.
void draw_curve_in_space(proof::Random& random, Pen& pen) {
  Place heading = sum_of({}, 1.0, {1.0});
  Place bend{};
  const double step = random.magnitude(0.002, 1.0);
  const double noise = random.chance(0.5) ? 0.0 : step * random.magnitude(1.0e-4, 0.3);
  const double swing = random.magnitude(1.0e-4, 0.5);
  const double sharp = random.chance(0.5) ? 0.0 : 0.03;
  const bool flat_now_and_then = random.chance(0.3);
  const std::size_t count = 10 + random.below(250);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) {
      bend[axis] = 0.95 * bend[axis] + swing * random.between(-0.1, 0.1);
    }
    heading = sum_of(heading, 1.0, bend);
    if (random.chance(sharp)) {
      heading = sum_of({}, 1.0, {random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.5});
    }
    heading = sum_of({}, 1.0 / std::sqrt(dot(heading, heading)), heading);
    const double length = step * (random.chance(0.05) ? 1.0e-3 : random.between(0.3, 1.0));
    Place travel = sum_of({}, length, heading);
    for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) {
      travel[axis] += noise * random.between(-1.0, 1.0);
    }
    if (flat_now_and_then && i % 40 < 20) travel[2] = 0.0;
    pen.line(travel);
  }
}

/// Draws lines shorter than most tolerances, many of which turn back.
void draw_zigzag(proof::Random& random, Pen& pen) {
  const double step = random.magnitude(0.001, 0.03);
  const double turn = random.magnitude(0.1, 3.2);
  double heading = random.between(-3.0, 3.0);
  const std::size_t count = 10 + random.below(250);
  for (std::size_t i = 0; i < count; ++i) {
    heading += random.chance(0.1) ? random.between(-3.2, 3.2) : turn * random.between(-0.2, 0.2);
    const double length = step * random.between(0.2, 1.0);
    pen.line({length * std::cos(heading), length * std::sin(heading)});
  }
}

/// Draws such lines in space.
void draw_zigzag_in_space(proof::Random& random, Pen& pen) {
  const double step = random.magnitude(0.001, 0.03);
  const double turn = random.magnitude(0.05, 1.0);
  Place heading{1.0};
  const std::size_t count = 10 + random.below(250);
  for (std::size_t i = 0; i < count; ++i) {
    const double swing = random.chance(0.1) ? 3.0 : turn;
    for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) {
      heading[axis] += swing * random.between(-1.0, 1.0);
    }
    heading = sum_of({}, 1.0 / std::sqrt(dot(heading, heading)), heading);
    pen.line(sum_of({}, step * random.between(0.2, 1.0), heading));
  }
}

using Draw = void (*)(proof::Random& random, Pen& pen);

void expect_chains_within_tolerances(Draw draw, const proof::Trials& trials) {
  std::size_t lines = 0;
  std::size_t blocks = 0;
  double worst = 0.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const double corner = random.chance(0.2) ? 0.0 : random.magnitude(1.0e-3, 0.1);
    const double weld = random.magnitude(1.0e-3, 0.1);
    Pen pen{{.corner_mm = static_cast<float>(corner), .weld_mm = static_cast<float>(weld)}};
    if (random.chance(0.5)) pen.grid_nm = 1000;
    draw(random, pen);
    const auto pieces = staged(pen.items);
    expect_sound(pen.items, pieces);
    const auto path = exact(pen.items);
    const auto driven = exact(pieces);
    const double allowed = corner + weld;
    const double of_path = farthest(path, driven, 6);
    const double of_driven = farthest(driven, path, 40);
    EXPECT_LE(of_path, allowed + 2.0e-6) << "tolerances " << corner << " and " << weld;
    EXPECT_LE(of_driven, allowed + 2.0e-6) << "tolerances " << corner << " and " << weld;
    worst = std::max({worst, of_path / allowed, of_driven / allowed});
    lines += pen.items.size();
    blocks += pieces.size();
  }
  std::printf("random chains: %zu lines, %zu blocks, greatest deviation %.4f of P + Q\n",
              lines,
              blocks,
              worst);
}

TEST(RandomChains, StayWithinBothTolerancesBothWays) {
  const proof::Trials trials{150};
  expect_chains_within_tolerances(draw_curve, trials);
}

TEST(RandomChains, InSpaceStayWithinBothTolerancesBothWays) {
  const proof::Trials trials{150};
  expect_chains_within_tolerances(draw_curve_in_space, trials);
}

TEST(RandomChains, ThatTurnBackStayWithinBothTolerancesBothWays) {
  const proof::Trials trials{150};
  expect_chains_within_tolerances(draw_zigzag, trials);
}

TEST(RandomChains, ThatTurnBackInSpaceStayWithinBothTolerancesBothWays) {
  const proof::Trials trials{150};
  expect_chains_within_tolerances(draw_zigzag_in_space, trials);
}

}  // namespace
}  // namespace cnc::path
