#include "host-sim/surface/path/crossed_contour.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "host-sim/pocket/owned_area.hpp"
#include "planner/contour/meeting.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::surface {
namespace {

using Curve = cnc::contour::Curve<double>;

constexpr double kTouchMm = 1.0e-9;
/// Uncertainty of the position of a joint between neighbours at a sharp angle, mm.
constexpr double kJointMm = 1.0e-6;

/// Returns whether two elements intersect or touch at a point other than their common joint.
bool meet(const Curve& a, const Curve& b) {
  const auto is_joint = [&](const cnc::WideVec2& place) {
    const bool ends_there =
        (a.end - b.start).norm() < kJointMm && (place - a.end).norm() < kJointMm;
    const bool begins_there =
        (b.end - a.start).norm() < kJointMm && (place - b.end).norm() < kJointMm;
    return ends_there || begins_there;
  };
  const auto found = cnc::contour::meetings_of(a, b, kTouchMm);
  for (std::uint32_t i = 0; i < found.count; ++i) {
    if (!is_joint(found.places[i])) return true;
  }
  return false;
}

double length_between(const ContourVertex& from, const ContourVertex& to) {
  return (to.point() - from.point()).norm();
}

/// Removes the short detours of one loop.
class LoopUntangler {
 public:
  explicit LoopUntangler(std::vector<ContourVertex> loop) : loop_{std::move(loop)} {}

  /// Removes all short detours, except detours that include the loop's first vertex.
  void cut(double reach_mm) {
    for (std::size_t i = 0; i + 2 < loop_.size(); ++i) {
      while (cut_after(i, reach_mm)) {
      }
    }
  }
  void rotate() {
    const auto half = static_cast<std::ptrdiff_t>(loop_.size() / 2);
    std::rotate(loop_.begin(), loop_.begin() + half, loop_.end());
  }
  [[nodiscard]] const std::vector<ContourVertex>& loop() const { return loop_; }

 private:
  [[nodiscard]] bool make(std::size_t i, Curve& curve) const {
    const ContourVertex& end = loop_[(i + 1) % loop_.size()];
    return cnc::pocket::make_curve({loop_[i].point(), end.point(), loop_[i].bulge}, curve);
  }

  /// Joins element `i` directly to the farthest following element within `reach_mm` that it
  /// intersects, and removes the elements between. Returns false if there is no such element.
  bool cut_after(std::size_t i, double reach_mm) {
    Curve first;
    if (!make(i, first)) return false;
    double way = 0.0;
    std::size_t last = i;
    cnc::WideVec2 place{0.0, 0.0};
    for (std::size_t k = i + 2; k < loop_.size(); ++k) {
      way += length_between(loop_[k - 1], loop_[k]);
      if (way > reach_mm) break;
      Curve other;
      if (!make(k, other) || !first.box().meets(other.box())) continue;
      const auto found = cnc::contour::meetings_of(first, other, kTouchMm);
      for (std::uint32_t m = 0; m < found.count; ++m) {
        const bool closes = (found.places[m] - other.end).norm() < kJointMm &&
                            (first.start - other.end).norm() < kJointMm;
        if (closes) continue;
        last = k;
        place = found.places[m];
      }
    }
    if (last == i) return false;
    Curve other;
    if (!make(last, other)) return false;
    loop_[i].bulge = first.bulge_between(first.start, place);
    loop_[last] = {place.x(), place.y(), other.bulge_between(place, other.end)};
    const auto begin = loop_.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    loop_.erase(begin, loop_.begin() + static_cast<std::ptrdiff_t>(last));
    return true;
  }

  std::vector<ContourVertex> loop_;
};

}  // namespace

Contour untangled(const Contour& contour, double reach_mm) {
  Contour result;
  const auto view = contour.view();
  for (std::size_t i = 0; i < contour.loop_ends.size(); ++i) {
    LoopUntangler untangler{{contour.vertices.begin() + view.loop_begin(i),
                             contour.vertices.begin() + contour.loop_ends[i]}};
    untangler.cut(reach_mm);
    untangler.rotate();
    untangler.cut(reach_mm);
    if (untangler.loop().size() < 2) continue;
    result.vertices.insert(result.vertices.end(), untangler.loop().begin(), untangler.loop().end());
    result.end_loop();
  }
  return result;
}

bool crosses_itself(const Contour& contour) {
  const pocket::OwnedArea area{contour.view()};
  bool crosses = false;
  for (std::uint32_t i = 0; i < area->element_count() && !crosses; ++i) {
    const Curve& element = area->element(i);
    area->search(element.box(), [&](const Curve& other) {
      crosses = &other > &element && meet(element, other);
      return !crosses;
    });
  }
  return crosses;
}

}  // namespace sim::surface
