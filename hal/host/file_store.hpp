#pragma once

#include <string>

#include "hal/host/memory_store.hpp"

namespace hal::host {

/// Records in one text file, a line each: number, colon, bytes in hexadecimal. The first line names
/// the format, the last one has the number of records and the CRC-32 of all lines before it:
///
///     kerfline store 2
///     7:736576656e
///     end 1 0a3b4c5d
///
/// Every save writes a new file beside it and renames that over it, so the file is whole at any
/// moment: as it was before the save, or as it is after. While the object lives the file is locked
/// against any other. Files of the first format, records alone, are read as well.
class FileStore final : public MemoryStore {
 public:
  /// Reads the file, or creates it. Throws std::runtime_error naming the file, and the line where
  /// one is wrong: for a file that is empty, damaged, cut off, no store, locked by another process,
  /// or cannot be opened or written. Damage is never taken for the absence of records.
  explicit FileStore(std::string path);
  ~FileStore();
  FileStore(const FileStore&) = delete;
  FileStore& operator=(const FileStore&) = delete;

  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override;

 private:
  /// True where a file was there, false where it was created.
  [[nodiscard]] bool open_and_lock();
  /// False where another process has created the file meanwhile.
  [[nodiscard]] bool create();
  void read();
  [[nodiscard]] bool write();
  void release();

  std::string path_;
  int lock_ = -1;  ///< The open file that is locked: the one that the name leads to.
};

}  // namespace hal::host
