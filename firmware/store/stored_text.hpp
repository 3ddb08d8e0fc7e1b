#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "hal/interface/record_store.hpp"

namespace cnc {

/// A line of text that fits into a record.
class StoredText {
 public:
  static constexpr std::size_t kLongest = hal::RecordStore::kLongestRecord;

  /// Appends a letter. Returns false if there is no free space; the text is then unchanged.
  [[nodiscard]] bool add(char letter) {
    if (size_ == kLongest) return false;
    bytes_[size_++] = letter;
    return true;
  }
  [[nodiscard]] std::string_view view() const { return {bytes_.data(), size_}; }
  [[nodiscard]] bool empty() const { return size_ == 0; }

 private:
  std::array<char, kLongest> bytes_{};
  std::size_t size_ = 0;
};

}  // namespace cnc
