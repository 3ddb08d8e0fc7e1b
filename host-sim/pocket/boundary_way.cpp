#include "host-sim/pocket/boundary_way.hpp"

#include "host-sim/cut/stroke.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using Curve = cnc::contour::Curve<double>;

/// Length below which an element is a rounding error, mm.
constexpr double kShortestMm = 1.0e-9;

/// Builds a path along a boundary, element by element.
class WayMaker {
 public:
  WayMaker(const OwnedArea& area, const WideVec2& start, bool is_backwards)
      : area_{area}, at_{start}, is_backwards_{is_backwards} {}

  /// Continues along an element to the point `to` of the element.
  void go(std::uint32_t element, const WideVec2& to) {
    if ((to - at_).norm() < kShortestMm) return;
    const Curve& curve = area_->element(element);
    const double bulge =
        is_backwards_ ? -curve.bulge_between(to, at_) : curve.bulge_between(at_, to);
    const cut::Stroke stroke{.from = at_, .to = to, .bulge = bulge};
    length_mm_ += cut::length_of(stroke);
    way_.push_back({to, bulge});
    at_ = to;
  }
  void go_to_end(std::uint32_t element) {
    const Curve& curve = area_->element(element);
    go(element, is_backwards_ ? curve.start : curve.end);
  }

  [[nodiscard]] double length_mm() const { return length_mm_; }
  [[nodiscard]] std::vector<WayElement> way() && { return std::move(way_); }

 private:
  const OwnedArea& area_;
  WideVec2 at_;
  bool is_backwards_;
  double length_mm_ = 0.0;
  std::vector<WayElement> way_;
};

/// Returns whether `to` is at or after `from` on an element, in the direction of driving.
bool is_ahead(const Curve& curve, const WideVec2& from, const WideVec2& to, bool is_backwards) {
  const double step = curve.order_of(to) - curve.order_of(from);
  return is_backwards ? step <= 0.0 : step >= 0.0;
}

}  // namespace

std::optional<std::vector<WayElement>> way_along(const OwnedArea& area,
                                                 const BoundaryPlace& from,
                                                 const BoundaryPlace& to,
                                                 bool is_backwards,
                                                 double limit_mm) {
  WayMaker maker{area, from.place, is_backwards};
  std::uint32_t element = from.element;
  const bool is_on_one =
      element == to.element && is_ahead(area->element(element), from.place, to.place, is_backwards);
  if (!is_on_one) {
    do {
      maker.go_to_end(element);
      element = is_backwards ? area->previous(element) : area->next(element);
      if (maker.length_mm() > limit_mm) return std::nullopt;
      // The tour around the loop is shorter than the limit, and `to` is not on the loop.
      if (element == from.element && element != to.element) return std::nullopt;
    } while (element != to.element);
  }
  maker.go(element, to.place);
  if (maker.length_mm() > limit_mm) return std::nullopt;
  return std::move(maker).way();
}

}  // namespace sim::pocket
