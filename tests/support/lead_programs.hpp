#pragma once

#include <vector>

#include "tests/support/random_source.hpp"

namespace proof {

/// The end of a line or arc in a plane, of at most half a turn. Helices also use z.
struct LeadStep {
  double x = 0.0;
  double y = 0.0;
  double bulge = 0.0;  ///< Bulge of the element that ends here.
  double z = 0.0;
};

enum class Lead {
  kLinePerpendicular,  ///< A perpendicular line, which is the entry or exit motion itself.
  kLineSlanted,        ///< The same with a line at an angle of up to 60°.
  kLineTangent,        ///< A line along the tangent; a perpendicular entry comes before it.
  kQuarterArc,         ///< A tangent quarter arc; a line comes before it.
  kHalfArc,
  kLineAndArc,  ///< A line, another line and a tangent quarter arc.
  /// An arc alone. To enter, the tangent arc is the entry motion; to leave, a line slanted forward.
  kArcAlone,
  kNone,  ///< No lead. The entry begins just beside the outline; to leave, G40 without a motion.
};
inline constexpr std::size_t kLeads = 8;

/// A closed outline with its leads, as a program with G41 or G42 drives it.
struct LeadProgram {
  double offset_mm = 0.0;  ///< Offset of the tool, mm; positive is to the right of the path.
  Lead in = Lead::kNone;
  Lead out = Lead::kNone;
  /// The outline is convex and all leads fit, so that the program must be accepted.
  bool roomy = false;
  LeadStep start{};
  /// Lead-in from the entry motion on; its last step ends on the outline.
  std::vector<LeadStep> lead_in;
  /// Outline from the end of the lead-in, where its last step ends, too.
  std::vector<LeadStep> outline;
  std::vector<LeadStep> overlap;   ///< Continues along the outline beyond its end.
  std::vector<LeadStep> lead_out;  ///< The motions before G40.
  std::vector<LeadStep> exit;      ///< The motion after G40, if any.
};

/// Returns a program that depends only on the state of `random`. Outlines are stars, triangles to
/// hexagons, rounded rectangles, slots and circles, flat or as helices, in either direction, with
/// the tool on either side. Coordinates have four decimals.
[[nodiscard]] LeadProgram random_lead_program(Random& random);

}  // namespace proof
