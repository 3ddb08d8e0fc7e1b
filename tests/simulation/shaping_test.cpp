#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "host-sim/measure/motion_meter.hpp"
#include "tests/support/laser_settings.hpp"
#include "tests/support/program_text.hpp"
#include "tests/support/random_motor_settings.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::motion::ShaperKind;
using cnc::motion::ShaperSetting;

/// A mass that is coupled to the X motor by a spring and a damper. Between two edges the motor
/// stands still, so that the motion of the mass has a closed form.
class Oscillator final : public sim::TraceSink {
 public:
  Oscillator(double frequency_hz, double damping, double steps_per_mm)
      : omega_{2.0 * std::numbers::pi * frequency_hz},
        damping_{damping},
        steps_per_mm_{steps_per_mm} {}

  void on_row(const sim::TraceRow& row) override {
    pass(static_cast<double>(row.time_ns) * 1.0e-9 - time_);
    time_ = static_cast<double>(row.time_ns) * 1.0e-9;
    motor_ = row.position[0] / steps_per_mm_;
  }

  /// Returns the amplitude of the mass about the motor's position, mm.
  [[nodiscard]] double swing() const {
    const double off = place_ - motor_;
    return std::hypot(off, (speed_ + damping_ * omega_ * off) / damped());
  }

 private:
  [[nodiscard]] double damped() const { return omega_ * std::sqrt(1.0 - damping_ * damping_); }

  void pass(double seconds) {
    const double decay = std::exp(-damping_ * omega_ * seconds);
    const double sine = std::sin(damped() * seconds);
    const double cosine = std::cos(damped() * seconds);
    const double off = place_ - motor_;
    const double quarter = (speed_ + damping_ * omega_ * off) / damped();
    place_ = motor_ + decay * (off * cosine + quarter * sine);
    speed_ = decay * ((quarter * cosine - off * sine) * damped() -
                      damping_ * omega_ * (off * cosine + quarter * sine));
  }

  double omega_;
  double damping_;
  double steps_per_mm_;
  double time_ = 0.0;
  double motor_ = 0.0;
  double place_ = 0.0;
  double speed_ = 0.0;
};

/// Returns the root mean square of the remaining amplitudes after moves of many lengths.
double swing_after_moves(const ShaperSetting& shaper, double frequency_hz, double damping) {
  constexpr double kStepsPerMm = 1000.0;
  // The acceleration is chosen so that a step of it causes an amplitude of 0.05 mm.
  const double omega = 2.0 * std::numbers::pi * frequency_hz;
  const double acceleration = std::min(1.0e5, 0.05 * omega * omega);
  double sum = 0.0;
  constexpr int kMoves = 8;
  for (int move = 0; move < kMoves; ++move) {
    const double length = 3.0 + 0.37 * move;
    sim::Simulator simulator{"G21 G90 F5000\nG1" + word('X', length) + "\n", {}};
    set_up_laser(simulator, kStepsPerMm, 100.0, acceleration);
    SettingValues settings{{0, 1.0}};
    add_shaper(0, shaper, settings);
    for (const auto& [number, value] : settings) {
      change(simulator, static_cast<std::size_t>(number), value);
    }
    Oscillator oscillator{frequency_hz, damping, kStepsPerMm};
    simulator.add_sink(oscillator);
    EXPECT_TRUE(simulator.run().refusals.empty());
    EXPECT_EQ(simulator.port().position[0], std::lround(length * kStepsPerMm));
    sum += oscillator.swing() * oscillator.swing();
  }
  return std::sqrt(sum / kMoves);
}

