// EXPECT: the sheet names each pin of the board once
#include "hal/stm32f405/boards/btt_skr_2.hpp"

namespace {

constexpr hal::stm32f405::Board faulty() {
  hal::stm32f405::Board board = hal::stm32f405::kBttSkr2;
  board.probe = hal::stm32f405::pe(5);
  return board;
}
constexpr hal::stm32f405::Board kFaulty = faulty();

}  // namespace

template <>
inline constexpr hal::stm32f405::BoardSheet hal::stm32f405::kSheet<kFaulty> =
    hal::stm32f405::kSheet<hal::stm32f405::kBttSkr2>;
template struct hal::stm32f405::CheckedSheet<kFaulty>;
