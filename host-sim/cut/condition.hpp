#pragma once

#include <cstdint>
#include <optional>

#include "host-sim/knowledge/material_record.hpp"

namespace sim::cut {

/// Power and speed to cut with, and how wide that is.
struct Condition {
  cnc::kerf::Condition cut{};
  double kerf_mm = 0.0;
  double half_interval_mm = 0.0;  ///< 95 % of cuts are within so much of it.
};

/// Whatever is given is kept; the rest is chosen: the fastest speed that is permissible, and the
/// least power that permits it. Throws std::invalid_argument saying what is permissible when
/// nothing is.
/// @param most_power_mw what the laser gives; no power above it is chosen
[[nodiscard]] Condition choose(const MaterialRecord& record,
                               std::uint32_t thickness_um,
                               std::optional<std::uint32_t> power_mw,
                               std::optional<std::uint32_t> speed_um_min,
                               std::uint32_t most_power_mw = cnc::kerf::kMostPowerMw);

/// Returns how a line is engraved: as it would be cut, but with the power and speed given.
/// Engraving needs no kerf, so nothing has to be known of its width.
/// @param share of the cut's power where none is given, 0 to 1
[[nodiscard]] Condition engraving(const Condition& cut,
                                  double share,
                                  std::optional<std::uint32_t> power_mw,
                                  std::optional<std::uint32_t> speed_um_min);

/// The greatest power that the record has at a thickness, mW; 0 where it has none.
[[nodiscard]] std::uint32_t greatest_power(const MaterialRecord& record,
                                           std::uint32_t thickness_um);

}  // namespace sim::cut
