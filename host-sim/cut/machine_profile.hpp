#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/cut/plan.hpp"
#include "host-sim/import/drawing.hpp"
#include "host-sim/job/setting_line.hpp"

namespace sim::cut {

/// The position on the bed at which X and Y are 0, as an operator in front of the machine sees it.
enum class OriginCorner : std::uint8_t { kFrontLeft, kFrontRight, kBackLeft, kBackRight, kCentre };

/// The upright rectangle that the head can reach, mm.
struct BedBox {
  drawing::Place low{0.0, 0.0};
  drawing::Place high{0.0, 0.0};
};

/// A machine with its data, as its profile file describes it.
struct MachineProfile {
  std::string name;  ///< Name of the machine for messages.
  std::string note;  ///< Remark about the certainty of the profile's figures; may be empty.
  drawing::Place bed_mm{0.0, 0.0};
  OriginCorner origin = OriginCorner::kFrontLeft;
  double full_power_w = 0.0;                ///< Power of the laser at the greatest S; 0: not known.
  drawing::Place beam_offset_mm{0.0, 0.0};  ///< Position of the beam relative to the head.
  /// Settings of the controller, such as rates, accelerations, travel and the scale of S.
  std::vector<SettingChange> settings{};

  /// Returns the rectangle that the head can reach.
  [[nodiscard]] BedBox bed() const;
  /// Returns a text such as `origin at the back left of the bed`.
  [[nodiscard]] std::string origin_text() const;
};

/// Reads a profile from its JSON text. Throws std::invalid_argument with the file, the JSON
/// pointer, the reason and the remedy. Unknown keys are faults, too.
[[nodiscard]] MachineProfile read_machine_profile(const std::string& text, const std::string& file);

/// Returns a fault for each side at which a job leaves the bed. The fault names the distance and
/// the cut.
[[nodiscard]] std::vector<drawing::Fault> off_the_bed(const CutPlan& plan,
                                                      const drawing::Drawing& drawn,
                                                      const MachineProfile& profile);

}  // namespace sim::cut
