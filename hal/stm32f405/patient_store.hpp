#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/interface/record_store.hpp"
#include "hal/stm32f405/watchdog.hpp"

namespace hal::stm32f405 {

/// A store that wraps another store and lengthens the watchdog's period during each save. A save
/// may move the log to its other sector. It then searches the complete log several times (a third
/// of a second) and erases a sector (up to 2 s). Main loop.
/// @tparam Store class of the wrapped store; it is final, so that the stack use of its calls is
///     known
template <typename Store, RegisterBus Bus = MemoryBus>
class PatientStore final : public RecordStore {
 public:
  constexpr explicit PatientStore(Store& store) : store_{store} {}

  [[nodiscard]] std::size_t load(std::uint16_t number, std::span<std::byte> into) override {
    return store_.load(number, into);
  }
  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override {
    Watchdog<Bus>::be_patient();
    const bool saved = store_.save(number, record);
    Watchdog<Bus>::be_strict();
    return saved;
  }
  [[nodiscard]] StoreWear wear() const override { return store_.wear(); }
  [[nodiscard]] bool damaged() const override { return store_.damaged(); }

 private:
  Store& store_;
};

}  // namespace hal::stm32f405
