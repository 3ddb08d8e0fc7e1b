#include "planner/contour/curve_piece.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::contour {
namespace {

constexpr int kLooks = 48;  // Number of samples of each span.

/// Returns the direction of travel. If the first derivative vanishes, as it does where control
/// points at an end coincide, the limit is the direction of the second derivative.
WideVec2 direction_of(const CurveJet& jet, double share) {
  // Share of the second derivative below which the first derivative counts as 0.
  constexpr double kVanishing = 1.0e-9;
  const double first = jet.first.norm();
  const double second = jet.second.norm();
  if (first > kVanishing * second) return (1.0 / first) * jet.first;
  if (!(second > 0.0)) return {0.0, 0.0};
  return (share < 0.5 ? 1.0 / second : -1.0 / second) * jet.second;
}

/// Properties of the offset at one sample of the source curve.
struct Look {
  double share = 0.0;
  WideVec2 direction{0.0, 0.0};  ///< Direction of the source; null if the source has no direction.
  /// Speed of the offset relative to the speed of the source: 1 + κ d.
  double pace = 1.0;

  [[nodiscard]] bool backwards() const { return pace < 0.0; }
  [[nodiscard]] WideVec2 travel() const { return pace < 0.0 ? WideVec2{-direction} : direction; }
};

class Splitter {
 public:
  Splitter(const PlaneCurve& curve,
           double offset_mm,
           std::span<CurvePiece> pieces,
           double min_corner)
      : curve_{&curve}, offset_mm_{offset_mm}, min_corner_{min_corner}, pieces_{pieces} {}

  [[nodiscard]] Result<std::size_t, SplitError> run() {
    Look last{};
    for (std::size_t span = 0; span < curve_->span_count(); ++span) {
      const Look first = look(span, 0.0);
      if (!has_direction(first)) return SplitError::kNoDirection;
      if (span == 0) {
        backwards_ = first.backwards();
      } else if (jumps(last, first)) {
        cut(static_cast<double>(span), first.backwards());
      }
      if (!divide(span)) return SplitError::kNoDirection;
      last = look(span, 1.0);
    }
    cut(static_cast<double>(curve_->span_count()), false);
    if (count_ > pieces_.size()) return SplitError::kTooManyPieces;
    return count_;
  }

 private:
  [[nodiscard]] static bool has_direction(const Look& look) {
    return look.direction.squaredNorm() > 0.5;
  }

  [[nodiscard]] bool jumps(const Look& before, const Look& after) const {
    const WideVec2 a = before.travel();
    const WideVec2 b = after.travel();
    return a.dot(b) < 0.0 || std::abs(cross(a, b)) > min_corner_;
  }

  /// Returns whether the direction of travel differs by more than a quarter turn between two
  /// samples. If the samples are near each other, this happens only at a cusp.
  [[nodiscard]] static bool turns_back(const Look& before, const Look& after) {
    return before.travel().dot(after.travel()) < 0.0;
  }

  [[nodiscard]] static bool turns_far(const Look& before, const Look& after) {
    constexpr double kMinCosine = 0.9;
    return before.direction.dot(after.direction) < kMinCosine;
  }

  [[nodiscard]] Look look(std::size_t span, double share) const {
    const CurveJet jet = curve_->at(span, share);
    const double square = jet.first.squaredNorm();
    Look found{.share = share, .direction = direction_of(jet, share)};
    if (square <= 0.0 || offset_mm_ == 0.0) return found;
    const double curvature = cross(jet.first, jet.second) / (square * std::sqrt(square));
    found.pace = 1.0 + curvature * offset_mm_;
    return found;
  }

  void cut(double at, bool backwards_from_here) {
    if (at - begun_ > kCuspShare) {
      if (count_ < pieces_.size()) {
        pieces_[count_] = {.curve = curve_,
                           .offset_mm = offset_mm_,
                           .from = begun_,
                           .to = at,
                           .backwards = backwards_};
      }
      ++count_;
    }
    begun_ = at;
    backwards_ = backwards_from_here;
  }

