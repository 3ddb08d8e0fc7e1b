#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "planner/base/result.hpp"
#include "planner/kerf/stored_table.hpp"

/// A kerf table as bytes in flash and on the wire. All numbers have their lowest byte first:
///
/// | offset | bytes | content |
/// |---|---|---|
/// | 0 | 4 | "KFT" and the version, 1 |
/// | 4 | 2 | size of the complete image, bytes |
/// | 6 | 1 | unit of Q: 0 W/(mm/min), 1 J/mm |
/// | 7 | 3 × 1 | number of thicknesses, of powers and of measured points |
/// | 10 | 2 | 0 |
/// | 12 | 16 | name, filled up with 0 |
/// | 28 | 16 each | thickness, µm; λ1, λ2 (floats); number of powers (8 bits); 1 if measured |
/// | then | 16 each | power, mW; least and greatest speed, µm/min; number of measured points |
/// | then | 8 each | speed, µm/min; kerf, nm |
/// | last | 4 | CRC-32 (planner/base/crc32) of all bytes before it |
///
/// The number of powers has 8 bits, and the flag after it has 24 bits. All other numbers in the
/// items of 16 and 8 bytes have 32 bits.
namespace cnc::kerf {

namespace table_image {
inline constexpr std::uint32_t kMagic = 0x01'54'46'4B;
inline constexpr std::size_t kHeadBytes = 28;
inline constexpr std::size_t kNameBytes = 16;
inline constexpr std::size_t kRowBytes = 16;
inline constexpr std::size_t kBandBytes = 16;
inline constexpr std::size_t kPointBytes = 8;
inline constexpr std::size_t kSumBytes = 4;
/// Size of the largest image that a controller accepts, bytes.
inline constexpr std::size_t kMaxBytes = kHeadBytes + StoredTable::kMaxRows * kRowBytes +
                                         StoredTable::kMaxBands * kBandBytes +
                                         StoredTable::kMaxPoints * kPointBytes + kSumBytes;
static_assert(kLongestName < kNameBytes);
}  // namespace table_image

/// Writes the image of a table. @return number of bytes written, or the fault: the table is
/// unsound, or larger than a controller accepts
[[nodiscard]] Result<std::size_t, TableFault> write_image(
    const TableView<float>& table, std::span<std::byte, table_image::kMaxBytes> image);

/// Source of the bytes of an image. Implementations read the bytes from their storage.
class ImageSource {
 public:
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// Copies the bytes from index `at` on. Bytes outside the image may have any value. @pre at +
  /// into.size() ≤ size()
  virtual void read(std::size_t at, std::span<std::byte> into) = 0;

 protected:
  ~ImageSource() = default;
};

/// Reads an image twice, each time from front to back. The bytes may have any values. @return the
/// fault of the image or of the table in it; nothing if `table` holds the table. After a fault the
/// content of `table` is undefined.
[[nodiscard]] std::optional<TableFault> read_image(ImageSource& source, StoredTable& table);
[[nodiscard]] std::optional<TableFault> read_image(std::span<const std::byte> image,
                                                   StoredTable& table);

/// Returns the name in the head of an image. @pre `image` has at least kHeadBytes
[[nodiscard]] std::string_view name_in_image(std::span<const std::byte> image);

}  // namespace cnc::kerf
