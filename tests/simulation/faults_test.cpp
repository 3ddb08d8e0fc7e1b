#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/machine_bench.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

constexpr std::uint64_t kTickNs = sim::VirtualController::kNanosecondsPerTick;
constexpr std::uint64_t kSameTickNs = 10'000;

/// Records when the output is on and when motors step.
class BeamLog final : public sim::TraceSink {
 public:
  struct Row {
    std::uint64_t time_ns;
    bool lit;
    bool stepped;
  };

  void on_row(const sim::TraceRow& row) override {
    rows_.push_back({row.time_ns, row.duty > 0.0F, row.position != position_});
    position_ = row.position;
  }

  [[nodiscard]] bool lit_at(std::uint64_t time_ns) const {
    bool lit = false;
    for (const Row& row : rows_) {
      if (row.time_ns > time_ns) break;
      lit = row.lit;
    }
    return lit;
  }
  [[nodiscard]] bool ever_lit_from(std::uint64_t time_ns) const {
    if (lit_at(time_ns)) return true;
    for (const Row& row : rows_) {
      if (row.time_ns > time_ns && row.lit) return true;
    }
    return false;
  }
  [[nodiscard]] std::size_t steps_from(std::uint64_t time_ns) const {
    std::size_t steps = 0;
    for (const Row& row : rows_) steps += row.stepped && row.time_ns > time_ns ? 1 : 0;
    return steps;
  }

 private:
  std::vector<Row> rows_;
  cnc::AxisArray<std::int32_t> position_{};
};

/// Activity of the machine at the fault, with the beam on or off.
enum class Scene : std::uint8_t { kM3, kM4, kRapid, kHold, kDwell, kIdle, kStarved, kSpindle };

constexpr std::array<std::pair<Scene, std::string_view>, 8> kScenes{
    {{Scene::kM3, "M3 cutting"},
     {Scene::kM4, "M4 cutting"},
     {Scene::kRapid, "rapid"},
     {Scene::kHold, "hold"},
     {Scene::kDwell, "dwell"},
     {Scene::kIdle, "idle"},
     {Scene::kStarved, "a sender that fell silent"},
     {Scene::kSpindle, "spindle at rest"}}};

bool is_lit(Scene scene) {
  return scene == Scene::kM3 || scene == Scene::kM4 || scene == Scene::kSpindle;
}

/// A controller in a scene, at a random time after the scene began.
class Stage {
 public:
  Stage(Scene scene, Random& random) : scene_{scene} {
    bench_.controller.add_sink(log_);
    bench_.set({{32, scene == Scene::kSpindle ? 0 : 1}, {120, 2000}, {121, 2000}});
    for (const std::string_view line : lines()) bench_.send(line);
    bench_.run(scene == Scene::kM3 || scene == Scene::kM4 || scene == Scene::kRapid ? 60 : 1000);
    if (scene == Scene::kHold) {
      bench_.machine().feed_hold();
      bench_.run(400);
    }
    bench_.run(static_cast<int>(random.between(0.0, 200.0)));
  }

