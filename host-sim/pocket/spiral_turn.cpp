#include "host-sim/pocket/spiral_turn.hpp"

#include <algorithm>
#include <cmath>

#include "planner/geometry/biarc.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;

/// Greatest speed of the nearest point, divided by the speed of the point on the outer loop. A
/// faster point counts as a jump.
constexpr double kFastest = 8.0;
/// Length below which parts of the outer loop are not divided further, mm.
constexpr double kShortestPartMm = 1.0e-5;
/// Half the length of a chord that approximates a tangent, mm.
constexpr double kHalfChordMm = 1.0e-6;
/// Distance below which two loops touch, within rounding, mm.
constexpr double kLoopsMeetMm = 1.0e-9;
/// Greatest turn of a part, radians, so that the samples are dense enough.
constexpr double kMaxTurn = 0.8;

/// A point of a turn, with the direction of the turn at this point.
struct Sample {
  double way_mm = 0.0;  ///< Distance along the outer loop from the start of the turn, mm.
  WideVec2 place{0.0, 0.0};
  WideVec2 tangent{1.0, 0.0};
};

class TurnMaker {
 public:
  TurnMaker(const OwnedBoundary& inner, cut::MeasuredRow outer, const TurnOptions& options)
      : inner_{inner}, outer_{std::move(outer)}, options_{options} {}

  std::optional<std::vector<WayElement>> make() {
    const double length = outer_.length();
    Sample from = sample(0.0);
    for (std::size_t i = 0; i < outer_.strokes().size(); ++i) {
      const bool is_last = i + 1 == outer_.strokes().size();
      const Sample to = sample(is_last ? length : outer_.way_to(i + 1));
      if (!add(from, to)) return std::nullopt;
      from = to;
    }
    return std::move(way_);
  }

 private:
  /// Returns a value that grows with `share` from 0 to 1, with slope 0 at both ends.
  static double smooth_step(double share) { return share * share * (3.0 - 2.0 * share); }

  [[nodiscard]] WideVec2 place_at(double way_mm) {
    const double range = options_.end_share - options_.begin_share;
    return place_at(way_mm, options_.begin_share + range * smooth_step(way_mm / outer_.length()));
  }

  [[nodiscard]] WideVec2 place_at(double way_mm, double share) {
    const WideVec2 outer = outer_.place(way_mm);
    const WideVec2 inner = inner_.nearest().nearest_to(outer).point;
    const double range = options_.end_share - options_.begin_share;
    widest_mm_ = std::max(widest_mm_, range * (outer - inner).norm());
    const double inwards = cnc::cross(outer_.leaving(way_mm), WideVec2{inner - outer});
    const bool is_seen = (options_.milling == cnc::pocket::Milling::kClimb) == (inwards > 0.0);
    is_all_seen_ = is_all_seen_ && (is_seen || std::abs(inwards) < kLoopsMeetMm);
    return inner + share * (outer - inner);
  }

  [[nodiscard]] Sample sample(double way_mm) {
    const double length = outer_.length();
    Sample sample{way_mm, place_at(way_mm)};
    if (way_mm <= 0.0) {
      sample.tangent = tangent_at_start(options_.begin_share);
    } else if (way_mm >= length) {
      sample.tangent = tangent_at_start(options_.end_share);
    } else {
      const double half = std::min({kHalfChordMm, way_mm, length - way_mm});
      sample.tangent = (place_at(way_mm + half) - place_at(way_mm - half)).normalized();
    }
    return sample;
  }

  /// Returns the tangent at the start of the outer loop. On one of the two loops, it is the tangent
  /// of that loop. Between the loops, it is the direction of a chord of a curve: the points at the
  /// constant share `share` of the distance between the loops.
  [[nodiscard]] WideVec2 tangent_at_start(double share) {
    const double length = outer_.length();
    if (share >= 1.0) return outer_.arriving(length);
    if (share > 0.0) {
      return (place_at(kHalfChordMm, share) - place_at(length - kHalfChordMm, share)).normalized();
    }
    const auto nearest = inner_.nearest().nearest_to(outer_.place(0.0));
    const WideVec2 tangent = inner_.nearest()[nearest.curve].tangent_at(nearest.point);
    return tangent.dot(outer_.leaving(0.0)) < 0.0 ? WideVec2{-tangent} : tangent;
  }

