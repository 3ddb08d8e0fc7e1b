#pragma once

#include <cstdint>

#include "firmware/machine/machine.hpp"
#include "firmware/protocol/reply.hpp"
#include "firmware/protocol/report_lines.hpp"

namespace cnc {

/// The answer to `?`: `<Idle|MPos:…|Bf:…|FS:…>`.
///
/// `$10` selects the fields. In values below 32, two bits have Grbl's meaning (machine or work
/// position, and the buffers), and all other fields are shown. In larger values each bit selects
/// its field, as in grblHAL. WCO and Ov (with A) are slow fields, as in Grbl: a report contains
/// them after a change or a reset, and otherwise only once in 10 to 30 reports.
class StatusReport {
 public:
  /// Writes a report.
  /// @param receive_room free space for received bytes, shown in Bf
  /// @param full whether to show all fields regardless of `$10`, as 0x87 requests
  void write(Reply& reply,
             const Machine& machine,
             std::uint32_t receive_room,
             const ReportForm& form,
             bool full);
  /// Restarts the slow fields, as after a reset: the next report has WCO, and the report after it
  /// has Ov.
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
  /// Number of reports until WCO is shown again; override_wait_ is the same for Ov.
  int offset_wait_ = 0;
  int override_wait_ = 0;
};

}  // namespace cnc
