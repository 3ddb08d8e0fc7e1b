#include "firmware/store/stored_state.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

namespace cnc {
namespace {

// Numbers of records. The record of a setting has the setting's number.
constexpr std::uint16_t kSystems = 0x4000;    ///< 0 to 8 is added, for G54 to G59.3.
constexpr std::uint16_t kG28 = 0x4100;        ///< 1 is added for G30.
constexpr std::uint16_t kToolRadii = 0x4200;  ///< 0 or 1 is added; each record has six tools.
constexpr std::uint16_t kStartupLine = 0x5000;
constexpr std::uint16_t kUserText = 0x5100;
constexpr std::uint16_t kPowerTable = 0x5200;
constexpr std::uint16_t kProgress = 0x5300;

constexpr std::size_t kPlaceBytes = kAxisCount * sizeof(std::uint64_t);
constexpr std::size_t kProgressBytes = (1 + kAxisCount) * sizeof(std::uint32_t);
constexpr std::size_t kPointBytes = sizeof(std::uint16_t) + sizeof(std::uint32_t);
using Record = std::array<std::byte, hal::RecordStore::kLongestRecord>;
static_assert(motion::PowerTable::kMaxPoints * kPointBytes <= hal::RecordStore::kLongestRecord);
static_assert(kPlaceBytes <= hal::RecordStore::kLongestRecord);

/// Writes a word in little-endian order on every computer, so that a store can be moved between
/// computers.
template <typename Word>
void put(std::span<std::byte> to, Word word) {
  for (std::size_t i = 0; i < sizeof(Word); ++i) to[i] = static_cast<std::byte>(word >> (8 * i));
}

template <typename Word>
Word get(std::span<const std::byte> from) {
  Word word = 0;
  for (std::size_t i = 0; i < sizeof(Word); ++i) {
    word |= static_cast<Word>(static_cast<Word>(from[i]) << (8 * i));
  }
  return word;
}

/// Returns the record number of the position with this index.
constexpr std::uint16_t place_record(std::size_t index) {
  constexpr std::size_t kHomes = gcode::kCoordinateSystemCount;
  constexpr std::size_t kTools = kHomes + 2;
  const std::size_t number = index < kHomes   ? kSystems + index
                             : index < kTools ? kG28 + index - kHomes
                                              : kToolRadii + index - kTools;
  return static_cast<std::uint16_t>(number);
}

}  // namespace

std::optional<float> StoredState::load_setting(const SettingInfo& info) {
  Record record{};
  const std::size_t size = store_.load(info.number, record);
  if (size == 0) return std::nullopt;
  const float value = std::bit_cast<float>(get<std::uint32_t>(record));
  if (size == sizeof(float) && value >= info.least && value <= info.most) return value;
  found_damage_ = true;
  return std::nullopt;
}

bool StoredState::save_setting(const SettingInfo& info, float value) {
  if (value == info.standard) return store_.save(info.number, {});
  std::array<std::byte, sizeof(float)> record{};
  put(record, std::bit_cast<std::uint32_t>(value));
  return store_.save(info.number, record);
}

Position StoredState::load_place(std::uint16_t number) {
  Record record{};
  const std::size_t size = store_.load(number, record);
  if (size == 0) return {};
  Position place{};
  bool sound = size == kPlaceBytes;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto bytes = std::span{record}.subspan(axis * sizeof(std::uint64_t));
    place[axis] = Coordinate{static_cast<std::int64_t>(get<std::uint64_t>(bytes))};
    sound = sound && place[axis].in_range();
  }
  if (sound) return place;
  found_damage_ = true;
  return {};
}

const gcode::StoredPlaces& StoredState::load_places() {
  for (std::size_t i = 0; i < gcode::StoredPlaces::kCount; ++i)
    gcode::place_at(saved_, i) = load_place(place_record(i));
  return saved_;
}

bool StoredState::save_place(std::uint16_t number, const Position& place, Position& saved) {
  if (place == saved) return true;
  std::array<std::byte, kPlaceBytes> record{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    put(std::span{record}.subspan(axis * sizeof(std::uint64_t)),
        static_cast<std::uint64_t>(place[axis].nanometres()));
  }
  const bool zero = place == Position{};
  const auto bytes = zero ? std::span<const std::byte>{} : std::span<const std::byte>{record};
  if (!store_.save(number, bytes)) return false;
  saved = place;
  return true;
}