  /// Appends arcs between two samples. Halves the parts until the arcs are within the tolerance.
  /// Returns false if the turn is impossible there.
  [[nodiscard]] bool add(const Sample& first, const Sample& last) {
    // Ends of the parts that arcs do not yet follow. The end of the next part is the last item.
    std::vector<Sample> ends{last};
    Sample from = first;
    while (!ends.empty()) {
      const Sample& to = ends.back();
      if (widest_mm_ > options_.widest_mm || !is_all_seen_) return false;
      const double length = to.way_mm - from.way_mm;
      if (try_arcs(from, to)) {
        from = to;
        ends.pop_back();
        continue;
      }
      if (length < kShortestPartMm) {
        if (jumps(from, to)) return false;
        way_.push_back({to.place, 0.0});
        from = to;
        ends.pop_back();
        continue;
      }
      ends.push_back(sample(0.5 * (from.way_mm + to.way_mm)));
    }
    return true;
  }

  /// Returns whether two samples are so far apart that the nearest point must have jumped between
  /// them.
  [[nodiscard]] bool jumps(const Sample& from, const Sample& to) const {
    const double length = to.way_mm - from.way_mm;
    return (to.place - from.place).norm() > kFastest * length + options_.tolerance_mm;
  }

  /// Appends two arcs if they follow the turn within the tolerance. Does not try arcs at a jump:
  /// there, all samples are at the ends of the jump, and so are the ends of any arcs.
  [[nodiscard]] bool try_arcs(const Sample& from, const Sample& to) {
    if (jumps(from, to)) return false;
    if (from.tangent.dot(to.tangent) < std::cos(kMaxTurn)) return false;
    const WideVec2 chord = to.place - from.place;
    if (chord.norm() < 1.0e-9) return true;
    if (from.tangent.dot(chord) <= 0.0 || to.tangent.dot(chord) <= 0.0) return false;
    const auto biarc = cnc::make_biarc({from.place, from.tangent, to.place, to.tangent}, 0.5);
    if (!biarc.ok()) return false;
    const cnc::WideBiarc& arcs = biarc.value();
    for (const double share : {0.2, 0.4, 0.5, 0.6, 0.8}) {
      const WideVec2 place = place_at(from.way_mm + share * (to.way_mm - from.way_mm));
      const double away = std::min(distance(from.place, arcs.joint, arcs.first_bulge, place),
                                   distance(arcs.joint, to.place, arcs.second_bulge, place));
      if (away > options_.tolerance_mm) return false;
    }
    way_.push_back({arcs.joint, arcs.first_bulge});
    way_.push_back({to.place, arcs.second_bulge});
    return true;
  }

  static double distance(const WideVec2& from,
                         const WideVec2& to,
                         double bulge,
                         const WideVec2& of) {
    cnc::contour::Curve<double> curve;
    if (!cnc::pocket::make_curve<double>({from, to, bulge}, curve)) return (of - from).norm();
    return curve.distance(of);
  }

  const OwnedBoundary& inner_;
  cut::MeasuredRow outer_;
  TurnOptions options_;
  double widest_mm_ = 0.0;  ///< Greatest distance between turns up to now, mm.
  /// Whether all lines to nearest points lead from the outer loop to its inside.
  bool is_all_seen_ = true;
  std::vector<WayElement> way_;
};

}  // namespace

std::optional<std::vector<WayElement>> spiral_turn(const OwnedBoundary& inner,
                                                   const DrivenLoop& outer,
                                                   double start_mm,
                                                   const TurnOptions& options) {
  return TurnMaker{inner, cut::MeasuredRow{outer.stretch(start_mm, start_mm)}, options}.make();
}

}  // namespace sim::pocket
