#include "host-sim/report/progress_bar.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "host-sim/report/printable.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/report/utf8.hpp"

namespace sim {
namespace {

/// Returns the number of columns of the terminal. If the stream is not a terminal, returns the
/// greatest number.
std::size_t columns_of(std::FILE* stream) {
  winsize size{};
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): that is how ioctl is declared.
  const bool is_known = ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col != 0;
  return is_known ? size.ws_col : std::numeric_limits<std::size_t>::max();
}

/// Returns the longest beginning of the text that fits into `columns`, with an ellipsis where it is
/// cut off.
std::string shortened(std::string_view text, std::size_t columns) {
  if (display_width(text) <= columns) return std::string{text};
  std::string start;
  while (!text.empty()) {
    const std::string_view next = text.substr(0, first_character(text).bytes);
    if (display_width(start) + display_width(next) + 1 > columns) break;
    start += next;
    text.remove_prefix(next.size());
  }
  return columns == 0 ? "" : start + "\u2026";
}

/// Returns the line of bar, percentage and label. The line does not use the last column of the
/// terminal, which may wrap.
std::string line_of(double done, std::string_view label, std::size_t columns) {
  constexpr std::size_t kMaxCells = 30;
  constexpr std::size_t kFewestCells = 10;
  // Number of columns of `[`, `] 100 % ` and the terminal's last column.
  constexpr std::size_t kBesides = 10;
  const double percent = 100.0 * done;
  if (columns < kBesides) {
    return shortened(fmt::format("{:.0f} %", percent), std::max<std::size_t>(columns, 1) - 1);
  }
  const std::size_t free = columns - kBesides;
  const std::size_t label_columns = std::min(display_width(label), free);
  const std::size_t least = std::min(kFewestCells, free);
  const std::size_t bar = std::clamp(free - label_columns, least, kMaxCells);
  const auto cells = static_cast<std::size_t>(std::lround(static_cast<double>(bar) * done));
  return fmt::format(
      "[{:<{}}] {:3.0f} % {}", std::string(cells, '#'), bar, percent, shortened(label, free - bar));
}

}  // namespace

void ProgressBar::update(double fraction, std::string_view label, Time now) {
  if (!is_shown_ || now < next_) return;
  const double done = std::clamp(fraction, 0.0, 1.0);
  const std::size_t columns = columns_.value_or(columns_of(stream_));
  terminal::print_styled(stream_, "\r\033[K" + line_of(done, printable_line(label), columns));
  std::fflush(stream_);
  is_drawn_ = true;
  next_ = now + kPeriod;
}

void ProgressBar::clear() {
  if (!is_drawn_) return;
  terminal::print_styled(stream_, "\r\033[K");
  std::fflush(stream_);
  is_drawn_ = false;
}

bool is_terminal(std::FILE* stream) { return ::isatty(::fileno(stream)) == 1; }

}  // namespace sim
