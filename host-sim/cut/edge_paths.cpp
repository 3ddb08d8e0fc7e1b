#include "host-sim/cut/edge_paths.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host-sim/cut/wedge_marks.hpp"

namespace sim::cut {
namespace {

/// Greatest distance along a path between two marks that count as one, mm.
constexpr double kSameMark = 1.0e-6;
/// Tolerance of a path's offset, mm. A path belongs to an outline if its distance is at most half a
/// kerf plus this tolerance.
constexpr double kBeside = 1.0e-3;
/// Greatest distance along an outline between two shared edges that count as joined, mm. These
/// edges end at one node.
constexpr double kNoGap = 4.0 * kTouchesMm;

/// The passage of an outline along a shared edge, with the free stretch that follows.
struct Passage {
  std::size_t edge = 0;
  bool is_second = false;  ///< Whether the outline is the second of the two outlines of the edge.
  /// Number of the free stretch that follows the edge; nothing if another shared edge follows.
  std::optional<std::size_t> rest{};
};

/// A stretch of a path around all outlines, between two marks, as distances along the path.
struct Run {
  double from_mm = 0.0;
  double to_mm = 0.0;
};

void append(std::vector<Stroke>& row, const std::vector<Stroke>& more) {
  row.insert(row.end(), more.begin(), more.end());
}

/// Makes the paths of outlines that share edges.
class PathDivider {
 public:
  PathDivider(const std::vector<Outline>& outlines,
              const SharedEdges& shared,
              const std::vector<std::vector<Stroke>>& around,
              double half_kerf_mm)
      : outlines_{outlines}, shared_{shared}, half_{half_kerf_mm}, runs_(around.size()) {
    for (const std::vector<Stroke>& loop : around) rows_.emplace_back(loop);
  }

  std::optional<EdgePaths> divide(const Clearance& near) {
    for (std::size_t i = 0; i < shared_.edges.size(); ++i) {
      for (const std::size_t side : {0U, 1U}) {
        passages_[shared_.edges[i].beside[side].contour].push_back({i, side == 1U});
      }
    }
    for (auto& [contour, along] : passages_) {
      std::ranges::sort(along, {}, [this](const Passage& one) { return stretch_of(one).from_mm; });
      note_rests(contour, along);
    }
    WedgeMarks{shared_.nodes, rows_, near, half_}.find(rests_);
    EdgePaths paths;
    for (const auto& [contour, along] : passages_) {
      auto path = path_of(along);
      if (!path) return std::nullopt;
      paths.of_contour[contour] = *std::move(path);
    }
    if (!are_divided_once()) return std::nullopt;
    for (const std::vector<Run>& runs : runs_) paths.is_divided.push_back(!runs.empty());
    return paths;
  }

 private:
  [[nodiscard]] const EdgeStretch& stretch_of(const Passage& one) const {
    return shared_.edges[one.edge].beside[one.is_second ? 1 : 0];
  }
  [[nodiscard]] std::size_t start_of(const Passage& one) const {
    return shared_.edges[one.edge].nodes[one.is_second ? 1 : 0];
  }
  [[nodiscard]] std::size_t end_of(const Passage& one) const {
    return shared_.edges[one.edge].nodes[one.is_second ? 0 : 1];
  }
  void note_rests(std::size_t contour, std::vector<Passage>& along);
  [[nodiscard]] std::optional<std::vector<Stroke>> path_of(const std::vector<Passage>& along);
  [[nodiscard]] bool add_run(const FreeStretch& rest, std::vector<Stroke>& path);
  [[nodiscard]] std::vector<Stroke> strokes_of(std::size_t loop, const Run& run) const;
  [[nodiscard]] bool is_beside(std::size_t contour, const std::vector<Stroke>& run) const;
  [[nodiscard]] bool are_divided_once();

