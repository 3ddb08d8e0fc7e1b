#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "host-sim/import/drawing.hpp"
#include "host-sim/job/setting_line.hpp"

namespace sim::cut {

/// The corner of the bed at which X and Y are 0, as seen by an operator in front of the machine.
enum class OriginCorner : std::uint8_t { kFrontLeft, kFrontRight, kBackLeft, kBackRight, kCentre };

/// An upright rectangle that the head reaches, mm.
struct BedBox {
  drawing::Place low{0.0, 0.0};
  drawing::Place high{0.0, 0.0};
};

/// A machine as its profile file describes it.
struct MachineProfile {
  std::string name;  ///< Name for people.
  std::string note;  ///< Remark on the certainty of the profile's figures; may be empty.
  drawing::Place bed_mm{0.0, 0.0};
  OriginCorner origin = OriginCorner::kFrontLeft;
  double full_power_w = 0.0;                ///< Power at the greatest S; 0: not known.
  drawing::Place beam_offset_mm{0.0, 0.0};  ///< Offset from the head's position to the beam.
  /// Settings, including rates, accelerations, travel and the scale of S.
  std::vector<SettingChange> settings{};

  /// Returns the rectangle that the head reaches.
  [[nodiscard]] BedBox bed() const;
  /// Returns a text such as `origin at the back left of the bed`.
  [[nodiscard]] std::string origin_text() const;
};

/// Reads the JSON of a profile. Throws std::invalid_argument with the file, the JSON pointer, the
/// reason and the remedy, also for unknown keys.
[[nodiscard]] MachineProfile read_machine_profile(const std::string& text, const std::string& file);

/// Returns a fault for each side at which a job leaves the bed. The fault says by how much, and
/// with which cut.
[[nodiscard]] std::vector<drawing::Fault> off_the_bed(const CutPlan& plan,
                                                      const drawing::Drawing& drawn,
                                                      const MachineProfile& profile);

}  // namespace sim::cut
