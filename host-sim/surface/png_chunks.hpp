#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sim::surface {

inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1A\n";

/// Header of a PNG picture.
struct PngHeader {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::uint8_t depth = 0;  ///< Bits of a sample.
  std::uint8_t kind = 0;   ///< 0 grey, 4 grey with opacity; others are colours.
  bool is_interlaced = false;
};

/// A PNG picture before its pixels are decompressed.
struct PngChunks {
  PngHeader header;
  std::string compressed;  ///< Bytes of all IDAT chunks.
};

/// Reads the chunks and compares their check sums. Throws std::invalid_argument.
/// @pre bytes start with kPngSignature
[[nodiscard]] PngChunks read_png_chunks(std::string_view bytes, const std::string& name);

}  // namespace sim::surface
