#include "tests/firmware/store/power_cut.hpp"

#include <gtest/gtest.h>

#include <array>

namespace cnc {
namespace {

using hal::host::CutKind;
using hal::host::FlashModel;
using hal::host::FlashOperation;
using hal::host::Unsteadiness;

constexpr int kNumbers = 9;
constexpr int kOtherPowerUps = 2;

Value load(FlashLog& log, std::uint16_t number) {
  std::array<std::byte, hal::RecordStore::kLongestRecord> bytes{};
  const std::size_t size = log.load(number, bytes);
  return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)};
}

class Trial {
 public:
  explicit Trial(const PowerCutTrial& trial) : trial_{trial}, random_{trial.seed} {}

  PowerCutCount run() {
    FlashModel flash{FlashModel::kSectors, trial_.words};
    FlashLog log{flash};
    flash.watch([this](const FlashModel& before, const FlashOperation& next) {
      if (before.operations() % trial_.every == 0) cut(before, next, trial_.cuts_of_recovery);
    });
    for (int i = 0; i < trial_.saves && !testing::Test::HasFailure(); ++i) {
      doubt_ = next_save();
      EXPECT_TRUE(log.save(doubt_->number, doubt_->value));
      keep(values_, *doubt_);
      doubt_.reset();
    }
    count_.operations = flash.operations();
    for (std::size_t i = 0; i < flash.sector_count(); ++i) count_.erases += flash.erases(i);
    EXPECT_EQ(all_of(log), values_);
    return count_;
  }

 private:
  static void keep(Values& values, const Doubt& doubt) {
    if (doubt.value.empty()) {
      values.erase(doubt.number);
    } else {
      values[doubt.number] = doubt.value;
    }
  }

  Doubt next_save() {
    Doubt save{.number = static_cast<std::uint16_t>(random_() % kNumbers), .value = {}};
    // Most saves are settings. Words of all ones and of zeros occur in flash in any case.
    const std::size_t sizes[] = {4, 4, 4, 4, 0, 1, 12, 20};
    save.value.resize(sizes[random_() % std::size(sizes)]);
    const auto filler = static_cast<unsigned>(random_() % 4);
    for (std::byte& byte : save.value) {
      byte = filler == 0   ? std::byte{0xFF}
             : filler == 1 ? std::byte{0}
                           : static_cast<std::byte>(random_());
    }
    return save;
  }

  /// Continues with a copy in which the power was cut at this operation.
  void cut(const FlashModel& before, const FlashOperation& next, int more_cuts) {
    if (testing::Test::HasFailure()) return;
    ++count_.cuts;
    FlashModel flash = before;
    flash.cut_at(next, trial_.kind, random_());
    const auto unsteadiness =
        random_() % 2 == 0 ? Unsteadiness::kEachRead : Unsteadiness::kEachPowerUp;
    flash.power_up(random_(), unsteadiness);
    if (more_cuts > 0) {
      flash.watch([this, more_cuts](const FlashModel& then, const FlashOperation& operation) {
        cut(then, operation, more_cuts - 1);
      });
    }
    FlashLog log{flash};
    flash.watch(nullptr);
    if (!testing::Test::HasFailure()) judge(log, flash, unsteadiness);
  }

  void judge(FlashLog& log, FlashModel& flash, Unsteadiness unsteadiness) {
    EXPECT_FALSE(log.damaged()) << "a cut is no damage; cut " << count_.cuts;
    Values found = all_of(log);
    Values with_doubt = values_;
    if (doubt_) keep(with_doubt, *doubt_);
    if (found != values_) ++count_.appeared;
    ASSERT_TRUE(found == values_ || found == with_doubt)
        << "KERFLINE_SEED=" << trial_.seed << ", cut " << count_.cuts;
    for (int i = 0; i < kOtherPowerUps; ++i) {
      flash.power_up(random_(), unsteadiness);
      FlashLog again{flash};
      ASSERT_FALSE(again.damaged()) << "KERFLINE_SEED=" << trial_.seed << ", cut " << count_.cuts;
      ASSERT_EQ(all_of(again), found) << "KERFLINE_SEED=" << trial_.seed << ", cut " << count_.cuts;
      const Doubt save = next_save();
      ASSERT_TRUE(again.save(save.number, save.value));
      keep(found, save);
    }
  }

  PowerCutTrial trial_;
  std::mt19937_64 random_;
  Values values_;
  std::optional<Doubt> doubt_;
  PowerCutCount count_;
};

}  // namespace

Values all_of(FlashLog& log) {
  Values values;
  for (auto number = log.number_after(std::nullopt); number; number = log.number_after(number)) {
    values[*number] = load(log, *number);
  }
  for (std::uint16_t number = 0; number < kNumbers; ++number) {
    EXPECT_TRUE(values.contains(number) || load(log, number).empty()) << number;
  }
  return values;
}

PowerCutCount run(const PowerCutTrial& trial) { return Trial{trial}.run(); }

}  // namespace cnc
