#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/settings.hpp"
#include "host-sim/machine/five_axis_question.hpp"
#include "host-sim/machine/kerf_question.hpp"
#include "host-sim/measure/beside_path.hpp"
#include "host-sim/measure/program_reader.hpp"
#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// Reads a program as a machine with these settings does. Returns the programmed path and, under
/// G41 and G42, the path offset from it. The offset follows from tools, widths and the kerf tables
/// that the controller has or that the program sends.
[[nodiscard]] ProgrammedPath read_for_machine(const std::string& text,
                                              const cnc::Settings& settings);

/// Reads a program line by line, as the controller takes the lines; read_for_machine() reads a
/// whole program at once. Refused lines are no part of the path, and no path is kept.
class MachineReading {
 public:
  MachineReading(const cnc::Settings& settings, PieceSink sink);
  // Not copyable: its parts refer to each other.
  MachineReading(const MachineReading&) = delete;
  MachineReading& operator=(const MachineReading&) = delete;
  ~MachineReading() = default;

  void take(std::size_t line, std::string_view text) {
    reader_.read_line(text, static_cast<int>(line));
  }
  /// Sets the position after a motion that the program did not command, such as homing.
  void set_position(const Point& position) { reader_.set_position(position); }
  /// Ends the program: no more lines follow.
  void end() { beside_.end(); }
  [[nodiscard]] const std::vector<ReadNote>& notes() const { return reader_.path().notes; }
  /// Returns the first refusal of the offset path; see beside_path().
  [[nodiscard]] const std::optional<RefusedBeside>& refused() const { return beside_.refused(); }

 private:
  KerfQuestion kerf_;
  FiveAxisQuestion five_axes_;
  BesideWay beside_;
  ProgramReader reader_;
};

}  // namespace sim
