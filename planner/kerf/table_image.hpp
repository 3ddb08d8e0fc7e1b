#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "planner/base/result.hpp"
#include "planner/kerf/stored_table.hpp"

/// A kerf table as bytes in flash and on the wire. All numbers have their lowest byte first:
///
/// | from | bytes | holds |
/// |---|---|---|
/// | 0 | 4 | "KFT" and the version, 1 |
/// | 4 | 2 | bytes of the image, all of them |
/// | 6 | 1 | unit of Q: 0 W/(mm/min), 1 J/mm |
/// | 7 | 3 × 1 | number of thicknesses, of powers and of measured points |
/// | 10 | 2 | 0 |
/// | 12 | 16 | name, filled up with 0 |
/// | 28 | 16 each | thickness in µm; λ1, λ2 (IEEE 754 singles); powers (8 bits); 1 if measured (24
/// bits) | | then | 16 each | power in mW; least and greatest speed in µm/min; measured points | |
/// then | 8 each | speed in µm/min; kerf in nm | | last | 4 | CRC-32 (planner/base/crc32) of all
/// bytes before |
namespace cnc::kerf {

namespace table_image {
inline constexpr std::uint32_t kMagic = 0x01'54'46'4B;
inline constexpr std::size_t kHeadBytes = 28;
inline constexpr std::size_t kNameBytes = 16;
inline constexpr std::size_t kRowBytes = 16;
inline constexpr std::size_t kBandBytes = 16;
inline constexpr std::size_t kPointBytes = 8;
inline constexpr std::size_t kSumBytes = 4;
/// Bytes of the largest table that a controller takes.
inline constexpr std::size_t kMaxBytes = kHeadBytes + StoredTable::kMaxRows * kRowBytes +
                                         StoredTable::kMaxBands * kBandBytes +
                                         StoredTable::kMaxPoints * kPointBytes + kSumBytes;
static_assert(kLongestName < kNameBytes);
}  // namespace table_image

/// Writes the image of a table. @return number of bytes written, or the fault: the table is
/// unsound, or larger than a controller takes
[[nodiscard]] Result<std::size_t, TableFault> write_image(
    const TableView<float>& table, std::span<std::byte, table_image::kMaxBytes> image);

/// Source of the bytes of an image, wherever they are stored.
class ImageSource {
 public:
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// Copies the bytes from index `at` on. Bytes that do not exist may have any value. @pre at +
  /// into.size() ≤ size()
  virtual void read(std::size_t at, std::span<std::byte> into) = 0;

 protected:
  ~ImageSource() = default;
};

/// Reads an image, front to back and twice. The bytes may be anything at all. @return the fault of
/// the image or of the table in it; empty when `table` holds the table. A fault leaves `table`
/// undefined.
[[nodiscard]] std::optional<TableFault> read_image(ImageSource& source, StoredTable& table);
[[nodiscard]] std::optional<TableFault> read_image(std::span<const std::byte> image,
                                                   StoredTable& table);

/// Returns the name in the head of an image. @pre `image` has at least kHeadBytes
[[nodiscard]] std::string_view name_in_image(std::span<const std::byte> image);

}  // namespace cnc::kerf
