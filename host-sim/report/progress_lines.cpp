#include "host-sim/report/progress_lines.hpp"

#include <algorithm>

#include "host-sim/report/terminal.hpp"

namespace sim {

void ProgressLines::update(double fraction, std::string_view label, Time now) {
  if (!is_shown_ || now < next_) return;
  const double percent = 100.0 * std::clamp(fraction, 0.0, 1.0);
  const std::chrono::duration<double> passed = now - start_;
  terminal::print(stream_, "{}: {:.0f} % after {:.0f} s\n", label, percent, passed.count());
  std::fflush(stream_);
  next_ = now + kPeriod;
}

}  // namespace sim
