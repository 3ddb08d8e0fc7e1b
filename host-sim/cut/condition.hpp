#pragma once

#include <cstdint>
#include <optional>

#include "host-sim/knowledge/material_record.hpp"

namespace sim::cut {

/// Power and speed of a cut, with the width of its kerf.
struct Condition {
  cnc::kerf::Condition cut{};
  double kerf_mm = 0.0;
  /// Half width of the interval around `kerf_mm` that contains the kerfs of 95 % of cuts.
  double half_interval_mm = 0.0;
};

/// Returns the condition for a cut. A given power or speed is used unchanged. A missing speed
/// becomes the highest permissible speed, and a missing power the lowest power that permits this
/// speed. If nothing is permissible, throws std::invalid_argument with the conditions that the
/// record permits.
/// @param max_power_mw full power of the laser; no higher power is chosen
[[nodiscard]] Condition choose(const MaterialRecord& record,
                               std::uint32_t thickness_um,
                               std::optional<std::uint32_t> power_mw,
                               std::optional<std::uint32_t> speed_um_min,
                               std::uint32_t max_power_mw = cnc::kerf::kMaxPowerMw);

/// Returns the condition for engraving a line. A power or a speed that is not given is derived from
/// the condition of a cut. The kerf is 0, because an engraved line has none.
/// @param share ratio of the engraving power to the cutting power, 0 to 1; used if no power is
/// given
[[nodiscard]] Condition engraving(const Condition& cut,
                                  double share,
                                  std::optional<std::uint32_t> power_mw,
                                  std::optional<std::uint32_t> speed_um_min);

/// Returns the greatest power that the record permits at a thickness, mW; 0 if it permits none.
[[nodiscard]] std::uint32_t greatest_power(const MaterialRecord& record,
                                           std::uint32_t thickness_um);

}  // namespace sim::cut
