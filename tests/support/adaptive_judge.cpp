#include "tests/support/adaptive_judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

namespace proof {
namespace {

using cnc::WideVec2;
using cnc::pocket::Use;
using Element = ExactContour::Element;

/// Thickness of stock below which it counts as none, mm.
constexpr double kThin_mm = 1.0e-3;

/// An element of the path on the floor of the pocket, with its use.
struct Sweep {
  Element element{};
  Use use = Use::kPass;
};

std::vector<Sweep> sweeps_of(const sim::pocket::AdaptivePath& path, double floor_z) {
  std::vector<Sweep> sweeps;
  const auto view = path.path();
  for (std::size_t row = 0; row < view.row_ends.size(); ++row) {
    for (std::uint32_t i = view.row_begin(row); i + 1 < view.row_ends[row]; ++i) {
      const auto& from = view.points[i];
      const auto& to = view.points[i + 1];
      const bool is_level = from.z == floor_z && to.z == floor_z;
      if (!is_level || (from.x == to.x && from.y == to.y)) continue;
      const std::vector<sim::ContourVertex> ends{{from.x, from.y, from.bulge}, {to.x, to.y, 0.0}};
      const std::vector<std::uint32_t> loop_ends{2};
      const ExactContour both{{{ends.data(), 2}, {loop_ends.data(), 1}}};
      sweeps.push_back({both.elements().front(), from.use});
    }
  }
  return sweeps;
}

/// Returns the first part of an element, up to `share` of its length.
Element part_of(const Element& element, double share) {
  Element part = element;
  double right_x = 0, right_y = 0;
  element.at(share, part.x1, part.y1, right_x, right_y);
  part.sweep = share * element.sweep;
  return part;
}

/// Index of the swept elements by the cells of a grid: each cell lists the elements that come
/// within reach of it.
class SweptPlane {
 public:
  SweptPlane(const std::vector<Sweep>& sweeps, double reach_mm)
      : sweeps_{sweeps}, cell_mm_{reach_mm} {
    for (std::size_t i = 0; i < sweeps.size(); ++i) insert(i, reach_mm);
  }

  /// Returns whether one of the elements before number `count` comes within `mm` of a point.
  [[nodiscard]] bool is_within(const WideVec2& place, std::size_t count, double mm) const {
    const auto found = cells_.find(key_of(cell_of(place.x()), cell_of(place.y())));
    if (found == cells_.end()) return false;
    const std::vector<std::size_t>& near = found->second;
    auto i = std::lower_bound(near.begin(), near.end(), count);
    while (i != near.begin()) {
      --i;  // The latest element is the likeliest to be near.
      if (sweeps_[*i].element.distance(place.x(), place.y()) <= mm) return true;
    }
    return false;
  }

  /// Returns the least distance of a point from all elements; infinity if none comes within reach
  /// of the point's cell.
  [[nodiscard]] double distance(const WideVec2& place) const {
    double least = INFINITY;
    const auto found = cells_.find(key_of(cell_of(place.x()), cell_of(place.y())));
    if (found == cells_.end()) return least;
    for (const std::size_t i : found->second) {
      least = std::min(least, sweeps_[i].element.distance(place.x(), place.y()));
    }
    return least;
  }

 private:
  [[nodiscard]] std::int64_t cell_of(double mm) const {
    return static_cast<std::int64_t>(std::floor(mm / cell_mm_));
  }
  [[nodiscard]] static std::int64_t key_of(std::int64_t column, std::int64_t row) {
    return column * 1'000'003 + row;
  }

  void insert(std::size_t index, double reach_mm) {
    const Element& e = sweeps_[index].element;
    double x0 = std::min(e.x0, e.x1), x1 = std::max(e.x0, e.x1);
    double y0 = std::min(e.y0, e.y1), y1 = std::max(e.y0, e.y1);
    constexpr int kPlaces = 16;
    for (int i = 1; e.radius > 0.0 && i < kPlaces; ++i) {
      double x = 0, y = 0, right_x = 0, right_y = 0;
      e.at(static_cast<double>(i) / kPlaces, x, y, right_x, right_y);
      // Between two sampled points the arc bulges beyond their chord by at most this much.
      const double between = e.length() / kPlaces;
      const double slack = between * between / (8.0 * e.radius);
      x0 = std::min(x0, x - slack), x1 = std::max(x1, x + slack);
      y0 = std::min(y0, y - slack), y1 = std::max(y1, y + slack);
    }
    for (std::int64_t c = cell_of(x0 - reach_mm); c <= cell_of(x1 + reach_mm); ++c) {
      for (std::int64_t r = cell_of(y0 - reach_mm); r <= cell_of(y1 + reach_mm); ++r) {
        cells_[key_of(c, r)].push_back(index);
      }
    }
  }

  const std::vector<Sweep>& sweeps_;
  double cell_mm_;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> cells_;
};

class AdaptiveJudge {
 public:
  AdaptiveJudge(const cnc::contour::ContourView<double>& area,
                const sim::pocket::AdaptivePath& path,
                const sim::pocket::AdaptiveOptions& options,
                const std::optional<sim::pocket::StockBox>& stock)
      : area_{area},
        stock_{stock},
        path_{path},
        radius_{options.tool_radius_mm},
        sweeps_{sweeps_of(path, -options.depth_mm)},
        plane_{sweeps_, radius_ + 10.0 * kThin_mm} {}

