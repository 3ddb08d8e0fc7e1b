#pragma once

#include <string>
#include <vector>

#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/pocket/strategy.hpp"
#include "tests/planner/pocket/path_bench.hpp"
#include "tests/support/contour_oracle.hpp"

namespace proof {

/// Thickness of stock that does not count, mm: the planner takes the stock as a thousandth smaller,
/// and contours are written in micrometres.
inline constexpr double kOpenSkinMm = 2.0e-3;

/// Returns the distance from a point inside of a box to its border, mm; negative outside.
[[nodiscard]] double depth_in(const sim::pocket::StockBox& box, const cnc::WideVec2& place);

/// Finds faults in the path of open pockets by samples. It knows the stock, the walls and the area
/// that the tool has swept.
class OpenPocketJudge {
 public:
  /// @param path one level of the milled pockets
  OpenPocketJudge(const sim::Contour& pockets,
                  const sim::pocket::MilledPocket& path,
                  const sim::pocket::StrategyOptions& options);

  /// Returns the first fault, or an empty text if there is none.
  std::string run(Random& random);

  /// Returns the number of sampled points at which the tool must remove stock.
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
  /// Closely spaced points of the walls that are in the stock.
  std::vector<cnc::WideVec2> walls_in_stock_;
  cnc::pocket::PlainContour swept_;  ///< Path of the tool's centre on the floor so far.
  std::size_t places_ = 0;
  std::string complaint_;
};

}  // namespace proof
