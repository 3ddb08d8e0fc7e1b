#include "host-sim/plot/space/hidden_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sim {
namespace {

constexpr double kVisibilityPx = 2.0;
constexpr double kThinPx = 0.1;
/// Depth by which a surface may be in front of a line without hiding it. It is not 0, because lines
/// are in surfaces or slightly off them.
constexpr double kSlackPx = 4.0;
/// Greatest number of points of a part that one chord may replace. The limit bounds the computing
/// time.
constexpr std::size_t kMaxReplaced = 64;

double distance_px(const SeenPoint& point, const SeenPoint& from, const SeenPoint& to) {
  const double x = to.x_px - from.x_px;
  const double y = to.y_px - from.y_px;
  const double length = std::hypot(x, y);
  if (length == 0.0) return std::hypot(point.x_px - from.x_px, point.y_px - from.y_px);
  return std::abs(x * (point.y_px - from.y_px) - y * (point.x_px - from.x_px)) / length;
}

/// Collects the points of each visible part, one part after the other, and writes the part as path
/// data.
class VisibleParts {
 public:
  explicit VisibleParts(const DepthImage& image) : image_{image} {}

  void add(const SeenPoint& point) {
    if (image_.shows(point, kSlackPx)) {
      part_.push_back(point);
    } else {
      end_part();
    }
  }

  void end_part() {
    if (part_.size() > 1) {
      write('M', part_.front());
      for (std::size_t from = 0; from + 1 < part_.size();) {
        from = farthest_from(from);
        write('L', part_[from]);
      }
    }
    part_.clear();
  }

  [[nodiscard]] const std::string& data() const { return data_; }

 private:
  /// Returns the index of the farthest point of the part to which the chord from point `from` stays
  /// within kThinPx of the part.
  [[nodiscard]] std::size_t farthest_from(std::size_t from) const {
    const std::size_t end = std::min(part_.size(), from + kMaxReplaced);
    std::size_t to = from + 1;
    while (to + 1 < end) {
      for (std::size_t i = from + 1; i <= to; ++i) {
        if (distance_px(part_[i], part_[from], part_[to + 1]) > kThinPx) return to;
      }
      ++to;
    }
    return to;
  }

  void write(char command, const SeenPoint& point) {
    fmt::format_to(std::back_inserter(data_), "{}{:.1f} {:.1f}", command, point.x_px, point.y_px);
  }

  const DepthImage& image_;
  std::vector<SeenPoint> part_;
  std::string data_;
};

}  // namespace

std::string visible_path(const std::vector<SpaceLine>& lines,
                         const Axonometry& axonometry,
                         const DepthImage& image) {
  VisibleParts parts{image};
  for (const SpaceLine& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const SeenPoint to = axonometry.seen(line[i]);
      const SeenPoint from = i == 0 ? to : axonometry.seen(line[i - 1]);
      const double length = std::hypot(to.x_px - from.x_px, to.y_px - from.y_px);
      const double samples = std::max(1.0, std::ceil(length / kVisibilityPx));
      for (double s = i == 0 ? samples : 1.0; s <= samples; s += 1.0) {
        const double share = s / samples;
        parts.add({from.x_px + share * (to.x_px - from.x_px),
                   from.y_px + share * (to.y_px - from.y_px),
                   from.depth_px + share * (to.depth_px - from.depth_px)});
      }
    }
    parts.end_part();
  }
  return parts.data();
}

}  // namespace sim
