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

/// A signed distance, mm, and the point where it occurs.
struct EdgePeak {
  double mm = 0.0;
  Place place{0.0, 0.0};
};

/// A checked point of a drawn edge, with the width that was cut off the part there. A list of these
/// points follows the drawn edges.
struct EdgePlace {
  Place place{0.0, 0.0};
  double mm = 0.0;
  bool reached = false;  ///< Whether the beam of the plan touches this point.
  /// Whether the edge connects the previous point of the list with this point.
  bool joins = false;
};

/// Accuracy of the parts, as distances between the edge that the beam leaves and the drawn edge. A
/// positive distance is cut off the part, a negative one is left on it.
struct EdgeFigures {
  /// Greatest width that is cut off the part, at the points that the plan's beam touches.
  EdgePeak max_off{};
  /// Greatest width that is left on the part, at the points that the plan's beam touches. Points of
  /// inner corners, slots and tabs do not count.
  EdgePeak max_left{};
  double mean_mm = 0.0;  ///< Mean of the absolute distances at the touched points.
  /// Number of checked points that the plan's beam touches; 0: nothing was cut.
  std::size_t places = 0;
  double untouched_mm = 0.0;  ///< Length of drawn edges that the plan's beam does not touch.
  /// Greatest distance between the actual edge and the edge that the path and the kerf of the plan
  /// would leave. Inner corners count, too.
  EdgePeak max_off_model{};
  /// As max_off_model, but only at points that the beam reaches under conditions that test cuts
  /// cover.
  EdgePeak max_off_known{};
  /// Length of drawn edges that the beam reaches under conditions that no test cut covers.
  double unknown_mm = 0.0;
  /// Least ratio of the actual heat input P / V to the planned one, in windows of 0.05 mm along all
  /// cuts.
  double min_heat_ratio = 1.0;
  /// Greatest ratio of the actual heat input to the planned one along all cuts.
  double greatest_heat_ratio = 1.0;
  /// Greatest ratio of the actual heat input to the planned one within a kerf of a corner; 0 if
  /// there are no corners.
  double greatest_corner_ratio = 0.0;
  std::vector<EdgePlace> profile{};  ///< Points along drawn edges at intervals of 0.1 mm.
};

/// Checks the edges of the parts. Sweeps the kerf along the actual path of the motors, with the
/// actual power and speed. Then compares the remaining edge with the curves of the drawing itself,
/// so the error of the arcs that replace these curves is included.
///
/// Where the heat input P / V is beyond all test cuts, the law of the record is extrapolated as a
/// straight line. A measured thickness has no law, so the planned kerf counts. A pierce is not
/// swept, because the width of the beam is not known while it pierces.
class EdgeCheck {
 public:
  /// Adds itself to a simulator that is set up for the program and has not run yet. All arguments
  /// must outlive this object.
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

/// Return the figures as lines of text for the user, and as JSON for programs.
[[nodiscard]] std::vector<std::string> lines_of(const EdgeFigures& figures);
[[nodiscard]] nlohmann::ordered_json json_of(const EdgeFigures& figures);

}  // namespace sim::cut
