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

/// What a machine with these settings makes of a program's words: the programmed path and, where
/// G41 and G42 ask for it, the way beside it, by tools, widths, and the kerf tables that a
/// controller has or is sent.
[[nodiscard]] ProgrammedPath read_for_machine(const std::string& text,
                                              const cnc::Settings& settings);

/// The same line by line, for a program of which the lines are read as the controller takes them:
/// refused ones are no part of the path, and no path is kept.
class MachineReading {
 public:
  MachineReading(const cnc::Settings& settings, PieceSink sink);
  // Its parts know of each other.
  MachineReading(const MachineReading&) = delete;
  MachineReading& operator=(const MachineReading&) = delete;
  ~MachineReading() = default;

  void take(std::size_t line, std::string_view text) {
    reader_.read_line(text, static_cast<int>(line));
  }
  /// The machine has moved without the program, as by homing.
  void set_position(const Point& position) { reader_.set_position(position); }
  /// There are no more lines.
  void end() { beside_.end(); }
  [[nodiscard]] const std::vector<ReadNote>& notes() const { return reader_.path().notes; }
  /// See beside_path().
  [[nodiscard]] const std::optional<RefusedBeside>& refused() const { return beside_.refused(); }

 private:
  KerfQuestion kerf_;
  FiveAxisQuestion five_axes_;
  BesideWay beside_;
  ProgramReader reader_;
};

}  // namespace sim