bool StoredState::save_places(const gcode::StoredPlaces& places) {
  bool all = true;
  for (std::size_t i = 0; i < gcode::StoredPlaces::kCount; ++i) {
    all =
        save_place(place_record(i), gcode::place_at(places, i), gcode::place_at(saved_, i)) && all;
  }
  return all;
}

bool StoredState::forget_places() {
  bool all = true;
  for (std::size_t i = 0; i < gcode::StoredPlaces::kCount; ++i) {
    all = save_place(place_record(i), {}, gcode::place_at(saved_, i)) && all;
  }
  return all;
}

motion::PowerTable StoredState::load_power_table() {
  Record record{};
  const std::size_t size = store_.load(kPowerTable, record);
  std::array<motion::PowerPoint, motion::PowerTable::kMaxPoints> points{};
  const std::size_t count = std::min(size / kPointBytes, points.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto bytes = std::span{record}.subspan(i * kPointBytes);
    points[i] = {get<std::uint16_t>(bytes),
                 get<std::uint32_t>(bytes.subspan(sizeof(std::uint16_t)))};
  }
  const auto table = motion::PowerTable::make(std::span{points}.first(count));
  if (table.ok() && size == count * kPointBytes) return table.value();
  found_damage_ = true;
  return {};
}

bool StoredState::save_power_table(const motion::PowerTable& table) {
  Record record{};
  std::size_t size = 0;
  for (const motion::PowerPoint& point : table.points()) {
    const auto bytes = std::span{record}.subspan(size);
    put(bytes, point.duty);
    put(bytes.subspan(sizeof(std::uint16_t)), point.milliwatts);
    size += kPointBytes;
  }
  return store_.save(kPowerTable, std::span{record}.first(size));
}

const Progress& StoredState::load_progress() {
  Record record{};
  const std::size_t size = store_.load(kProgress, record);
  progress_ = {};
  if (size == 0) return progress_;
  found_damage_ = found_damage_ || size != kProgressBytes;
  if (size != kProgressBytes) return progress_;
  const auto word = [&record](std::size_t index) {
    return get<std::uint32_t>(std::span{record}.subspan(index * sizeof(std::uint32_t)));
  };
  progress_.line = std::bit_cast<motion::SourceLine>(word(0));
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    progress_.steps[axis] = static_cast<std::int32_t>(word(1 + axis));
  }
  return progress_;
}

bool StoredState::save_progress(const Progress& progress) {
  std::array<std::byte, kProgressBytes> record{};
  const auto put_word = [&record](std::size_t index, std::uint32_t word) {
    put(std::span{record}.subspan(index * sizeof(std::uint32_t)), word);
  };
  put_word(0, std::bit_cast<std::uint32_t>(progress.line));
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    put_word(1 + axis, static_cast<std::uint32_t>(progress.steps[axis]));
  }
  const auto bytes = std::span<const std::byte>{record};
  if (!store_.save(kProgress, progress.any() ? bytes : bytes.first(0))) return false;
  progress_ = progress;
  return true;
}

StoredText StoredState::load_text(std::uint16_t number) {
  Record record{};
  const std::size_t size = std::min(store_.load(number, record), record.size());
  StoredText text;
  for (std::size_t i = 0; i < size; ++i) static_cast<void>(text.add(static_cast<char>(record[i])));
  return text;
}

bool StoredState::save_text(std::uint16_t number, std::string_view text) {
  return store_.save(number, std::as_bytes(std::span{text.data(), text.size()}));
}

StoredText StoredState::load_startup_line(std::size_t index) {
  return load_text(static_cast<std::uint16_t>(kStartupLine + index));
}

bool StoredState::save_startup_line(std::size_t index, std::string_view line) {
  return save_text(static_cast<std::uint16_t>(kStartupLine + index), line);
}

StoredText StoredState::load_user_text() { return load_text(kUserText); }
bool StoredState::save_user_text(std::string_view text) { return save_text(kUserText, text); }

}  // namespace cnc
