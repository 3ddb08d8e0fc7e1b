#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/job/standpoint.hpp"
#include "host-sim/send/job_lines.hpp"

namespace sim {

/// Reads the state of a controller from its answers to `$$`, `$#`, `$G` and `?`: Grbl's, and the
/// fields of Kerfline's full report (0x87). A controller that does not report block delete ($890)
/// drives lines with /, as Grbl does.
class StandpointReading {
 public:
  /// The lines that ask for it.
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
  std::string modes_;  ///< Words of `[GC:`.
  std::uint8_t homed_ = 0;
};

}  // namespace sim
