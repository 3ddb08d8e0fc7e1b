#include "planner/path/corner_rounder.hpp"

#include "tests/planner/path/path_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::path {
namespace {

constexpr Tolerance kTenth{.corner_mm = 0.1F};

/// Expects that no stop remains, and that the driven path and the program are within the tolerance
/// of each other.
void expect_blended(const Pen& pen, const Tolerance& tolerance) {
  const auto pieces = staged(pen.items);
  EXPECT_EQ(stops_in(pieces), 0U);
  expect_sound(pen.items, pieces);
  const auto path = exact(pen.items);
  const auto driven = exact(pieces);
  const double allowed = static_cast<double>(tolerance.corner_mm) + 1.0e-5;
  EXPECT_LE(farthest(path, driven, 40), allowed);
  EXPECT_LE(farthest(driven, path, 24), allowed);
}

TEST(Corners, OfARightAngleGetTheArcThatTouchesTheTolerance) {
  Pen pen{kTenth};
  pen.line({50.0});
  pen.line({0.0, 50.0});
  const auto pieces = staged(pen.items);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(stops_in(pieces), 0U);
  const ExactElement arc{pieces[1].request.element};
  EXPECT_NEAR(arc.radius(), 0.1 / (std::sqrt(2.0) - 1.0), 1.0e-4);
  EXPECT_NEAR(distance(arc.at(0.5), {50.0}), 0.1, 5.0e-6);
  expect_sound(pen.items, pieces);
}

TEST(Corners, AreStopsWithoutATolerance) {
  Pen pen{{}};
  pen.line({50.0});
  pen.line({0.0, 50.0});
  pen.line({0.0, 50.0});
  const auto pieces = staged(pen.items);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[1].joint, motion::Joint::kStop);
  EXPECT_EQ(pieces[2].joint, motion::Joint::kSmooth) << "it does not turn";
}

TEST(Corners, ThatTurnBackAreStops) {
  Pen pen{kTenth};
  pen.line({50.0});
  pen.line({-20.0});
  EXPECT_EQ(stops_in(staged(pen.items)), 1U);
}

TEST(Corners, BetweenRapidAndFeedAreStops) {
  Pen pen{kTenth};
  pen.line({50.0});
  pen.request().feed_mm_s = 0.0F;
  pen.line({0.0, 50.0});
  pen.line({50.0});
  const auto pieces = staged(pen.items);
  ASSERT_EQ(pieces.size(), 4U);
  EXPECT_EQ(pieces[1].joint, motion::Joint::kStop);
  EXPECT_EQ(stops_in(pieces), 1U);
}

TEST(Corners, OfAPolygonAreDrivenLikeItsCircle) {
  Pen pen{{.corner_mm = 0.01F}};
  constexpr int kEdges = 720;
  const double edge = 40.0 * std::sin(std::numbers::pi / kEdges);
  for (int i = 0; i < kEdges; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kEdges;
    pen.line({edge * std::cos(angle), edge * std::sin(angle)});
  }
  const auto pieces = staged(pen.items);
  EXPECT_EQ(stops_in(pieces), 0U);
  EXPECT_LE(pieces.size(), kEdges + 1U);
  for (std::size_t i = 1; i + 1 < pieces.size(); ++i) {
    EXPECT_NEAR(ExactElement{pieces[i].request.element}.radius(), 20.0, 0.05) << i;
  }
  expect_sound(pen.items, pieces);
}

TEST(Corners, OfEdgesOfNearlyOneLengthLeaveNoLinesBetween) {
  for (const std::int64_t grid_nm : {100, 1000}) {
    Pen pen{{.corner_mm = 0.01F}};
    pen.grid_nm = grid_nm;
    constexpr int kEdges = 720;
    const double edge = 40.0 * std::sin(std::numbers::pi / kEdges);
    for (int i = 0; i < kEdges; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kEdges;
      pen.line({edge * std::cos(angle), edge * std::sin(angle)});
    }
    const auto pieces = staged(pen.items);
    EXPECT_EQ(stops_in(pieces), 0U);
    EXPECT_LE(pieces.size(), kEdges * 102U / 100U) << grid_nm;
    expect_sound(pen.items, pieces);
  }
}

TEST(Corners, ShareAShortEdgeByWhatEachNeeds) {
  Pen pen{kTenth};
  pen.line({50.0});
  pen.line({0.0, 0.2});
  // This corner hardly turns, and leaves nearly all of the edge to the other corner.
  pen.line({-0.01, 50.0});
  const auto pieces = staged(pen.items);
  EXPECT_EQ(stops_in(pieces), 0U);
  EXPECT_GT(ExactElement{pieces[1].request.element}.radius(), 0.15);
  expect_sound(pen.items, pieces);
}

TEST(Corners, OfAHelixAreBlendedWhereItIsGentle) {
  Pen pen{{.corner_mm = 0.01F}};
  for (int i = 0; i < 100; ++i) {
    const double angle = 0.02 * i;
    pen.line({std::cos(angle), std::sin(angle), 0.1});
  }
  const auto pieces = staged(pen.items);
  EXPECT_EQ(stops_in(pieces), 0U);
  expect_sound(pen.items, pieces);
}