  [[nodiscard]] sim::VirtualController& controller() { return bench_.controller; }
  void run(int milliseconds) { bench_.run(milliseconds); }
  /// Runs until motion ends, at most ten seconds. Returns the time of the end, ns.
  std::uint64_t run_until_rest_ns() {
    for (int left = 10'000; controller().step_timer_runs() && left > 0; --left) run(1);
    EXPECT_FALSE(controller().step_timer_runs());
    return controller().last_event_ticks() * kTickNs;
  }
  [[nodiscard]] std::uint64_t now_tick() const { return bench_.controller.now_ticks(); }
  [[nodiscard]] std::uint64_t now_ns() const { return now_tick() * kTickNs; }
  /// Returns the record up to now. The bench cannot run afterwards.
  [[nodiscard]] const BeamLog& log() {
    bench_.controller.end();
    return log_;
  }

 private:
  [[nodiscard]] std::vector<std::string_view> lines() const {
    switch (scene_) {
      case Scene::kM3:
      case Scene::kHold:
        return {"M3 S600", "G1 X90 Y30 F3000"};
      case Scene::kM4:
        return {"M4 S600", "G1 X90 Y30 F3000"};
      case Scene::kRapid:
        return {"M3 S600", "G0 X190"};
      case Scene::kDwell:
        return {"M3 S600", "G1 X0.5 F1500", "G4 P9"};
      case Scene::kIdle:
        return {"M3 S600", "G1 X0.5 F1500"};
      case Scene::kStarved:
        return {"M4 S600", "G1 X1 F3000", "G1 X2 Y1", "G1 X4"};
      case Scene::kSpindle:
        return {"M3 S600"};
    }
    return {};
  }

  Scene scene_;
  MachineBench bench_;
  BeamLog log_;
};

class FaultInScene : public testing::TestWithParam<std::pair<Scene, std::string_view>> {
 protected:
  /// Runs the check with a fault at a random tick in each trial, not only at the boundaries of
  /// cycles.
  template <typename Check>
  void try_faults(std::uint64_t usual, const Check& check) const {
    const Trials trials{usual};
    for (const std::uint64_t seed : trials) {
      SCOPED_TRACE("KERFLINE_SEED=" + std::to_string(seed));
      Random random{seed};
      Stage stage{GetParam().first, random};
      check(stage,
            stage.now_tick() + static_cast<std::uint64_t>(random.between(0.0, 40'000.0)),
            random);
      if (HasFatalFailure() || too_many_failures()) return;
    }
  }
};

TEST_P(FaultInScene, ThatEndsTheProgramDarkensInTheSameTick) {
  try_faults(20, [](Stage& stage, std::uint64_t tick, Random&) {
    stage.controller().plant({.kind = sim::Breakdown::kProgramEnds, .tick = tick});
    stage.run(200);
    EXPECT_EQ(stage.controller().restarts(), 1U);
    const std::uint64_t at_ns = tick * kTickNs;
    EXPECT_EQ(stage.log().lit_at(at_ns - kTickNs), is_lit(GetParam().first));
    EXPECT_FALSE(stage.log().ever_lit_from(at_ns + kSameTickNs));
    EXPECT_EQ(stage.log().steps_from(at_ns + kSameTickNs), 0U);
  });
}

/// Segments that were cut before are driven, and the beam goes off at their end. A spindle turns
/// until the watchdog resets the controller.
TEST_P(FaultInScene, ThatHangsTheMainLoopDarkensWhereMotionEnds) {
  try_faults(20, [](Stage& stage, std::uint64_t tick, Random&) {
    stage.controller().plant({.kind = sim::Breakdown::kMainLoopHangs, .tick = tick});
    stage.run(1);
    const std::uint64_t rest_ns = stage.run_until_rest_ns();
    stage.run(static_cast<int>(sim::kWatchdogMs) + 20);
    EXPECT_EQ(stage.controller().restarts(), 1U);
    const std::uint64_t hung_ns = tick * kTickNs;
    EXPECT_EQ(stage.log().lit_at(hung_ns), is_lit(GetParam().first));
    const std::uint64_t bite_ns = hung_ns + (sim::kWatchdogMs + 2) * std::uint64_t{1'000'000};
    const bool spindle = GetParam().first == Scene::kSpindle;
    EXPECT_FALSE(stage.log().ever_lit_from((spindle ? bite_ns : rest_ns) + kSameTickNs));
    EXPECT_LT(rest_ns, bite_ns);
    EXPECT_EQ(stage.log().steps_from(rest_ns), 0U);
  });
}

TEST_P(FaultInScene, OfASettingIsFoundWithinASecondAndDarkens) {
  std::uint64_t latest_ns = 0;
  try_faults(20, [&](Stage& stage, std::uint64_t tick, Random& random) {
    const auto bit = static_cast<std::uint32_t>(random.between(0.0, 1.0e6));
    SCOPED_TRACE(bit);
    stage.controller().plant({sim::Breakdown::kSettingTurnsOver, tick, bit});
    while (stage.controller().restarts() == 0 && stage.now_tick() < tick + 4'000'000) stage.run(1);
    // The cycle that found the fault has ended. The beam must have been off since that cycle began.
    const std::uint64_t found_ns = stage.now_ns() - 1'000'000;
    ASSERT_EQ(stage.controller().restarts(), 1U);
    stage.run(100);
    EXPECT_FALSE(stage.log().ever_lit_from(found_ns + kSameTickNs));
    EXPECT_EQ(stage.log().steps_from(found_ns + kSameTickNs), 0U);
    latest_ns = std::max(latest_ns, found_ns - tick * kTickNs);
  });
  std::printf("found after at most %.1f ms\n", static_cast<double>(latest_ns) * 1.0e-6);
}

/// Scenes with a beam, without the spindle, which may turn at rest.
class BeamInScene : public FaultInScene {};

/// Whatever the fault, the beam must be off while nothing moves.
TEST_P(BeamInScene, IsOffWhereSpeedIsZero) {
  try_faults(5, [](Stage& stage, std::uint64_t, Random&) {
    const std::uint64_t rest_ns = stage.run_until_rest_ns();
    stage.run(1000);
    EXPECT_FALSE(stage.log().ever_lit_from(rest_ns + kSameTickNs));
  });
}

std::string name_of(const testing::TestParamInfo<std::pair<Scene, std::string_view>>& info) {
  std::string name{info.param.second};
  for (char& letter : name) letter = letter == ' ' ? '_' : letter;
  return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, FaultInScene, testing::ValuesIn(kScenes), name_of);

static_assert(kScenes.back().first == Scene::kSpindle);
INSTANTIATE_TEST_SUITE_P(Scenes,
                         BeamInScene,
                         testing::ValuesIn(kScenes.begin(), kScenes.end() - 1),
                         name_of);

}  // namespace
}  // namespace proof
