#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "planner/gcode/interpreter.hpp"

namespace cnc::gcode {

inline std::string words_of(const Fault& fault) {
  std::array<char, 120> text{};
  return {text.data(), describe(fault, text)};
}

/// All state of an interpreter that a line can change.
struct Snapshot {
  ModalState state;
  Shift shift;
  StoredPlaces places;
  Position position;

  explicit Snapshot(const Interpreter& of)
      : state{of.state()}, shift{of.shift()}, places{of.places()}, position{of.position()} {}
  bool operator==(const Snapshot&) const = default;
};

/// An interpreter, with functions that check its results.
class InterpreterTest : public testing::Test {
 protected:
  /// Interprets a line that must be accepted, and copies its actions.
  std::vector<Action> take(std::string_view line) {
    const auto actions = interpreter.interpret(line);
    if (!actions.ok()) {
      ADD_FAILURE() << "'" << line << "' is refused: " << words_of(actions.error());
      return {};
    }
    return {actions.value().begin(), actions.value().end()};
  }

  /// Interprets a line that must give exactly one action.
  Action take_one(std::string_view line) {
    const auto actions = take(line);
    EXPECT_EQ(actions.size(), 1U) << line;
    return actions.empty() ? Action{} : actions.front();
  }

  /// Interprets a line that must be refused and change nothing.
  Fault refuse(std::string_view line) {
    const Snapshot before{interpreter};
    const auto actions = interpreter.interpret(line);
    EXPECT_TRUE(Snapshot{interpreter} == before) << "'" << line << "' left something changed";
    if (!actions.ok()) return actions.error();
    ADD_FAILURE() << "'" << line << "' is accepted";
    return {};
  }

  int refusal_number(std::string_view line) { return static_cast<int>(refuse(line).code()); }

  Coordinate at(Axis axis) const { return interpreter.position()[index_of(axis)]; }

  Interpreter interpreter;
};

inline Coordinate mm(std::int64_t millimetres) { return Coordinate{millimetres * 1'000'000}; }

}  // namespace cnc::gcode
