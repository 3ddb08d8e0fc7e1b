#pragma once

#include "planner/geometry/arc_elements.hpp"
#include "tests/support/exact_block.hpp"
#include "tests/support/random_program.hpp"

namespace proof {

/// Writes successive path elements on a decimal grid, and sums up the time and the number of steps
/// that they will take.
class PathWriter {
 public:
  PathWriter(const TestMachine& machine, double grid_mm)
      : machine_{&machine}, grid_nm_{grid_mm * 1.0e6} {}

  // Setters for the elements that follow.
  void set_feed(double mm_s) { feed_ = mm_s; }  ///< Feed, mm/s; 0 is a rapid.
  void set_beam(const cnc::motion::BeamCommand& beam) { beam_ = beam; }
  void stop() { stop_ = true; }

  void line(const Vector& travel) { element(travel, cnc::Plane::kXY, 0.0); }
  /// Appends an arc. The plane axes of `travel` are its chord.
  void arc(const Vector& travel, cnc::Plane plane, double bulge) { element(travel, plane, bulge); }
  /// Appends an arc as by G2 or G3, about a centre at the distance `to_centre` from here. `travel`
  /// applies to the axes off the plane; its plane axes are ignored.
  void circle(const Vector& travel,
              cnc::Plane plane,
              const std::array<double, 2>& to_centre,
              double sweep);
  /// Appends a uniform spline from here through the area of these control points, as arcs. The
  /// points are relative to here, mm.
  void spline(const std::vector<std::array<double, 2>>& points,
              std::size_t order,
              float tolerance_mm);
  void back_to(const cnc::Position& place);

  [[nodiscard]] const cnc::Position& place() const { return place_; }
  [[nodiscard]] double seconds() const { return seconds_; }
  [[nodiscard]] double steps() const { return steps_; }
  /// Returns the greatest speed that the limits of these axes allow together, mm/s.
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
