#pragma once

#include "planner/geometry/arc_elements.hpp"
#include "tests/support/exact_block.hpp"
#include "tests/support/random_program.hpp"

namespace proof {

/// Writes one path element after the other on a decimal grid, and keeps account
/// of the time and the steps that they will take.
class PathWriter {
 public:
  PathWriter(const TestMachine& machine, double grid_mm)
      : machine_{&machine}, grid_nm_{grid_mm * 1.0e6} {}

  // Of the elements to come.
  void set_feed(double mm_s) { feed_ = mm_s; }  ///< 0 is a rapid.
  void set_beam(const cnc::motion::BeamCommand& beam) { beam_ = beam; }
  void stop() { stop_ = true; }

  void line(const Vector& travel) { element(travel, cnc::Plane::kXY, 0.0); }
  /// The plane axes of `travel` are the chord.
  void arc(const Vector& travel, cnc::Plane plane, double bulge) { element(travel, plane, bulge); }
  /// As G2 and G3 do, about a centre that is `to_centre` away; `travel` carries
  /// the axes off the plane, its plane axes are ignored.
  void circle(const Vector& travel,
              cnc::Plane plane,
              const std::array<double, 2>& to_centre,
              double sweep);
  /// Uniform, from here by way of these control points, mm from here, as arcs.
  void spline(const std::vector<std::array<double, 2>>& points,
              std::size_t order,
              float tolerance_mm);
  void back_to(const cnc::Position& place);

  [[nodiscard]] const cnc::Position& place() const { return place_; }
  [[nodiscard]] double seconds() const { return seconds_; }
  [[nodiscard]] double steps() const { return steps_; }
  /// mm/s that these axes allow together.
  [[nodiscard]] double speed_on(const std::vector<std::size_t>& axes) const;
  [[nodiscard]] std::vector<ProgramItem> take() { return std::move(items_); }

 private:
  [[nodiscard]] cnc::Coordinate on_grid(double mm) const;
  void element(const Vector& travel, cnc::Plane plane, double bulge);
  void add(const cnc::PathElement& element);
  void account(const cnc::PathElement& element);

  const TestMachine* machine_;
  double grid_nm_;
  cnc::Position place_{};
  std::vector<ProgramItem> items_{};
  cnc::motion::BeamCommand beam_{};
  double feed_ = 0.0;
  bool stop_ = false;
  double seconds_ = 0.0;
  double steps_ = 0.0;
};

}  // namespace proof
