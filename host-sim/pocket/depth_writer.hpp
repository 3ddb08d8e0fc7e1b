#pragma once

#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

/// mm: places nearer to each other, or to a circle, are the same but for rounding.
inline constexpr double kSamePlaceMm = 1.0e-9;

/// Writes rows of a path whose passes are all at one depth.
class DepthWriter {
 public:
  DepthWriter(PathRows& out, double depth_mm) : out_{out}, z_{-depth_mm} {}

  /// Lifts the tool and begins a row at the top.
  void begin_row(const cnc::WideVec2& place);
  /// Lifts the tool and goes down where the stock is gone.
  void begin_row_in_cleared(const cnc::WideVec2& place);

  /// Goes on by a line or an arc. @param z of its end
  void go(cnc::pocket::Use use, const cnc::WideVec2& to, double bulge, double z);
  void pass(const cnc::WideVec2& to, double bulge = 0.0) {
    go(cnc::pocket::Use::kPass, to, bulge, z_);
  }
  void light_pass(const cnc::WideVec2& to, double bulge) {
    go(cnc::pocket::Use::kLight, to, bulge, z_);
  }
  /// Both add nothing where the tool is there already, but for rounding.
  void link(const cnc::WideVec2& to) { go_unless_there(cnc::pocket::Use::kLink, to); }
  void go_back(const cnc::WideVec2& to) { go_unless_there(cnc::pocket::Use::kReturn, to); }
  /// Around a circle to the left, from the tool's place.
  void circle(cnc::pocket::Use use, const cnc::WideVec2& centre);

  /// Puts the tool on the floor, which a descent in steps reaches but for rounding.
  void settle() { out_.points.back().z = z_; }
  void end_row() { out_.end_row(); }

  /// @pre a row is open
  [[nodiscard]] cnc::WideVec2 place() const { return out_.points.back().point(); }
  /// Unit vector of travel at the tool's place; null where a row has just begun or the last move
  /// was up or down.
  [[nodiscard]] cnc::WideVec2 heading() const;
  [[nodiscard]] double z() const { return out_.points.back().z; }
  [[nodiscard]] double floor_z() const { return z_; }

 private:
  void go_unless_there(cnc::pocket::Use use, const cnc::WideVec2& to);

  PathRows& out_;
  double z_;
};

}  // namespace sim::pocket
