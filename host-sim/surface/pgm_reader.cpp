#include "host-sim/surface/pgm_reader.hpp"

#include <fmt/format.h>

#include <utility>

#include "host-sim/surface/byte_reader.hpp"
#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/raster.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::surface {
namespace {

constexpr std::uint64_t kGreatestWhite = 65'535;

/// Returns the next whole number of the text, after any comments.
std::uint64_t next_count(TextWords& words, const std::string& name) {
  std::string_view word = words.next();
  while (word.starts_with('#')) {
    words.skip_line();
    word = words.next();
  }
  if (const auto count = parsed_count(word)) return *count;
  refuse(name,
         words.line(),
         word.empty() ? "ends too early" : fmt::format("`{}` is not a whole number", shown(word)),
         "export the picture again");
}

void require_length(std::size_t bytes, std::uint64_t needed, const std::string& name) {
  if (bytes >= needed) return;
  refuse(name,
         0,
         fmt::format("needs {} more bytes for its pixels", needed - bytes),
         "the file is cut off; export it again");
}

[[noreturn]] void refuse_pixel(const Raster& grey, std::uint64_t value, const std::string& name) {
  refuse(name,
         0,
         fmt::format("{} in row {}, column {} is above the white of the header",
                     value,
                     grey.heights.size() / grey.columns + 1,
                     grey.heights.size() % grey.columns + 1),
         "export the picture again");
}

}  // namespace

GridDraft read_pgm(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  const bool is_text = bytes.starts_with("P2");
  TextWords words{bytes.substr(2), 1};
  Raster grey;
  const std::uint64_t columns = next_count(words, name);
  const std::uint64_t rows = next_count(words, name);
  const std::uint64_t white = next_count(words, name);
  require_raster_size(rows, columns, name);
  if (white == 0 || white > kGreatestWhite) {
    refuse(name, 0, fmt::format("its value of white is {}", white), "export it with 8 or 16 bit");
  }
  grey.rows = rows;
  grey.columns = columns;
  const std::size_t pixel_bytes = white > 255 ? 2 : 1;
  // One blank ends the header. In a text file, a blank separates two pixels.
  require_length(
      words.rest().size(), rows * columns * (is_text ? 2 : pixel_bytes) + 1 - is_text, name);
  ByteReader pixels{words.rest().substr(is_text ? 0 : 1), ByteOrder::kBigEndian};
  grey.heights.reserve(rows * columns);
  while (grey.heights.size() < rows * columns) {
    std::uint64_t value = 0;
    if (is_text) {
      value = next_count(words, name);
    } else {
      value = pixel_bytes == 2 ? pixels.take<std::uint16_t>() : pixels.take<std::uint8_t>();
    }
    if (value > white) refuse_pixel(grey, value, name);
    grey.heights.push_back(static_cast<double>(value));
  }
  return picture_draft(std::move(grey), static_cast<double>(white), name, options);
}

}  // namespace sim::surface
