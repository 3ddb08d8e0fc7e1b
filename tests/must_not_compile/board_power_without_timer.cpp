// EXPECT: the power pin has no timer channel
#include "hal/stm32f405/boards/generic.hpp"

namespace {

constexpr hal::stm32f405::Board faulty() {
  hal::stm32f405::Board board = hal::stm32f405::kGeneric;
  board.power = hal::stm32f405::pc(13);
  return board;
}
constexpr hal::stm32f405::Board kFaulty = faulty();

}  // namespace

template struct hal::stm32f405::CheckedBoard<kFaulty>;
