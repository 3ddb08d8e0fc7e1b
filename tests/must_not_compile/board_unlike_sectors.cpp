// EXPECT: the store's sectors are not two of one size in the flash
#include "hal/stm32f405/boards/generic.hpp"

namespace {

constexpr hal::stm32f405::Board faulty() {
  hal::stm32f405::Board board = hal::stm32f405::kGeneric;
  board.store_sectors = {4, 5};
  return board;
}
constexpr hal::stm32f405::Board kFaulty = faulty();

}  // namespace

template struct hal::stm32f405::CheckedBoard<kFaulty>;