  const std::vector<Outline>& outlines_;
  const SharedEdges& shared_;
  double half_;
  std::vector<MeasuredRow> rows_;  ///< The paths around all outlines.
  /// Passages of each contour, in their order along the contour.
  std::map<std::size_t, std::vector<Passage>> passages_;
  std::vector<FreeStretch> rests_;
  /// For each path in `rows_`, the runs into which it is divided.
  std::vector<std::vector<Run>> runs_;
};

/// Records the free stretches of an outline, each between two of its shared edges.
void PathDivider::note_rests(std::size_t contour, std::vector<Passage>& along) {
  const MeasuredRow row{outlines_[contour].strokes};
  for (std::size_t i = 0; i < along.size(); ++i) {
    if (shared_.edges[along[i].edge].is_ring) continue;
    const Passage& next = along[(i + 1) % along.size()];
    const double from_mm = stretch_of(along[i]).to_mm;
    const double to_mm = stretch_of(next).from_mm;
    const double gap_mm = to_mm - from_mm;
    const bool is_joint = end_of(along[i]) == start_of(next) && along.size() > 1 &&
                          std::min(std::abs(gap_mm), row.length() - std::abs(gap_mm)) <= kNoGap;
    if (is_joint) continue;
    along[i].rest = rests_.size();
    FreeStretch& rest = rests_.emplace_back();
    rest.contour = contour;
    rest.from = end_of(along[i]);
    rest.to = start_of(next);
    rest.leaving = row.leaving(from_mm);
    rest.arriving = row.arriving(to_mm);
    rest.length_mm = gap_mm > 0.0 ? gap_mm : gap_mm + row.length();
  }
}

/// Returns the path of an outline; nothing if there is none. The path begins in the waste, at the
/// end of the first straight line that leaves a shared edge.
std::optional<std::vector<Stroke>> PathDivider::path_of(const std::vector<Passage>& along) {
  std::vector<Stroke> path;
  std::optional<std::size_t> begin;
  for (const Passage& passage : along) {
    const SharedEdge& edge = shared_.edges[passage.edge];
    if (edge.is_ring && along.size() > 1) return std::nullopt;
    std::vector<Stroke> strokes = edge.strokes;
    if (passage.is_second) turn_round(strokes);
    append(path, strokes);
    if (!passage.rest) continue;
    if (!begin) begin = path.size() + 1;
    if (!add_run(rests_[*passage.rest], path)) return std::nullopt;
  }
  if (begin) {
    std::rotate(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(*begin), path.end());
  }
  return path;
}

/// Appends the path along a free stretch, at the offset from the outline, and the straight lines
/// that connect the path with the nodes at both ends. Returns false if there is no such path.
bool PathDivider::add_run(const FreeStretch& rest, std::vector<Stroke>& path) {
  if (!rest.first || !rest.last || rest.first->loop != rest.last->loop) return false;
  path.push_back({shared_.nodes[rest.from], rest.first->place});
  // Both ends of a short free stretch, such as a small step, may have their marks at the same inner
  // corner of a path.
  const bool is_step = std::abs(rest.first->way_mm - rest.last->way_mm) <= kSameMark &&
                       rest.length_mm <= kLongestConnector * half_;
  if (!is_step) {
    const Run run{rest.first->way_mm, rest.last->way_mm};
    const std::vector<Stroke> strokes = strokes_of(rest.first->loop, run);
    if (strokes.empty() || !is_beside(rest.contour, strokes)) return false;
    append(path, strokes);
    runs_[rest.first->loop].push_back(run);
  }
  path.push_back({rest.last->place, shared_.nodes[rest.to]});
  return true;
}

std::vector<Stroke> PathDivider::strokes_of(std::size_t loop, const Run& run) const {
  const MeasuredRow& row = rows_[loop];
  if (run.to_mm > run.from_mm) return row.stretch(run.from_mm, run.to_mm);
  std::vector<Stroke> strokes;
  if (run.from_mm < row.length()) strokes = row.stretch(run.from_mm, row.length());
  if (run.to_mm > 0.0) append(strokes, row.stretch(0.0, run.to_mm));
  return strokes;
}

/// Returns whether the middle of a run is no farther from an outline than the offset.
bool PathDivider::is_beside(std::size_t contour, const std::vector<Stroke>& run) const {
  const MeasuredRow row{run};
  const Place middle = row.place(0.5 * row.length());
  return std::ranges::any_of(outlines_[contour].strokes, [&](const Stroke& stroke) {
    return distance_to(stroke, middle) <= half_ + kBeside;
  });
}

/// Returns whether the runs cover each divided path exactly once: each run ends where the next run
/// begins.
bool PathDivider::are_divided_once() {
  for (std::vector<Run>& runs : runs_) {
    std::ranges::sort(runs, {}, &Run::from_mm);
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const double next = runs[(i + 1) % runs.size()].from_mm;
      if (std::abs(runs[i].to_mm - next) > kSameMark) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<EdgePaths> paths_along_edges(const std::vector<Outline>& outlines,
                                           const SharedEdges& shared,
                                           const std::vector<std::vector<Stroke>>& around,
                                           const Clearance& near,
                                           double half_kerf_mm) {
  return PathDivider{outlines, shared, around, half_kerf_mm}.divide(near);
}

}  // namespace sim::cut
