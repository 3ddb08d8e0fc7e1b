#pragma once

#include <cstddef>
#include <span>

#include "planner/contour/arc_spline_fit.hpp"
#include "planner/contour/biarc_gauge.hpp"
#include "planner/contour/least_value.hpp"

namespace cnc::contour {

/// Constructs a smooth chain of arcs in a band, with as few arcs as possible.
///
/// From the start on, each arc leaves the previous arc at the point from which it has the greatest
/// reach. This point is the only parameter; the curvature follows from it (ToleranceBand). An arc
/// has the greatest reach if it touches the band on alternate sides, as the arcs of Maier's smooth
/// minimum arc paths do (Maier, "Optimal arc spline approximation", CAGD 31 (2014) 211). So no
/// chain with the same number of arcs has a greater reach. If the end is fixed, the last arcs must
/// also lead to the end: one arc through the end, or a biarc to the end with its tangent. These
/// last arcs follow the longest chain from which they exist.
class FewestArcs {
 public:
  FewestArcs(const ToleranceBand& band, const FitOptions& options, std::span<FitLink> links)
      : band_{&band}, options_{&options}, links_{links} {}

  /// Constructs the chain. @return the number of links; 0 if there is no chain, or if `links` is
  /// too short.
  [[nodiscard]] std::size_t run();
  [[nodiscard]] bool out_of_room() const { return out_of_room_; }

 private:
  /// The range of possible starts of link number `index`.
  struct Launches {
    std::size_t index = 0;
    /// Position of a free start across the curve, in quarters of the tolerance; 4 is on the curve.
    int variant = 0;
    SearchRange range{};
  };

  [[nodiscard]] Launches launches(std::size_t index) const;
  [[nodiscard]] int variants(std::size_t index) const;
  [[nodiscard]] BandStart launch(const Launches& from, double at) const;
  template <typename Function>
  void for_best(std::size_t index,
                double enough,
                const Function& function,
                LeastValue& best,
                int& variant) const;
  [[nodiscard]] bool extend(std::size_t index);
  [[nodiscard]] bool give_way(std::size_t index);
  [[nodiscard]] double next_reach(std::size_t index) const;
  [[nodiscard]] std::size_t finish(std::size_t index);
  [[nodiscard]] std::size_t finish_at_place(std::size_t index);
  [[nodiscard]] std::size_t finish_with_tangent(std::size_t index);
  [[nodiscard]] double arc_to_end(const BandStart& start, double* curvature) const;
  [[nodiscard]] LeastValue biarc_to_end(const BandStart& start) const;
  [[nodiscard]] double deviation(const BiarcGauge& gauge,
                                 double from,
                                 double bound,
                                 std::size_t& worst) const;
  void append_biarc(std::size_t index, const BandStart& start, double share);

  const ToleranceBand* band_;
  const FitOptions* options_;
  std::span<FitLink> links_;
  bool out_of_room_ = false;
};

}  // namespace cnc::contour
