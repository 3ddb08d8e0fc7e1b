#pragma once

#include <cstddef>
#include <span>

#include "planner/contour/arc_spline_fit.hpp"
#include "planner/contour/biarc_gauge.hpp"
#include "planner/contour/least_value.hpp"

namespace cnc::contour {

/// A smooth chain of as few arcs as will stay in a band.
///
/// From the start on, each arc leaves the one before wherever it then gets farthest:
/// one parameter, the place along the arc before; the curvature follows
/// (ToleranceBand). That arc reaches its farthest by touching the band on alternate
/// sides, as the arcs of Maier's smooth minimum arc paths do (Maier, "Optimal arc spline
/// approximation", CAGD 31 (2014) 211), so nothing that has as many arcs gets
/// farther. Where the end is fixed, its last arcs have to meet it as well: one through the
/// end, or a biarc to it with its tangent, from the longest chain that has one.
class FewestArcs {
 public:
  FewestArcs(const ToleranceBand& band, const FitOptions& options, std::span<FitLink> links)
      : band_{&band}, options_{&options}, links_{links} {}

  /// @return how many links there are; 0 when there is no chain, or no room.
  [[nodiscard]] std::size_t run();
  [[nodiscard]] bool out_of_room() const { return out_of_room_; }

 private:
  /// Where link number `index` may begin.
  struct Launches {
    std::size_t index = 0;
    int variant = 0;  ///< Of a free start: across the curve, in quarters of the tolerance.
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
