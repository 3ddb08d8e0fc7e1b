#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/plan.hpp"
#include "host-sim/job/program_digest.hpp"

namespace sim::cut {

/// Figures of a job for its report.
struct CutFigures {
  std::size_t cuts = 0;   ///< Number of cuts, without pictures.
  std::size_t lines = 0;  ///< Number of straight strokes, including leads and tabs.
  std::size_t arcs = 0;   ///< Number of strokes that are arcs, including leads and tabs.
  double cut_length_mm = 0.0;
  double rapid_length_mm = 0.0;
  std::size_t corners = 0;        ///< Number of corners of the beam's path along parts.
  std::size_t corner_loops = 0;   ///< Number of corners at which the beam makes a loop.
  double corner_loop_mm = 0.0;    ///< Length that loops at corners add to the cuts.
  std::size_t corner_dwells = 0;  ///< Number of corners at which the beam makes a dwell.
  double corner_dwell_s = 0.0;    ///< Total time of the dwells at corners.
  std::size_t pictures = 0;       ///< Number of burnt pictures; each pass counts as one.
  double burnt_mm = 0.0;          ///< Burnt length of the rows of all pictures.
  double job_time_s = 0.0;        ///< Time of the job, as simulated or as predicted.
  /// Whether the job was simulated. The time of long jobs is only predicted.
  bool is_simulated = true;
};

[[nodiscard]] CutFigures figures_of(const CutPlan& plan);

/// A job together with the data from which it was made.
struct CutJob {
  const drawing::Drawing& drawn;
  const CutPlan& plan;
  const MaterialRecord& record;
  Beam beam;
  std::string laser{};  ///< Name of this machine's laser; empty if the user gave none.
  /// Notes about the kerf (see kerf_notes()), and about assumptions and the machine.
  std::vector<std::string> notes{};
  std::vector<ProgramDigest> digests{};  ///< Digests of the inputs from which the job was made.
  /// Whether the user gave the kerf. Otherwise the kerf is that of the material record.
  bool is_kerf_given = false;
  /// Line about the position of the drawing on the machine; empty if the drawing was not moved.
  std::string placing{};
  /// Lines about settings that the drawing contains, by layer.
  std::vector<std::string> offered{};
  std::vector<std::string> origins{};  ///< Lines about the persons and dates of the measurements.
};

/// Returns the lines for the heading of the program and for the report to the user: material,
/// conditions of each layer that is cut, notes, and figures.
[[nodiscard]] std::vector<std::string> lines_of(const CutJob& job, const CutFigures& figures);

/// Returns the heading of a program: the lines of lines_of(), then the digests.
[[nodiscard]] std::vector<std::string> heading_of(const CutJob& job, const CutFigures& figures);

/// Returns the content of lines_of() as JSON, with faults and warnings.
[[nodiscard]] nlohmann::ordered_json json_of(const CutJob& job, const CutFigures& figures);

}  // namespace sim::cut
