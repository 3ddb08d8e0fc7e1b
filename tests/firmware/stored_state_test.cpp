#include "firmware/store/stored_state.hpp"

#include <gtest/gtest.h>

#include "hal/host/memory_store.hpp"
#include "planner/gcode/modal_state.hpp"

namespace cnc {
namespace {

std::vector<std::byte> filled(std::size_t count, unsigned char value) {
  return std::vector<std::byte>(count, std::byte{value});
}

class StoredStateTest : public testing::Test {
 protected:
  hal::host::MemoryStore store;
  StoredState state{store};
  const SettingInfo rate = *find_setting(110);
};

TEST_F(StoredStateTest, KeepsWhatDiffersFromTheDeliveredState) {
  EXPECT_TRUE(state.save_setting(rate, 6000.5F));
  EXPECT_EQ(StoredState{store}.load_setting(rate), 6000.5F);
  EXPECT_TRUE(state.save_setting(rate, rate.standard));
  EXPECT_TRUE(store.records().empty());
  EXPECT_EQ(state.load_setting(rate), std::nullopt);
}

TEST_F(StoredStateTest, KeepsEveryPlace) {
  gcode::StoredPlaces places;
  std::int64_t next = -7;
  for (Position& system : places.systems) {
    for (Coordinate& axis : system) axis = Coordinate{next = next * -3 % 1'000'000'000'000};
  }
  places.g28[1] = Coordinate{Coordinate::kFarthestNanometres};
  places.g30[5] = Coordinate{-Coordinate::kFarthestNanometres};
  EXPECT_TRUE(state.save_places(places));
  EXPECT_TRUE(state.has_saved(places));
  StoredState again{store};
  EXPECT_EQ(again.load_places(), places);
  EXPECT_TRUE(again.has_saved(places));
  EXPECT_TRUE(again.save_places({}));
  EXPECT_TRUE(store.records().empty());
}

TEST_F(StoredStateTest, KeepsTexts) {
  EXPECT_TRUE(state.save_startup_line(1, "G21 G90"));
  EXPECT_TRUE(state.save_user_text("third from the left"));
  StoredState again{store};
  EXPECT_EQ(again.load_startup_line(0).view(), "");
  EXPECT_EQ(again.load_startup_line(1).view(), "G21 G90");
  EXPECT_EQ(again.load_user_text().view(), "third from the left");
}

TEST_F(StoredStateTest, TakesTheDeliveredStateForDamagedRecordsAndSaysSo) {
  EXPECT_EQ(state.load_setting(rate), std::nullopt);
  EXPECT_FALSE(state.damaged()) << "absence is no damage";
  ASSERT_TRUE(store.save(110, filled(3, 1)));
  EXPECT_EQ(state.load_setting(rate), std::nullopt);
  EXPECT_TRUE(state.damaged());
  ASSERT_TRUE(store.save(110, filled(4, 0xFF)));  // The bytes represent NaN.
  StoredState second{store};
  EXPECT_EQ(second.load_setting(rate), std::nullopt);
  EXPECT_TRUE(second.damaged());
  ASSERT_TRUE(store.save(0x4000, filled(48, 0x7F)));  // The values are out of every range.
  StoredState third{store};
  EXPECT_EQ(third.load_places(), gcode::StoredPlaces{});
  EXPECT_TRUE(third.damaged());
}

}  // namespace
}  // namespace cnc
