#include "host-sim/cut/shared_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/shared_stretch.hpp"

namespace sim::cut {
namespace {

using drawing::cross;

/// Lengths below this are rounding, mm.
constexpr double kEdgeRounding = 1.0e-3;
/// No shorter rests of edges are left beside shared ones, in kerfs.
constexpr double kShortestRestKerfs = 2.0;
/// The beam that comes round a corner of half a kerf's radius is clear of an edge that has given
/// way for √3 half kerfs beyond that corner.
constexpr double kBeyondCorner = 1.7320508075688772;
/// Sine of an angle at which two edges go straight on.
constexpr double kStraightOn = 1.0e-3;

Place line_direction(const Stroke& line) { return (line.to - line.from).normalized(); }

/// A straight or curved stretch of an outline, and how far it gives way to the left, where the part
/// is, mm.
struct EdgePiece {
  Stroke stroke{};
  double gives_mm = 0.0;

  [[nodiscard]] bool gives() const { return gives_mm > 0.0; }
  [[nodiscard]] Place left() const {
    const Place way = line_direction(stroke);
    return {-way.y(), way.x()};
  }
};

/// Shared stretches of one stroke, longer by what corners of neighbours in its middle need, and
/// without short rests.
void widen_stretches(std::vector<SharedStretch>& stretches, double length_mm, double half_kerf_mm) {
  const double least = kShortestRestKerfs * 2.0 * half_kerf_mm;
  for (SharedStretch& stretch : stretches) {
    if (stretch.from_mm > kEdgeRounding) stretch.from_mm -= kBeyondCorner * half_kerf_mm;
    if (stretch.to_mm < length_mm - kEdgeRounding) stretch.to_mm += kBeyondCorner * half_kerf_mm;
    if (stretch.from_mm < least) stretch.from_mm = 0.0;
    if (stretch.to_mm > length_mm - least) stretch.to_mm = length_mm;
  }
  for (std::size_t i = 1; i < stretches.size(); ++i) {
    if (stretches[i].from_mm - stretches[i - 1].to_mm < least) {
      stretches[i].from_mm = stretches[i - 1].to_mm;
    }
  }
  join_stretches(stretches);
}

/// Divides a stroke at the ends of its stretches.
void divide_edge(const Stroke& stroke,
                 const std::vector<SharedStretch>& stretches,
                 double half_kerf_mm,
                 std::vector<EdgePiece>& pieces) {
  const double length = length_of(stroke);
  double done = 0.0;
  const auto add = [&](double to_mm, double gives_mm) {
    if (to_mm - done > kEdgeRounding) {
      pieces.push_back({part_of(stroke, done / length, std::min(1.0, to_mm / length)), gives_mm});
      done = to_mm;
    }
  };
  for (const SharedStretch& stretch : stretches) {
    add(stretch.from_mm, 0.0);
    add(stretch.to_mm, half_kerf_mm - 0.5 * stretch.off_mm);
  }
  if (stretches.empty()) {
    pieces.push_back({stroke});
  } else {
    add(length, 0.0);
  }
}

/// Where two pieces meet once they have given way: one point, or two with a step between them.
struct MovedCorner {
  Place end{0.0, 0.0};
  Place start{0.0, 0.0};
};

std::optional<MovedCorner> moved_corner(const EdgePiece& before, const EdgePiece& after) {
  const Place& corner = before.stroke.to;
  if (!before.gives() && !after.gives()) return MovedCorner{corner, corner};
  const Place end = before.gives() ? Place{corner + before.gives_mm * before.left()} : corner;
  const Place start = after.gives() ? Place{corner + after.gives_mm * after.left()} : corner;
  const Place from = tangent_at(before.stroke, 1.0);
  const Place to = tangent_at(after.stroke, 0.0);
  const double sine = cross(from, to);
  const bool goes_on = std::abs(sine) < kStraightOn;
  // Beside a straight line, or into the part: a step.
  if (goes_on || (sine < 0.0 && !(before.gives() && after.gives()))) return MovedCorner{end, start};
  if (before.stroke.bulge != 0.0 || after.stroke.bulge != 0.0) return std::nullopt;
  // Where the moved lines cross.
  const double along = cross(start - end, to) / sine;
  const Place meeting = end + along * from;
  const double left = drawing::dot(meeting - before.stroke.from, from);
  const double right = drawing::dot(after.stroke.to - meeting, to);
  if (left < kEdgeRounding || right < kEdgeRounding) return std::nullopt;
  return MovedCorner{meeting, meeting};
}

/// Moves all pieces that give way. Returns nothing where one is too short for its corners.
std::optional<std::vector<Stroke>> moved_edges(const std::vector<EdgePiece>& pieces) {
  std::vector<MovedCorner> corners;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto corner = moved_corner(pieces[i], pieces[(i + 1) % pieces.size()]);
    if (!corner) return std::nullopt;
    corners.push_back(*corner);
  }
  std::vector<Stroke> strokes;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const MovedCorner& before = corners[(i + pieces.size() - 1) % pieces.size()];
    Stroke stroke = pieces[i].stroke;
    stroke.from = before.start;
    stroke.to = corners[i].end;
    // Both corners may have eaten it up.
    const bool turns_back =
        stroke.bulge == 0.0 &&
        drawing::dot(stroke.to - stroke.from, pieces[i].stroke.to - pieces[i].stroke.from) <= 0.0;
    if (turns_back) return std::nullopt;
    strokes.push_back(stroke);
    if (drawing::distance(corners[i].end, corners[i].start) > kEdgeRounding) {
      strokes.push_back({corners[i].end, corners[i].start});
    } else {
      strokes.back().to = corners[i].start;
    }
  }
  return strokes;
}

