#include "hal/host/memory_store.hpp"

#include <algorithm>

namespace hal::host {

std::size_t MemoryStore::load(std::uint16_t number, std::span<std::byte> into) {
  const auto found = records_.find(number);
  if (found == records_.end()) return 0;
  const std::size_t size = std::min(found->second.size(), into.size());
  std::copy_n(found->second.begin(), size, into.begin());
  return size;
}

bool MemoryStore::save(std::uint16_t number, std::span<const std::byte> record) {
  if (record.size() > kLongestRecord) return false;
  if (record.empty()) {
    records_.erase(number);
  } else {
    records_[number].assign(record.begin(), record.end());
  }
  return true;
}

}  // namespace hal::host
