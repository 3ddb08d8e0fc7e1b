#include "host-sim/job/knot_file.hpp"

#include <cmath>
#include <iterator>

namespace sim {

KnotFile::KnotFile(const std::string& file,
                   const cnc::AxisArray<double>& steps_per_mm,
                   cnc::motion::ShapingObserver& next)
    : steps_per_mm_{steps_per_mm}, next_{next}, file_{file} {
  fmt::format_to(std::back_inserter(file_.buffer()),
                 "# time_s x y z a b c: positions of the axes, mm and degrees\n");
}

void KnotFile::on_cell(const cnc::motion::ShapedCell& cell) {
  next_.on_cell(cell);
  time_ns_ += cell.duration_ns;
  auto out = std::back_inserter(file_.buffer());
  fmt::format_to(out, "{:.9f}", static_cast<double>(time_ns_) * 1.0e-9);
  for (std::size_t axis = 0; axis < steps_per_mm_.size(); ++axis) {
    const double steps = std::ldexp(static_cast<double>(cell.planned[axis].q32()), -32);
    fmt::format_to(out, " {:.17g}", steps / steps_per_mm_[axis]);
  }
  fmt::format_to(out, "\n");
  file_.drain_when_full();
}

}  // namespace sim
