#pragma once

#include <string>

#include "hal/host/memory_store.hpp"

namespace hal::host {

/// Records in one text file, a line each: number, colon, bytes in hexadecimal.
///
/// Every save writes a new file beside it and renames that over it, so the file
/// is whole at any moment: as it was before the save, or as it is after.
class FileStore final : public MemoryStore {
 public:
  /// Reads the file, if there is one. Throws std::runtime_error, naming file and
  /// line, when it is not such a file.
  explicit FileStore(std::string path);

  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override;

 private:
  void read();
  [[nodiscard]] bool write() const;

  std::string path_;
};

}  // namespace hal::host
