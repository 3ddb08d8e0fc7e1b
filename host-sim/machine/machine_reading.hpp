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

/// Reads a program in the same way as a machine with these settings. Returns the programmed path
/// or, under G41 and G42, the path offset from it. The offset results from the tools, widths and
/// kerf tables that are stored in the controller or that the program sends.
[[nodiscard]] ProgrammedPath read_for_machine(const std::string& text,
                                              const cnc::Settings& settings);

/// Reads a program line by line, in the order in which the controller accepts the lines.
/// (read_for_machine() reads a complete program.) Refused lines are not part of the path. The path
/// is not stored.
class MachineReading {
 public:
  MachineReading(const cnc::Settings& settings, PieceSink sink);
  // Not copyable, because its members refer to each other.
  MachineReading(const MachineReading&) = delete;
  MachineReading& operator=(const MachineReading&) = delete;
  ~MachineReading() = default;

  void take(std::size_t line, std::string_view text) {
    reader_.read_line(text, static_cast<int>(line));
  }
  /// Sets the position after a motion that the program did not command, such as homing.
  void set_position(const Point& position) { reader_.set_position(position); }
  /// Ends the program. No lines may follow.
  void end() { beside_.end(); }
  [[nodiscard]] const std::vector<ReadNote>& notes() const { return reader_.path().notes; }
  /// Returns the first refusal of G41 or G42; see beside_path().
  [[nodiscard]] const std::optional<RefusedBeside>& refused() const { return beside_.refused(); }

 private:
  KerfQuestion kerf_;
  FiveAxisQuestion five_axes_;
  BesideWay beside_;
  ProgramReader reader_;
};

}  // namespace sim
