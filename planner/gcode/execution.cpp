#include "planner/gcode/execution.hpp"

#include <array>
#include <span>

#include "planner/base/units.hpp"

namespace cnc::gcode {

namespace {

constexpr std::uint32_t kLargestLineNumber = 9'999'999;
constexpr std::uint32_t kLastDigitalOutput = 7;
constexpr std::uint32_t kLastAnalogOutput = 3;

Fault with_limit(Fault fault, float limit) {
  fault.limit = limit;
  return fault;
}

/// Sets `mode` to the meaning of the line's word of a modal group, if there is such a word.
template <typename Mode>
void adopt(const Block& block, ModalGroup group, Mode& mode) {
  if (block.has(group)) mode = block.meaning<Mode>(group);
}

}  // namespace

/// Performs the steps of RS274/NGC table 8 in order. Outputs change in the same step as in
/// LinuxCNC. All words that only set a mode are handled before these steps. This order matters only
/// for F: as in Grbl, F is read in the units that its own line selects.
Refusal Execution::run() {
  if (options_.changes_tool) {
    if (const auto fault = check_tool_change_words()) return fault;
  }
  static constexpr std::array<Step, 7> kFirst{{
      &Execution::check_signs,
      &Execution::check_open_nurbs,
      &Execution::check_compensated_words,
      &Execution::number_line,
      &Execution::set_feed,
      &Execution::set_spindle_speed,
      &Execution::select_tool,
  }};
  // Steps for G and M words other than motion words. Most lines have no such word and omit these
  // steps, which saves time.
  static constexpr std::array<Step, 11> kByWord{{
      &Execution::change_tool,
      &Execution::set_output,
      &Execution::set_spindle,
      &Execution::set_coolant,
      &Execution::dwell,
      &Execution::set_tool_length,
      &Execution::set_material,
      &Execution::set_compensation,
      &Execution::set_path_control,
      &Execution::set_offsets,
      &Execution::go_to_stored_place,
  }};
  static constexpr std::array<Step, 3> kLast{{
      &Execution::move,
      &Execution::check_powers,
      &Execution::stop,
  }};
  set_modes();
  if (context_.modal.tool_centre) {
    if (const auto fault = check_words_at_tool_centre()) return fault;
  }
  if (const auto fault = take_steps(kFirst)) return fault;
  if (!block_.has_no_word_but_motion()) {
    if (const auto fault = take_steps(kByWord)) return fault;
  }
  if (const auto fault = take_steps(kLast)) return fault;
  return block_.unused_word();
}

/// Refuses the words for spindle, coolant, outputs, tool, pauses and all other state of the
/// program. They must wait until the tool change has ended.
Refusal Execution::check_tool_change_words() const {
  constexpr std::array<ModalGroup, 7> kOfTheProgram{ModalGroup::kToolChange,
                                                    ModalGroup::kSpindle,
                                                    ModalGroup::kCoolant,
                                                    ModalGroup::kOutput,
                                                    ModalGroup::kStop,
                                                    ModalGroup::kMaterial,
                                                    ModalGroup::kCutterRadius};
  for (const ModalGroup group : kOfTheProgram) {
    if (block_.has(group)) return block_.blame(FaultDetail::kNotInToolChange, group);
  }
  for (const char letter : {'S', 'T'}) {
    if (block_.has(letter)) return block_.blame(FaultDetail::kNotInToolChange, letter);
  }
  return std::nullopt;
}

/// Performs the steps in order, up to the first step that refuses the line.
Refusal Execution::take_steps(std::span<const Step> steps) {
  for (const Step step : steps) {
    if (const auto fault = (this->*step)()) return fault;
  }
  return std::nullopt;
}

void Execution::commit() {
  context_ = next_;
  commit_nurbs();
  if (stored_value_) *stored_ = *stored_value_;
}

void Execution::set_modes() {
  ModalState& modal = next_.modal;
  adopt(block_, ModalGroup::kMotion, modal.motion);
  adopt(block_, ModalGroup::kPlane, modal.plane);
  adopt(block_, ModalGroup::kDistance, modal.distance);
  adopt(block_, ModalGroup::kArcDistance, modal.arc_distance);
  adopt(block_, ModalGroup::kFeedMode, modal.feed_mode);
  adopt(block_, ModalGroup::kUnits, modal.units);
  adopt(block_, ModalGroup::kCoordinateSystem, modal.coordinate_system);
  offsets_changed_ = modal.coordinate_system != context_.modal.coordinate_system;
}

/// Refuses a negative P, except in G5: there, P is the component of a vector and may be negative.
/// No other letter may be negative in some lines and not in others, so `Block` checks the others.
Refusal Execution::check_signs() {
  const bool length = next_.modal.motion == MotionMode::kCubicSpline;
  if (length || !block_.has('P') || !block_.value('P').is_negative()) return std::nullopt;
  return block_.blame(FaultDetail::kNegative, 'P');
}

Refusal Execution::number_line() {
  next_.modal.line_number = 0;
  const Decimal* const number = block_.take('N');
  if (number == nullptr) return std::nullopt;
  if (number->whole > kLargestLineNumber) {
    return with_limit(block_.blame(FaultDetail::kLineNumberTooLarge, 'N'),
                      static_cast<float>(kLargestLineNumber));
  }
  next_.modal.line_number = number->whole;
  return std::nullopt;
}

/// Sets the feed. In G93 an F holds for its own line only. So after a line in G93, no feed is set.
Refusal Execution::set_feed() {
  ModalState& modal = next_.modal;
  const Decimal* const per_minute = block_.take('F');
  if (modal.feed_mode == FeedMode::kInverseTime) {
    inverse_time_ = per_minute != nullptr ? per_minute->to_float() : 0.0F;
    modal.feed = 0.0F;
    modal.rotary_feed = 0.0F;
  } else if (per_minute != nullptr) {
    modal.rotary_feed = per_minute->to_float() / kSecondsPerMinute;
    const bool inches = modal.units == Units::kInches;
    modal.feed = inches ? modal.rotary_feed * kMillimetresPerInch : modal.rotary_feed;
  }
  if (keeps_kerf() && modal.feed != context_.modal.feed) {
    return block_.blame(FaultDetail::kNotBesideThePath, 'F');
  }
  return std::nullopt;
}

Refusal Execution::set_spindle_speed() {
  const Decimal* const number = block_.take('S');
  if (number == nullptr) return std::nullopt;
  if (!block_.powers().empty()) return set_powers();
  const float speed = number->to_float();
  if (speed > options_.highest_spindle_speed) {
    return with_limit(block_.blame(FaultDetail::kTooLarge, 'S'), options_.highest_spindle_speed);
  }
  if (keeps_kerf() && speed != context_.modal.spindle_speed) {
    return block_.blame(FaultDetail::kNotBesideThePath, 'S');
  }
  next_.modal.spindle_speed = speed;
  actions_.append(ActionKind::kSpindleSpeed).value = speed;
  return std::nullopt;
}

/// Reads several values of S, one for each part of a G1, as LightBurn combines them. The last value
/// stays in effect after the line.
Refusal Execution::set_powers() {
  if (!options_.laser) return block_.blame(FaultDetail::kPowersNeedLaser, 'S');
  if (keeps_kerf()) return block_.blame(FaultDetail::kNotBesideThePath, 'S');
  for (const float power : block_.powers()) {
    if (power <= options_.highest_spindle_speed) continue;
    Fault fault =
        with_limit(block_.blame(FaultDetail::kTooLarge, 'S'), options_.highest_spindle_speed);
    fault.value = power;
    return fault;
  }
  next_.modal.spindle_speed = block_.powers().back();
  powers_wait_ = true;
  return std::nullopt;
}

Refusal Execution::check_powers() {
  if (!powers_wait_) return std::nullopt;
  return block_.blame(FaultDetail::kPowersNeedLine, 'S');
}

Refusal Execution::select_tool() {
  const Decimal* const number = block_.take('T');
  if (number == nullptr) return std::nullopt;
  if (number->whole > options_.highest_tool) {
    return with_limit(block_.blame(FaultDetail::kTooLarge, 'T'),
                      static_cast<float>(options_.highest_tool));
  }
  next_.modal.tool = number->whole;
  actions_.append(ActionKind::kTool).number = number->whole;
  return std::nullopt;
}

/// Requests a change to the tool that T has selected in this line or in an earlier line.
Refusal Execution::change_tool() {
  if (!block_.has(ModalGroup::kToolChange)) return std::nullopt;
  actions_.append(ActionKind::kToolChange).number = next_.modal.tool;
  return std::nullopt;
}

Refusal Execution::set_output() {
  if (!block_.has(ModalGroup::kOutput)) return std::nullopt;
  const auto output = block_.meaning<Output>(ModalGroup::kOutput);
  const bool analog = output == Output::kAnalog || output == Output::kAnalogWithMotion;
  return analog ? set_analog_output(output) : set_digital_output(output);
}

Refusal Execution::set_digital_output(Output output) {
  std::uint32_t number = 0;
  if (const auto fault = take_index(
          'P', ModalGroup::kOutput, kLastDigitalOutput, FaultDetail::kTooLarge, number)) {
    return fault;
  }
  const bool on = output == Output::kOn || output == Output::kOnWithMotion;
  actions_.append(ActionKind::kOutput).output = {
      .number = static_cast<std::uint8_t>(number),
      .analog = false,
      .with_motion = output == Output::kOnWithMotion || output == Output::kOffWithMotion,
      .value = on ? 1.0F : 0.0F};
  return std::nullopt;
}

Refusal Execution::set_analog_output(Output output) {
  std::uint32_t number = 0;
  if (const auto fault =
          take_index('E', ModalGroup::kOutput, kLastAnalogOutput, FaultDetail::kTooLarge, number)) {
    return fault;
  }
  const Decimal* const value = block_.take('Q');
  if (value == nullptr) return missing('Q', ModalGroup::kOutput);
  actions_.append(ActionKind::kOutput).output = {.number = static_cast<std::uint8_t>(number),
                                                 .analog = true,
                                                 .with_motion = output == Output::kAnalogWithMotion,
                                                 .value = value->to_float()};
  return std::nullopt;
}

Refusal Execution::set_spindle() {
  if (!block_.has(ModalGroup::kSpindle)) return std::nullopt;
  adopt(block_, ModalGroup::kSpindle, next_.modal.spindle);
  actions_.append(ActionKind::kSpindle).spindle = next_.modal.spindle;
  return std::nullopt;
}

Refusal Execution::set_coolant() {
  if (!block_.has(ModalGroup::kCoolant)) return std::nullopt;
  Coolant& coolant = next_.modal.coolant;
  switch (block_.meaning<CoolantWord>(ModalGroup::kCoolant)) {
    case CoolantWord::kMist:
      coolant.mist = true;
      break;
    case CoolantWord::kFlood:
      coolant.flood = true;
      break;
    case CoolantWord::kBoth:
      coolant = Coolant{.mist = true, .flood = true};
      break;
    case CoolantWord::kOff:
      coolant = Coolant{};
      break;
  }
  actions_.append(ActionKind::kCoolant).coolant = coolant;
  return std::nullopt;
}

Refusal Execution::dwell() {
  if (block_.non_modal() != NonModal::kDwell) return std::nullopt;
  const Decimal* const number = block_.take('P');
  if (number == nullptr) return missing('P', ModalGroup::kNonModal);
  const float seconds = number->to_float();
  if (seconds > options_.longest_dwell_s) {
    return with_limit(block_.blame(FaultDetail::kTooLarge, 'P'), options_.longest_dwell_s);
  }
  actions_.append(ActionKind::kDwell).seconds = seconds;
  return std::nullopt;
}

Refusal Execution::stop() {
  if (!block_.has(ModalGroup::kStop)) return std::nullopt;
  const auto word = block_.meaning<Stop>(ModalGroup::kStop);
  if (word == Stop::kEnd) {
    end_program();
  } else if (next_.modal.compensation.side != CutterSide::kOn) {
    return block_.blame(FaultDetail::kNotBesideThePath, ModalGroup::kStop);
  } else {
    actions_.append(ActionKind::kPause).number = word == Stop::kOptionalPause ? 1 : 0;
  }
  return std::nullopt;
}

/// Ends the program as Grbl 1.1 does: restores G1 G17 G40 G54 G90 G94 M5 M9. Units, F, S, T, G92,
/// the tool length and path control (RS274/NGC 3.6.1 does not mention it) keep their values. G43.4
/// ends.
void Execution::end_program() {
  ModalState& modal = next_.modal;
  modal.motion = MotionMode::kLine;
  modal.plane = Plane::kXY;
  modal.distance = DistanceMode::kAbsolute;
  modal.feed_mode = FeedMode::kUnitsPerMinute;
  modal.coordinate_system = 0;
  modal.spindle = SpindleMode::kOff;
  modal.coolant = Coolant{};
  modal.tool_centre = false;
  if (modal.compensation.side != CutterSide::kOn) {
    modal.compensation = {};
    static_cast<void>(actions_.append(ActionKind::kCompensation));
  }
  static_cast<void>(actions_.append(ActionKind::kEnd));
}

Refusal Execution::take_index(char letter,
                              ModalGroup group,
                              std::uint32_t highest,
                              FaultDetail when_higher,
                              std::uint32_t& index) {
  const Decimal* const number = block_.take(letter);
  if (number == nullptr) return missing(letter, group);
  if (number->is_negative()) return block_.blame(FaultDetail::kNegative, letter);
  if (!number->is_integer()) return block_.blame(FaultDetail::kNotAnInteger, letter);
  if (number->whole > highest) {
    return with_limit(block_.blame(when_higher, letter), static_cast<float>(highest));
  }
  index = number->whole;
  return std::nullopt;
}

Coordinate Execution::to_length(const Decimal& number) const {
  return next_.modal.units == Units::kInches ? from_inches(number) : from_millimetres(number);
}

/// Returns the value of an axis word. A value in degrees is never converted from inches.
Coordinate Execution::to_axis_value(std::size_t axis, const Decimal& number) const {
  return axis < kLinearAxisCount ? to_length(number) : from_millimetres(number);
}

Refusal Execution::check_range(FaultDetail detail, std::size_t axis, Coordinate place) const {
  if (place.in_range()) return std::nullopt;
  Fault fault = block_.blame(detail, kAxisLetters[axis]);
  fault.value = place.mm();
  fault.limit = Coordinate{Coordinate::kFarthestNanometres}.mm();
  return fault;
}

Fault Execution::out_of_reach(Fault word, std::size_t axis, Coordinate place) const {
  word.letter = kAxisLetters[axis];
  word.value = place.mm();
  word.limit = options_.reach[axis].mm();
  return word;
}

Fault Execution::missing(char letter, ModalGroup for_group) const {
  Fault fault = block_.blame(FaultDetail::kWordMissing, for_group);
  fault.letter = letter;
  return fault;
}

}  // namespace cnc::gcode
