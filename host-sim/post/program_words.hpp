#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "planner/gcode/line_reader.hpp"

namespace sim::post {

/// The G and M words that the program makers write, and S. A post may replace any of them.
inline constexpr std::array<std::string_view, 24> kProgramWords{
    "G0",  "G1",  "G2",  "G3", "G4", "G17", "G18", "G19", "G21", "G40", "G41",  "G42",
    "G54", "G90", "G94", "M2", "M3", "M4",  "M5",  "M7",  "M8",  "M9",  "M190", "S"};

/// Returns the words of a line. Throws std::invalid_argument if the line is not G-code.
[[nodiscard]] std::vector<cnc::gcode::Word> words_in(std::string_view line);

/// Returns the number of a word, which has up to nine decimals.
[[nodiscard]] double number_of(const cnc::gcode::Word& word);

/// Returns a number with at most `decimals` decimals, rounded half away from zero, without trailing
/// zeros.
/// @param has_point whether a whole number ends in a point
[[nodiscard]] std::string decimal_text(double value, int decimals, bool has_point);

}  // namespace sim::post
