/// libFuzzer: random bytes as the memory of a controller, in a file, in flash, and as records.
///
/// The first byte, modulo 3, chooses: 0 a file of `--store`, 1 flash with sectors of 256 words that
/// contain the bytes, 2 records (number in two bytes, length, bytes).
///
/// Whatever the bytes are, they are read, or refused with a reason. Reading twice gives the same
/// result. Records that a store accepted exist after the next power-up, and all other records are
/// unchanged. A machine starts on any records, answers, and changes settings or refuses to.

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "firmware/store/flash_log.hpp"
#include "hal/host/file_store.hpp"
#include "hal/host/flash_model.hpp"
#include "hal/host/memory_store.hpp"
#include "host-sim/machine/virtual_controller.hpp"

namespace {

using Bytes = std::span<const std::uint8_t>;
using Records = hal::host::MemoryStore::Records;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

/// A sender that requests everything and accepts any answer.
class Talk final : public hal::ByteStream {
 public:
  [[nodiscard]] std::size_t read(std::span<std::byte> into) override {
    const std::size_t count = std::min(into.size(), text_.size() - at_);
    for (std::size_t i = 0; i < count; ++i) into[i] = static_cast<std::byte>(text_[at_ + i]);
    at_ += count;
    return count;
  }
  [[nodiscard]] std::size_t write(std::span<const std::byte> bytes) override {
    for (const std::byte byte : bytes) answers += static_cast<char>(byte);
    return bytes.size();
  }

  std::string answers;

 private:
  std::string text_ = "\x18$$\n$#\n$N\n$I+\n$K\n$PC\n$110=5000\n$X\nG10 L2 P1 X1\nG0 X1\n?\n";
  std::size_t at_ = 0;
};

/// Starts a machine on these records.
void start_machine(hal::RecordStore& store) {
  constexpr int kTurns = 400;
  Talk talk;
  sim::VirtualController controller{talk, {}, store};
  for (int turn = 0; turn < kTurns; ++turn) controller.turn();
  require(talk.answers.find("Grbl") != std::string::npos, "a machine that starts says so");
}

std::string folder() {
  static const std::string name = [] {
    std::string made = (std::filesystem::temp_directory_path() / "fuzz_store_XXXXXX").string();
    require(::mkdtemp(made.data()) != nullptr, "a folder for the file");
    return made;
  }();
  return name;
}

void try_file(Bytes bytes) {
  const std::string path = folder() + "/store";
  std::ofstream{path, std::ios::binary}.write(reinterpret_cast<const char*>(bytes.data()),
                                              static_cast<std::streamsize>(bytes.size()));
  Records before;
  try {
    hal::host::FileStore store{path};
    before = store.records();
    start_machine(store);
    require(store.save(7, std::as_bytes(std::span{"seven", 5})), "a file takes a record");
    before = store.records();
  } catch (const std::runtime_error& error) {
    require(std::string_view{error.what()}.starts_with(path), "a reason names the file");
    const bool same = std::filesystem::file_size(path) == bytes.size();
    require(same, "a file that is refused stays as it is");
    return;
  }
  const hal::host::FileStore again{path};
  require(again.records() == before, "what was saved is read again");
}

using Values = std::map<std::uint16_t, std::vector<std::byte>>;

Values all_of(cnc::FlashLog& log) {
  Values values;
  for (auto number = log.number_after(std::nullopt); number; number = log.number_after(number)) {
    std::array<std::byte, hal::RecordStore::kLongestRecord> record{};
    const std::size_t size = log.load(*number, record);
    require(size <= record.size(), "a record's length");
    values[*number].assign(record.begin(), record.begin() + static_cast<std::ptrdiff_t>(size));
  }
  return values;
}

void try_flash(Bytes bytes) {
  constexpr std::size_t kWords = 256;
  hal::host::FlashModel flash{2, kWords};
  for (std::size_t i = 0; i + 3 < bytes.size() && i / 4 < 2 * kWords; i += 4) {
    std::uint32_t word = 0;
    for (std::size_t byte = 0; byte < 4; ++byte) {
      word |= static_cast<std::uint32_t>(bytes[i + byte]) << (8 * byte);
    }
    flash.set_word(i / 4 / kWords, i / 4 % kWords, word);
  }
  Values kept;
  {
    cnc::FlashLog log{flash};
    kept = all_of(log);
    cnc::FlashLog same{flash};
    require(all_of(same) == kept, "the next power-up reads the same");
    require(same.damaged() == log.damaged(), "damage is noticed until a save");
  }
  {
    cnc::FlashLog log{flash};
    const bool saved = log.save(7, std::as_bytes(std::span{"seven", 5}));
    if (saved) kept[7].assign(5, {});
    cnc::FlashLog again{flash};
    Values found = all_of(again);
    if (saved) found[7].assign(5, {});
    require(found == kept, "a save changes its own record only");
    std::array<std::byte, hal::RecordStore::kLongestRecord> record{};
    require(!saved || again.load(7, record) == 5, "what was saved is there");
  }
  cnc::FlashLog log{flash};
  start_machine(log);
}

void try_records(Bytes bytes) {
  hal::host::MemoryStore store;
  while (bytes.size() >= 3) {
    const auto number = static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8U);
    const std::size_t size =
        std::min<std::size_t>(bytes[2] % (hal::RecordStore::kLongestRecord + 1), bytes.size() - 3);
    static_cast<void>(store.save(number, std::as_bytes(bytes.subspan(3, size))));
    bytes = bytes.subspan(3 + size);
  }
  start_machine(store);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Bytes bytes{data + 1, size - 1};
  switch (data[0] % 3) {
    case 0:
      try_file(bytes);
      break;
    case 1:
      try_flash(bytes);
      break;
    default:
      try_records(bytes);
  }
  return 0;
}
