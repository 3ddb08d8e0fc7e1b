// EXPECT: the PLL cannot use this crystal
#include "hal/stm32f405/boards/generic.hpp"

namespace {

constexpr hal::stm32f405::Board faulty() {
  hal::stm32f405::Board board = hal::stm32f405::kGeneric;
  board.crystal_hz = 8'500'000;
  return board;
}
constexpr hal::stm32f405::Board kFaulty = faulty();

}  // namespace

template struct hal::stm32f405::CheckedBoard<kFaulty>;
