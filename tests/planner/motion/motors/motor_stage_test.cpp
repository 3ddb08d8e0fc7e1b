#include "planner/motion/motors/motor_stage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/support/random_motors.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

constexpr double kTick = 1.0 / kTicksPerSecond;

/// A motion of one axis with piecewise constant acceleration, in steps.
class RandomMotion {
 public:
  RandomMotion(proof::Random& random, double max_speed, double acceleration) {
    double speed = 0.0;
    double place = random.between(-1.0e6, 1.0e6);
    for (int i = 0; i < 12; ++i) {
      const double to = i == 11 || random.chance(0.2) ? 0.0 : random.between(-max_speed, max_speed);
      const double seconds = std::abs(to - speed) / acceleration + 1.0e-6;
      pieces_.push_back({end_, place, speed, (to - speed) / seconds});
      place += 0.5 * (speed + to) * seconds;
      speed = to;
      end_ += seconds;
      const double even = speed == 0.0 ? random.between(0.0, 0.02) : random.between(0.0, 0.1);
      pieces_.push_back({end_, place, speed, 0.0});
      place += speed * even;
      end_ += even;
    }
    final_ = place;
  }

  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] double at(double time) const {
    if (time <= 0.0) return pieces_.front().place;
    if (time >= end_) return final_;
    const auto after = std::upper_bound(
        pieces_.begin(), pieces_.end(), time, [](double t, const Piece& p) { return t < p.start; });
    const Piece& piece = *(after - 1);
    const double t = time - piece.start;
    return piece.place + (piece.speed + 0.5 * piece.acceleration * t) * t;
  }

 private:
  struct Piece {
    double start;
    double place;
    double speed;
    double acceleration;
  };
  std::vector<Piece> pieces_;
  double end_ = 0.0;
  double final_ = 0.0;
};

/// Returns the position by the definition, in double precision: each impulse at its own time, and
/// all centred at the mean of their times.
double shaped_at(const RandomMotion& motion, const ShaperSetting& setting, double time) {
  const ShaperImpulses impulses = impulses_of(setting);
  double mean = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < impulses.count; ++i) {
    const auto amplitude = static_cast<double>(impulses.amplitude[i]);
    mean += amplitude * static_cast<double>(impulses.delay_s[i]);
    sum += amplitude;
  }
  double place = 0.0;
  for (std::size_t i = 0; i < impulses.count; ++i) {
    place += static_cast<double>(impulses.amplitude[i]) / sum *
             motion.at(time + mean / sum - static_cast<double>(impulses.delay_s[i]));
  }
  return place;
}

constexpr std::size_t kMovedAxes = 3;