TEST(Corners, OfASteepRampAreBlendedInThePlaneOfBothLines) {
  for (const double slope : {0.01, 0.1, 1.0}) {
    SCOPED_TRACE(slope);
    Pen pen{kTenth};
    pen.line({10.0, 0.0, 10.0 * slope});
    pen.line({0.0, 10.0, 10.0 * slope});
    expect_blended(pen, kTenth);
  }
}

// The line moves 1.6 mm along Y and less than 100 nm along X and Z, so it is nearly vertical in the
// plane of X and Z. In this plane the corner is a right angle, although the turn of such a steep
// line is small.
TEST(Corners, OfAnUprightLineAreBlendedInThePlaneInWhichTheyTurn) {
  Pen pen{kTenth};
  pen.line({-0.00007, -1.6347, 0.00003});
  pen.line({-1.6347, 0.00138, 0.00021});
  expect_blended(pen, kTenth);
}

TEST(Corners, OffThePlanesAndOfRotaryAxesAreBlended) {
  Pen pen{kTenth};
  pen.line({10.0, 10.0, 10.0});
  pen.line({10.0, -10.0, 3.0});
  pen.line({10.0, -10.0, 3.0, 5.0});
  pen.line({0.0, 0.0, 0.0, 5.0, 2.0});
  expect_blended(pen, kTenth);
}

TEST(Corners, OfOneArcInSpaceTouchTheTolerance) {
  Pen pen{kTenth};
  pen.line({30.0, 30.0, 30.0});
  pen.line({30.0, -30.0, 0.0});
  const auto pieces = staged(pen.items);
  ASSERT_EQ(pieces.size(), 3U);
  const ExactElement arc{pieces[1].request.element};
  EXPECT_NEAR(arc.radius(), 0.1 / (std::sqrt(2.0) - 1.0), 1.0e-4);
  EXPECT_NEAR(distance(arc.at(0.5), {30.0, 30.0, 30.0}), 0.1, 5.0e-6);
  expect_sound(pen.items, pieces);
}

TEST(Corners, BetweenArcsOfDifferentPlanesAreBlended) {
  Pen pen{kTenth};
  pen.arc({10.0, 10.0}, Plane::kXY, 0.3);
  pen.arc({0.0, 10.0, 10.0}, Plane::kYZ, -0.4);
  pen.line({10.0, 10.0, 3.0});
  pen.arc({10.0, 0.0, 10.0}, Plane::kZX, 0.2);
  pen.arc({10.0, 10.0, 4.0}, Plane::kXY, 0.5);  // The element is a helix.
  pen.line({-10.0, 2.0, 1.0, 8.0});
  expect_blended(pen, kTenth);
}

TEST(Corners, InAllPlanesAreBlended) {
  Pen pen{kTenth};
  pen.line({10.0});
  pen.line({0.0, 0.0, 10.0});
  pen.line({0.0, 10.0});
  pen.line({10.0});
  EXPECT_EQ(stops_in(staged(pen.items)), 0U);
}

TEST(Corners, KeepFeedBeamAndOutputsOnTheirOwnSide) {
  Pen pen{kTenth};
  pen.request().beam = {.duty = 0.5F};
  pen.line({50.0});
  pen.request().beam = {};
  pen.request().feed_mm_s = 100.0F;
  pen.request().outputs = {.raise = 1};
  pen.line({0.0, 50.0});
  const auto pieces = staged(pen.items);
  ASSERT_EQ(pieces.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const motion::MotionRequest& piece = pieces[i].request;
    EXPECT_EQ(piece.beam.duty, i < 2 ? 0.5F : 0.0F) << i;
    EXPECT_EQ(piece.feed_mm_s, i < 2 ? 200.0F : 100.0F) << i;
    EXPECT_EQ(piece.line, i < 2 ? 1U : 2U) << i;
    EXPECT_EQ(piece.outputs.any(), i == 2) << i;
  }
  // The beam is on up to the point nearest to the corner.
  const Place middle = to_mm(pieces[2].request.element.start);
  EXPECT_NEAR(distance(middle, {50.0}), 0.1, 1.0e-5);
  expect_sound(pen.items, pieces);
}

TEST(Corners, OfJogsAndSearchesAreLeftAlone) {
  Pen pen{kTenth};
  pen.request().fixed_feed = true;
  pen.line({50.0});
  pen.line({0.0, 50.0});
  EXPECT_EQ(stops_in(staged(pen.items)), 1U);
}

TEST(HeldElements, ComeOutWholeWhenFlushed) {
  const motion::Limits limits = path_limits();
  PathStage stage{limits};
  Pen pen{kTenth};
  pen.line({50.0});
  pen.line({0.0, 50.0});
  stage.put(pen.items[0]);
  EXPECT_EQ(stage.next(), nullptr);
  EXPECT_EQ(stage.line(), 1U);
  stage.flush();
  const PathPiece* piece = stage.next();
  ASSERT_NE(piece, nullptr);
  EXPECT_EQ(piece->request.element.end, pen.items[0].request.element.end);
  EXPECT_TRUE(stage.empty());
  stage.put(pen.items[1]);
  stage.flush();
  piece = stage.next();
  ASSERT_NE(piece, nullptr);
  EXPECT_EQ(piece->joint, motion::Joint::kStop) << "the corner was given away";
}

