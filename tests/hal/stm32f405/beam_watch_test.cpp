#include "hal/stm32f405/beam_watch.hpp"

#include <gtest/gtest.h>

#include "hal/stm32f405/boards/generic.hpp"
#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

/// A step clock at a chosen count, with its interrupt due at another count, and the beam's output.
class BeamWatchTest : public testing::Test {
 protected:
  static constexpr std::uint32_t kSlice = 4000;
  static constexpr Word kNow = 0xFFFF'FF00;  ///< A count shortly before the counter overflows.

  BeamWatchTest() { power_.set_up(kFullSpeed); }

  bool lit_at_rest(std::uint16_t duty, std::int32_t due_in) {
    power_.set_duty(duty);
    chip_.cells[timer::kTim2 + timer::kCounter] = kNow;
    chip_.cells[timer::kTim2 + timer::compare(1)] = kNow + static_cast<Word>(due_in);
    return BeamWatch<kGeneric, ModelBus>::lit_at_rest(kSlice);
  }

  ChipModel& chip_ = ModelBus::start_anew();
  PowerPin<kGeneric, ModelBus> power_;
};

TEST_F(BeamWatchTest, ABeamMayBeLitWhileTheNextStepIsNear) {
  for (const std::int32_t due_in : {-400, -1, 0, 20, 3999, 4000}) {
    EXPECT_FALSE(lit_at_rest(65535, due_in)) << due_in;
    EXPECT_FALSE(lit_at_rest(20, due_in)) << due_in;
  }
}

TEST_F(BeamWatchTest, ABeamMayNotBeLitAtRest) {
  EXPECT_TRUE(lit_at_rest(65535, 40'000)) << "as at rest";
  EXPECT_TRUE(lit_at_rest(200, 4001));
}

TEST_F(BeamWatchTest, NorWhenTheStepInterruptHangs) {
  EXPECT_TRUE(lit_at_rest(200, -401));
  EXPECT_TRUE(lit_at_rest(200, -4'000'000));
}

TEST_F(BeamWatchTest, ADarkOneMayRestAsLongAsItLikes) {
  for (const std::int32_t due_in : {-1'000'000, -401, 0, 4001, 40'000}) {
    EXPECT_FALSE(lit_at_rest(0, due_in)) << due_in;
  }
}

TEST_F(BeamWatchTest, LightAtRestIsJudgedByTheRegisters) {
  using Watch = BeamWatch<kGeneric, ModelBus>;
  for (const std::uint16_t duty : {std::uint16_t{700}, std::uint16_t{6554}, std::uint16_t{65535}}) {
    power_.set_duty(duty);
    EXPECT_TRUE(Watch::brighter_than(0));
    EXPECT_FALSE(Watch::brighter_than(duty));
    EXPECT_FALSE(Watch::brighter_than(65535));
    EXPECT_TRUE(Watch::brighter_than(static_cast<std::uint16_t>(duty / 2)));
  }
}

TEST_F(BeamWatchTest, AMotionThatBeginsIsNotTakenForRest) {
  StepTimer<ModelBus> clock;
  clock.set_up(kFullSpeed);
  chip_.cells[timer::kTim2 + timer::kCounter] = 5000;
  clock.begin_turns();
  chip_.cells[timer::kTim2 + timer::kCounter] = chip_.cells[timer::kTim2 + timer::compare(2)];
  power_.set_duty(0);
  clock.on_interrupt([] { return 0U; }, [&] { clock.start(); });
  bool seen = false;
  bool played = false;
  clock.on_interrupt(
      [&] {
        // The beam goes on before the interrupt has set its next time.
        power_.set_duty(30'000);
        seen = BeamWatch<kGeneric, ModelBus>::lit_at_rest(kSlice);
        played = true;
        return 100U;
      },
      [] {});
  EXPECT_TRUE(played);
  EXPECT_FALSE(seen);
}

}  // namespace
}  // namespace hal::stm32f405
