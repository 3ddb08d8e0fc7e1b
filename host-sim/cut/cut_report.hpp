#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host-sim/cut/cut_program.hpp"
#include "host-sim/cut/plan.hpp"
#include "host-sim/job/program_digest.hpp"

namespace sim::cut {

/// What a job of cuts amounts to.
struct CutFigures {
  std::size_t cuts = 0;   ///< Without pictures.
  std::size_t lines = 0;  ///< Strokes that are straight, with leads and tabs…
  std::size_t arcs = 0;   ///< …and that are not.
  double cut_length_mm = 0.0;
  double rapid_length_mm = 0.0;
  std::size_t corners = 0;        ///< Of the beam's way beside parts…
  std::size_t corner_loops = 0;   ///< …that are passed in a loop…
  double corner_loop_mm = 0.0;    ///< …by which the cuts are longer;
  std::size_t corner_dwells = 0;  ///< that the beam rests at…
  double corner_dwell_s = 0.0;    ///< …in all.
  std::size_t pictures = 0;       ///< Pictures that are burnt, each pass by itself…
  double burnt_mm = 0.0;          ///< …and the length of their pixels.
  double job_time_s = 0.0;        ///< As the simulated controller drives it…
  bool is_simulated = true;       ///< …or, of long jobs, as it is predicted.
};

[[nodiscard]] CutFigures figures_of(const CutPlan& plan);

/// A job with what it was made from.
struct CutJob {
  const drawing::Drawing& drawn;
  const CutPlan& plan;
  const MaterialRecord& record;
  Beam beam;
  std::string laser{};                   ///< Name of this machine's; empty: not named.
  std::vector<std::string> notes{};      ///< About the kerf, see kerf_notes(), and guesses.
  std::vector<ProgramDigest> digests{};  ///< Of what it was made from.
  bool is_kerf_given = false;            ///< By the user, not by the record.
  std::string placing{};                 ///< Where the drawing was put; empty: as drawn.
  std::vector<std::string> offered{};    ///< Settings that the drawing itself has, by layer.
  std::vector<std::string> origins{};    ///< Persons and days of the measurements.
};

/// Material, conditions of each layer that is cut, notes, and figures: the heading of the program,
/// and what people are told.
[[nodiscard]] std::vector<std::string> lines_of(const CutJob& job, const CutFigures& figures);

/// The heading of a program: these lines, and the digests.
[[nodiscard]] std::vector<std::string> heading_of(const CutJob& job, const CutFigures& figures);

/// The same for programs, with faults and warnings.
[[nodiscard]] nlohmann::ordered_json json_of(const CutJob& job, const CutFigures& figures);

}  // namespace sim::cut
