#include "firmware/protocol/code_texts.hpp"

#include <array>

#include "planner/base/contract.hpp"

namespace cnc {
namespace {

constexpr std::array<CodeText, 35> kErrors{{
    {1, "A word of G-code begins with a letter, and only a comment holds other bytes."},
    {2, "A number is missing or has a wrong form."},
    {3, "No such $ statement, or not now."},
    {4, "The value must not be negative."},
    {5, "Homing is switched off ($22)."},
    {6, "The step pulse would be too short."},
    {7, "The store cannot keep this."},
    {8, "Only possible while the machine is idle."},
    {9, "G-code is locked out during an alarm, a jog or sleep."},
    {11, "The line is too long."},
    {13, "The safety door is open."},
    {14, "The text is too long to be kept."},
    {15, "The jog would leave the travel."},
    {16, "A jog takes F, axis words, G20, G21, G53, G90 and G91, nothing else."},
    {20, "This word is not supported."},
    {21, "Two words of one modal group."},
    {22, "No feed is set."},
    {23, "The word takes a whole number."},
    {24, "Two words claim the axis words."},
    {25, "A word is repeated."},
    {26, "Axis words are missing."},
    {27, "The line number is too large."},
    {28, "A value that a word needs is missing."},
    {29, "No such coordinate system."},
    {30, "G53 needs G0 or G1."},
    {31, "Axis words that nothing uses."},
    {32, "An arc needs an axis word in its plane."},
    {33, "The target is wrong or out of range."},
    {34, "The radius of the arc is wrong."},
    {35, "The arc needs R or a centre in its plane."},
    {36, "Words that nothing uses."},
    {37, "G43.1 needs Z and no other axis."},
    {38, "The value is larger than supported."},
    {79, "The emergency stop is pressed."},
    {200, "Stopped, or the probe did not change."},
}};

constexpr std::array<CodeText, 17> kAlarms{{
    {1, "A limit switch was reached. The position may be lost; home again."},
    {2, "The target lies beyond the travel. The position is kept."},
    {3, "Stopped while moving. The position may be lost; home again."},
    {4, "The probe was already in the state that ends probing."},
    {5, "The probe did not change within the programmed distance."},
    {6, "Homing was ended by a reset."},
    {7, "Homing was ended by the safety door."},
    {8, "Homing did not release the switch by pulling off."},
    {9, "Homing found no switch within its search distance."},
    {10, "Homing did not find the second switch of a squared axis."},
    {11, "Homing is required."},
    {23, "Motion was cut off because the plan came too late."},
    {24, "The emergency stop is pressed."},
    {25, "The link fell silent while the beam was on ($858). The position is kept."},
    {26, "The compensated path cannot be driven. The position is kept."},
    {27, "The path did not pass the position where the program was interrupted."},
    {28, "The store is damaged. Check settings and offsets, and store one of them again."},
}};

}  // namespace

std::span<const CodeText> error_texts() { return kErrors; }
std::string_view error_text(std::uint8_t number) {
  for (const CodeText& error : kErrors) {
    if (error.number == number) return error.text;
  }
  CNC_ASSERT(false);
  return {};
}

std::span<const CodeText> alarm_texts() { return kAlarms; }

}  // namespace cnc
