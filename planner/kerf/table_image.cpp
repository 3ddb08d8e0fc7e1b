#include "planner/kerf/table_image.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "planner/base/crc32.hpp"
#include "planner/kerf/table_check.hpp"

namespace cnc::kerf {
namespace {

using table_image::kBandBytes;
using table_image::kHeadBytes;
using table_image::kMagic;
using table_image::kMaxBytes;
using table_image::kNameBytes;
using table_image::kPointBytes;
using table_image::kRowBytes;
using table_image::kSumBytes;

constexpr std::size_t kNameAt = 12;

std::uint32_t crc_of_image(std::span<const std::byte> bytes) {
  Crc32 crc;
  crc.add(bytes);
  return crc.value();
}

/// An image in memory.
class SpanSource final : public ImageSource {
 public:
  explicit SpanSource(std::span<const std::byte> bytes) : bytes_{bytes} {}

  [[nodiscard]] std::size_t size() const override { return bytes_.size(); }
  void read(std::size_t at, std::span<std::byte> into) override {
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at), into.size(), into.begin());
  }

 private:
  std::span<const std::byte> bytes_;
};

/// Reads consecutive numbers from an image. @pre the image has enough bytes
class ImageReader {
 public:
  explicit ImageReader(ImageSource& source, std::size_t at = 0) : source_{source}, at_{at} {}

  std::uint32_t number(std::size_t bytes) {
    std::array<std::byte, 4> raw{};
    source_.read(at_, std::span{raw}.first(bytes));
    at_ += bytes;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) {
      value |= std::to_integer<std::uint32_t>(raw[i]) << (8 * i);
    }
    return value;
  }
  std::uint32_t word() { return number(4); }
  std::uint16_t small() { return static_cast<std::uint16_t>(number(1)); }
  float real() { return std::bit_cast<float>(word()); }

 private:
  ImageSource& source_;
  std::size_t at_;
};

/// Writes consecutive numbers into an image.
class ImageWriter {
 public:
  explicit ImageWriter(std::span<std::byte> bytes) : bytes_{bytes} {}

  void number(std::uint32_t value, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i) {
      bytes_[size_++] = static_cast<std::byte>(value >> (8 * i));
    }
  }
  void word(std::uint32_t value) { number(value, 4); }
  void real(float value) { word(std::bit_cast<std::uint32_t>(value)); }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::span<std::byte> bytes_;
  std::size_t size_ = 0;
};

/// Numbers that follow the magic number in the head of an image.
struct Counts {
  std::size_t size = 0;
  std::uint32_t unit = 0;
  std::size_t rows = 0;
  std::size_t bands = 0;
  std::size_t points = 0;

  [[nodiscard]] std::size_t bytes() const {
    return kHeadBytes + rows * kRowBytes + bands * kBandBytes + points * kPointBytes + kSumBytes;
  }
};

TableFault too_many(TableError error, std::size_t count, std::size_t capacity) {
  return {.error = error,
          .count = static_cast<std::uint16_t>(count),
          .capacity = static_cast<std::uint16_t>(capacity)};
}

std::optional<TableFault> overflow_of(std::size_t rows, std::size_t bands, std::size_t points) {
  if (rows > StoredTable::kMaxRows) {
    return too_many(TableError::kTooManyRows, rows, StoredTable::kMaxRows);
  }
  if (bands > StoredTable::kMaxBands) {
    return too_many(TableError::kTooManyBands, bands, StoredTable::kMaxBands);
  }
  if (points > StoredTable::kMaxPoints) {
    return too_many(TableError::kTooManyPoints, points, StoredTable::kMaxPoints);
  }
  return std::nullopt;
}

std::uint32_t crc_of_source(ImageSource& source, std::size_t bytes) {
  Crc32 crc;
  std::array<std::byte, 16> some{};
  for (std::size_t at = 0; at < bytes; at += some.size()) {
    const auto next = std::span{some}.first(std::min(some.size(), bytes - at));
    source.read(at, next);
    crc.add(next);
  }
  return crc.value();
}

