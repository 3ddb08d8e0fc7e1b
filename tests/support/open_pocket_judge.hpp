#pragma once

#include <string>
#include <vector>

#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/strategy.hpp"
#include "tests/planner/pocket/path_bench.hpp"
#include "tests/support/contour_oracle.hpp"

namespace proof {

/// mm: the stock counts as a thousandth smaller, and contours are written in micrometres.
inline constexpr double kOpenSkinMm = 2.0e-3;

/// Returns how far a place is inside of a box; negative outside.
[[nodiscard]] double depth_in(const sim::pocket::StockBox& box, const cnc::WideVec2& place);

/// Looks for faults of the path of open pockets by samples: it knows the stock, the walls and what
/// the tool has swept.
class OpenPocketJudge {
 public:
  /// @param path one level
  OpenPocketJudge(const sim::Contour& pockets,
                  const sim::pocket::MilledPocket& path,
                  const sim::pocket::StrategyOptions& options);

  /// Returns the first fault; empty where there is none.
  std::string run(Random& random);

  /// Returns how many places were tried at which the tool has to take stock.
  [[nodiscard]] std::size_t places() const { return places_; }

 private:
  using Point = cnc::pocket::PathPoint<double>;

  void complain(const std::string& text, const cnc::WideVec2& place);
  [[nodiscard]] bool must_stay(const cnc::WideVec2& place) const;
  [[nodiscard]] bool is_cleared(const cnc::WideVec2& place) const;
  void check_element(const Point& from, const Point& to);
  void check_link(const Point& from, const Point& to);
  void take(const Point& from, const Point& to);
  [[nodiscard]] bool is_reachable(const cnc::WideVec2& place) const;
  [[nodiscard]] bool is_free(const cnc::WideVec2& centre) const;
  void check_stock(Random& random);

  const sim::pocket::MilledPocket& path_;
  double radius_;
  double floor_z_;
  sim::pocket::StockBox stock_;
  sim::pocket::OwnedArea pockets_;
  cnc::pocket::PlainContour walls_;
  std::vector<cnc::WideVec2> walls_in_stock_;  ///< Places of the walls, close together.
  cnc::pocket::PlainContour swept_;            ///< By the tool's centre on the floor, so far.
  std::size_t places_ = 0;
  std::string complaint_;
};

}  // namespace proof
