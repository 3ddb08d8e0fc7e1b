// Pins that a board uses for other devices, by its maker's firmware (Marlin,
// pins_BTT_SKR_V2_0_common.h, pins_BTT_SKR_PRO_common.h, pins_MKS_ROBIN_NANO_V3_common.h). The
// boards of the product must not name them.

#include <gtest/gtest.h>

#include <vector>

#include "hal/stm32f405/board_sheet.hpp"
#include "hal/stm32f405/boards/btt_skr_2.hpp"
#include "hal/stm32f405/boards/btt_skr_pro_1_2.hpp"
#include "hal/stm32f405/boards/generic.hpp"
#include "hal/stm32f405/boards/mks_robin_nano_v3.hpp"

namespace hal::stm32f405 {
namespace {

struct Taken {
  const Board& board;
  std::vector<Pin> driver_uarts;
  std::vector<Pin> thermistors;
  std::vector<Pin> memories;  ///< Pins of SD card and EEPROM.
};

const std::vector<Taken> kTaken{
    {kBttSkr2,
     {pe(0), pd(3), pd(0), pc(6), pd(12)},
     {pa(1), pa(2), pa(3)},
     {pc(8), pc(9), pc(10), pc(11), pc(12), pd(2)}},
    {kBttSkrPro12,
     {pc(13), pe(3), pe(1), pd(4), pd(1), pd(6)},
     {pf(3), pf(4), pf(5), pf(6)},
     {pa(4), pa(5), pa(6), pb(5), pb(11)}},
    {kMksRobinNanoV30,
     {pd(5), pd(7), pd(4), pd(9), pd(8)},
     {pc(0), pc(1), pa(2)},
     {pb(6), pb(7), pc(9), pc(10), pc(11), pc(12), pd(12)}},
};

TEST(BoardFacts, NoneIsADriversUartAThermistorsOrAMemorys) {
  for (const Taken& taken : kTaken) {
    const PinCensus pins = pins_of(taken.board);
    for (const std::vector<Pin>& some : {taken.driver_uarts, taken.thermistors, taken.memories}) {
      for (const Pin pin : some) {
        EXPECT_FALSE(pins.has(pin))
            << taken.board.name << ": P" << char('A' + pin.port) << unsigned{pin.number};
      }
    }
  }
}

TEST(BoardFacts, EachMotorOfABoardHasItsOwnLimitSwitch) {
  for (const Taken& taken : kTaken) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      EXPECT_EQ(taken.board.motors[axis].step.exists(), taken.board.limits[axis].exists())
          << taken.board.name << ", axis " << axis;
    }
  }
  EXPECT_EQ(pa(0), kBttSkr2.limits[4]);
  EXPECT_EQ(pe(10), kBttSkrPro12.limits[4]);
  EXPECT_EQ(pg(5), kBttSkrPro12.limits[5]);
  EXPECT_EQ(pc(4), kMksRobinNanoV30.limits[3]);
}

TEST(BoardFacts, ARobinNanosButtonsAreAtItsConnectors) {
  const Board& board = kMksRobinNanoV31;
  EXPECT_EQ(pe(6), board.start);
  EXPECT_EQ(pa(13), board.hold);
  EXPECT_EQ(pe(12), board.reset);
  EXPECT_EQ(pa(6), board.door);
  EXPECT_EQ(pa(5), board.probe);
  EXPECT_EQ(pb(0), kMksRobinNanoV31He1.power);
}

TEST(BoardFacts, OnlyBoardsWithATransceiverOrItsPinsOnHeadersSpeakCan) {
  for (const Taken& taken : kTaken) EXPECT_FALSE(taken.board.can_transmit.exists());
  EXPECT_TRUE(kGenericCan.can_transmit.exists());
}

TEST(BoardFacts, WhoFlashesAnSkr2IsAskedForItsRevision) {
  EXPECT_NE(std::string::npos, std::string{kSheet<kBttSkr2>.caution}.find("revision B?"));
}

}  // namespace
}  // namespace hal::stm32f405
