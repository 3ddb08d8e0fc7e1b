#include <algorithm>
#include <array>
#include <cstdint>

#include "planner/base/units.hpp"
#include "planner/gcode/execution.hpp"
#include "planner/gcode/kerf_condition.hpp"
#include "planner/kerf/kerf_lookup.hpp"

namespace cnc::gcode {
namespace {

/// Least width of a cut, mm. A smaller width is a mistake, because no tool is so thin.
constexpr float kNarrowestCutMm = 0.01F;

constexpr float kMicrometresPerMillimetre = 1000.0F;
/// Factor from mm/s to µm/min.
constexpr float kMicrometresPerMinute = 60.0F * kMicrometresPerMillimetre;

/// Returns the nearest whole number. @pre value ≥ 0
std::uint32_t whole(float value) { return static_cast<std::uint32_t>(value + 0.5F); }

/// Completes a fault with its reason, the requested value and the nearest permitted value, in mm, W
/// or mm/min.
Fault kerf_fault(Fault fault, const kerf::Condition& asked, const kerf::Refusal& refusal) {
  constexpr float kThousandth = 1.0F / 1000.0F;
  std::uint32_t value = asked.power_mw;
  switch (refusal.reason) {
    case kerf::RefusalReason::kThickness:
      fault.detail = FaultDetail::kNotThisThickness;
      value = asked.thickness_um;
      break;
    case kerf::RefusalReason::kPower:
      fault.detail = FaultDetail::kNotThisPower;
      break;
    case kerf::RefusalReason::kSpeed:
      fault.detail = FaultDetail::kNotThisSpeed;
      value = asked.speed_um_min;
      break;
    case kerf::RefusalReason::kNoSpeed:
      break;
  }
  fault.value = static_cast<float>(value) * kThousandth;
  fault.limit = static_cast<float>(std::clamp(value, refusal.least, refusal.most)) * kThousandth;
  return fault;
}

}  // namespace

kerf::Condition kerf_condition(const ModalState& modal, const Options& options) {
  const float share = std::min(modal.spindle_speed / options.full_power_speed, 1.0F);
  return {.thickness_um = modal.material.thickness_um,
          .power_mw = whole(share * static_cast<float>(options.greatest_power_mw)),
          .speed_um_min = whole(modal.feed * kMicrometresPerMinute)};
}

/// Refuses, between G41 or G42 and G40, words that stop the machine or move it away from the path.
/// A stop is impossible there, because the end of an element's offset depends on the next element.
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
  // The speed of a spindle changes only at standstill. An analog output may be the speed of a
  // second spindle.
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

/// Handles G40, G41, G42, G41.1 and G42.1. A G40 must come between one side and the other, or
/// between two widths (RS274/NGC 3.5.8). But the present state may be repeated, because senders
/// restore the modes that were reported.
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
  const bool left = word == CutterRadius::kLeft || word == CutterRadius::kLeftByWidth;
  wanted.side = left ? CutterSide::kLeft : CutterSide::kRight;
  const bool by_width = word == CutterRadius::kLeftByWidth || word == CutterRadius::kRightByWidth;
  if (by_width) return read_cut_width(wanted.width_mm);
  wanted.by_kerf = options_.laser && !block_.has('D');
  return wanted.by_kerf ? look_up_kerf(wanted.width_mm) : read_tool_width(wanted.width_mm);
}

/// Reads the width of the tool that D selects in G41 and G42. D0, or no D, selects the tool in the
/// spindle. D0 without a tool in the spindle gives width 0, so that the programmed path itself is
/// driven, as in LinuxCNC.
Refusal Execution::read_tool_width(float& width_mm) {
  std::uint32_t tool = next_.modal.tool;
  if (block_.has('D')) {
    if (const auto fault =
            take_index('D', ModalGroup::kCutterRadius, kToolCount, FaultDetail::kTooLarge, tool)) {
      return fault;
    }
    if (tool == 0) tool = next_.modal.tool;
    if (tool == 0) return std::nullopt;
  }
  const bool listed = tool >= 1 && tool <= kToolCount;
  if (listed) {
    width_mm = 2.0F * places_.tool_radii[(tool - 1) / kAxisCount][(tool - 1) % kAxisCount].mm();
  }
  if (!listed || width_mm < kNarrowestCutMm) {
    return block_.blame(FaultDetail::kToolHasNoRadius, ModalGroup::kCutterRadius);
  }
  return std::nullopt;
}

