#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim::surface {

enum class PlyScalar : std::uint8_t {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kFloat,
  kDouble,
};

/// Returns the bytes of a scalar in a binary file.
[[nodiscard]] std::size_t size_of(PlyScalar scalar);

struct PlyProperty {
  std::string name;
  PlyScalar scalar = PlyScalar::kFloat;
  std::optional<PlyScalar> list_count;  ///< Type of a list's length; nothing for a single value.
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Returns the index of a property; the count of properties if there is none.
  [[nodiscard]] std::size_t index(std::string_view property) const;
};

enum class PlyFormat : std::uint8_t { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;
  std::size_t lines = 0;  ///< Lines of the header.
  std::string_view body;  ///< Bytes behind it.
};

/// Reads a header and compares what it promises with the bytes behind it. Throws
/// std::invalid_argument with the line.
[[nodiscard]] PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace sim::surface
