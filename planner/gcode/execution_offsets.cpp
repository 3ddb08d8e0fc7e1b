#include "planner/base/units.hpp"
#include "planner/gcode/execution.hpp"

namespace cnc::gcode {

/// Handles G43.1, G43.4 and G49. The tool length is an offset along Z only, as in Grbl.
Refusal Execution::set_tool_length() {
  if (!block_.has(ModalGroup::kToolLength)) return std::nullopt;
  const auto word = block_.meaning<ToolLength>(ModalGroup::kToolLength);
  Coordinate length{};
  if (word != ToolLength::kCancel) {
    if (const auto fault = read_tool_length(word, length)) return fault;
  }
  const bool centre = word == ToolLength::kCentre;
  const bool changed = next_.shift.tool_length != length;
  if (centre != next_.modal.tool_centre || (centre && changed)) {
    if (const auto fault = switch_tool_centre(centre)) return fault;
  }
  next_.modal.tool_length_in_use = word != ToolLength::kCancel;
  offsets_changed_ |= changed;
  next_.shift.tool_length = length;
  return std::nullopt;
}

/// Reads the tool length from Z. G43.4 without Z keeps the present length.
Refusal Execution::read_tool_length(ToolLength word, Coordinate& length) {
  const bool centre = word == ToolLength::kCentre;
  const FaultDetail detail =
      centre ? FaultDetail::kToolCentreTakesZAlone : FaultDetail::kToolOffsetNeedsZAlone;
  const Decimal* const z = block_.take('Z');
  for (const char axis : {'X', 'Y', 'A', 'B', 'C'}) {
    if (block_.has(axis)) return block_.blame(detail, axis);
  }
  if (z == nullptr && !centre) return block_.blame(detail, ModalGroup::kToolLength);
  length = z != nullptr ? to_length(*z) : next_.shift.tool_length;
  return check_range(FaultDetail::kOffsetOutOfRange, index_of(Axis::kZ), length);
}

/// Begins or ends G43.4. The machine is at rest before and after the change, which gives positions
/// in the program another meaning. So no other word of the line may give positions.
Refusal Execution::switch_tool_centre(bool on) {
  if (on && !options_.five_axes) {
    return block_.blame(FaultDetail::kNotFiveAxes, ModalGroup::kToolLength);
  }
  const bool names_places = block_.axis_use() == AxisUse::kPlaces ||
                            (block_.axis_use() != AxisUse::kToolLength && block_.has_axis_word());
  if (names_places || block_.non_modal() != NonModal::kNothing) {
    return block_.blame(FaultDetail::kToolCentreAlone, ModalGroup::kToolLength);
  }
  next_.modal.tool_centre = on;
  static_cast<void>(actions_.append(ActionKind::kToolCentre));
  return std::nullopt;
}

/// Refuses tool changes, cutter compensation and words for positions of the axes themselves. They
/// are possible only after G49, as are probes and splines, which move() refuses.
Refusal Execution::check_words_at_tool_centre() const {
  for (const ModalGroup group : {ModalGroup::kToolChange, ModalGroup::kCutterRadius}) {
    if (!block_.has(group)) continue;
    const bool ends_it = group == ModalGroup::kCutterRadius &&
                         block_.meaning<CutterRadius>(group) == CutterRadius::kOff;
    if (!ends_it) return block_.blame(FaultDetail::kNotAtToolCentre, group);
  }
  switch (block_.non_modal()) {
    case NonModal::kGoToG28:
    case NonModal::kStoreG28:
    case NonModal::kGoToG30:
    case NonModal::kStoreG30:
    case NonModal::kMachineCoordinates:
      return block_.blame(FaultDetail::kNotAtToolCentre, ModalGroup::kNonModal);
    default:
      return std::nullopt;
  }
}

/// Handles G10, G28.1, G30.1 and the G92 family. A single action reports all changes of offsets in
/// the line, including a new coordinate system or tool length.
Refusal Execution::set_offsets() {
  Refusal fault;
  switch (block_.non_modal()) {
    case NonModal::kSetSystem:
      fault = set_system();
      break;
    case NonModal::kStoreG28:
      store(places_.g28, next_.position);
      break;
    case NonModal::kStoreG30:
      store(places_.g30, next_.position);
      break;
    case NonModal::kSetG92:
      fault = set_g92();
      break;
    case NonModal::kClearG92:
    case NonModal::kSuspendG92:
    case NonModal::kRestoreG92:
      switch_g92(block_.non_modal());
      break;
    default:
      break;
  }
  if (fault) return fault;
  if (offsets_changed_) static_cast<void>(actions_.append(ActionKind::kOffsets));
  return std::nullopt;
}

/// Handles G10. L1 sets the radius of a tool. L2 sets the origin of a coordinate system. L20 sets
/// the origin so that the present position gets the given coordinates. P0 means the coordinate
/// system in use.
Refusal Execution::set_system() {
  constexpr auto kGroup = ModalGroup::kNonModal;
  const Decimal* const kind = block_.take('L');
  if (kind != nullptr && *kind == Decimal{.whole = 1}) return set_tool_radius();
  if (!block_.has_axis_word()) return block_.blame(FaultDetail::kAxisWordsMissing, kGroup);
  std::uint32_t number = 0;
  if (const auto fault = take_index(
          'P', kGroup, kCoordinateSystemCount, FaultDetail::kNoSuchCoordinateSystem, number)) {
    return fault;
  }
  if (kind == nullptr) return missing('L', kGroup);
  const bool from_present_place = *kind == Decimal{.whole = 20};
  if (!from_present_place && *kind != Decimal{.whole = 2}) {
    return block_.blame(FaultDetail::kUnsupported, 'L');
  }
  if (!from_present_place && block_.has('R')) return block_.blame(FaultDetail::kUnsupported, 'R');
  Position& system =
      places_.systems[number == 0 ? next_.modal.coordinate_system : std::size_t{number} - 1];
  Position origin = system;
  if (const auto fault = read_origin(from_present_place, origin)) return fault;
  store(system, origin);
  return std::nullopt;
}

/// Handles G10 L1: P is the tool, and R is its radius. R0 deletes the radius.
Refusal Execution::set_tool_radius() {
  constexpr auto kGroup = ModalGroup::kNonModal;
  if (block_.has_axis_word()) return block_.blame_first_axis_word(FaultDetail::kAxisWordUnused);
  std::uint32_t tool = 0;
  if (const auto fault = take_index('P', kGroup, kToolCount, FaultDetail::kTooLarge, tool)) {
    return fault;
  }
  if (tool == 0) return block_.blame(FaultDetail::kBelowOne, 'P');
  const Decimal* const radius = block_.take('R');
  if (radius == nullptr) return missing('R', kGroup);
  const Coordinate length = to_length(*radius);
  const float max_mm = 0.5F * options_.widest_cut_mm;
  if (length < Coordinate{} || length.mm() > max_mm) {
    Fault fault = block_.blame(FaultDetail::kNotACutWidth, 'R');
    const bool inches = next_.modal.units == Units::kInches;
    fault.limit = max_mm / (inches ? kMillimetresPerInch : 1.0F);
    return fault;
  }
  AxisArray<Coordinate>& row = places_.tool_radii[(tool - 1) / kAxisCount];
  AxisArray<Coordinate> changed = row;
  changed[(tool - 1) % kAxisCount] = length;
  store(row, changed);
  return std::nullopt;
}

Refusal Execution::read_origin(bool from_present_place, Position& origin) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const Decimal* const number = block_.take(kAxisLetters[axis]);
    if (number == nullptr) continue;
    const Coordinate value = to_axis_value(axis, *number);
    const Coordinate base = next_.position[axis] - shift_of(next_.shift, axis);
    origin[axis] = from_present_place ? base - value : value;
    if (const auto fault = check_range(FaultDetail::kOffsetOutOfRange, axis, origin[axis])) {
      return fault;
    }
  }
  return std::nullopt;
}

