#include "host-sim/surface/patch/plane_slices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host-sim/surface/patch/cubic.hpp"
#include "host-sim/surface/patch/subdivision.hpp"

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kNoChord = std::numeric_limits<std::uint32_t>::max();

/// The line between two hits on the border of a piece.
struct Chord {
  std::array<std::uint32_t, 2> hits{};
  double error_bound = 0.0;
};

/// A point at which the plane cuts an edge. On each side of the edge, a chord ends at this point.
/// At the rim of the surface, there is only one chord.
struct Hit {
  Vector3d point = Vector3d::Zero();
  std::array<std::uint32_t, 2> chords{kNoChord, kNoChord};
};

/// Range of the hits of one edge, in the order along the edge.
struct HitRun {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  /// Number of the plane to which these hits belong.
  std::size_t of_plane = std::numeric_limits<std::size_t>::max();
};

/// Cuts a net with several planes, one after another.
class Slicer {
 public:
  Slicer(const PieceNet& net, const Vector3d& normal)
      : net_{net}, normal_{normal}, runs_(net.edges().size()) {}

  /// Returns the paths in the plane at `distance`.
  /// @param pieces the pieces that the plane may cut
  std::vector<SlicePath> paths(double distance, const std::vector<std::uint32_t>& pieces) {
    ++plane_;
    distance_ = distance;
    hits_.clear();
    chords_.clear();
    for (const std::uint32_t piece : pieces) cut(piece);
    return chained();
  }

 private:
  void cut(std::uint32_t piece) {
    std::vector<std::uint32_t> around;
    for (const BorderEdge& edge : net_.border(piece)) {
      const HitRun& run = hits_of(edge.edge);
      for (std::uint32_t i = 0; i < run.count; ++i) {
        around.push_back(run.first + (edge.is_reversed ? run.count - 1 - i : i));
      }
    }
    if (around.empty()) return;
    const BezierPatch& shape = net_.pieces()[piece].shape;
    const double bound = chord_error_bound(shape, {.slicing_normal = normal_, .min_sine = 0.0});
    // The hits divide the border into parts on alternating sides of the plane. The start of the
    // border is in the last part.
    const BorderEdge start = net_.border(piece).front();
    const BezierCurve& curve = net_.edges()[start.edge];
    const bool starts_above = is_above(curve.controls[start.is_reversed ? 3 : 0]);
    const bool middle_is_above = is_above(shape.at(0.5, 0.5));
    const std::size_t first = starts_above == middle_is_above ? 0 : 1;
    for (std::size_t i = first; i < around.size() + first; i += 2) {
      add_chord(around[i % around.size()], around[(i + 1) % around.size()], bound);
    }
  }

  [[nodiscard]] bool is_above(const Vector3d& point) const {
    return normal_.dot(point) - distance_ >= 0.0;
  }

  const HitRun& hits_of(std::uint32_t edge) {
    HitRun& run = runs_[edge];
    if (run.of_plane == plane_) return run;
    const BezierCurve& curve = net_.edges()[edge];
    Cubic distances{};
    for (std::size_t i = 0; i < 4; ++i) distances[i] = normal_.dot(curve.controls[i]) - distance_;
    const auto [lowest, highest] = std::minmax_element(distances.begin(), distances.end());
    const bool is_cut = *lowest < 0.0 && *highest >= 0.0;
    const Parameters changes = is_cut ? sign_changes(distances) : Parameters{};
    run = {static_cast<std::uint32_t>(hits_.size()),
           static_cast<std::uint32_t>(changes.count),
           plane_};
    for (std::size_t i = 0; i < changes.count; ++i) hits_.push_back({curve.at(changes.values[i])});
    return run;
  }

  void add_chord(std::uint32_t from, std::uint32_t to, double bound) {
    const auto number = static_cast<std::uint32_t>(chords_.size());
    chords_.push_back({{from, to}, bound});
    for (const std::uint32_t hit : {from, to}) {
      std::array<std::uint32_t, 2>& chords = hits_[hit].chords;
      chords[chords[0] == kNoChord ? 0 : 1] = number;
    }
  }

