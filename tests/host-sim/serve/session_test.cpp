#include "host-sim/serve/session.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace sim {
namespace {

class SessionTest : public testing::Test {
 protected:
  void turn(unsigned times) {
    for (; times > 0; --times) {
      session.turn();
      while (!session.link().outgoing().empty()) {
        const auto out = session.link().outgoing();
        heard.append(reinterpret_cast<const char*>(out.data()), out.size());
        session.link().taken(out.size());
      }
    }
  }
  void send(std::string_view text) { session.link().receive(std::as_bytes(std::span{text})); }
  cnc::MachineState state() { return session.controller().machine().state(); }

  hal::host::MemoryStore store;
  Session session{MachineModel{}, {{.number = 32, .value = 1.0F, .place = "test"}}, store};
  std::string heard;
};

TEST_F(SessionTest, WelcomesASenderWithTheBannerAndThenHearsHim) {
  turn(10);
  EXPECT_EQ(heard, "");
  session.welcome_sender();
  EXPECT_FALSE(session.hears());
  turn(5);
  EXPECT_TRUE(session.hears());
  EXPECT_EQ(heard, "Grbl 1.1h ['$' for help]\r\n");
}

TEST_F(SessionTest, StopsOnThePathWithTheBeamOffWhenTheSenderIsLost) {
  session.welcome_sender();
  turn(5);
  send("M3 S1000\nG1 X30 F3000\nG1 X60\n");
  turn(300);
  ASSERT_EQ(state(), cnc::MachineState::kRun);
  ASSERT_GT(session.controller().port().power, 0);
  session.lose_sender();
  turn(2);
  EXPECT_EQ(session.controller().port().power, 0) << "at once, while it still moves";
  EXPECT_TRUE(session.controller().step_timer_runs());
  turn(1000);
  EXPECT_TRUE(session.calm());
  EXPECT_EQ(state(), cnc::MachineState::kIdle) << "the position stays known";
  const std::int32_t place = session.controller().port().position[0];
  EXPECT_GT(place, 0);
  turn(2000);
  EXPECT_EQ(session.controller().port().position[0], place) << "nothing goes on";
}

TEST_F(SessionTest, WaitsForTheMachineBeforeItWelcomesTheNext) {
  session.welcome_sender();
  turn(5);
  send("G1 X30 F3000\n");
  turn(100);
  session.lose_sender();
  turn(1);
  EXPECT_FALSE(session.calm());
  turn(1000);
  EXPECT_TRUE(session.calm());
}

TEST_F(SessionTest, RestsOnlyWhenNothingGoesOn) {
  turn(200);
  EXPECT_TRUE(session.resting());
  session.welcome_sender();
  turn(5);
  send("G4 P1\n");
  turn(500);
  EXPECT_FALSE(session.resting()) << "in a dwell";
  turn(1000);
  EXPECT_TRUE(session.resting());
  send("G1 X1 F60\n");
  turn(500);
  EXPECT_FALSE(session.resting()) << "in motion";
}

TEST_F(SessionTest, RefusesABadSettingWithItsPlace) {
  try {
    const Session other{MachineModel{}, {{.number = 110, .value = -1.0F, .place = "f:3"}}, store};
    FAIL();
  } catch (const std::invalid_argument& fault) {
    EXPECT_EQ(std::string{fault.what()}.substr(0, 10), "f:3: $110=");
  }
}

}  // namespace
}  // namespace sim
