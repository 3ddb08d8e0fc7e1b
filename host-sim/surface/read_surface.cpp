#include "host-sim/surface/read_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "host-sim/surface/asc_reader.hpp"
#include "host-sim/surface/grid_finish.hpp"
#include "host-sim/surface/json_heights.hpp"
#include "host-sim/surface/mesh_draft.hpp"
#include "host-sim/surface/pgm_reader.hpp"
#include "host-sim/surface/ply_reader.hpp"
#include "host-sim/surface/png_reader.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/stl_reader.hpp"
#include "host-sim/surface/tiff_reader.hpp"
#include "host-sim/surface/xyz_reader.hpp"

namespace sim::surface {
namespace {

/// Number of bytes at the beginning of a file by which a text is recognized.
constexpr std::size_t kProbeBytes = 1'000;

void require_options(const std::string& name, const ReadOptions& options) {
  const auto is_length = [](double value) { return value >= 0.0 && value <= kFarthestMm; };
  if (is_length(options.unit_mm) && options.unit_mm > 0.0 && is_length(options.pitch_mm) &&
      is_length(options.height_mm)) {
    return;
  }
  refuse(name,
         0,
         "the unit, the pitch or the height in the options is not a valid length",
         fmt::format("give a length of up to {:g} mm", kFarthestMm));
}

/// Refuses known but unsupported formats, which are recognized by their first bytes.
void refuse_other_formats(std::string_view bytes, const std::string& name) {
  struct OtherFormat {
    std::string_view start;
    std::string_view reason;
    std::string_view remedy;
  };
  using namespace std::string_view_literals;
  constexpr std::string_view kGrey = "export it as grey PNG or PGM";
  constexpr std::string_view kMesh = "export it as STL or PLY";
  constexpr std::string_view kText = "save it as text in UTF-8";
  constexpr auto kOthers = std::to_array<OtherFormat>({
      {"PK\x03\x04"sv, "is a packed file, such as a spreadsheet or 3MF", "export it as CSV or STL"},
      {"\xFF\xD8\xFF"sv, "is a JPEG picture", kGrey},
      {"GIF8"sv, "is a GIF picture", kGrey},
      {"P1\n"sv, "is a PBM picture", kGrey},
      {"P3\n"sv, "is a PPM picture", kGrey},
      {"P4\n"sv, "is a PBM picture", kGrey},
      {"P6\n"sv, "is a PPM picture", kGrey},
      {"OFF\n"sv, "is an OFF mesh", kMesh},
      {"v "sv, "is an OBJ mesh", kMesh},
      {"ISO-10303"sv, "is a STEP file", kMesh},
      {"\xFF\xFE"sv, "is a text in UTF-16", kText},
      {"\xFE\xFF"sv, "is a text in UTF-16", kText},
  });
  for (const OtherFormat& other : kOthers) {
    if (bytes.starts_with(other.start)) refuse(name, 0, other.reason, other.remedy);
  }
}

bool has_word(std::string_view text, std::string_view word) {
  return text.size() > word.size() && text.starts_with(word) &&
         std::string_view{" \t\r\n"}.find(text[word.size()]) != std::string_view::npos;
}

/// Returns `text` in small letters of ASCII.
std::string in_small_letters(std::string_view text) {
  std::string small{text};
  for (char& c : small) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return small;
}

/// Returns the surface of a mesh file; nothing for other files.
std::optional<SurfaceInput> read_mesh(std::string_view bytes,
                                      std::string_view first_word,
                                      bool is_text,
                                      const std::string& name,
                                      const ReadOptions& options) {
  if (has_word(bytes, "ply")) return finished_mesh(read_ply(bytes, name), options);
  if (has_length_of_stl(bytes)) return finished_mesh(read_binary_stl(bytes, name), options);
  if (!first_word.starts_with("solid")) return {};
  return finished_mesh(is_text ? read_ascii_stl(bytes, name) : read_binary_stl(bytes, name),
                       options);
}

/// Returns the grid of a height map or of a file of points.
GridDraft read_grid(std::string_view bytes,
                    std::string_view first_word,
                    const std::string& name,
                    const ReadOptions& options) {
  if (has_word(bytes, "P2") || has_word(bytes, "P5")) return read_pgm(bytes, name, options);
  if (bytes.starts_with(kPngSignature)) return read_png(bytes, name, options);
  if (is_tiff(bytes)) return read_tiff(bytes, name, options);
  if (first_word.starts_with('{') || first_word.starts_with('[')) {
    return read_json_heights(bytes, name, options);
  }
  for (const std::string_view key : {"ncols", "nrows", "xll", "yll", "cellsize", "nodata_value"}) {
    if (first_word.starts_with(key)) return read_asc(bytes, name, options);
  }
  return read_xyz(bytes, name, options);
}

}  // namespace

SurfaceInput read_surface(std::string_view bytes,
                          const std::string& name,
                          const ReadOptions& options) {
  require_options(name, options);
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  const std::size_t first = bytes.find_first_not_of(" \t\r\n\f\v");
  if (first == std::string_view::npos) {
    refuse(name, 0, "is empty", "give points, a mesh or a height map");
  }
  const std::string_view probe = bytes.substr(0, kProbeBytes);
  const bool is_text = probe.find('\0') == std::string_view::npos;
  const std::string first_word = in_small_letters(probe.substr(std::min(first, probe.size())));
  if (auto mesh = read_mesh(bytes, first_word, is_text, name, options)) return *std::move(mesh);
  refuse_other_formats(bytes, name);
  const bool is_picture =
      bytes.starts_with(kPngSignature) || is_tiff(bytes) || has_word(bytes, "P5");
  if (!is_text && !is_picture) {
    // A binary STL file is recognized only by its length. If the length is wrong, read_binary_stl()
    // throws an exception with the reason.
    static_cast<void>(read_binary_stl(bytes, name));
  }
  return finished_grid(read_grid(bytes, first_word, name, options), options);
}

}  // namespace sim::surface
