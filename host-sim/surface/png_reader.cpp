#include "host-sim/surface/png_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <span>
#include <utility>

#include "host-sim/surface/inflate.hpp"
#include "host-sim/surface/png_chunks.hpp"
#include "host-sim/surface/raster.hpp"
#include "host-sim/surface/refusal.hpp"

namespace sim::surface {
namespace {

constexpr std::uint8_t kGreyAlone = 0;
constexpr std::uint8_t kGreyAndOpacity = 4;

void require_grey(const PngHeader& header, const std::string& name) {
  if (header.kind != kGreyAlone && header.kind != kGreyAndOpacity) {
    refuse(name, 0, "a picture of colours", "export it as grey of 8 or 16 bit");
  }
  if ((header.depth != 8 && header.depth != 16) || header.is_interlaced) {
    refuse(name,
           0,
           fmt::format("has {} bit{}", header.depth, header.is_interlaced ? ", interlaced" : ""),
           "export it as grey of 8 or 16 bit, without interlacing");
  }
}

/// Returns the one of `left`, `above` and `corner` that is nearest to left + above - corner.
int paeth(int left, int above, int corner) {
  const int guess = left + above - corner;
  const int to_left = std::abs(guess - left);
  const int to_above = std::abs(guess - above);
  const int to_corner = std::abs(guess - corner);
  if (to_left <= to_above && to_left <= to_corner) return left;
  return to_above <= to_corner ? above : corner;
}

/// Undoes the filter of one row (PNG specification, 9.2); returns false for an unknown one. `above`
/// is empty for the first row; `step` is the count of a pixel's bytes.
bool unfilter(std::uint8_t filter,
              std::span<std::uint8_t> row,
              std::span<const std::uint8_t> above,
              std::size_t step) {
  if (filter > 4) return false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int a = i < step ? 0 : row[i - step];
    const int b = above.empty() ? 0 : above[i];
    const int c = i < step || above.empty() ? 0 : above[i - step];
    const std::array<int, 5> guesses{0, a, b, (a + b) / 2, paeth(a, b, c)};
    row[i] = static_cast<std::uint8_t>(row[i] + guesses[filter]);
  }
  return true;
}

}  // namespace

GridDraft read_png(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  const PngChunks chunks = read_png_chunks(bytes, name);
  const PngHeader& header = chunks.header;
  require_grey(header, name);
  require_raster_size(header.rows, header.columns, name);
  const std::size_t sample = header.depth / 8U;
  const std::size_t step = header.kind == kGreyAlone ? sample : 2 * sample;
  const std::size_t width = step * header.columns;
  auto pixels = inflated(chunks.compressed, header.rows * (width + 1));
  if (!pixels) refuse(name, 0, "its pixels are damaged", "export the picture again");
  Raster grey{.rows = header.rows, .columns = header.columns};
  grey.heights.reserve(grey.rows * grey.columns);
  std::span<const std::uint8_t> above;
  for (std::size_t r = 0; r < grey.rows; ++r) {
    const std::span<std::uint8_t> row = std::span{*pixels}.subspan(r * (width + 1) + 1, width);
    if (!unfilter((*pixels)[r * (width + 1)], row, above, step)) {
      refuse(name, 0, fmt::format("row {} is damaged", r + 1), "export the picture again");
    }
    for (std::size_t i = 0; i < width; i += step) {
      grey.heights.push_back(sample == 1 ? row[i] : row[i] * 256 + row[i + 1]);
    }
    above = row;
  }
  GridDraft draft = picture_draft(std::move(grey), sample == 1 ? 255.0 : 65'535.0, name, options);
  if (header.kind == kGreyAndOpacity) draft.notes.push_back(name + ": its opacity is passed over");
  return draft;
}

}  // namespace sim::surface
