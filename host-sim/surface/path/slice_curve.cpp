#include "host-sim/surface/path/slice_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sim::surface {
namespace {

using Node = SliceCurve::Node;

/// A cubic over a part of a slice, given by the nodes at its ends.
struct Cubic {
  Node from;
  Node to;

  /// Limits the slopes at the ends, so that the cubic does not rise far above both ends. Next to a
  /// jump of the heights, the measured slope may be the slope of the jump.
  Cubic(const Node& begin, const Node& end, double error_mm) : from{begin}, to{end} {
    const double most = (3.0 * std::abs(to.height - from.height) + 6.0 * error_mm) / width();
    from.slope = std::clamp(from.slope, -most, most);
    to.slope = std::clamp(to.slope, -most, most);
  }

  [[nodiscard]] double width() const { return to.along - from.along; }
  /// Returns the height and its first and second derivative by `share`, which is 0 to 1.
  [[nodiscard]] std::array<double, 3> at(double share) const {
    const double begin = width() * from.slope;
    const double rise = to.height - from.height;
    const double square = 3.0 * rise - 2.0 * begin - width() * to.slope;
    const double cube = begin + width() * to.slope - 2.0 * rise;
    return {from.height + share * (begin + share * (square + share * cube)),
            begin + share * (2.0 * square + share * 3.0 * cube),
            2.0 * square + 6.0 * share * cube};
  }
  [[nodiscard]] double height_at(double along) const {
    return at((along - from.along) / width())[0];
  }
};

/// Divides a slice into cubics, from its start to its end.
class CurveBuilder {
 public:
  CurveBuilder(SliceHeights& heights, const SliceDensity& density, double begin, double end)
      : heights_{heights}, density_{density}, begin_{begin}, end_{end} {}

  std::vector<Node> build() {
    constexpr double kPitchesAtOnce = 16.0;
    const double length = end_ - begin_;
    const auto whole = static_cast<int>(std::ceil(length / (kPitchesAtOnce * density_.pitch_mm)));
    nodes_.push_back(node_at(begin_));
    for (int i = 1; i <= whole; ++i) {
      const double to = i == whole ? end_ : begin_ + length * i / whole;
      pending_.push_back(node_at(to));
      while (!pending_.empty()) settle();
    }
    return std::move(nodes_);
  }

 private:
  /// Returns the node at the distance `along` the slice. The slope is a central difference, or a
  /// one-sided difference at the ends of the slice.
  [[nodiscard]] Node node_at(double along) {
    constexpr double kBeside = 1.0e-5;
    const double before = std::max(begin_, along - kBeside);
    const double after = std::min(end_, along + kBeside);
    const double low = heights_(before);
    const double height = heights_(along);
    return {along, height, (heights_(after) - low) / (after - before)};
  }

  /// Accepts the nearest pending node if one cubic follows the heights up to this node. Otherwise
  /// inserts a node half way.
  void settle() {
    const Cubic cubic{nodes_.back(), pending_.back(), density_.error_mm};
    if (cubic.width() <= density_.min_mm || follows(cubic)) {
      nodes_.push_back(pending_.back());
      pending_.pop_back();
      return;
    }
    pending_.push_back(node_at(0.5 * (cubic.from.along + cubic.to.along)));
  }

  [[nodiscard]] bool follows(const Cubic& cubic) {
    // Between samples, the heights have kinks where the contact moves from one facet to the next.
    // With eight samples, the error between them is at most twice the error at the samples.
    constexpr int kMinLooks = 8;
    const int looks =
        std::max(kMinLooks, static_cast<int>(std::ceil(cubic.width() / density_.pitch_mm)));
    const auto is_near_at = [&](int i) {
      const double along = cubic.from.along + cubic.width() * i / looks;
      return is_near(along, cubic.height_at(along));
    };
    // Checks the middle first, because the error of a cubic is usually greatest there.
    if (!is_near_at(looks / 2)) return false;
    for (int i = 1; i < looks; ++i) {
      if (i != looks / 2 && !is_near_at(i)) return false;
    }
    return true;
  }

  /// Returns whether the heights pass a point of the curve at a distance within the error,
  /// vertically or horizontally. The reverse check, from a height to the curve, is not sufficient:
  /// the curve may cut off the corner between a jump and a plateau while the heights on the plateau
  /// are near the curve.
  [[nodiscard]] bool is_near(double along, double height) {
    const double error = 0.5 * density_.error_mm;
    const double off = height - heights_(along);
    if (std::abs(off) <= error) return true;
    const double before = heights_(std::max(begin_, along - error));
    const double after = heights_(std::min(end_, along + error));
    return off < 0.0 ? std::min(before, after) <= height + error
                     : std::max(before, after) >= height - error;
  }

  SliceHeights& heights_;
  SliceDensity density_;
  double begin_;
  double end_;
  std::vector<Node> nodes_;
  std::vector<Node> pending_;  ///< Nodes that are still to be reached; the nearest node is last.
};

}  // namespace

SliceDensity density_for(const cnc::surface::Profile& profile, double error_mm) {
  const double round = std::sqrt(8.0 * (profile.flat_mm + profile.corner_mm) * error_mm);
  double pointed = 0.0;
  if (profile.rise > 0.0) {
    pointed = 2.0 * error_mm * std::sqrt(1.0 + profile.rise * profile.rise) / profile.rise;
  }
  return {.pitch_mm = std::max(round, pointed), .error_mm = error_mm, .min_mm = 0.25 * error_mm};
}

SliceCurve::SliceCurve(SliceHeights& heights, double begin, double end, const SliceDensity& density)
    : nodes_{CurveBuilder{heights, density, begin, end}.build()},
      error_mm_{density.error_mm},
      min_mm_{density.min_mm} {}

bool SliceCurve::is_straight(std::size_t span) const {
  return nodes_[span + 1].along - nodes_[span].along <= min_mm_;
}

cnc::contour::CurveJet SliceCurve::at(std::size_t span, double share) const {
  const Cubic cubic{nodes_[span], nodes_[span + 1], error_mm_};
  const double width = cubic.width();
  const double along = cubic.from.along + share * width;
  if (is_straight(span)) {
    const double rise = cubic.to.height - cubic.from.height;
    return {{along, cubic.from.height + share * rise}, {width, rise}, {0.0, 0.0}};
  }
  const auto [height, rise, bend] = cubic.at(share);
  return {{along, height}, {width, rise}, {0.0, bend}};
}

}  // namespace sim::surface