/// Reads and checks the head. The capacity is checked before the size, so that a sender of too
/// large a table gets the fault of the capacity.
std::optional<TableFault> read_head(ImageSource& source, Counts& counts) {
  if (source.size() < kHeadBytes + kSumBytes) return TableFault{TableError::kBadSize};
  ImageReader reader{source};
  const std::uint32_t magic = reader.word();
  constexpr std::uint32_t kWithoutVersion = 0x00FF'FFFF;
  if (((magic ^ kMagic) & kWithoutVersion) != 0) return TableFault{TableError::kNotATable};
  if (magic != kMagic) return TableFault{TableError::kOtherVersion};
  counts.size = reader.number(2);
  counts.unit = reader.small();
  counts.rows = reader.small();
  counts.bands = reader.small();
  counts.points = reader.small();
  if (const auto fault = overflow_of(counts.rows, counts.bands, counts.points)) return fault;
  if (counts.size != source.size() || counts.bytes() != source.size()) {
    return TableFault{TableError::kBadSize};
  }
  constexpr auto kLastUnit = static_cast<std::uint32_t>(HeatUnit::kJoulesPerMillimetre);
  if (counts.unit > kLastUnit) return TableFault{TableError::kNotATable};
  const std::size_t summed = source.size() - kSumBytes;
  const std::uint32_t sum = crc_of_source(source, summed);
  if (ImageReader{source, summed}.word() != sum) return TableFault{TableError::kBadSum};
  return std::nullopt;
}

void read_rows(ImageReader& reader, std::span<Row<float>> rows) {
  std::uint16_t bands = 0;
  for (Row<float>& row : rows) {
    row.thickness_um = reader.word();
    row.law.slope = reader.real();
    row.law.intercept = reader.real();
    row.first_band = bands;
    row.bands = reader.small();
    row.measured = reader.number(3) != 0;
    bands = static_cast<std::uint16_t>(bands + row.bands);
  }
}

void read_bands(ImageReader& reader, std::span<Band> bands) {
  std::uint16_t points = 0;
  for (Band& band : bands) {
    band.power_mw = reader.word();
    band.min_um_min = reader.word();
    band.max_um_min = reader.word();
    band.first_point = points;
    band.points = static_cast<std::uint16_t>(reader.word());
    points = static_cast<std::uint16_t>(points + band.points);
  }
}

void write_parts(ImageWriter& writer, const TableView<float>& table) {
  for (const Row<float>& row : table.rows) {
    writer.word(row.thickness_um);
    writer.real(row.law.slope);
    writer.real(row.law.intercept);
    writer.number(row.bands, 1);
    writer.number(row.measured ? 1U : 0U, 3);
  }
  for (const Band& band : table.bands) {
    writer.word(band.power_mw);
    writer.word(band.min_um_min);
    writer.word(band.max_um_min);
    writer.word(band.points);
  }
  for (const Point& point : table.points) {
    writer.word(point.speed_um_min);
    writer.word(point.kerf_nm);
  }
}

}  // namespace

Result<std::size_t, TableFault> write_image(const TableView<float>& table,
                                            std::span<std::byte, kMaxBytes> image) {
  const Counts counts{.size = 0,
                      .unit = static_cast<std::uint32_t>(table.unit),
                      .rows = table.rows.size(),
                      .bands = table.bands.size(),
                      .points = table.points.size()};
  if (const auto fault = overflow_of(counts.rows, counts.bands, counts.points)) return *fault;
  if (const auto fault = find_fault(table)) return *fault;
  ImageWriter writer{image};
  writer.word(kMagic);
  writer.number(static_cast<std::uint32_t>(counts.bytes()), 2);
  writer.number(counts.unit, 1);
  writer.number(static_cast<std::uint32_t>(counts.rows), 1);
  writer.number(static_cast<std::uint32_t>(counts.bands), 1);
  writer.number(static_cast<std::uint32_t>(counts.points), 1);
  writer.number(0, 2);
  for (std::size_t i = 0; i < kNameBytes; ++i) {
    writer.number(i < table.name.size() ? static_cast<unsigned char>(table.name[i]) : 0U, 1);
  }
  write_parts(writer, table);
  writer.word(crc_of_image(image.first(writer.size())));
  return writer.size();
}

std::string_view name_in_image(std::span<const std::byte> image) {
  const auto name = image.subspan(kNameAt, kNameBytes);
  const auto end = std::find(name.begin(), name.end(), std::byte{0});
  return {reinterpret_cast<const char*>(name.data()), static_cast<std::size_t>(end - name.begin())};
}

std::optional<TableFault> read_image(ImageSource& source, StoredTable& table) {
  Counts counts;
  if (const auto fault = read_head(source, counts)) return fault;
  table.unit = static_cast<HeatUnit>(counts.unit);
  std::array<std::byte, kHeadBytes> head{};
  source.read(0, head);
  table.set_name(name_in_image(head));
  ImageReader reader{source, kHeadBytes};
  read_rows(reader, table.make_rows(counts.rows));
  read_bands(reader, table.make_bands(counts.bands));
  for (Point& point : table.make_points(counts.points)) {
    point.speed_um_min = reader.word();
    point.kerf_nm = reader.word();
  }
  return find_fault(table.view());
}

std::optional<TableFault> read_image(std::span<const std::byte> image, StoredTable& table) {
  SpanSource source{image};
  return read_image(source, table);
}

}  // namespace cnc::kerf