  AdaptiveVerdict judge(const cnc::contour::ContourView<double>& area) {
    for (std::size_t i = 0; i < sweeps_.size(); ++i) judge_sweep(i);
    judge_rest(area);
    return verdict_;
  }

 private:
  void judge_sweep(std::size_t index) {
    const Element& element = sweeps_[index].element;
    const int places = std::clamp(static_cast<int>(4.0 * element.length() / radius_), 3, 24);
    for (int i = 1; i <= places; ++i) {
      const double share = static_cast<double>(i) / places;
      double x = 0, y = 0, right_x = 0, right_y = 0;
      element.at(share, x, y, right_x, right_y);
      verdict_.gouge_mm = std::max(verdict_.gouge_mm, radius_ - area_->depth({x, y}));
      if (sweeps_[index].use == Use::kEntry) continue;
      if (is_excepted({x, y})) {
        ++verdict_.excepted;
        continue;
      }
      const double degrees = engaged(index, share, {x, y}, {-right_y, right_x});
      if (sweeps_[index].use == Use::kLink || sweeps_[index].use == Use::kReturn) {
        verdict_.link_deg = std::max(verdict_.link_deg, degrees);
        continue;
      }
      ++verdict_.judged;
      if (degrees <= verdict_.engagement_deg) continue;
      verdict_.engagement_deg = degrees;
      verdict_.engaged_at = {x, y};
    }
  }

  /// Returns whether the tool is in a narrow stretch, or near one of its ends.
  [[nodiscard]] bool is_excepted(const WideVec2& place) const {
    for (const sim::pocket::NarrowStretch& stretch : path_.narrow) {
      for (std::size_t i = 0; i < stretch.places.size(); ++i) {
        const WideVec2& from = stretch.places[i > 0 ? i - 1 : 0];
        const WideVec2 way = stretch.places[i] - from;
        const double square = way.squaredNorm();
        const double along = square > 0.0 ? way.dot(place - from) / square : 0.0;
        const WideVec2 foot = from + std::clamp(along, 0.0, 1.0) * way;
        if ((place - foot).norm() <= 1.2 * radius_) return true;
      }
    }
    return false;
  }

  /// Returns whether a point never had stock, or only a skin of it.
  [[nodiscard]] bool is_beside_stock(const WideVec2& place) const {
    if (!stock_) return false;
    return sim::pocket::gap_to(sim::pocket::widened(*stock_, -2.0 * kThin_mm), place) > 0.0;
  }

  /// Returns how many degrees of the leading half of the tool's edge are in stock. The last piece
  /// of path before `share` does not count as cleared: beside it the tool's edge always lies one
  /// radius away from the tool's path.
  [[nodiscard]] double engaged(std::size_t index,
                               double share,
                               const WideVec2& place,
                               const WideVec2& forwards) const {
    constexpr int kParts = 240;
    const Element& element = sweeps_[index].element;
    const double lag = std::min(0.1 * radius_ / element.length(), 0.5 * share);
    const Element so_far = part_of(element, share - lag);
    const double from = std::atan2(forwards.y(), forwards.x()) - 0.5 * std::numbers::pi;
    const double cleared = radius_ + kThin_mm;
    int count = 0;
    for (int i = 0; i < kParts; ++i) {
      const double angle = from + std::numbers::pi * (i + 0.5) / kParts;
      const WideVec2 edge = place + radius_ * WideVec2{std::cos(angle), std::sin(angle)};
      if (is_beside_stock(edge)) continue;
      if (so_far.distance(edge.x(), edge.y()) <= cleared) continue;
      if (!plane_.is_within(edge, index, cleared)) ++count;
    }
    return 180.0 * count / kParts;
  }

  /// Finds the points of a grid that the tool could reach but did not sweep.
  void judge_rest(const cnc::contour::ContourView<double>& area) {
    sim::ContourOffset offset;
    const sim::pocket::OwnedArea locus{offset.offset(area, -radius_)};
    if (locus->element_count() == 0) return;
    double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
    for (const sim::ContourVertex& vertex : area.vertices) {
      x0 = std::min(x0, vertex.x), x1 = std::max(x1, vertex.x);
      y0 = std::min(y0, vertex.y), y1 = std::max(y1, vertex.y);
    }
    constexpr int kRows = 150;
    for (int i = 0; i <= kRows; ++i) {
      for (int k = 0; k <= kRows; ++k) {
        const WideVec2 place{x0 + (x1 - x0) * i / kRows, y0 + (y1 - y0) * k / kRows};
        if (is_beside_stock(place)) continue;
        if (area_->depth(place) < 0.0 || locus->depth(place) < 2.0 * kThin_mm - radius_) continue;
        verdict_.left_mm = std::max(verdict_.left_mm, plane_.distance(place) - radius_);
      }
    }
  }

  sim::pocket::OwnedArea area_;
  std::optional<sim::pocket::StockBox> stock_;
  const sim::pocket::AdaptivePath& path_;
  double radius_;
  std::vector<Sweep> sweeps_;
  SweptPlane plane_;
  AdaptiveVerdict verdict_;
};

}  // namespace

AdaptiveVerdict judge_adaptive(const cnc::contour::ContourView<double>& area,
                               const sim::pocket::AdaptivePath& path,
                               const sim::pocket::AdaptiveOptions& options,
                               const std::optional<sim::pocket::StockBox>& stock) {
  return AdaptiveJudge{area, path, options, stock}.judge(area);
}

}  // namespace proof
