#pragma once

#include <string>
#include <vector>

#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// A test coupon: one straight slot for each condition, side by side in Y.
struct CouponPlan {
  std::string material;
  std::string laser;
  double gas_pressure_mpa = 0.0;
  std::vector<cnc::kerf::Condition> slots{};
  /// Length of a slot; its middle 60 mm are measured (Park and Ahn 2007, 3.2).
  double length_mm = 100.0;
  double pitch_mm = 8.0;
  double margin_mm = 5.0;      ///< Distance of the slots from X0 and Y0.
  double full_power_w = 0.0;   ///< Power of the laser at `full_power_s`.
  double full_power_s = 1000;  ///< S of full power, $30.
};

/// Returns the permissible speeds of each power that was cut at a thickness: least, middle and
/// greatest. Throws std::invalid_argument if the record does not have the thickness.
[[nodiscard]] std::vector<cnc::kerf::Condition> default_slots(const MaterialRecord& record,
                                                              std::uint32_t thickness_um);

/// Returns the coupon as G-code, slot by slot with its number and condition in a comment. Throws
/// std::invalid_argument if there is no slot, or if a slot requires more than full power.
[[nodiscard]] std::string coupon_program(const CouponPlan& plan);

/// Returns the form for the measurements: one line for each slot, with the measured values still
/// empty.
[[nodiscard]] std::string coupon_form(const CouponPlan& plan);

}  // namespace sim