/// Draws a stretch of one difficult kind.
void scribble(proof::Random& random, Pen& pen) {
  const std::size_t kind = random.below(7);
  const double size = random.magnitude(0.001, 50.0);
  double heading = random.between(-std::numbers::pi, std::numbers::pi);
  const std::size_t count = 2 + random.below(12);
  for (std::size_t i = 0; i < count; ++i) {
    const double length = size * random.magnitude(kind == 1 ? 1.0e-4 : 0.1, 1.0);
    const double turn = kind == 0   ? random.signed_magnitude(1.0e-5, 0.05)
                        : kind == 2 ? std::numbers::pi + random.signed_magnitude(1.0e-6, 0.1)
                                    : random.between(-3.0, 3.0);
    heading += turn;
    Place travel{length * std::cos(heading), length * std::sin(heading)};
    const double bulge = random.chance(0.2) ? 1.0 : random.magnitude(1.0e-5, 1.0);
    const bool left = random.chance(0.5);
    if (kind >= 4) {
      pen.arc(travel, Plane::kXY, left ? bulge : -bulge);
    } else if (kind == 3 && random.chance(0.5)) {
      pen.arc(travel, Plane::kXY, left ? bulge : -bulge);
    } else {
      pen.line(travel);
    }
  }
}

/// Draws a stretch in space: each line and arc has any direction, sometimes with rotary axes.
void scribble_in_space(proof::Random& random, Pen& pen) {
  const double size = random.magnitude(0.001, 50.0);
  const bool gentle = random.chance(0.3);
  const std::size_t count = 2 + random.below(12);
  Place heading = any_direction(random);
  for (std::size_t i = 0; i < count; ++i) {
    const Place turn = any_direction(random);
    const double by = gentle ? random.magnitude(1.0e-5, 0.05) : random.between(0.0, 3.0);
    heading = sum_of(heading, by, turn);
    const double length = size * random.magnitude(0.01, 1.0);
    const Place travel = sum_of({}, length / std::sqrt(dot(heading, heading)), heading);
    if (random.chance(0.3)) {
      const double bulge = random.signed_magnitude(1.0e-5, 1.0);
      pen.arc(travel, static_cast<Plane>(random.below(3)), bulge);
    } else {
      pen.line(travel);
    }
  }
}

struct Deviation {
  double of_path = 0.0;    ///< Greatest distance of the programmed path from the driven one, as a
                           ///< fraction of the tolerance.
  double of_driven = 0.0;  ///< Greatest distance of the driven path from the programmed one, as a
                           ///< fraction of the tolerance.
  std::size_t pieces = 0;
  std::size_t stops = 0;
};

using Scribble = void (*)(proof::Random& random, Pen& pen);

void try_scribble(Scribble scribble, std::uint64_t seed, Deviation& greatest) {
  proof::Random random{seed};
  const double tolerance = random.magnitude(5.0e-4, 1.0);
  Pen pen{{.corner_mm = static_cast<float>(tolerance)}};
  const std::size_t stretches = 1 + random.below(3);
  for (std::size_t i = 0; i < stretches; ++i) scribble(random, pen);
  if (pen.items.empty()) return;  // All moves were shorter than a nanometre.
  const auto pieces = staged(pen.items);
  expect_sound(pen.items, pieces);
  const auto path = exact(pen.items);
  const auto driven = exact(pieces);
  // 10 nm allow for the rounding of the arcs, which is 1e-7 of a radius of some metres.
  const double allowed = tolerance + 1.0e-5;
  const double of_path = farthest(path, driven, 40);
  const double of_driven = farthest(driven, path, 24);
  EXPECT_LE(of_path, allowed);
  EXPECT_LE(of_driven, allowed);
  greatest.of_path = std::max(greatest.of_path, of_path / tolerance);
  greatest.of_driven = std::max(greatest.of_driven, of_driven / tolerance);
  greatest.pieces += pieces.size();
  greatest.stops += stops_in(pieces);
}

void expect_within_tolerance(Scribble scribble, const proof::Trials& trials) {
  Deviation greatest;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    try_scribble(scribble, seed, greatest);
  }
  std::printf(
      "random corners: %zu pieces, %zu stops; greatest deviation of the tolerance %.4f "
      "of the path, %.4f of what is driven\n",
      greatest.pieces,
      greatest.stops,
      greatest.of_path,
      greatest.of_driven);
}

TEST(RandomCorners, StayWithinTheToleranceBothWays) {
  const proof::Trials trials{400};
  expect_within_tolerance(scribble, trials);
}

TEST(RandomCorners, OfAnyPlanesStayWithinTheToleranceBothWays) {
  const proof::Trials trials{400};
  expect_within_tolerance(scribble_in_space, trials);
}

}  // namespace
}  // namespace cnc::path
