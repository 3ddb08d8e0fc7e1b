#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "host-sim/import/dxf_binary.hpp"
#include "host-sim/import/dxf_reader.hpp"
#include "host-sim/import/gunzip.hpp"
#include "host-sim/import/json_reader.hpp"
#include "host-sim/import/lbrn_reader.hpp"
#include "host-sim/import/pdf_reader.hpp"
#include "host-sim/import/piece.hpp"
#include "host-sim/import/svg_reader.hpp"
#include "planner/base/contract.hpp"

namespace sim::drawing {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr double kMillimetresPerPoint = 25.4 / 72.0;
constexpr double kMillimetresPerPixel = 25.4 / 96.0;

/// Reads an SVGZ, which is an SVG packed by gzip.
void read_packed(const std::string& bytes, Sketch& sketch) {
  const auto text = gunzip(bytes, kMaxBytes);
  if (!text) {
    sketch.refuse(
        0,
        0,
        fmt::format("its gzip data are damaged, or contain more than {} MiB", kMaxBytes >> 20),
        "export the drawing again as SVG");
  } else if (const std::size_t begin = text->find_first_not_of(" \t\r\n\xEF\xBB\xBF");
             begin == std::string::npos || (*text)[begin] != '<') {
    sketch.refuse(0, 0, "its gzip data contain no SVG", "unpack it first");
  } else {
    read_svg(*text, sketch);
  }
}

/// A format that is not supported, but is recognised by the start of its files, so that a message
/// can name it.
struct OtherFormat {
  std::string_view start;
  std::string_view name;
  std::string_view remedy;
};

constexpr std::string_view kByInkscape =
    "open it in Inkscape and save it as SVG (or: inkscape --export-type=svg FILE)";

constexpr auto kOtherFormats = std::to_array<OtherFormat>({
    {"%!PS", "PostScript (EPS, or a drawing of Illustrator)", kByInkscape},
    {"\xC5\xD0\xD3\xC6", "EPS with a preview", kByInkscape},
    {"AC10", "DWG", "save it as DXF"},
    {"RIFF", "a drawing of CorelDRAW, or a picture", kByInkscape},
    {"PK\x03\x04", "a compressed archive", "unpack it, or export the drawing as SVG or DXF"},
    {"\x89PNG", "a picture (PNG)", "trace it to paths, and save the paths as SVG"},
    {"\xFF\xD8\xFF", "a picture (JPEG)", "trace it to paths, and save the paths as SVG"},
    {"BM", "a picture (BMP)", "trace it to paths, and save the paths as SVG"},
    {"GIF8", "a picture (GIF)", "trace it to paths, and save the paths as SVG"},
    {"solid ", "a solid model (STL)", "save a sketch or a section of it as SVG or DXF"},
});

void refuse_other(std::string_view start, Sketch& sketch) {
  const auto* const found = std::ranges::find_if(
      kOtherFormats, [&](const OtherFormat& other) { return start.starts_with(other.start); });
  if (found != kOtherFormats.end()) {
    sketch.refuse(1, 0, fmt::format("it is {}", found->name), std::string{found->remedy});
  } else {
    sketch.refuse(1, 0, "it is neither SVG nor DXF nor JSON", "export the drawing as SVG or DXF");
  }
}

/// Returns the millimetres per unit of the drawing. If the options give a unit, it replaces the
/// unit of the format, `usual_mm`. The sketch is then scaled by the ratio of both units, including
/// sizes that the drawing gives in millimetres.
double read_scaled(const ImportOptions& options, double usual_mm, Sketch& sketch) {
  if (!options.unit_mm) return usual_mm;
  sketch.scale(*options.unit_mm / usual_mm);
  return *options.unit_mm;
}

/// Reads a drawing of any format. Returns the millimetres per unit of the drawing.
double read_any(const std::string& text, const ImportOptions& options, Sketch& sketch) {
  std::string_view start = text;
  if (start.starts_with(kByteOrderMark)) start.remove_prefix(kByteOrderMark.size());
  start.remove_prefix(std::min(start.size(), start.find_first_not_of(" \t\r\n")));
  if (text.size() > kMaxBytes) {
    sketch.refuse(0,
                  0,
                  fmt::format("it has more than {} MiB", kMaxBytes >> 20),
                  "simplify the drawing, or divide it into several files");
  } else if (start.empty()) {
    sketch.refuse(1, 0, "it is empty", "export the drawing again");
  } else if (is_lbrn(start)) {
    read_lbrn(text, sketch);
    return read_scaled(options, 1.0, sketch);
  } else if (is_pdf(start)) {
    read_pdf(text, sketch);
    return read_scaled(options, kMillimetresPerPoint, sketch);
  } else if (is_gzip(start)) {
    read_packed(text, sketch);
    return read_scaled(options, kMillimetresPerPixel, sketch);
  } else if (start.front() == '<') {
    read_svg(text, sketch);
    return read_scaled(options, kMillimetresPerPixel, sketch);
  } else if (start.front() == '[' || start.front() == '{') {
    read_json(text, sketch);
    return read_scaled(options, 1.0, sketch);
  } else if (is_binary_dxf(start) || (start.front() >= '0' && start.front() <= '9')) {
    return read_dxf(text, sketch, options.unit_mm);
  } else {
    refuse_other(start, sketch);
  }
  return 1.0;
}

}  // namespace

Drawing read_drawing(const std::string& file,
                     const std::string& text,
                     const ImportOptions& options) {
  CNC_ASSERT(options.gap_mm >= kMinGapMm && options.gap_mm <= kGreatestGapMm);
  CNC_ASSERT(options.effort > 0.0 && options.effort <= 1.0);
  CNC_ASSERT(!options.unit_mm ||
             (*options.unit_mm >= kMinUnitMm && *options.unit_mm <= kGreatestUnitMm));
  Sketch sketch{options.effort, options.text};
  sketch.set_read_beside(options.read_beside);
  const double mm_per_unit = read_any(text, options, sketch);
  return assemble(sketch, file, options, mm_per_unit);
}

}  // namespace sim::drawing