/// Reads D of G41.1 and G42.1. The width 0 means that the programmed path itself is driven.
Refusal Execution::read_cut_width(float& width_mm) {
  const Decimal* const number = block_.take('D');
  if (number == nullptr) return missing('D', ModalGroup::kCutterRadius);
  width_mm = to_length(*number).mm();
  if (width_mm == 0.0F) return std::nullopt;
  if (width_mm < kNarrowestCutMm || width_mm > options_.widest_cut_mm) {
    const bool inches = next_.modal.units == Units::kInches;
    Fault fault = block_.blame(FaultDetail::kNotACutWidth, 'D');
    fault.limit = options_.widest_cut_mm / (inches ? kMillimetresPerInch : 1.0F);
    return fault;
  }
  return std::nullopt;
}

/// Reads the width from the material's kerf table at the present power and speed, which S and F do
/// not change until G40.
Refusal Execution::look_up_kerf(float& width_mm) const {
  const auto blame = [this](FaultDetail detail) {
    return block_.blame(detail, ModalGroup::kCutterRadius);
  };
  const ModalState& modal = next_.modal;
  const bool selected = options_.kerf != nullptr && modal.material.thickness_um != 0 &&
                        options_.kerf->holds(modal.material.table);
  if (!selected) return blame(FaultDetail::kMaterialMissing);
  if (options_.greatest_power_mw == 0) return blame(FaultDetail::kKerfNeedsWatts);
  if (modal.feed <= 0.0F) return blame(FaultDetail::kFeedMissing);
  const kerf::Condition condition = kerf_condition(modal, options_);
  const auto width = kerf::kerf_width(options_.kerf->view, condition);
  if (!width.ok()) {
    return kerf_fault(block_.blame(FaultDetail::kNoSpeedAtAll, ModalGroup::kCutterRadius),
                      condition,
                      width.error());
  }
  width_mm = width.value();
  return std::nullopt;
}

/// Handles M190 P Q, which selects a kerf table and a thickness. The table does not have to contain
/// this thickness.
Refusal Execution::set_material() {
  if (!block_.has(ModalGroup::kMaterial)) return std::nullopt;
  const std::uint32_t count = options_.kerf != nullptr ? options_.kerf->count : 0;
  std::uint32_t table = 0;
  const std::uint32_t last = count > 0 ? count - 1 : 0;
  if (const auto fault =
          take_index('P', ModalGroup::kMaterial, last, FaultDetail::kNoSuchMaterial, table)) {
    return fault;
  }
  const Decimal* const thickness = block_.take('Q');
  if (thickness == nullptr) return missing('Q', ModalGroup::kMaterial);
  const float thickness_um = to_length(*thickness).mm() * kMicrometresPerMillimetre;
  constexpr auto kMax = static_cast<float>(kerf::kMaxThicknessUm);
  if (thickness_um < 1.0F) return block_.blame(FaultDetail::kNegative, 'Q');
  if (thickness_um > kMax) {
    Fault fault = block_.blame(FaultDetail::kTooLarge, 'Q');
    const bool inches = next_.modal.units == Units::kInches;
    fault.limit = kMax / kMicrometresPerMillimetre / (inches ? kMillimetresPerInch : 1.0F);
    return fault;
  }
  next_.modal.material = {.table = table, .thickness_um = whole(thickness_um)};
  return std::nullopt;
}

/// Returns whether the path is offset by a kerf and the line has no word that could end the offset.
/// The width of the kerf is then constant, so power and speed must not change.
bool Execution::keeps_kerf() const {
  return context_.modal.compensation.by_kerf && !block_.has(ModalGroup::kCutterRadius);
}

}  // namespace cnc::gcode
