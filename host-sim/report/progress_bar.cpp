#include "host-sim/report/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace sim {

void ProgressBar::update(double fraction, std::string_view label, Time now) {
  constexpr int kCells = 30;
  if (!is_shown_ || now < next_) return;
  const double done = std::clamp(fraction, 0.0, 1.0);
  const auto cells = static_cast<std::size_t>(std::lround(kCells * done));
  fmt::print(stream_,
             "\r\033[K[{:<{}}] {:3.0f} % {}",
             std::string(cells, '#'),
             kCells,
             100.0 * done,
             label);
  std::fflush(stream_);
  is_drawn_ = true;
  next_ = now + kPeriod;
}

void ProgressBar::clear() {
  if (!is_drawn_) return;
  fmt::print(stream_, "\r\033[K");
  std::fflush(stream_);
  is_drawn_ = false;
}

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) == 1; }

}  // namespace sim
