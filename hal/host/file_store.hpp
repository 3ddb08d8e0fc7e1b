#pragma once

#include <string>

#include "hal/host/memory_store.hpp"

namespace hal::host {

/// Records in one text file, one record a line: number, colon, bytes in hexadecimal. The first line
/// names the format. The last line has the number of records and the CRC-32 of all lines before it:
///
///     kerfline store 2
///     7:736576656e
///     end 1 0a3b4c5d
///
/// Every save writes a new file next to the old one and renames it over the old one. So the file is
/// whole at any moment: it has the content from before the save or from after it. While the object
/// lives, the file is locked against other processes. Files of the first format, which have records
/// alone, can be read as well.
class FileStore final : public MemoryStore {
 public:
  /// Reads the file, or creates it. Throws std::runtime_error, which names the file and, if a line
  /// is wrong, the line. It throws if the file is empty, damaged, cut off, not a store, locked by
  /// another process, or cannot be opened or written. Damage is never taken for the absence of
  /// records.
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
  int lock_ = -1;  ///< Locked open file: the one that `path_` leads to.
};

}  // namespace hal::host
