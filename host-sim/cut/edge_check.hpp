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

/// A signed distance and where it is, mm.
struct EdgePeak {
  double mm = 0.0;
  Place place{0.0, 0.0};
};

/// What of a place on a drawn edge was cut off the part, as a row along the edges.
struct EdgePlace {
  Place place{0.0, 0.0};
  double mm = 0.0;
  bool reached = false;  ///< By the plan's beam.
  bool joins = false;    ///< The edge comes here from the place before.
};

/// How well the parts fit: the edge that the beam leaves, seen from the drawn one. Positive is
/// cut off the part, negative is left on it.
struct EdgeFigures {
  EdgePeak most_off{};        ///< Of the places that the plan's beam just touches…
  EdgePeak most_left{};       ///< …that is, of all but inner corners, slots and tabs.
  double mean_mm = 0.0;       ///< Of the sizes there.
  std::size_t places = 0;     ///< Looked at; 0: nothing was cut.
  double untouched_mm = 0.0;  ///< Length of drawn edges that the plan's beam does not touch.
  /// Greatest distance from the edge that the plan's path and kerf would leave, inner
  /// corners included.
  EdgePeak most_off_model{};
  /// The same of the places that only the beam comes to under conditions that somebody has cut
  /// with…
  EdgePeak most_off_known{};
  double unknown_mm = 0.0;        ///< …and how much of the drawn edges it came to under others.
  double least_heat_ratio = 1.0;  ///< P / V over what was planned, in windows of 0.05 mm…
  double greatest_heat_ratio = 1.0;    ///< …of all that is cut…
  double greatest_corner_ratio = 0.0;  ///< …and within a kerf of corners; 0 where there are none.
  std::vector<EdgePlace> profile{};    ///< Every tenth of a millimetre.
};

/// Sweeps the kerf of the power and the speed really driven along where the motors really were,
/// and compares what is left with the drawing: with its curves themselves, so that the error of the
/// arcs that they were cut as is part of it. Where P / V is beyond what was ever cut, the law of
/// the record goes on straight; a thickness that was measured instead has no law, and the planned
/// kerf counts. How wide a beam is that pierces nobody knows: it is not swept.
class EdgeCheck {
 public:
  /// Listens to a simulator that is set up for the program and has not run yet. All must outlive
  /// this.
  EdgeCheck(const CutJob& job, const std::string& program, Simulator& simulator);
  ~EdgeCheck();
  EdgeCheck(const EdgeCheck&) = delete;
  EdgeCheck& operator=(const EdgeCheck&) = delete;

  /// After the run.
  [[nodiscard]] EdgeFigures figures() const;

 private:
  class Sweep;
  std::unique_ptr<Sweep> sweep_;
};

/// For people, and for programs.
[[nodiscard]] std::vector<std::string> lines_of(const EdgeFigures& figures);
[[nodiscard]] nlohmann::ordered_json json_of(const EdgeFigures& figures);

}  // namespace sim::cut