/// Finds which edges touch, and moves them.
class Parting {
 public:
  Parting(const drawing::Drawing& drawn, std::vector<Outline>& outlines, const EdgeSharing& sharing)
      : drawn_{drawn}, outlines_{outlines}, sharing_{sharing}, strokes_{kTouchReachMm} {}

  std::vector<drawing::Fault> run() {
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      if (!may_give(i)) continue;
      for (const Stroke& stroke : outlines_[i].strokes) {
        if (stroke.bulge != 0.0) continue;
        strokes_.add(stroke, owners_.size());
        owners_.push_back({i, stroke});
      }
    }
    strokes_.prepare();
    std::vector<std::pair<std::size_t, std::vector<Stroke>>> changed;
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      if (!may_give(i)) continue;
      if (auto strokes = given_way(i)) changed.emplace_back(i, std::move(*strokes));
    }
    for (auto& [contour, strokes] : changed) outlines_[contour].strokes = std::move(strokes);
    return std::move(warnings_);
  }

 private:
  static constexpr double kTouchReachMm = 1.0;

  struct TouchingStroke {
    std::size_t contour = 0;
    Stroke stroke{};
  };

  [[nodiscard]] bool may_give(std::size_t contour) const {
    return outlines_[contour].is_beside && sharing_.half_kerf_mm(contour) > 0.0;
  }

  [[nodiscard]] std::vector<SharedStretch> stretches_of(std::size_t contour,
                                                        const Stroke& stroke) const {
    std::vector<SharedStretch> stretches;
    if (stroke.bulge != 0.0) return stretches;
    for (const std::size_t number : strokes_.owners_near(stroke, kTouchesMm)) {
      const TouchingStroke& other = owners_[number];
      if (other.contour == contour || !sharing_.are_alike(contour, other.contour)) continue;
      if (const auto shared = shared_stretch(stroke, other.stroke, kTouchesMm)) {
        stretches.push_back(*shared);
      }
    }
    join_stretches(stretches);
    return stretches;
  }

  [[nodiscard]] std::optional<std::vector<Stroke>> given_way(std::size_t contour);

  const drawing::Drawing& drawn_;
  std::vector<Outline>& outlines_;
  const EdgeSharing& sharing_;
  Clearance strokes_;
  std::vector<TouchingStroke> owners_;
  std::vector<drawing::Fault> warnings_;
};

std::optional<std::vector<Stroke>> Parting::given_way(std::size_t contour) {
  const double half = sharing_.half_kerf_mm(contour);
  std::vector<EdgePiece> pieces;
  double shared_mm = 0.0;
  std::optional<Place> where;
  for (const Stroke& stroke : outlines_[contour].strokes) {
    std::vector<SharedStretch> stretches = stretches_of(contour, stroke);
    widen_stretches(stretches, length_of(stroke), half);
    for (const SharedStretch& stretch : stretches) {
      shared_mm += stretch.to_mm - stretch.from_mm;
      if (!where) {
        where = place_at(stroke, 0.5 * (stretch.from_mm + stretch.to_mm) / length_of(stroke));
      }
    }
    divide_edge(stroke, stretches, half, pieces);
  }
  if (!where) return std::nullopt;
  auto strokes = moved_edges(pieces);
  if (!strokes) return std::nullopt;
  warnings_.push_back(
      {drawing::FaultKind::kIgnored,
       drawn_.contours[contour].entity,
       where,
       fmt::format("lies against other parts along {:.3f} mm: the cut along the edge "
                   "takes {:.3f} mm off it there",
                   shared_mm,
                   half),
       fmt::format("draw parts {:.3f} mm apart, the kerf, that are to have their "
                   "size",
                   2.0 * half)});
  return strokes;
}

}  // namespace

std::vector<drawing::Fault> part_touching_edges(const drawing::Drawing& drawn,
                                                std::vector<Outline>& outlines,
                                                const EdgeSharing& sharing) {
  return Parting{drawn, outlines, sharing}.run();
}

}  // namespace sim::cut
