#include "host-sim/surface/png_chunks.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>

#include "host-sim/surface/byte_reader.hpp"
#include "host-sim/surface/refusal.hpp"

namespace sim::surface {
namespace {

constexpr std::string_view kExportPngAgain = "export the picture again";
constexpr std::size_t kHeaderBytes = 13;

/// One chunk: its type and its data.
struct PngChunk {
  std::string_view type;
  std::string_view data;
};

PngChunk next_chunk(ByteReader& reader, std::string_view bytes, const std::string& name) {
  constexpr std::size_t kFrame = 12;  // Length, type and check sum.
  const std::size_t from = reader.at();
  const std::size_t left = reader.left();
  const std::uint32_t length = left < kFrame ? 0 : reader.take<std::uint32_t>();
  if (left < kFrame || left - kFrame < length) {
    refuse(name, 0, fmt::format("is cut off in the chunk at byte {}", from), kExportPngAgain);
  }
  const std::string_view typed = bytes.substr(reader.at(), length + 4);
  reader.skip(typed.size());
  boost::crc_32_type sum;
  sum.process_bytes(typed.data(), typed.size());
  if (sum.checksum() != reader.take<std::uint32_t>()) {
    refuse(name,
           0,
           fmt::format("the chunk at byte {} differs from its check sum", from),
           kExportPngAgain);
  }
  return {typed.substr(0, 4), typed.substr(4)};
}

PngHeader header_of(const PngChunk& chunk, const std::string& name) {
  if (chunk.type != "IHDR" || chunk.data.size() != kHeaderBytes) {
    refuse(name, 0, "has no header of PNG", kExportPngAgain);
  }
  ByteReader reader{chunk.data, ByteOrder::kBigEndian};
  PngHeader header;
  header.columns = reader.take<std::uint32_t>();
  header.rows = reader.take<std::uint32_t>();
  header.depth = reader.take<std::uint8_t>();
  header.kind = reader.take<std::uint8_t>();
  reader.skip(2);  // There is one method of compression, and one of filters.
  header.is_interlaced = reader.take<std::uint8_t>() != 0;
  return header;
}

}  // namespace

PngChunks read_png_chunks(std::string_view bytes, const std::string& name) {
  ByteReader reader{bytes, ByteOrder::kBigEndian};
  reader.skip(kPngSignature.size());
  PngChunks chunks;
  chunks.header = header_of(next_chunk(reader, bytes, name), name);
  while (true) {
    const PngChunk chunk = next_chunk(reader, bytes, name);
    if (chunk.type == "IEND") return chunks;
    if (chunk.type == "IDAT") chunks.compressed += chunk.data;
  }
}

}  // namespace sim::surface
