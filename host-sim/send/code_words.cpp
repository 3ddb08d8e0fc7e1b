#include "host-sim/send/code_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "firmware/protocol/code_texts.hpp"

namespace sim {
namespace {

constexpr std::array<CodeRemedy, 17> kAlarmRemedies{{
    {1, "First reset, unlock, and move the axis off the switch."},
    {2, "Reset and unlock; move the job or its origin so that it fits."},
    {3, "Without switches unlock, and set the origin again."},
    {4, "Unlock; free the probe, or move away from the plate, and probe again."},
    {5, "Unlock; start nearer to the plate, or probe farther."},
    {6, "Home, and let the cycle end."},
    {7, "Close the door and home again."},
    {8, "Check the limit switch, or raise the pull-off $27; home again."},
    {9, "Check the limit switch, or raise the travel $130…$135; home again."},
    {10, "Check the second switch of the axis; home again."},
    {11, "Send $H, or press Home."},
    {23, "Home; send longer motions, or a lower feed."},
    {24, "Release the emergency stop, reset, and home."},
    {25, "Check the cable and the sender; unlock, and resume the job."},
    {26, "Reset and unlock; correct the line that is named, or take a narrower tool."},
    {27, "Unlock; begin the job from its start, or from a line."},
    {28, "Reset and unlock; send the backup of the settings, and set the offsets again."},
}};

constexpr std::array<CodeRemedy, 35> kErrorRemedies{{
    {1, "Correct the line; text that is no G-code belongs in brackets."},
    {2, "Give the letter a number, such as X1.5."},
    {3, "$ lists the statements; check the spelling."},
    {4, "Give a value of 0 or more."},
    {5, "Set $22 so that the axes home; homing of one axis requires its bit 1."},
    {6, "Give a longer step pulse in $0."},
    {7, "Unlock or reset and try again; if it fails again, the flash is worn out."},
    {8, "Wait until the machine is idle, or stop it."},
    {9, "Home ($H) or unlock ($X); wait until a jog ends."},
    {11, "Split the line, or wait for the answers before more lines are sent."},
    {13, "Close the door."},
    {14, "Give a shorter text."},
    {15, "Jog less far, or home."},
    {16, "Send the other words in a line of their own."},
    {20, "Leave the word out, or choose Grbl in the program that wrote the file."},
    {21, "Split the line in two."},
    {22, "Give a feed with F before the first G1, G2 or G3."},
    {23, "Give the number without a fraction."},
    {24, "Split the line in two."},
    {25, "Remove one of the two words."},
    {26, "Add the axis words, such as X10."},
    {27, "Number the lines below 10,000,000, or leave N out."},
    {28, "Add the word that is named."},
    {29, "Use G54 to G59.3."},
    {30, "Write G53 beside G0 or G1."},
    {31, "Remove the axis words."},
    {32, "Add an axis word of the plane (G17, G18, G19)."},
    {33, "Correct the target: it is out of reach, or the motion cannot be driven."},
    {34, "Correct R or the end: the arc cannot have this radius."},
    {35, "Add R, or I, J or K of the plane."},
    {36, "Remove the words."},
    {37, "Write G43.1 with Z alone."},
    {38, "Give a smaller value."},
    {79, "Release the emergency stop, and reset."},
    {200, "Check the probe and the distance; start the program from here or from its start."},
}};

std::string_view remedy_in(std::span<const CodeRemedy> remedies, std::uint32_t number) {
  const auto found = std::ranges::find(
      remedies, number, [](const CodeRemedy& one) { return std::uint32_t{one.number}; });
  return found == remedies.end() ? std::string_view{} : found->remedy;
}

std::string words_and_remedy(std::span<const cnc::CodeText> texts,
                             std::span<const CodeRemedy> remedies,
                             std::uint32_t number) {
  const auto found = std::ranges::find(
      texts, number, [](const cnc::CodeText& one) { return std::uint32_t{one.number}; });
  if (found == texts.end()) return {};
  return fmt::format("{} {}", found->text, remedy_in(remedies, number));
}

}  // namespace

std::span<const CodeRemedy> alarm_remedies() { return kAlarmRemedies; }
std::span<const CodeRemedy> error_remedies() { return kErrorRemedies; }

std::string alarm_words(std::uint32_t number) {
  return words_and_remedy(cnc::alarm_texts(), kAlarmRemedies, number);
}

std::string error_words(std::uint32_t number) {
  return words_and_remedy(cnc::error_texts(), kErrorRemedies, number);
}

std::string_view error_remedy(std::uint32_t number) { return remedy_in(kErrorRemedies, number); }

}  // namespace sim
