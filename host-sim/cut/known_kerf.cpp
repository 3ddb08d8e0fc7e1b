#include "host-sim/cut/known_kerf.hpp"

#include <fmt/format.h>

namespace sim::cut {

MaterialRecord record_of_known_kerf(double kerf_mm,
                                    const std::string& material,
                                    std::uint32_t thickness_um) {
  const cnc::kerf::Window all_speeds{1, cnc::kerf::kMaxSpeedUmMin};
  ThicknessRecord row{.thickness_um = thickness_um, .intercept = kerf_mm};
  row.powers = {{1, all_speeds}, {cnc::kerf::kMaxPowerMw, all_speeds}};
  return {.name = material,
          .calibrated = true,
          .provenance = fmt::format("kerf of {:g} mm, as the command gives it", kerf_mm),
          .thicknesses = {row}};
}

}  // namespace sim::cut
