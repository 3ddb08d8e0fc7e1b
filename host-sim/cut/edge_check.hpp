#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host-sim/cut/cut_report.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/machine/simulator.hpp"

namespace sim::cut {

/// A signed distance and its point, mm.
struct EdgePeak {
  double mm = 0.0;
  Place place{0.0, 0.0};
};

/// Width that was cut off the part at a point of a drawn edge. These points form a row along the
/// edges.
struct EdgePlace {
  Place place{0.0, 0.0};
  double mm = 0.0;
  bool reached = false;  ///< The beam of the plan reaches this point.
  bool joins = false;    ///< The edge leads here from the previous point of the row.
};

/// Accuracy of the parts: the edge that the beam leaves, measured from the drawn edge. A positive
/// distance is cut off the part, a negative one is left on it.
struct EdgeFigures {
  /// Greatest width cut off the part, over the points that the plan's beam just touches.
  EdgePeak max_off{};
  /// Greatest width left on the part, over the same points: all except inner corners, slots and
  /// tabs.
  EdgePeak max_left{};
  double mean_mm = 0.0;       ///< Mean of the absolute distances at these points.
  std::size_t places = 0;     ///< Number of checked points; 0: nothing was cut.
  double untouched_mm = 0.0;  ///< Length of drawn edges that the plan's beam does not touch.
  /// Greatest distance between the actual edge and the edge that the plan's path and kerf would
  /// leave. It includes inner corners.
  EdgePeak max_off_model{};
  /// Greatest such distance over the points that the beam reaches only under conditions that test
  /// cuts cover.
  EdgePeak max_off_known{};
  /// Length of drawn edges that the beam reaches under other conditions.
  double unknown_mm = 0.0;
  /// Least ratio of the actual P / V to the planned one, in windows of 0.05 mm along all cuts.
  double min_heat_ratio = 1.0;
  /// Greatest ratio of the actual P / V to the planned one along all cuts.
  double greatest_heat_ratio = 1.0;
  /// Greatest ratio within a kerf of corners; 0 if there are no corners.
  double greatest_corner_ratio = 0.0;
  std::vector<EdgePlace> profile{};  ///< Points at intervals of a tenth of a millimetre.
};

/// Sweeps the kerf along the actual path of the motors, with the actual power and speed. Then
/// compares the remaining edge with the curves of the drawing itself, so the error of the arcs that
/// replace these curves is included. Where P / V is beyond all test cuts, the law of the record is
/// continued in a straight line. A thickness that was measured instead has no law, so the planned
/// kerf counts. The width of a beam while it pierces is not known, so a pierce is not swept.
class EdgeCheck {
 public:
  /// Listens to a simulator that is set up for the program and has not run yet. All arguments must
  /// outlive this object.
  EdgeCheck(const CutJob& job, const std::string& program, Simulator& simulator);
  ~EdgeCheck();
  EdgeCheck(const EdgeCheck&) = delete;
  EdgeCheck& operator=(const EdgeCheck&) = delete;

  /// Returns the figures. Call it after the run.
  [[nodiscard]] EdgeFigures figures() const;

 private:
  class Sweep;
  std::unique_ptr<Sweep> sweep_;
};

/// Return the figures as lines for people, and as JSON for programs.
[[nodiscard]] std::vector<std::string> lines_of(const EdgeFigures& figures);
[[nodiscard]] nlohmann::ordered_json json_of(const EdgeFigures& figures);

}  // namespace sim::cut
