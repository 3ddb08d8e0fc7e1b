// EXPECT: these two pins are no CAN1
#include "hal/stm32f405/boards/generic.hpp"

namespace {

constexpr hal::stm32f405::Board faulty() {
  hal::stm32f405::Board board = hal::stm32f405::kGeneric;
  board.can_transmit = hal::stm32f405::pd(1);
  board.can_receive = hal::stm32f405::pb(10);
  return board;
}
constexpr hal::stm32f405::Board kFaulty = faulty();

}  // namespace

template struct hal::stm32f405::CheckedBoard<kFaulty>;