const char* name_of(ShaperKind kind) {
  constexpr std::array kNames{"none", "ZV", "ZVD", "MZV", "EI"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// Returns the ratio of the remaining amplitude to that without a shaper.
double swing_left(ShaperKind kind, double set_hz, double real_hz, double damping) {
  const ShaperSetting shaper{kind, static_cast<float>(set_hz), static_cast<float>(damping)};
  const double with = swing_after_moves(shaper, real_hz, damping);
  const double without = swing_after_moves({}, real_hz, damping);
  std::printf("%-4s set to %.0f Hz on %.1f Hz, damping %.2f: %.4f mm of %.4f mm left, %.2f %%\n",
              name_of(kind),
              set_hz,
              real_hz,
              damping,
              with,
              without,
              100.0 * with / without);
  return with / without;
}

TEST(Shaping, TakesAwayTheSwingAtItsFrequency) {
  for (const double frequency : {18.0, 45.0, 110.0}) {
    for (const double damping : {0.0, 0.1}) {
      for (const ShaperKind kind : {ShaperKind::kZv, ShaperKind::kZvd, ShaperKind::kMzv}) {
        EXPECT_LT(swing_left(kind, frequency, frequency, damping), 0.05);
      }
      // EI leaves 5 % at its own frequency by design, in order to leave no more at neighbouring
      // frequencies.
      EXPECT_LT(swing_left(ShaperKind::kEi, frequency, frequency, damping), 0.052);
    }
  }
}

TEST(Shaping, OfEiAndZvdHoldsWhereTheFrequencyIsNotKnownWell) {
  for (const double off : {0.85, 1.15}) {
    EXPECT_LT(swing_left(ShaperKind::kEi, 45.0, 45.0 * off, 0.0), 0.06);
    EXPECT_LT(swing_left(ShaperKind::kZvd, 45.0, 45.0 * off, 0.0), 0.07);
    EXPECT_GT(swing_left(ShaperKind::kZv, 45.0, 45.0 * off, 0.0), 0.15) << "what they are for";
  }
}

/// Stores all trace rows, so that the position at any time can be computed.
class RasterLog final : public sim::TraceSink {
 public:
  void on_row(const sim::TraceRow& row) override { rows.push_back(row); }
  std::vector<sim::TraceRow> rows;
};

constexpr double kRasterScale = 80.0;
constexpr int kRasterDots = 6;
constexpr double kRasterStart = 60.0;

/// Returns strokes in both directions over the same dots of 0.5 mm, 1 mm apart, at 1 m/s, on a
/// slope.
std::string sloping_raster(double slope) {
  const auto to = [slope](double x) { return word('X', x) + word('Y', slope * x) + "\n"; };
  std::string program = "G21 G90 M4 F60000 S0\n";
  for (int stroke = 0; stroke < 6; ++stroke) {
    const bool forward = stroke % 2 == 0;
    for (int i = 0; i < kRasterDots; ++i) {
      const double low = kRasterStart + (forward ? i : kRasterDots - 1 - i);
      program += "G1 S0" + to(forward ? low : low + 0.5);
      program += "S600" + to(forward ? low + 0.5 : low);
    }
    program += "S0" + to(forward ? 126.0 : 0.0);
  }
  return program;
}

void expect_beam_with_tool(const ShaperSetting& x, const ShaperSetting& y, double slope) {
  sim::Simulator simulator{sloping_raster(slope), {}};
  set_up_laser(simulator, kRasterScale, 1000.0, 20'000.0);
  SettingValues settings;
  add_shaper(0, x, settings);
  add_shaper(1, y, settings);
  for (const auto& [number, value] : settings) {
    change(simulator, static_cast<std::size_t>(number), value);
  }
  RasterLog log;
  simulator.add_sink(log);
  ASSERT_TRUE(simulator.run().refusals.empty());
  int edges = 0;
  bool was_lit = false;
  for (const sim::TraceRow& row : log.rows) {
    const bool is_lit = row.duty > 0.0F;
    if (is_lit == was_lit) continue;
    was_lit = is_lit;
    const double place = row.position[0] / kRasterScale - kRasterStart;
    const double dot = 0.5 * std::round(2.0 * place);
    EXPECT_LE(std::abs(place - dot) * kRasterScale, 1.01) << "edge " << edges << " at " << place;
    const double beside = row.position[1] - slope * (dot + kRasterStart) * kRasterScale;
    EXPECT_LE(std::abs(beside), 1.01) << "edge " << edges << " at " << place;
    ++edges;
  }
  EXPECT_EQ(edges, 6 * kRasterDots * 2);
}

TEST(Shaping, KeepsTheBeamWithTheToolInBothDirections) {
  const ShaperSetting none{};
  expect_beam_with_tool({ShaperKind::kZv, 40.0F, 0.0F}, none, 0.0);
  expect_beam_with_tool({ShaperKind::kEi, 40.0F, 0.2F}, none, 0.0);
  expect_beam_with_tool({ShaperKind::kMzv, 33.0F, 0.1F}, none, 0.4);
  expect_beam_with_tool({ShaperKind::kZvd, 50.0F, 0.1F}, {ShaperKind::kZv, 71.0F, 0.0F}, 0.4);
}

/// A shaped position is a mean of positions, so nothing is faster than the plan. Taking up backlash
/// adds its own share.
TEST(Shaping, AndBacklashKeepSpeedAndAcceleration) {
  const Trials trials{25};
  double most = 0.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    std::string program = "G21 G90 G17 G64 P0.05\nF9000\nM4 S500\n";
    for (int i = 0; i < 30; ++i) {
      const double x = random.between(0.0, 20.0);
      const double y = random.between(0.0, 20.0);
      program += (random.chance(0.3) ? "G2 R30" : "G1") + word('X', x) + word('Y', y) + "\n";
    }
    sim::Simulator simulator{program, {}};
    const double acceleration = random.magnitude(300.0, 5000.0);
    set_up_laser(simulator, 400.0, 100.0, acceleration);
    change(simulator, 0, 1.0);
    for (const auto& [number, value] : random_motor_settings(random)) {
      change(simulator, static_cast<std::size_t>(number), value);
    }
    sim::MotionMeter meter{{400.0, 400.0, 400.0, 250.0, 250.0, 250.0}};
    simulator.add_sink(meter);
    EXPECT_TRUE(simulator.run().refusals.empty());
    for (const cnc::Axis axis : {cnc::Axis::kX, cnc::Axis::kY}) {
      const sim::AxisMotion motion = meter.axis(axis);
      EXPECT_LE(motion.greatest_speed, 100.0 * 1.002);
      // An edge may be a slot of 2 µs early or late, which contributes 4 v ε / window².
      EXPECT_LE(motion.greatest_acceleration, acceleration * 1.005 + 16.0);
      most = std::max(most, motion.greatest_acceleration / acceleration);
    }
  }
  std::printf("shaping and backlash: acceleration at most %.4f of the limit\n", most);
}

}  // namespace
}  // namespace proof
