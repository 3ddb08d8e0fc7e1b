#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/job/standpoint.hpp"
#include "host-sim/send/job_lines.hpp"

namespace sim {

/// Reads the state of a controller from its answers to `$$`, `$#`, `$G` and `?`. It reads the
/// answers of Grbl, and the fields of the full report of Kerfline (0x87). If a controller does not
/// report block delete ($890), it counts as driving lines that begin with `/`, as Grbl does.
class StandpointReading {
 public:
  /// Returns the lines that request the state.
  [[nodiscard]] static std::vector<JobLine> questions();

  void read(std::string_view line);
  [[nodiscard]] Standpoint standpoint() const;

 private:
  void read_setting(std::string_view line);
  void read_place(std::string_view line);
  void read_status(std::string_view line);

  cnc::Settings settings_{};
  std::optional<bool> block_delete_{};
  cnc::gcode::StoredPlaces places_{};
  cnc::Position position_{};
  cnc::Position g92_{};
  cnc::Coordinate tool_length_{};
  std::string modes_;  ///< Words of the last `[GC:` line.
  std::uint8_t homed_ = 0;
};

}  // namespace sim
