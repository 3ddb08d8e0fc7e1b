#include "host-sim/machine/switch_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {
namespace {

constexpr double kBeyondTravelMm = 1.0;
/// Duration for which a bouncing contact keeps one reading, ticks.
constexpr std::uint64_t kBounceSlot = 400;

bool in_mask(float mask, std::size_t axis) {
  return (static_cast<unsigned>(mask) >> axis & 1U) != 0;
}

/// Returns a pseudo-random bit that depends only on `number`.
bool noise(std::uint64_t number) {
  number *= 0x9E37'79B9'7F4A'7C15U;
  return ((number >> 40) & 1U) != 0;
}

}  // namespace

void SwitchModel::place(const cnc::Settings& settings) {
  if (!model_.has_switches) return;
  for (std::size_t axis = 0; axis < switches_.size(); ++axis) {
    Switch& found = switches_[axis];
    found.low = in_mask(settings.get(cnc::setting::kHomingDirectionInvert), axis);
    found.second = in_mask(settings.get(cnc::setting::kSquaredAxes), axis);
    const auto travel = static_cast<double>(settings.get(cnc::setting::kTravel, axis));
    found.present = model_.switch_mm[axis].has_value() || travel > 0.0;
    const double end = found.low ? -kBeyondTravelMm : travel + kBeyondTravelMm;
    const auto scale = static_cast<double>(settings.get(cnc::setting::kStepsPerMm, axis));
    found.step = std::llround(model_.switch_mm[axis].value_or(end) * scale);
    const std::int64_t ahead = std::llround(model_.second_ahead_mm[axis] * scale);
    found.second_ahead = found.low ? -ahead : ahead;
  }
}

hal::SwitchMask SwitchModel::read(const PlayModel::Steps& first,
                                  const PlayModel::Steps& second,
                                  std::uint64_t tick) {
  hal::SwitchMask mask;
  for (std::size_t axis = 0; axis < switches_.size(); ++axis) {
    const Switch& found = switches_[axis];
    if (!found.present) continue;
    const auto bit = static_cast<std::uint8_t>(1U << axis);
    const auto pressed = [&](std::int64_t step) {
      return found.low ? step <= found.step : step >= found.step;
    };
    if (reads_closed(contacts_[axis][0], pressed(first[axis]), tick)) {
      mask.first = static_cast<std::uint8_t>(mask.first | bit);
    }
    const std::int64_t beside = second[axis] + found.second_ahead;
    if (found.second && reads_closed(contacts_[axis][1], pressed(beside), tick)) {
      mask.second = static_cast<std::uint8_t>(mask.second | bit);
    }
  }
  return mask;
}

std::uint64_t SwitchModel::steps_undisturbed(const PlayModel::Steps& first,
                                             const PlayModel::Steps& second) const {
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
  // If a motor is one step away from the position at which a switch changes, its next step may
  // change the reading.
  const auto stay_off = [&](std::int64_t distance) {
    const auto beyond = static_cast<std::uint64_t>(std::abs(distance));
    steps = std::min(steps, beyond > 0 ? beyond - 1 : 0);
  };
  for (std::size_t axis = 0; axis < switches_.size(); ++axis) {
    const Switch& found = switches_[axis];
    if (!found.present) continue;
    if (contacts_[axis][0].bounces || contacts_[axis][1].bounces) return 0;
    stay_off(first[axis] - found.step);
    if (found.second) stay_off(second[axis] + found.second_ahead - found.step);
  }
  return steps;
}

/// Returns the reading of a contact. The first reading after a change is the new state. As long as
/// the contact bounces, later readings are random.
bool SwitchModel::reads_closed(Contact& contact, bool pressed, std::uint64_t tick) const {
  if (pressed != contact.closed) {
    contact = {.closed = pressed, .bounces = true, .changed = tick};
    return pressed;
  }
  if (!contact.bounces) return contact.closed;
  const std::uint64_t since = tick - contact.changed;
  contact.bounces = since < model_.bounce_ticks;
  if (!contact.bounces || since < kBounceSlot) return contact.closed;
  return noise(contact.changed + since / kBounceSlot);
}

}  // namespace sim
