#include "host-sim/import/dxf_kinds.hpp"

#include <algorithm>
#include <array>

#include "host-sim/import/dxf_letters.hpp"

namespace sim::drawing {
namespace {

constexpr auto kDxfLetters = std::to_array<std::string_view>({"RTEXT", "ARCALIGNEDTEXT"});

constexpr auto kDxfAnnotations = std::to_array<std::string_view>({
    "ACAD_TABLE",
    "ARC_DIMENSION",
    "CAMERA",
    "COORDINATION_MODEL",
    "DGNUNDERLAY",
    "DIMENSION",
    "DWFUNDERLAY",
    "GEOPOSITIONMARKER",
    "LARGE_RADIAL_DIMENSION",
    "LEADER",
    "LIGHT",
    "MLEADER",
    "MULTILEADER",
    "OLE2FRAME",
    "OLEFRAME",
    "PDFUNDERLAY",
    "POINT",
    "RAY",
    "SECTION",
    "SECTIONOBJECT",
    "SUN",
    "TOLERANCE",
    "VIEWPORT",
    "WIPEOUT",
    "XLINE",
});

template <std::size_t count>
bool is_among(std::string_view type, const std::array<std::string_view, count>& types) {
  return std::ranges::find(types, type) != types.end();
}

}  // namespace

DxfKind dxf_kind(std::string_view type) {
  if (is_dxf_text(type)) {
    return {DxfRole::kLetters,
            "are letters: they are left out",
            "--text outline or --text stroke draws them"};
  }
  if (is_among(type, kDxfLetters)) {
    return {DxfRole::kLetters,
            "are letters and no paths: they are left out",
            "to cut them, convert text to polylines in the drawing program (TXTEXP)"};
  }
  if (type == "HATCH" || type == "MPOLYGON") {
    return {DxfRole::kAnnotation,
            "is nothing to cut: a filling without lines",
            "to cut its edge, draw its boundary (HATCHGENERATEBOUNDARY)"};
  }
  if (type == "IMAGE") return {DxfRole::kAnnotation, "is nothing to cut: a picture"};
  if (is_among(type, kDxfAnnotations)) return {DxfRole::kAnnotation, "is nothing to cut"};
  return {DxfRole::kUnread,
          "is not read",
          "it is left out; make lines, arcs and polylines of it (EXPLODE, or FLATSHOT for solids)"};
}

}  // namespace sim::drawing
