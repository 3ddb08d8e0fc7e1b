#include <array>

#include "planner/base/units.hpp"
#include "planner/gcode/execution.hpp"

namespace cnc::gcode {
namespace {

/// Less is a slip: no tool is so thin.
constexpr float kNarrowestCutMm = 0.01F;

}  // namespace

/// What stops the machine, or moves it otherwise than along a path, has no place on the way beside
/// it: how an element ends is known with the next one only.
Refusal Execution::check_compensated_words() {
  if (context_.modal.compensation.side == CutterSide::kOn) return std::nullopt;
  constexpr std::array<ModalGroup, 4> kStandstill{
      ModalGroup::kToolChange, ModalGroup::kSpindle, ModalGroup::kCoolant, ModalGroup::kToolLength};
  for (const ModalGroup group : kStandstill) {
    if (block_.has(group)) return block_.blame(FaultDetail::kNotBesideThePath, group);
  }
  if (next_.modal.plane != context_.modal.plane) {
    return block_.blame(FaultDetail::kNotBesideThePath, ModalGroup::kPlane);
  }
  // A spindle's speed waits for standstill, and so may a second analog output.
  if (block_.has('S') && !options_.laser) return block_.blame(FaultDetail::kNotBesideThePath, 'S');
  if (block_.has(ModalGroup::kOutput) &&
      block_.meaning<Output>(ModalGroup::kOutput) == Output::kAnalogWithMotion) {
    return block_.blame(FaultDetail::kNotBesideThePath, ModalGroup::kOutput);
  }
  const NonModal word = block_.non_modal();
  const bool goes =
      word == NonModal::kDwell || word == NonModal::kGoToG28 || word == NonModal::kGoToG30;
  if (goes) return block_.blame(FaultDetail::kNotBesideThePath, ModalGroup::kNonModal);
  return std::nullopt;
}

/// From one side to the other, or to another width, G40 comes between (RS274/NGC 3.5.8). What is
/// as it was may be said again: senders give back the modes that they were told.
Refusal Execution::set_compensation() {
  if (!block_.has(ModalGroup::kCutterRadius)) return std::nullopt;
  CutterCompensation wanted;
  if (const auto fault = read_compensation(wanted)) return fault;
  CutterCompensation& now = next_.modal.compensation;
  if (wanted == now) return std::nullopt;
  if (wanted.side != CutterSide::kOn && now.side != CutterSide::kOn) {
    return block_.blame(FaultDetail::kAlreadyBesideThePath, ModalGroup::kCutterRadius);
  }
  now = wanted;
  Action& action = actions_.append(ActionKind::kCompensation);
  action.compensation = wanted;
  action.plane = next_.modal.plane;
  return std::nullopt;
}

Refusal Execution::read_compensation(CutterCompensation& wanted) {
  const auto word = block_.meaning<CutterRadius>(ModalGroup::kCutterRadius);
  if (word == CutterRadius::kOff) return std::nullopt;
  wanted.side = word == CutterRadius::kLeft ? CutterSide::kLeft : CutterSide::kRight;
  const Decimal* const number = block_.take('D');
  if (number == nullptr) return missing('D', ModalGroup::kCutterRadius);
  wanted.width_mm = to_length(*number).mm();
  if (wanted.width_mm < kNarrowestCutMm || wanted.width_mm > options_.widest_cut_mm) {
    const bool inches = next_.modal.units == Units::kInches;
    Fault fault = block_.blame(FaultDetail::kNotACutWidth, 'D');
    fault.limit = options_.widest_cut_mm / (inches ? kMillimetresPerInch : 1.0F);
    return fault;
  }
  return std::nullopt;
}

}  // namespace cnc::gcode
