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

/// Returns the number of bytes that a scalar takes in a binary file.
[[nodiscard]] std::size_t size_of(PlyScalar scalar);

struct PlyProperty {
  std::string name;
  PlyScalar scalar = PlyScalar::kFloat;
  /// Type of a list's length; empty if the property is a single value.
  std::optional<PlyScalar> list_count;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Returns the index of a property; the number of properties if the element does not have the
  /// property.
  [[nodiscard]] std::size_t index(std::string_view property) const;
};

enum class PlyFormat : std::uint8_t { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;
  std::size_t lines = 0;  ///< Number of lines of the header.
  std::string_view body;  ///< Bytes after the header.
};

/// Reads a header and checks that the file has enough bytes for the announced elements.
/// Throws std::invalid_argument with the line.
[[nodiscard]] PlyHeader read_ply_header(std::string_view bytes, const std::string& name);

}  // namespace sim::surface