/// Handles G92. Axes without a word keep the offset that is in effect. An offset that G92.2 has
/// suspended is deleted first.
Refusal Execution::set_g92() {
  if (!block_.has_axis_word()) {
    return block_.blame(FaultDetail::kAxisWordsMissing, ModalGroup::kNonModal);
  }
  Shift& shift = next_.shift;
  if (!shift.g92_in_use) shift.g92 = Position{};
  shift.g92_in_use = true;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const Decimal* const number = block_.take(kAxisLetters[axis]);
    if (number == nullptr) continue;
    const Coordinate present = next_.position[axis] - work_offset(next_, places_, axis);
    shift.g92[axis] += present - to_axis_value(axis, *number);
    if (const auto fault = check_range(FaultDetail::kOffsetOutOfRange, axis, shift.g92[axis])) {
      return fault;
    }
  }
  offsets_changed_ = true;
  return std::nullopt;
}

/// Handles the other words of the family: G92.1 deletes the offset, G92.2 suspends it, and G92.3
/// restores it.
void Execution::switch_g92(NonModal word) {
  if (word == NonModal::kClearG92) next_.shift.g92 = Position{};
  next_.shift.g92_in_use = word == NonModal::kRestoreG92;
  offsets_changed_ = true;
}

void Execution::store(Position& place, const Position& value) {
  stored_ = &place;
  stored_value_ = value;
  offsets_changed_ = true;
}

/// Handles G28 and G30: a rapid to the stored position. With axis words, the machine first moves to
/// the position that these words give. Then only the axes of these words move to the stored
/// position.
Refusal Execution::go_to_stored_place() {
  const NonModal word = block_.non_modal();
  if (word != NonModal::kGoToG28 && word != NonModal::kGoToG30) return std::nullopt;
  Position end = word == NonModal::kGoToG28 ? places_.g28 : places_.g30;
  if (block_.has_axis_word()) {
    Position via = next_.position;
    if (const auto fault = read_target(via)) return fault;
    actions_.append(ActionKind::kRapid).end = via;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (!block_.has(kAxisLetters[axis])) end[axis] = next_.position[axis];
    }
  }
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (within_reach(axis, end[axis])) continue;
    const Fault fault = block_.blame(FaultDetail::kTargetOutOfRange, ModalGroup::kNonModal);
    return out_of_reach(fault, axis, end[axis]);
  }
  actions_.append(ActionKind::kRapid).end = end;
  next_.position = end;
  return std::nullopt;
}

}  // namespace cnc::gcode
