#include "host-sim/contour/polyline_arcs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace sim {
namespace {

using drawing::Place;

/// Greatest deviation at the checked points of the chords, as a share of the tolerance. It is below
/// 1, because the deviation between these points may be larger.
constexpr double kLooked = 0.97;

/// Returns the bulge of the arc from `from` through `middle` to `to`; nothing if the arc exceeds
/// half a turn.
std::optional<double> bulge_through(const Place& from, const Place& middle, const Place& to) {
  // Seen from the middle point, the angle between the directions to both ends is half a turn minus
  // half the sweep.
  const Place back = from - middle;
  const Place on = to - middle;
  const double angle = std::atan2(drawing::cross(on, back), drawing::dot(on, back));
  const double half_sweep =
      angle < 0.0 ? -(drawing::kFullTurn / 2.0 + angle) : drawing::kFullTurn / 2.0 - angle;
  if (std::abs(half_sweep) > drawing::kFullTurn / 4.0) return std::nullopt;
  return std::tan(0.5 * half_sweep);
}

/// The arc with a given bulge from one point to another one, or a line if the arc is flat.
class Arc {
 public:
  Arc(const Place& from, const Place& to, double bulge) : from_{from}, way_{to - from} {
    const double length = way_.norm();
    is_line_ = std::abs(bulge) * length < kFlat;
    if (is_line_) return;
    const Place left{-way_.y(), way_.x()};
    centre_ = from + 0.5 * way_ + left * ((1.0 - bulge * bulge) / (4.0 * bulge));
    radius_ = (from - centre_).norm();
  }

  [[nodiscard]] bool is_line() const { return is_line_; }
  [[nodiscard]] double distance_of(const Place& place) const {
    if (!is_line_) return std::abs((place - centre_).norm() - radius_);
    return std::abs(drawing::cross(way_, place - from_)) / way_.norm();
  }

 private:
  /// Twice the height below which an arc counts as a line, mm.
  static constexpr double kFlat = 2.0e-6;

  Place from_;
  Place way_;
  Place centre_{0.0, 0.0};
  double radius_ = 0.0;
  bool is_line_ = true;
};

/// Returns the bulge of the arc from the first point through the middle one to the last one;
/// nothing if this arc is not within the tolerance of the chords between the points.
std::optional<double> bulge_along(std::span<const Place> places, double tolerance_mm) {
  const Place& from = places.front();
  const Place& to = places.back();
  if (places.size() == 2) return 0.0;
  if (from == to) return std::nullopt;
  const std::optional<double> bulge = bulge_through(from, places[places.size() / 2], to);
  if (!bulge) return std::nullopt;
  const Arc arc{from, to, *bulge};
  const Place way = to - from;
  const double most = kLooked * tolerance_mm;
  double along = 0.0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      const Place place = places[i - 1] + share * (places[i] - places[i - 1]);
      if (arc.distance_of(place) > most) return std::nullopt;
    }
    // An arc of at most half a turn always advances along its chord and stays on one side of it.
    // The row of points must do the same, within the tolerance.
    const double next = drawing::dot(places[i] - from, way);
    const double left = drawing::cross(way, places[i] - from) / way.norm();
    if (next < along || std::copysign(left, left * *bulge) > most) return std::nullopt;
    along = next;
  }
  return arc.is_line() ? 0.0 : *bulge;
}

}  // namespace

std::vector<ContourVertex> arcs_along(const std::vector<Place>& places, double tolerance_mm) {
  const std::span all{places};
  std::vector<ContourVertex> elements;
  std::size_t from = 0;
  while (from + 1 < places.size()) {
    // `fits` is the greatest number of chords that is known to fit one element, and `fails` the
    // smallest number that is known not to fit.
    std::size_t fits = 1;
    double bulge = 0.0;
    std::size_t fails = places.size() - from;
    for (std::size_t chords = 2; fails - fits > 1;) {
      const auto found = bulge_along(all.subspan(from, chords + 1), tolerance_mm);
      if (found) {
        fits = chords;
        bulge = *found;
      } else {
        fails = chords;
      }
      const bool is_bounded = fails < places.size() - from;
      chords = is_bounded ? (fits + fails) / 2 : std::min(2 * fits, fails - 1);
    }
    elements.push_back({places[from].x(), places[from].y(), bulge});
    from += fits;
  }
  elements.push_back({places.back().x(), places.back().y(), 0.0});
  return elements;
}

}  // namespace sim
