#pragma once

#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// Distance below which two points, or a point and a circle, count as equal, mm. Distances below
/// this value come only from rounding.
inline constexpr double kSamePlaceMm = 1.0e-9;

/// Writes rows of a path with all passes at one depth.
class DepthWriter {
 public:
  DepthWriter(PathRows& out, double depth_mm) : out_{out}, z_{-depth_mm} {}

  /// Lifts the tool and begins a row at the top of the stock.
  void begin_row(const cnc::WideVec2& place);
  /// Lifts the tool and descends to the floor at a point where the stock is gone.
  void begin_row_in_cleared(const cnc::WideVec2& place);

  /// Adds a line or an arc. @param z height of the end of the element, mm
  void go(cnc::pocket::Use use, const cnc::WideVec2& to, double bulge, double z);
  void pass(const cnc::WideVec2& to, double bulge = 0.0) {
    go(cnc::pocket::Use::kPass, to, bulge, z_);
  }
  void light_pass(const cnc::WideVec2& to, double bulge) {
    go(cnc::pocket::Use::kLight, to, bulge, z_);
  }
  /// link() and go_back() add nothing if the tool is already at `to` within rounding.
  void link(const cnc::WideVec2& to) { go_unless_there(cnc::pocket::Use::kLink, to); }
  void go_back(const cnc::WideVec2& to) { go_unless_there(cnc::pocket::Use::kReturn, to); }
  /// Adds a full circle that turns left and begins at the tool's position.
  void circle(cnc::pocket::Use use, const cnc::WideVec2& centre);

  /// Sets the height of the last point to exactly the height of the floor. A descent in steps
  /// reaches that height only within rounding.
  void settle() { out_.points.back().z = z_; }
  void end_row() { out_.end_row(); }

  /// Returns the tool's position. @pre a row is open
  [[nodiscard]] cnc::WideVec2 place() const { return out_.points.back().point(); }
  /// Returns the unit vector of travel at the tool's position. Returns the null vector if a row has
  /// just begun, or if the last move was vertical.
  [[nodiscard]] cnc::WideVec2 heading() const;
  [[nodiscard]] double z() const { return out_.points.back().z; }
  [[nodiscard]] double floor_z() const { return z_; }

 private:
  void go_unless_there(cnc::pocket::Use use, const cnc::WideVec2& to);

  PathRows& out_;
  double z_;
};

}  // namespace sim::pocket
