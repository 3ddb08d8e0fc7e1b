#include "planner/path/short_lines.hpp"

#include "tests/planner/path/path_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::path {
namespace {

constexpr Tolerance kExact{};
constexpr double kHalfStep = 0.002;  ///< Half a step, mm.

motion::Limits coarse_limits() {
  motion::Limits limits = path_limits();
  limits.scale.fill(AxisScale{250.0F});
  return limits;
}

/// Draws a stair whose steps no motor can follow.
void draw_stair(Pen& pen, double rise) {
  for (int i = 0; i < 100; ++i) {
    pen.line({0.0, rise});
    pen.line({1.0});
  }
}

TEST(ShortLines, OfAStairAreTakenByTheLinesBetweenThem) {
  for (const Tolerance& tolerance : {kExact, Tolerance{.corner_mm = 0.01F}}) {
    Pen pen{tolerance};
    draw_stair(pen, 0.0005);
    const auto pieces = staged(pen.items, coarse_limits());
    EXPECT_EQ(stops_in(pieces), 0U);
    EXPECT_LE(pieces.size(), 100U);
    EXPECT_LE(farthest(exact(pen.items), exact(pieces), 2), 0.0005);
    expect_sound(pen.items, pieces);
  }
}

TEST(ShortLines, ThatAMotorFollowsAreDriven) {
  Pen pen{kExact};
  draw_stair(pen, 0.0021);
  EXPECT_EQ(staged(pen.items, coarse_limits()).size(), 200U);
}

TEST(ShortLines, AddUpToWhatAMotorFollows) {
  Pen pen{kExact};
  for (int i = 0; i < 1000; ++i) pen.line({0.0005, 0.0001 * (i % 7)});
  const auto pieces = staged(pen.items, coarse_limits());
  EXPECT_LE(farthest(exact(pen.items), exact(pieces), 2), kHalfStep);
  expect_sound(pen.items, pieces);
}

TEST(ShortLines, ComeOutWhenFlushed) {
  Pen pen{kExact};
  pen.line({0.001});
  const auto pieces = staged(pen.items, coarse_limits());
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].request.element.end, pen.items[0].request.element.end);
}

TEST(ShortLines, ThatComeBackMoveNothing) {
  Pen pen{kExact};
  pen.line({0.001});
  pen.line({-0.001});
  EXPECT_TRUE(staged(pen.items, coarse_limits()).empty());
}

TEST(ShortLines, AtWhichSomethingChangesAreDriven) {
  Pen pen{kExact};
  pen.line({0.0, 0.001});
  pen.request().outputs = {.raise = 1};
  pen.line({1.0});
  pen.request().beam = {.duty = 0.5F};
  pen.line({0.0, 0.001});
  pen.request().beam = {.duty = 0.6F};
  pen.line({1.0});
  pen.line({0.0, 0.001});
  pen.request().feed_mm_s = 50.0F;
  pen.line({1.0});
  const auto pieces = staged(pen.items, coarse_limits());
  ASSERT_EQ(pieces.size(), 6U);
  EXPECT_TRUE(pieces[1].request.outputs.any());
}

TEST(ShortLines, KeepTheOutputsThatComeWithThem) {
  Pen pen{kExact};
  pen.request().outputs = {.raise = 1};
  pen.line({0.0, 0.001});
  pen.line({1.0});
  const auto pieces = staged(pen.items, coarse_limits());
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_TRUE(pieces[0].request.outputs.any());
}

TEST(ShortLines, LeaveArcsTheirStart) {
  Pen pen{kExact};
  pen.line({0.001});
  pen.arc({0.01, 0.01}, Plane::kXY, 0.4);
  const auto pieces = staged(pen.items, coarse_limits());
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[1].request.element.start, pen.items[1].request.element.start);
}

// The tolerance of a corner decreases by the distance of a line's start from its programmed point.
TEST(RandomShortLines, StayWithinTheToleranceAndHalfAStep) {
  const proof::Trials trials{200};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const double corner = random.chance(0.3) ? 0.0 : random.magnitude(1.0e-3, 0.1);
    const double weld = random.chance(0.5) ? 0.0 : random.magnitude(1.0e-3, 0.05);
    Pen pen{{.corner_mm = static_cast<float>(corner), .weld_mm = static_cast<float>(weld)}};
    for (int i = 0; i < 200; ++i) {
      const double length = random.magnitude(1.0e-4, 1.0);
      const Place direction = any_direction(random);
      pen.line(sum_of({}, random.chance(0.5) ? 0.002 * random.unit() : length, direction));
    }
    const auto pieces = staged(pen.items, coarse_limits());
    expect_sound(pen.items, pieces);
    const double allowed = std::max(corner + weld, kHalfStep * std::sqrt(6.0)) + 1.0e-5;
    EXPECT_LE(farthest(exact(pen.items), exact(pieces), 6), allowed);
    EXPECT_LE(farthest(exact(pieces), exact(pen.items), 24), allowed);
  }
}

}  // namespace
}  // namespace cnc::path
