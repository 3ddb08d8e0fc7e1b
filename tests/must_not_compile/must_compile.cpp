// Reference case of all the others: with these flags, correct uses must compile.
#include "hal/interface/tick_count.hpp"
#include "hal/stm32f405/boards/generic.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/base/result.hpp"
#include "planner/base/units.hpp"

using cnc::literals::operator""_mm_per_s;
using cnc::literals::operator""_nm;

namespace {

enum class Refusal { kNone };

cnc::Result<int, Refusal> make() { return 1; }

}  // namespace

template struct hal::stm32f405::CheckedBoard<hal::stm32f405::kGeneric>;

bool right_uses(hal::TickCount a, hal::TickCount b) {
  const auto speed = 10.0_mm_per_s + 10.0_mm_per_s;
  const cnc::Coordinate place = 10_nm + 10_nm;
  return a.reached(b) && speed > 1.0_mm_per_s && place > 0_nm && make().ok();
}