/// A stage with random shapers, random motions as its input, and its output.
class ShapedRun {
 public:
  explicit ShapedRun(std::uint64_t seed) : random_{seed} {
    setting_.shapers = proof::random_shapers(random_);
    setting_.max_steps_per_s.fill(200'000.0F);
    setting_.dark_at_rest = true;
    setting_.shapers[0].kind = ShaperKind::kZvd;
    acceleration_ = random_.magnitude(1.0e4, 1.0e6);
    const double speed = random_.magnitude(100.0, 60'000.0);
    for (std::size_t axis = 0; axis < kMovedAxes; ++axis) {
      motions_.emplace_back(random_, speed, acceleration_);
      end_ = std::max(end_, motions_.back().end());
    }
    stage_->configure(setting_);
    stage_->reset(places_at(0.0), {});
  }

  void run() {
    const double first_cell = -static_cast<double>(grid().ahead) * cell();
    AxisArray<double> motors{};
    for (std::size_t axis = 0; axis < kMovedAxes; ++axis) {
      motors[axis] = std::round(motions_[axis].at(0.0));
    }
    do {
      fill_cell();
      stage_->close_cell();
      Segment segment;
      std::uint32_t ticks = 0;
      while (stage_->take(segment)) {
        ticks += segment.ticks;
        const double out = first_cell + static_cast<double>(cells_out_) * cell() + ticks * kTick;
        check(segment, out, motors);
        came_to_rest_ = segment.comes_to_rest;
      }
      EXPECT_EQ(ticks, grid().cell_ticks);
      ++cells_out_;
    } while (!stage_->at_rest() && !testing::Test::HasFatalFailure() && cells_out_ < max_cells());
    EXPECT_TRUE(came_to_rest_);
    for (std::size_t axis = 0; axis < kMovedAxes; ++axis) {
      EXPECT_EQ(motors[axis], std::round(motions_[axis].at(end_))) << axis;
    }
  }

 private:
  [[nodiscard]] ShaperGrid grid() const { return grid_of(setting_.shapers); }
  [[nodiscard]] double cell() const { return grid().cell_ticks * kTick; }
  /// The cells of the motion, and more cells than the slowest shaper requires to come to rest.
  [[nodiscard]] std::size_t max_cells() const {
    return static_cast<std::size_t>(end_ / cell()) + 10'000;
  }

  [[nodiscard]] AxisArray<StepPosition> places_at(double time) const {
    AxisArray<StepPosition> places{};
    for (std::size_t axis = 0; axis < kMovedAxes; ++axis) {
      places[axis] = StepPosition{std::llround(motions_[axis].at(time) * 0x1.0p32)};
    }
    return places;
  }

  /// Passes a plan with the beam on from 0 to its end, in slices of any length.
  void fill_cell() {
    while (stage_->room_ns() > 0) {
      if (planned_ >= end_) return stage_->rest();
      const auto most = static_cast<double>(stage_->room_ns());
      const double slice = std::floor(random_.chance(0.1) ? 0.0 : random_.magnitude(1.0, 1.0e6));
      const auto ns = static_cast<std::uint32_t>(std::min(slice, most));
      planned_ns_ += ns;
      planned_ = static_cast<double>(planned_ns_) * 1.0e-9;
      stage_->add(
          {.end = places_at(planned_), .duration_ns = ns, .start_duty = 1.0F, .end_duty = 1.0F},
          this);
    }
  }

  void check(const Segment& segment, double time, AxisArray<double>& motors) {
    const bool lit = !segment.power.dark();
    // Times are rounded to a tick at both ends.
    if (lit) {
      EXPECT_GE(time - segment.ticks * kTick, -kTick) << "the beam is early";
    }
    if (!lit && time > 2.0 * kTick) {
      EXPECT_GE(time, end_ - kTick) << "dark while the plan moves";
    }
    const double bend = acceleration_ * cell() * cell();
    for (std::size_t axis = 0; axis < kMovedAxes; ++axis) {
      const double steps = segment.trains[axis].count;
      motors[axis] += (segment.negative >> axis & 1U) != 0 ? -steps : steps;
      const double exact = shaped_at(motions_[axis], setting_.shapers[axis], time);
      // The bound is half a step, the difference between two points of the grid, and that of the
      // parabola.
      ASSERT_LE(std::abs(motors[axis] - exact), 0.5 + 0.35 * bend + 2.0e-3)
          << "axis " << axis << " at " << time << ", bend " << bend;
    }
  }

  proof::Random random_;
  MotorStageSetting setting_{};
  double acceleration_ = 0.0;
  std::vector<RandomMotion> motions_;
  double end_ = 0.0;
  std::unique_ptr<MotorStage> stage_ = std::make_unique<MotorStage>();
  std::uint64_t planned_ns_ = 0;
  double planned_ = 0.0;
  std::size_t cells_out_ = 0;
  bool came_to_rest_ = false;
};

TEST(MotorStage, IsTheConvolutionInTimeAndTheBeamIsWithIt) {
  const proof::Trials trials{150};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    ShapedRun{seed}.run();
    if (HasFailure()) return;
  }
}

/// Blocks of a few µm at full speed give more slices than the stage has space for pieces.
TEST(MotorStage, AveragesTheOutputWhereItChangesTooOften) {
  MotorStageSetting setting;
  setting.shapers[0] = {ShaperKind::kEi, 10.0F, 0.0F};
  setting.dark_at_rest = true;
  const auto stage = std::make_unique<MotorStage>();
  stage->configure(setting);
  stage->reset({}, {});
  double energy_in = 0.0;
  double energy_out = 0.0;
  int slices = 0;
  do {
    while (stage->room_ns() > 0) {
      const auto ns = std::min<std::uint32_t>(stage->room_ns(), 10'000);
      const float duty = slices % 2 == 0 ? 0.25F : 0.75F;
      if (slices >= 100'000) {
        stage->rest();
        break;
      }
      stage->add({.duration_ns = ns, .start_duty = duty, .end_duty = duty}, stage.get());
      energy_in += static_cast<double>(duty) * ns;
      ++slices;
    }
    stage->close_cell();
    Segment segment;
    while (stage->take(segment)) {
      energy_out += segment.ticks * 250.0 * segment.power.first / 65535.0;
    }
  } while (!stage->at_rest());
  EXPECT_NEAR(energy_out / energy_in, 1.0, 1.0e-3);
}

TEST(MotorStage, KeepsASpindleTurningBeforeAndAfterAMotion) {
  MotorStageSetting setting;
  setting.shapers[0] = {ShaperKind::kZvd, 20.0F, 0.1F};
  const auto stage = std::make_unique<MotorStage>();
  stage->configure(setting);
  stage->reset({}, {});
  stage->add({.duration_ns = 1000, .start_duty = 0.5F, .end_duty = 0.5F}, stage.get());
  do {
    stage->rest();
    stage->close_cell();
    Segment segment;
    while (stage->take(segment)) EXPECT_NEAR(segment.power.first, 32768, 1);
  } while (!stage->at_rest());
}

}  // namespace
}  // namespace cnc::motion
