#pragma once

#include <map>
#include <vector>

#include "hal/interface/record_store.hpp"

namespace hal::host {

/// Stores records in memory; they are lost when the process ends.
class MemoryStore : public RecordStore {
 public:
  [[nodiscard]] std::size_t load(std::uint16_t number, std::span<std::byte> into) override;
  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override;
  [[nodiscard]] StoreWear wear() const override { return {}; }

  using Records = std::map<std::uint16_t, std::vector<std::byte>>;
  [[nodiscard]] const Records& records() const { return records_; }

 protected:
  Records records_;
};

}  // namespace hal::host
