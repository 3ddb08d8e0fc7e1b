// EXPECT: a pin does not exist, or does two things
#include "hal/stm32f405/boards/generic.hpp"

namespace {

constexpr hal::stm32f405::Board faulty() {
  hal::stm32f405::Board board = hal::stm32f405::kGeneric;
  board.probe = hal::stm32f405::pa(12);
  return board;
}
constexpr hal::stm32f405::Board kFaulty = faulty();

}  // namespace

template struct hal::stm32f405::CheckedBoard<kFaulty>;
