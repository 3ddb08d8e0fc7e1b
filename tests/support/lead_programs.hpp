#pragma once

#include <vector>

#include "tests/support/random_source.hpp"

namespace proof {

/// The end of a line or arc in a plane, of at most half a turn; z for helices.
struct LeadStep {
  double x = 0.0;
  double y = 0.0;
  double bulge = 0.0;  ///< Of the element that ends here.
  double z = 0.0;
};

enum class Lead {
  kLinePerpendicular,  ///< The entry or exit motion itself.
  kLineSlanted,        ///< The same at an angle of up to 60°.
  kLineTangent,        ///< A line along the tangent, behind a perpendicular entry.
  kQuarterArc,         ///< A tangent arc behind a line.
  kHalfArc,
  kLineAndArc,  ///< Entry, line, tangent arc.
  kArcAlone,    ///< A tangent arc is the entry motion; to leave, a line slanted forward.
  kNone,        ///< From just beside the outline; to leave, G40 without a motion.
};
inline constexpr std::size_t kLeads = 8;

/// A closed outline with its leads, as a program with G41 or G42 drives it.
struct LeadProgram {
  double offset_mm = 0.0;  ///< Positive is the right of the path.
  Lead in = Lead::kNone;
  Lead out = Lead::kNone;
  bool roomy = false;  ///< Convex, and everything fits: it must be driven.
  LeadStep start{};
  std::vector<LeadStep> lead_in;   ///< From the entry motion on; the last ends on the outline.
  std::vector<LeadStep> outline;   ///< From there; its last step ends there, too.
  std::vector<LeadStep> overlap;   ///< On along the outline.
  std::vector<LeadStep> lead_out;  ///< The motions before G40.
  std::vector<LeadStep> exit;      ///< The motion after G40, if any.
};

/// The same program for the same state of `random`. Outlines are stars, triangles to hexagons,
/// rounded rectangles, slots and circles, flat or as helices, either way round, with the tool on
/// either side; places have four decimals.
[[nodiscard]] LeadProgram random_lead_program(Random& random);

}  // namespace proof