  /// Divides a span at its cusps, where the direction of travel reverses. Returns false if the span
  /// has a point without a direction.
  [[nodiscard]] bool divide(std::size_t span) {
    Look before = look(span, 0.0);
    Look middle = look(span, 1.0 / kLooks);
    if (!has_direction(middle)) return false;
    cut_between(span, before, middle);
    for (int i = 2; i <= kLooks; ++i) {
      const Look after = look(span, static_cast<double>(i) / kLooks);
      if (!has_direction(after)) return false;
      const bool lowest = middle.pace < before.pace && middle.pace <= after.pace;
      const bool highest = middle.pace > before.pace && middle.pace >= after.pace;
      const bool same = !turns_back(before, middle) && !turns_back(middle, after);
      if (same && ((lowest && middle.pace > 0.0) || (highest && middle.pace < 0.0))) {
        const Look peak = extreme(span, before, after, lowest);
        if (turns_back(before, peak)) {
          cut_between(span, before, peak);
          cut_between(span, peak, after);
        }
      }
      if (turns_far(middle, after) || turns_back(middle, after)) cut_between(span, middle, after);
      before = middle;
      middle = after;
    }
    return true;
  }

  [[nodiscard]] Look extreme(std::size_t span, Look low, Look high, bool lowest) const {
    constexpr int kThirds = 24;
    for (int i = 0; i < kThirds; ++i) {
      const double third = (high.share - low.share) / 3.0;
      const Look left = look(span, low.share + third);
      const Look right = look(span, high.share - third);
      if ((left.pace < right.pace) == lowest) {
        high = right;
      } else {
        low = left;
      }
    }
    return look(span, 0.5 * (low.share + high.share));
  }

  /// Cuts at the cusps between two samples. If the source turns far between the samples, two cusps
  /// may look like one. The function therefore divides the stretch between the samples into steps
  /// with little turn.
  void cut_between(std::size_t span, Look low, const Look& high) {
    constexpr int kMaxSteps = 200;
    for (int i = 0; i < kMaxSteps && low.share < high.share; ++i) {
      Look next = high;
      while (turns_far(low, next) && next.share - low.share > kCuspShare) {
        const Look middle = look(span, 0.5 * (low.share + next.share));
        if (middle.share <= low.share || middle.share >= next.share) break;
        next = middle;
      }
      cut_step(span, low, next);
      low = next;
    }
  }

  /// Cuts at the cusp of a step, if there is one. A step turns so little that it has at most one
  /// cusp.
  void cut_step(std::size_t span, Look low, Look high) {
    if (!turns_back(low, high)) return;
    while (high.share - low.share > kCuspShare) {
      const double share = 0.5 * (low.share + high.share);
      const Look middle = look(span, share);
      if (share <= low.share || share >= high.share || !has_direction(middle)) break;
      (turns_back(low, middle) ? high : low) = middle;
    }
    const bool still = turns_back(low, high);
    if (still) cut(static_cast<double>(span) + high.share, high.backwards());
  }

  const PlaneCurve* curve_;
  double offset_mm_;
  double min_corner_;
  std::span<CurvePiece> pieces_;
  std::size_t count_ = 0;
  double begun_ = 0.0;
  bool backwards_ = false;
};

}  // namespace

WayPoint CurvePiece::at(double spans) const {
  const double first = std::floor(from);
  const double last = std::ceil(to) - 1.0;
  const double span = std::clamp(std::floor(spans), first, std::max(first, last));
  const double share = std::clamp(spans - span, 0.0, 1.0);
  const CurveJet jet = curve->at(static_cast<std::size_t>(span), share);
  const WideVec2 forward = direction_of(jet, share);
  return {.place = jet.place - offset_mm * left_normal(forward),
          .tangent = backwards ? WideVec2{-forward} : forward};
}

Result<std::size_t, SplitError> split_offset(const PlaneCurve& curve,
                                             double offset_mm,
                                             std::span<CurvePiece> pieces,
                                             double min_corner) {
  return Splitter{curve, offset_mm, pieces, min_corner}.run();
}

}  // namespace cnc::contour
