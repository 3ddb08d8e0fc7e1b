#include "host-sim/knowledge/flash_lines.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <stdexcept>

#include "hal/interface/record_store.hpp"
#include "planner/kerf/table_image.hpp"

namespace sim {
namespace {

namespace kerf = cnc::kerf;

const char* counted_by(kerf::TableError error) {
  switch (error) {
    case kerf::TableError::kTooManyRows:
      return "thicknesses";
    case kerf::TableError::kTooManyBands:
      return "powers";
    case kerf::TableError::kTooManyPoints:
      return "measured speeds";
    default:
      return nullptr;
  }
}

}  // namespace

std::vector<std::byte> flash_image(const MaterialRecord& record, const std::string& name) {
  OwnedKerfTable<float> table = table_of<float>(record);
  table.name = name;
  std::array<std::byte, kerf::table_image::kMaxBytes> image{};
  const auto size = kerf::write_image(table.view(), image);
  if (size.ok()) return {image.begin(), image.begin() + static_cast<std::ptrdiff_t>(size.value())};
  const kerf::TableFault& fault = size.error();
  const char* const counted = counted_by(fault.error);
  const std::string reason =
      counted == nullptr
          ? std::string{kerf::describe(fault.error)}
          : fmt::format("kerf table has {} {}, capacity {}", fault.count, counted, fault.capacity);
  throw std::invalid_argument(fmt::format("{}: {}", name, reason));
}

std::string flash_lines(std::span<const std::byte> image) {
  std::string out;
  for (std::size_t part = 0; !image.empty(); ++part) {
    const auto bytes = image.first(std::min(image.size(), hal::RecordStore::kLongestRecord));
    out += fmt::format("$KW={}:", part);
    for (const std::byte byte : bytes) {
      fmt::format_to(std::back_inserter(out), "{:02X}", std::to_integer<unsigned>(byte));
    }
    out += '\n';
    image = image.subspan(bytes.size());
  }
  return out + "$KS\n";
}

}  // namespace sim
