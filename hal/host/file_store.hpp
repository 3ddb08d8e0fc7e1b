#pragma once

#include <string>

#include "hal/host/memory_store.hpp"

namespace hal::host {

/// Stores records in one text file, one record in each line: number, colon, bytes in hexadecimal.
/// The first line names the format. The last line contains the number of records and the CRC-32 of
/// all lines before it:
///
///     kerfline store 2
///     7:736576656e
///     end 1 0a3b4c5d
///
/// Every save writes a new file next to the old file and renames the new file over the old one. So
/// at any moment the file is complete: it has the content before the save or after it. While the
/// object exists, the file is locked against other processes. Files of the first format, which
/// contain only records, can be read, too.
class FileStore final : public MemoryStore {
 public:
  /// Reads the file, or creates it if it does not exist. Throws std::runtime_error if the file is
  /// empty, damaged, truncated, not a store, or locked by another process, or if it cannot be
  /// opened or written. The text of the exception names the file and, if a line is wrong, this
  /// line. Damage is never mistaken for missing records.
  explicit FileStore(std::string path);
  ~FileStore();
  FileStore(const FileStore&) = delete;
  FileStore& operator=(const FileStore&) = delete;

  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override;

 private:
  /// Opens and locks the file. Returns true if the file existed, false if it was created.
  [[nodiscard]] bool open_and_lock();
  /// Creates the file. Returns false if another process has created it meanwhile.
  [[nodiscard]] bool create();
  void read();
  [[nodiscard]] bool write();
  void release();

  std::string path_;
  /// Descriptor of the locked file to which `path_` leads; -1 if no file is locked.
  int lock_ = -1;
};

}  // namespace hal::host
