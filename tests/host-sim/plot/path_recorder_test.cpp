#include "host-sim/plot/path_recorder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/host-sim/plot/step_pen.hpp"

namespace sim {
namespace {

constexpr cnc::AxisArray<float> kScale{80.0F, 80.0F, 80.0F, 10.0F, 10.0F, 10.0F};
constexpr double kStepMm = 1.0 / 80.0;

/// A recorder, and the machine that it records.
struct Recording {
  PathRecorder recorder{kScale};
  StepPen pen{recorder, 80.0};

  [[nodiscard]] const std::vector<PathVertex>& vertices() {
    pen.end();
    return recorder.path().vertices;
  }
};

std::size_t count(const std::vector<PathVertex>& vertices, Move move) {
  const auto is_such = [move](const PathVertex& vertex) { return vertex.move == move; };
  return static_cast<std::size_t>(std::count_if(vertices.begin() + 1, vertices.end(), is_such));
}

TEST(PathRecorder, IsEmptyWithoutMotion) {
  Recording recording;
  EXPECT_TRUE(recording.vertices().empty());
}

TEST(PathRecorder, EndsExactlyWhereTheMotorsAre) {
  Recording recording;
  recording.pen.line({12.5, 40.0}, 50.0, 1'000.0);
  const auto& vertices = recording.vertices();
  EXPECT_EQ(vertices.back().x_mm, 12.5);
  EXPECT_EQ(vertices.back().y_mm, 40.0);
}

TEST(PathRecorder, SeesTheSpeedOfALineInAnyDirection) {
  for (const double angle : {0.0, 0.02, 0.3, 0.785, 1.2}) {
    Recording recording;
    recording.pen.set_duty(1.0F);
    recording.pen.line({100.0 * std::cos(angle), 100.0 * std::sin(angle)}, 80.0, 2'000.0);
    const auto& vertices = recording.vertices();
    EXPECT_LT(vertices.size(), 100U) << angle;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      const double here_mm = std::hypot(vertices[i].x_mm, vertices[i].y_mm);
      const bool cruises = here_mm > 5.0 && here_mm < 98.0;
      EXPECT_GT(vertices[i].speed_mm_s, cruises ? 77.6F : 0.0F) << angle;
      EXPECT_LT(vertices[i].speed_mm_s, 82.4F) << angle;
    }
  }
}

TEST(PathRecorder, KeepsToTheCircleAndToItsSpeed) {
  for (const double radius : {0.5, 2.0, 20.0}) {
    Recording recording;
    recording.pen.line({radius, 0.0}, 20.0, 1'000.0);
    recording.pen.set_duty(1.0F);
    recording.pen.arc({0.0, 0.0}, 3.0, 20.0, 1'000.0);
    for (const PathVertex& vertex : recording.vertices()) {
      if (vertex.move != Move::kCut) continue;
      EXPECT_NEAR(std::hypot(vertex.x_mm, vertex.y_mm), radius, 0.75 * kStepMm);
      EXPECT_LT(vertex.speed_mm_s, 20.6F) << radius;
    }
  }
}

TEST(PathRecorder, TakesADarkMoveForTravelUntilTold) {
  Recording recording;
  recording.pen.line({10.0, 0.0}, 50.0, 1'000.0);
  recording.pen.set_duty(0.5F);
  recording.pen.line({20.0, 0.0}, 50.0, 1'000.0);
  const auto& vertices = recording.vertices();
  EXPECT_GT(count(vertices, Move::kTravel), 0U);
  EXPECT_GT(count(vertices, Move::kCut), 0U);
  EXPECT_EQ(count(vertices, Move::kFeed), 0U);
}

TEST(PathRecorder, TellsFeedRapidAndCutWhenTold) {
  Recording recording;
  recording.recorder.on_motion_kind(false);
  recording.pen.line({10.0, 0.0}, 50.0, 1'000.0);
  recording.recorder.on_motion_kind(true);
  recording.pen.set_duty(0.5F);  // The spindle of a mill keeps turning.
  recording.pen.line({20.0, 0.0}, 50.0, 1'000.0);
  recording.recorder.on_motion_kind(false);
  recording.pen.line({30.0, 0.0}, 50.0, 1'000.0);
  for (const PathVertex& vertex : recording.vertices()) {
    const double middle = vertex.x_mm - 2.0 * kStepMm;
    if (middle < 0.0) continue;
    const Move expected =
        middle < 10.0 ? Move::kFeed : (middle < 20.0 ? Move::kTravel : Move::kCut);
    EXPECT_EQ(vertex.move, expected) << vertex.x_mm;
  }
}

TEST(PathRecorder, DoesNotAverageAWaitIntoTheMotion) {
  Recording recording;
  recording.pen.set_duty(1.0F);
  recording.pen.line({10.0, 0.0}, 20.0, 20'000.0);
  recording.pen.wait_ns(2'000'000'000);
  recording.pen.line({20.0, 0.0}, 20.0, 20'000.0);
  const auto& vertices = recording.vertices();
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const double stretch_mm = vertices[i].x_mm - vertices[i - 1].x_mm;
    if (stretch_mm <= 2.0 * kStepMm) continue;
    EXPECT_GT(vertices[i].speed_mm_s, 15.0F) << vertices[i].x_mm;
  }
}

TEST(PathRecorder, CountsZIntoTheSpeed) {
  Recording recording;
  recording.pen.set_duty(1.0F);
  recording.pen.line({30.0, 0.0, 40.0}, 50.0, 5'000.0);
  const auto& vertices = recording.vertices();
  EXPECT_NEAR(vertices[vertices.size() / 2].speed_mm_s, 50.0, 1.5);
}

TEST(PathRecorder, StandsWhenOnlyZMoves) {
  Recording recording;
  recording.pen.set_duty(1.0F);
  recording.pen.line({0.0, 0.0, 40.0}, 50.0, 5'000.0);
  for (const PathVertex& vertex : recording.vertices()) EXPECT_EQ(vertex.x_mm, 0.0);
}

// A motor alternates by single steps while the beam flickers. No window is ever filled by distance,
// and every row changes the kind of move.
TEST(PathRecorder, IsBoundedOnTheWorstJob) {
  PathRecorder recorder{kScale};
  TraceRow row;
  for (std::int32_t i = 0; i < 1'000'000; ++i) {
    row.time_ns += 20'000;
    row.position[0] += i % 50 < 30 ? 1 : -1;
    row.position[1] += i % 3 - 1;
    row.duty = i % 2 == 0 ? 1.0F : 0.0F;
    recorder.on_row(row);
  }
  recorder.on_end(row.time_ns);
  EXPECT_GT(recorder.path().vertices.size(), 1'000U);
  EXPECT_LE(recorder.path().vertices.size(), PathRecorder::kMaxVertices + 1);
}

}  // namespace
}  // namespace sim
