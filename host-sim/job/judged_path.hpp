#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/job/standpoint.hpp"
#include "host-sim/job/travel_check.hpp"
#include "host-sim/machine/machine_reading.hpp"

namespace sim {

/// Reads the path of a program line by line, and checks it against the travel. Splines and arcs are
/// checked with their true curves, which are offset where G41 and G42 require it. Homing cycles and
/// changes of $130… in the program are taken into account. The memory is bounded. The lines must be
/// lines that a controller accepts.
class JudgedPath {
 public:
  /// Begins a path at a standpoint.
  /// @param sink function that is called with each piece of the path
  JudgedPath(const Standpoint& standpoint, PieceSink sink);

  void take(std::size_t line, std::string_view text);
  /// Ends the program: no more lines follow.
  void end() { reading_.end(); }

  /// Returns whether the last line was a homing cycle, which ends at position().
  [[nodiscard]] bool homed_now() const { return homed_now_; }
  [[nodiscard]] const Point& position() const { return position_; }
  [[nodiscard]] const TravelCheck& travel() const { return travel_; }
  [[nodiscard]] const std::vector<ReadNote>& notes() const { return reading_.notes(); }
  [[nodiscard]] const std::optional<RefusedBeside>& refused() const { return reading_.refused(); }

 private:
  void take_statement(std::string_view text);
  void home(std::string_view letters);

  cnc::Settings settings_;
  Point position_;  ///< Position at the end of the last piece.
  bool homed_now_ = false;
  TravelCheck travel_;
  PieceSink sink_;
  MachineReading reading_;
};

}  // namespace sim
