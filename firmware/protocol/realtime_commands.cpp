#include "firmware/protocol/realtime_commands.hpp"

#include <algorithm>

namespace cnc {
namespace {

constexpr int kMinFeed = 10;
constexpr int kMaxFeed = 200;

/// Returns the percentage after a step. A step beyond the range ends at the limit of the range, as
/// in Grbl.
int stepped(int percent, int step) { return std::clamp(percent + step, kMinFeed, kMaxFeed); }

/// Changes the override that `command` names. Returns false if `command` names no override.
bool change(RealtimeByte command, OverridePercent& percent) {
  switch (command) {
    case RealtimeByte::kFeedReset:
      percent.feed = 100;
      return true;
    case RealtimeByte::kFeedUp10:
      percent.feed = stepped(percent.feed, 10);
      return true;
    case RealtimeByte::kFeedDown10:
      percent.feed = stepped(percent.feed, -10);
      return true;
    case RealtimeByte::kFeedUp1:
      percent.feed = stepped(percent.feed, 1);
      return true;
    case RealtimeByte::kFeedDown1:
      percent.feed = stepped(percent.feed, -1);
      return true;
    case RealtimeByte::kRapidFull:
      percent.rapid = 100;
      return true;
    case RealtimeByte::kRapidHalf:
      percent.rapid = 50;
      return true;
    case RealtimeByte::kRapidQuarter:
      percent.rapid = 25;
      return true;
    case RealtimeByte::kPowerReset:
      percent.power = 100;
      return true;
    case RealtimeByte::kPowerUp10:
      percent.power = stepped(percent.power, 10);
      return true;
    case RealtimeByte::kPowerDown10:
      percent.power = stepped(percent.power, -10);
      return true;
    case RealtimeByte::kPowerUp1:
      percent.power = stepped(percent.power, 1);
      return true;
    case RealtimeByte::kPowerDown1:
      percent.power = stepped(percent.power, -1);
      return true;
    default:
      return false;
  }
}

}  // namespace

void apply(RealtimeByte command, Machine& machine) {
  OverridePercent percent = machine.overrides();
  if (change(command, percent)) return machine.set_overrides(percent);
  switch (command) {
    case RealtimeByte::kFeedHold:
    case RealtimeByte::kFeedHoldRaw:
      return machine.feed_hold();
    case RealtimeByte::kCycleStart:
    case RealtimeByte::kCycleStartRaw:
      return machine.resume();
    case RealtimeByte::kSafetyDoor:
      return machine.safety_door();
    case RealtimeByte::kJogCancel:
      return machine.jog_cancel();
    case RealtimeByte::kOptionalStop:
      return machine.switches().toggle_optional_stop();
    case RealtimeByte::kSingleBlock:
      return machine.switches().toggle_single_block();
    case RealtimeByte::kSpindleStop:
      return machine.toggle_spindle_stop();
    case RealtimeByte::kFlood:
      return machine.toggle_coolant({.flood = true});
    case RealtimeByte::kMist:
      return machine.toggle_coolant({.mist = true});
    default:
      return;
  }
}

}  // namespace cnc
