#include "host-sim/cut/doubled_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/coincident.hpp"
#include "host-sim/cut/shared_edges.hpp"
#include "host-sim/cut/shared_stretch.hpp"

namespace sim::cut {
namespace {

class DoubledLines {
 public:
  DoubledLines(const drawing::Drawing& drawn,
               const std::vector<Outline>& outlines,
               const std::vector<Side>& sides)
      : drawn_{drawn}, outlines_{outlines}, near_{1.0} {
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      if (outlines[i].strokes.empty() || sides[i] == Side::kFill) continue;
      contours_.push_back(i);
    }
    std::ranges::stable_sort(contours_, std::ranges::greater{}, [&](std::size_t i) {
      return outlines[i].is_beside ? depth_of(Side::kWaste) : depth_of(sides[i]);
    });
    for (const std::size_t i : contours_) {
      for (const Stroke& stroke : outlines[i].strokes) {
        near_.add(stroke, strokes_.size());
        strokes_.push_back(stroke);
      }
    }
    near_.prepare();
  }

  LeftLines find() {
    std::size_t first = 0;  // Number of the first stroke of contour `i`.
    for (const std::size_t i : contours_) {
      if (!outlines_[i].is_beside) leave_out(i, first);
      first += outlines_[i].strokes.size();
    }
    if (!left_.rests.empty()) tell();
    return std::move(left_);
  }

 private:
  void leave_out(std::size_t contour, std::size_t first) {
    const MeasuredRow path{outlines_[contour].strokes};
    std::vector<SharedStretch> doubled;
    for (std::size_t k = 0; k < path.strokes().size(); ++k) {
      for (SharedStretch& stretch : stretches_before(first + k)) {
        stretch.from_mm += path.way_to(k);
        stretch.to_mm += path.way_to(k);
        doubled.push_back(stretch);
      }
    }
    join_stretches(doubled);
    std::erase_if(doubled, [](const SharedStretch& stretch) {
      return stretch.to_mm - stretch.from_mm < kShortestDoubledMm;
    });
    if (doubled.empty()) return;
    if (left_.rests.empty()) {
      first_ = contour;
      place_ = path.place(doubled.front().from_mm);
    }
    for (const SharedStretch& stretch : doubled) length_mm_ += stretch.to_mm - stretch.from_mm;
    auto rests =
        outlines_[contour].is_closed ? rests_between(path, doubled) : rests_of_open(path, doubled);
    // A rest this short is covered by the beam at the ends of the other line.
    std::erase_if(rests, [](const auto& rest) { return length_of(rest) < 2.0 * kTouchesMm; });
    left_.rests[contour] = std::move(rests);
  }

  /// Returns the stretches of a stroke that run along strokes with lower numbers.
  [[nodiscard]] std::vector<SharedStretch> stretches_before(std::size_t number) const {
    const Stroke& stroke = strokes_[number];
    std::vector<SharedStretch> stretches;
    for (const std::size_t other : near_.owners_near(stroke, kTouchesMm)) {
      if (other >= number) continue;
      for (const Stroke& way : {strokes_[other], reversed(strokes_[other])}) {
        if (const auto shared = shared_stretch(stroke, way, kTouchesMm)) {
          stretches.push_back(*shared);
        }
      }
    }
    return stretches;
  }

  void tell() {
    const std::size_t count = left_.rests.size();
    left_.warning = {drawing::FaultKind::kDuplicate,
                     drawn_.contours[first_].entity,
                     place_,
                     fmt::format("{} line{} along others within {} mm, this one first; the common "
                                 "path is driven once, which leaves out {:.3f} mm",
                                 count,
                                 count == 1 ? " runs" : "s run",
                                 kTouchesMm,
                                 length_mm_),
                     "draw each line once"};
  }

  const drawing::Drawing& drawn_;
  const std::vector<Outline>& outlines_;
  std::vector<std::size_t> contours_;  ///< Numbers of the contours, the deepest cut first.
  std::vector<Stroke> strokes_;        ///< Strokes of all contours, in the order of `contours_`.
  Clearance near_;
  LeftLines left_;
  std::size_t first_ = 0;  ///< Number of the first contour of which a stretch is left out.
  Place place_{0.0, 0.0};  ///< Start of the first stretch that is left out.
  double length_mm_ = 0.0;
};

}  // namespace

LeftLines without_doubled(const drawing::Drawing& drawn,
                          const std::vector<Outline>& outlines,
                          const std::vector<Side>& sides) {
  const auto is_line = [](const Outline& outline) {
    return !outline.is_beside && !outline.strokes.empty();
  };
  if (std::ranges::none_of(outlines, is_line)) return {};
  return DoubledLines{drawn, outlines, sides}.find();
}

}  // namespace sim::cut
