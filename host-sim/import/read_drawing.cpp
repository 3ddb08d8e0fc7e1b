#include <fmt/format.h>

#include <string_view>

#include "host-sim/import/dxf_reader.hpp"
#include "host-sim/import/gunzip.hpp"
#include "host-sim/import/json_reader.hpp"
#include "host-sim/import/piece.hpp"
#include "host-sim/import/svg_reader.hpp"
#include "planner/base/contract.hpp"

namespace sim::drawing {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBinaryDxf = "AutoCAD Binary DXF";

/// Reads an SVGZ: an SVG in gzip.
void read_packed(const std::string& bytes, Sketch& sketch) {
  const auto text = gunzip(bytes, kMostBytes);
  if (!text) {
    sketch.refuse(0,
                  0,
                  fmt::format("its gzip is damaged, or holds more than {} MiB", kMostBytes >> 20),
                  "export the drawing again as SVG");
  } else if (const std::size_t begin = text->find_first_not_of(" \t\r\n\xEF\xBB\xBF");
             begin == std::string::npos || (*text)[begin] != '<') {
    sketch.refuse(0, 0, "its gzip holds no SVG", "unpack it first");
  } else {
    read_svg(*text, sketch);
  }
}

void read_any(const std::string& text, Sketch& sketch) {
  std::string_view start = text;
  if (start.starts_with(kByteOrderMark)) start.remove_prefix(kByteOrderMark.size());
  start.remove_prefix(std::min(start.size(), start.find_first_not_of(" \t\r\n")));
  if (text.size() > kMostBytes) {
    sketch.refuse(0,
                  0,
                  fmt::format("it has more than {} MiB", kMostBytes >> 20),
                  "simplify the drawing, or cut it in parts");
  } else if (start.empty()) {
    sketch.refuse(1, 0, "it is empty", "export the drawing again");
  } else if (start.starts_with(kBinaryDxf)) {
    sketch.refuse(1, 0, "it is a binary DXF", "save it as DXF in ASCII");
  } else if (is_gzip(start)) {
    read_packed(text, sketch);
  } else if (start.front() == '<') {
    read_svg(text, sketch);
  } else if (start.front() == '[' || start.front() == '{') {
    read_json(text, sketch);
  } else if ((start.front() >= '0' && start.front() <= '9')) {
    read_dxf(text, sketch);
  } else {
    sketch.refuse(1, 0, "it is neither SVG nor DXF nor JSON", "export the drawing as SVG or DXF");
  }
}

}  // namespace

Drawing read_drawing(const std::string& file,
                     const std::string& text,
                     const ImportOptions& options) {
  CNC_ASSERT(options.gap_mm >= kLeastGapMm && options.gap_mm <= kGreatestGapMm);
  CNC_ASSERT(options.effort > 0.0 && options.effort <= 1.0);
  Sketch sketch{options.effort, options.text};
  read_any(text, sketch);
  return assemble(sketch, file, options.gap_mm);
}

}  // namespace sim::drawing
