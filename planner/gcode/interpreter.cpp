#include "planner/gcode/interpreter.hpp"

#include <algorithm>

#include "planner/base/contract.hpp"

namespace cnc::gcode {

namespace {

bool in_range(const Position& place) {
  return std::ranges::all_of(place, [](Coordinate axis) { return axis.in_range(); });
}

}  // namespace

Result<Actions, Fault> Interpreter::interpret(std::string_view line) {
  actions_.clear();
  if (const auto fault = read_block(line, options_.block_delete, block_)) return *fault;
  if (block_.empty()) return actions_.all();
  Execution execution{options_, context_, places_, spline_store_, block_, actions_};
  if (const auto fault = execution.run()) return *fault;
  execution.commit();
  if (execution.stores_place()) ++places_revision_;
  return actions_.all();
}

Result<Actions, Fault> Interpreter::interpret_jog(std::string_view words) {
  actions_.clear();
  if (const auto fault = read_block(words, false, block_)) return *fault;
  Execution execution{options_, context_, places_, spline_store_, block_, actions_};
  if (const auto fault = execution.run_jog()) return *fault;
  jog_line_number_ = execution.commit_jog();
  return actions_.all();
}

void Interpreter::set_position(const Position& machine) {
  CNC_ASSERT(in_range(machine));
  context_.position = machine;
}

void Interpreter::set_places(const StoredPlaces& places) {
  CNC_ASSERT(std::ranges::all_of(places.systems, in_range));
  CNC_ASSERT(in_range(places.g28) && in_range(places.g30));
  places_ = places;
}

void Interpreter::begin_tool_change(const Position& machine) {
  set_position(machine);
  options_.changes_tool = true;
}

/// Changes both interpreters in place, because the stack of a controller is too small for a copy.
void Interpreter::end_tool_change(Interpreter& before) {
  before.context_.shift = context_.shift;
  before.context_.modal.tool_length_in_use = context_.modal.tool_length_in_use;
  before.places_ = places_;
  before.places_revision_ = places_revision_;
  *this = before;
}

void Interpreter::reset() {
  context_.modal = ModalState{};
  context_.shift = Shift{};
  context_.cubic_exit = {};
}

}  // namespace cnc::gcode
