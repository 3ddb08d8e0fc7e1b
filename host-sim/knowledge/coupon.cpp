#include "host-sim/knowledge/coupon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/knowledge/experiment_csv.hpp"

namespace sim {

std::vector<cnc::kerf::Condition> default_slots(const MaterialRecord& record,
                                                std::uint32_t thickness_um) {
  std::vector<cnc::kerf::Condition> slots;
  std::string known;
  for (const ThicknessRecord& row : record.thicknesses) {
    known += fmt::format("{}{:g}", known.empty() ? "" : ", ", from_thousandths(row.thickness_um));
    if (row.thickness_um != thickness_um) continue;
    for (const PowerRecord& power : row.powers) {
      const auto [least, most] = power.speeds_um_min;
      for (const std::uint32_t speed : {least, least + (most - least) / 2, most}) {
        const cnc::kerf::Condition slot{thickness_um, power.power_mw, speed};
        if (slots.empty() || !(slots.back() == slot)) slots.push_back(slot);
      }
    }
  }
  if (slots.empty()) {
    throw std::invalid_argument(
        fmt::format("{} has no record at {:g} mm, but at {} mm; name --powers and --speeds",
                    record.name,
                    from_thousandths(thickness_um),
                    known));
  }
  return slots;
}

std::string coupon_program(const CouponPlan& plan) {
  if (plan.slots.empty()) throw std::invalid_argument("a coupon requires at least one slot");
  std::string out = fmt::format(
      "(test coupon: {}, {} slots of {:g} mm; S{:g} is {:g} W)\n"
      "(measure the kerf at top and bottom in the middle 60 mm of each)\n"
      "G21 G90 G17 G94 G54\nM8\n",
      plan.material,
      plan.slots.size(),
      plan.length_mm,
      plan.full_power_s,
      plan.full_power_w);
  for (std::size_t i = 0; i < plan.slots.size(); ++i) {
    const cnc::kerf::Condition& slot = plan.slots[i];
    const double watts = from_thousandths(slot.power_mw);
    if (watts > plan.full_power_w) {
      throw std::invalid_argument(
          fmt::format("slot {}: {:g} W are more than the laser's {:g} W (--full-power)",
                      i + 1,
                      watts,
                      plan.full_power_w));
    }
    fmt::format_to(std::back_inserter(out),
                   "(slot {}: {:g} mm, {:g} W, {:g} mm/min)\n"
                   "G0 X{:g} Y{:g}\nM3 S{:.3f}\nG1 X{:g} F{:g}\nM5\n",
                   i + 1,
                   from_thousandths(slot.thickness_um),
                   watts,
                   from_thousandths(slot.speed_um_min),
                   plan.margin_mm,
                   plan.margin_mm + plan.pitch_mm * static_cast<double>(i),
                   watts / plan.full_power_w * plan.full_power_s,
                   plan.margin_mm + plan.length_mm,
                   from_thousandths(slot.speed_um_min));
  }
  return out + "M9\nG0 X0 Y0\nM2\n";
}

std::string coupon_form(const CouponPlan& plan) {
  std::string out = fmt::format("{}\n", kExperimentHeader);
  for (const cnc::kerf::Condition& slot : plan.slots) {
    fmt::format_to(std::back_inserter(out),
                   "{},\"{}\",{:g},{:g},{:g},{:g},,,,\n",
                   plan.material,
                   plan.laser,
                   plan.gas_pressure_mpa,
                   from_thousandths(slot.thickness_um),
                   from_thousandths(slot.power_mw),
                   from_thousandths(slot.speed_um_min));
  }
  return out;
}

}  // namespace sim
