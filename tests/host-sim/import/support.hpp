#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::drawing {

inline Drawing read(const std::string& text, double gap_mm = 0.01) {
  return read_drawing("test", text, {.gap_mm = gap_mm});
}

/// A page of 100 mm by 100 mm in mm, with the origin at the upper left.
inline std::string svg_of(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" "
         "viewBox=\"0 0 100 100\">" +
         content + "</svg>";
}

inline std::string dxf_of(const std::string& entities, const std::string& blocks = {}) {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n" + blocks +
         "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

inline std::vector<FaultKind> kinds_of(const Drawing& drawn) {
  std::vector<FaultKind> kinds;
  for (const Fault& fault : drawn.faults) kinds.push_back(fault.kind);
  return kinds;
}

inline std::vector<std::string> shapes_of(const DrawnContour& contour) {
  std::vector<std::string> names;
  for (const Shape& shape : contour.shapes) names.emplace_back(name_of(shape));
  return names;
}

}  // namespace sim::drawing