  /// Joins the chords to paths: first the paths that begin at the rim, then the closed paths.
  std::vector<SlicePath> chained() {
    std::vector<SlicePath> paths;
    done_.assign(hits_.size(), 0);
    for (std::uint32_t hit = 0; hit < hits_.size(); ++hit) {
      if (hits_[hit].chords[1] == kNoChord && done_[hit] == 0) paths.push_back(path_from(hit));
    }
    for (std::uint32_t hit = 0; hit < hits_.size(); ++hit) {
      if (done_[hit] == 0) paths.push_back(path_from(hit));
    }
    return paths;
  }

  /// Returns the path from a hit to the rim, or the closed path through the hit.
  SlicePath path_from(std::uint32_t hit) {
    SlicePath path;
    path.is_closed = true;
    std::uint32_t next = hits_[hit].chords[0];
    while (done_[hit] == 0) {
      done_[hit] = 1;
      path.points.push_back(hits_[hit].point);
      if (next == kNoChord) {
        path.is_closed = false;
        break;
      }
      const Chord& chord = chords_[next];
      path.error_bound_mm = std::max(path.error_bound_mm, chord.error_bound);
      hit = chord.hits[chord.hits[0] == hit ? 1 : 0];
      const std::array<std::uint32_t, 2>& chords = hits_[hit].chords;
      next = chords[chords[0] == next ? 1 : 0];
    }
    return path;
  }

  const PieceNet& net_;
  Vector3d normal_;
  double distance_ = 0.0;
  std::size_t plane_ = 0;
  /// Hits of each edge. An entry is valid only if its `of_plane` is the current plane.
  std::vector<HitRun> runs_;
  std::vector<Hit> hits_;
  std::vector<Chord> chords_;
  std::vector<std::uint8_t> done_;
};

/// Returns the range of a piece's control points along the normal.
Range reach_of(const BezierPatch& shape, const Vector3d& normal) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const BezierCurve& row : shape.rows) {
    for (const Vector3d& control : row.controls) {
      range.lowest = std::min(range.lowest, normal.dot(control));
      range.highest = std::max(range.highest, normal.dot(control));
    }
  }
  return range;
}

}  // namespace

std::vector<std::vector<SlicePath>> plane_slices(const PieceNet& net,
                                                 const Vector3d& normal,
                                                 const std::vector<double>& distances_mm) {
  std::vector<std::vector<std::uint32_t>> pieces_of(distances_mm.size());
  std::vector<std::size_t> ascending(distances_mm.size());
  for (std::size_t i = 0; i < ascending.size(); ++i) ascending[i] = i;
  std::sort(ascending.begin(), ascending.end(), [&distances_mm](std::size_t a, std::size_t b) {
    return distances_mm[a] < distances_mm[b];
  });
  for (std::uint32_t piece = 0; piece < net.pieces().size(); ++piece) {
    // The range is widened by `slack`, because the end of an edge may come from a neighbour and
    // differ by rounding.
    Range reach = reach_of(net.pieces()[piece].shape, normal);
    const double slack =
        1.0e-12 * (1.0 + std::max(std::abs(reach.lowest), std::abs(reach.highest)));
    auto next = std::lower_bound(
        ascending.begin(),
        ascending.end(),
        reach.lowest - slack,
        [&distances_mm](std::size_t plane, double value) { return distances_mm[plane] < value; });
    for (; next != ascending.end() && distances_mm[*next] <= reach.highest + slack; ++next) {
      pieces_of[*next].push_back(piece);
    }
  }
  Slicer slicer{net, normal};
  std::vector<std::vector<SlicePath>> all;
  all.reserve(distances_mm.size());
  for (std::size_t i = 0; i < distances_mm.size(); ++i) {
    all.push_back(slicer.paths(distances_mm[i], pieces_of[i]));
  }
  return all;
}

}  // namespace sim::surface::patch
