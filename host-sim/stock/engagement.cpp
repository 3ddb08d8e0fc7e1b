#include "host-sim/stock/engagement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace sim::stock {
namespace {

constexpr double kFloorSkinMm = 0.002;
constexpr double kPosesPerRadius = 8.0;
constexpr int kMinSamples = 180;  ///< Minimum number of samples on the leading half circle.
/// Maximum number of samples, which limits the time for small cells.
constexpr int kMaxSamples = 20'000;

/// A flat tool on a stretch, and the stock ahead of it.
class Front {
 public:
  Front(const Stock& stock, double radius_mm, const Stretch& stretch)
      : stock_{stock}, radius_mm_{radius_mm}, stretch_{stretch} {
    const double dx = stretch.to.x_mm - stretch.from.x_mm;
    const double dy = stretch.to.y_mm - stretch.from.y_mm;
    length_mm_ = std::hypot(dx, dy);
    if (length_mm_ == 0.0) return;
    along_x_ = dx / length_mm_;
    along_y_ = dy / length_mm_;
    // Radius of a circle beyond all cells that the tool has partly cut at its position.
    ring_mm_ = radius_mm + stretch.side_slack_mm + std::hypot(stock.cell_x_mm(), stock.cell_y_mm());
    const double spacing = 0.5 * std::min(stock.cell_x_mm(), stock.cell_y_mm());
    const double wanted = std::ceil(std::numbers::pi * radius_mm / spacing);
    samples_ = static_cast<int>(std::clamp<double>(wanted, kMinSamples, kMaxSamples));
  }

  [[nodiscard]] double length_mm() const { return length_mm_; }

  /// Returns the bounds of the engagement at the fraction `share` of the stretch.
  [[nodiscard]] Engagement at(double share) const {
    const double z = std::lerp(stretch_.from.z_mm, stretch_.to.z_mm, share);
    const double skin = kFloorSkinMm + 2.0 * stretch_.up_slack_mm;
    const double min_nm = (z + skin - stock_.box().top) * kNmPerMm;
    int sure = 0;
    int possible = 0;
    for (int i = 0; i < samples_; ++i) {
      const double side = radius_mm_ * std::sin(std::numbers::pi * ((i + 0.5) / samples_ - 0.5));
      const Cell* cell = cell_ahead(share, side);
      if (cell == nullptr) continue;
      if (cell->lower_nm > min_nm) ++sure;
      if (cell->upper_nm > min_nm) ++possible;
    }
    return {180.0 * sure / samples_, 180.0 * possible / samples_};
  }

 private:
  /// Returns the first cell ahead of a point of the circumference that is `side` mm to the left of
  /// the path. Cells within `ring_mm_`, which may be partly cut, are skipped. The search goes
  /// parallel to the path, so that its distance from a wall along the path stays constant. Returns
  /// null outside of the stock.
  [[nodiscard]] const Cell* cell_ahead(double share, double side) const {
    const double ahead = share * length_mm_ + std::sqrt((ring_mm_ - side) * (ring_mm_ + side));
    const double x = stretch_.from.x_mm + ahead * along_x_ - side * along_y_;
    const double y = stretch_.from.y_mm + ahead * along_y_ + side * along_x_;
    return stock_.cell_at(x, y);
  }

  const Stock& stock_;
  double radius_mm_;
  const Stretch& stretch_;
  double length_mm_ = 0.0;
  double along_x_ = 1.0;
  double along_y_ = 0.0;
  double ring_mm_ = 0.0;
  int samples_ = 0;
};

}  // namespace

Engagement greatest_engagement(const Stock& stock, double radius_mm, const Stretch& stretch) {
  const double lowest = std::min(stretch.from.z_mm, stretch.to.z_mm);
  if (lowest >= stock.box().top) return {};
  const Front front{stock, radius_mm, stretch};
  Engagement greatest;
  if (front.length_mm() == 0.0) return greatest;
  const double step_mm = radius_mm / kPosesPerRadius;
  const int poses = 1 + static_cast<int>(front.length_mm() / step_mm);
  for (int i = 0; i < poses; ++i) {
    const Engagement found = front.at(i / static_cast<double>(poses));
    if (found.middle_deg() > greatest.middle_deg()) greatest = found;
  }
  return greatest;
}

}  // namespace sim::stock
