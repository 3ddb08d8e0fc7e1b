#pragma once

#include <cstdint>

#include "firmware/machine/machine.hpp"
#include "firmware/protocol/reply.hpp"
#include "firmware/protocol/report_lines.hpp"

namespace cnc {

/// The answer to `?`: `<Idle|MPos:…|Bf:…|FS:…>`.
///
/// `$10` selects the fields. The values 0…3 are Grbl's two bits (machine or work position, and the
/// buffers); all other fields are then on. From 4 on every bit adds its field, as in grblHAL. WCO
/// and Ov (with A) are slow fields, as in Grbl: they are in the report after a change or a reset,
/// and otherwise once in 10 to 30 reports.
class StatusReport {
 public:
  /// Writes a report.
  /// @param full all fields, whatever `$10` selects (0x87)
  void write(Reply& reply,
             const Machine& machine,
             std::uint32_t receive_room,
             const ReportForm& form,
             bool full);
  /// Restarts as after a reset: the next report has WCO, and the one after it Ov.
  void begin_anew() { offset_wait_ = override_wait_ = 0; }

 private:
  void put_slow_fields(Reply& reply,
                       const Machine& machine,
                       const Position& offset,
                       const ReportForm& form,
                       std::uint32_t shown,
                       bool full);
  [[nodiscard]] bool offset_is_due(const Position& offset, bool moving);
  [[nodiscard]] bool overrides_are_due(const Machine& machine, bool moving);

  struct Accessories {
    OverridePercent percent{};
    gcode::SpindleMode spindle = gcode::SpindleMode::kOff;
    gcode::Coolant coolant{};
  };

  Position told_offset_{};
  Accessories told_{};
  int offset_wait_ = 0;  ///< Reports until the field is shown again.
  int override_wait_ = 0;
};

}  // namespace cnc
