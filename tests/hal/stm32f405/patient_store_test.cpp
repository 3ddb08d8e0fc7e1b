#include "hal/stm32f405/patient_store.hpp"

#include <gtest/gtest.h>

#include <array>

#include "hal/host/memory_store.hpp"
#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

constexpr Address kReload = watchdog::kReload;

/// A store that records the watchdog's timeout during a save.
class LookingStore final : public host::MemoryStore {
 public:
  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override {
    reload_then = ModelBus::chip().cells[kReload];
    return host::MemoryStore::save(number, record);
  }
  Word reload_then = 0;
};

TEST(PatientStore, TheWatchdogWaitsWhileItSavesAndNotLonger) {
  ChipModel& chip = ModelBus::start_anew();
  Watchdog<ModelBus>::begin();
  const Word usual = chip.cells[kReload];
  LookingStore store;
  PatientStore<LookingStore, ModelBus> patient{store};
  const std::array<std::byte, 2> record{std::byte{1}, std::byte{2}};
  EXPECT_TRUE(patient.save(7, record));
  EXPECT_GT(store.reload_then, usual);
  EXPECT_EQ(usual, chip.cells[kReload]);
  std::array<std::byte, RecordStore::kLongestRecord> read{};
  EXPECT_EQ(2U, patient.load(7, read));
  EXPECT_EQ(record[1], read[1]);
}

}  // namespace
}  // namespace hal::stm32f405
