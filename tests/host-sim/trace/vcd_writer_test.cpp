#include "host-sim/trace/vcd_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bitset>
#include <map>
#include <sstream>

#include "tests/host-sim/trace/random_rows.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

using testing::HasSubstr;

/// Values of all variables at one time, by name such as `X.position`.
using Values = std::map<std::string, double>;

/// A small reader of Value Change Dumps: scopes, wires, vectors and reals.
class VcdFile {
 public:
  explicit VcdFile(const std::string& text) {
    std::istringstream in{text};
    for (std::string line; std::getline(in, line);) read(line);
    if (has_time_) states_[now_ns_] = values_;
  }

  /// Returns the values from each written time on.
  [[nodiscard]] const std::map<std::uint64_t, Values>& states() const { return states_; }
  [[nodiscard]] bool is_in_order() const { return is_in_order_; }

 private:
  void read(const std::string& line) {
    std::istringstream words{line};
    std::string first, kind, bits, code, name;
    words >> first;
    if (first == "$scope" && (words >> kind >> name)) scope_ = name == "kerfline" ? "" : name + ".";
    if (first == "$upscope") scope_ = "";
    if (first == "$var" && (words >> kind >> bits >> code >> name)) names_[code] = scope_ + name;
    if (first.front() == '#') start_time(std::stoull(first.substr(1)));
    if (first.front() == '0' || first.front() == '1') set(first.substr(1), first.front() - '0');
    if (first.front() == 'r' && (words >> code)) set(code, std::stod(first.substr(1)));
    if (first.front() == 'b' && (words >> code)) set(code, signed_value(first.substr(1)));
  }

  static double signed_value(const std::string& bits) {
    return static_cast<std::int32_t>(std::bitset<32>{bits}.to_ulong());
  }

  void start_time(std::uint64_t time_ns) {
    if (has_time_) states_[now_ns_] = values_;
    is_in_order_ = is_in_order_ && (!has_time_ || time_ns > now_ns_);
    has_time_ = true;
    now_ns_ = time_ns;
  }

  void set(const std::string& code, double value) { values_[names_.at(code)] = value; }

  std::string scope_;
  std::map<std::string, std::string> names_;
  Values values_;
  bool has_time_ = false;
  bool is_in_order_ = true;
  std::uint64_t now_ns_ = 0;
  std::map<std::uint64_t, Values> states_;
};

std::string written(const std::vector<TraceRow>& rows, std::uint64_t end_ns, VcdOptions options) {
  const ScratchFile file{".vcd"};
  VcdWriter writer{file.path(), options};
  for (const TraceRow& row : rows) writer.on_row(row);
  writer.on_end(end_ns);
  return file.text();
}

TEST(VcdWriter, WritesEdgesInOrder) {
  const std::string text =
      written({{1'000, {1}, 0.0F}, {1'500, {1, -1}, 0.5F}}, 9'000, {.pulse_width_ns = 700});
  EXPECT_THAT(text, HasSubstr("$timescale 1 ns $end\n"));
  EXPECT_THAT(text, HasSubstr("$scope module X $end\n$var wire 1 ! step $end\n"));
  EXPECT_THAT(text,
              HasSubstr("$end\n"
                        "#1000\nb1 #\n1!\n"
                        "#1500\n1%\nb11111111111111111111111111111111 &\n1$\nr0.5 3\n"
                        "#1700\n0!\n"
                        "#2200\n0$\n"
                        "#9000\n"));
}

TEST(VcdWriter, StartsWhereItIsTold) {
  const VcdFile file{written({}, 10, {.start_position = {7, -8}})};
  EXPECT_EQ(file.states().at(0).at("X.position"), 7);
  EXPECT_EQ(file.states().at(0).at("Y.position"), -8);
  EXPECT_EQ(file.states().at(0).at("Z.dir"), 0);
}

TEST(VcdWriter, LowersAPulseBeforeTheNextOfItsAxis) {
  const VcdFile file{written({{1'000, {1}, 0.0F}, {1'400, {2}, 0.0F}}, 5'000, {})};
  EXPECT_EQ(file.states().at(1'200).at("X.step"), 0);
  EXPECT_EQ(file.states().at(1'400).at("X.step"), 1);
  EXPECT_EQ(file.states().at(3'400).at("X.step"), 0);
}

TEST(VcdWriter, SeparatesPulsesThatTouch) {
  const VcdFile file{
      written({{1'000, {1}, 0.0F}, {3'000, {2}, 0.0F}}, 9'000, {.pulse_width_ns = 2'000})};
  EXPECT_EQ(file.states().at(2'000).at("X.step"), 0);
  EXPECT_EQ(file.states().at(3'000).at("X.step"), 1);
}

// Property: for any rows, the file contains their positions and output at every time, and no time
// is written twice or out of order.
TEST(VcdWriter, TellsEveryRow) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  const std::vector<TraceRow> rows = random_rows(seed, 3'000);
  const VcdFile file{written(rows, rows.back().time_ns + 100, {})};
  EXPECT_TRUE(file.is_in_order());
  cnc::AxisArray<std::int32_t> before{};
  for (const TraceRow& row : rows) {
    const Values& values = std::prev(file.states().upper_bound(row.time_ns))->second;
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      const std::string name{cnc::kAxisLetters[axis], '.'};
      ASSERT_EQ(values.at(name + "position"), row.position[axis]) << "at " << row.time_ns;
      if (row.position[axis] == before[axis]) continue;
      ASSERT_EQ(values.at(name + "step"), 1) << "at " << row.time_ns;
      ASSERT_EQ(values.at(name + "dir"), row.position[axis] < before[axis] ? 1 : 0);
    }
    ASSERT_EQ(static_cast<float>(values.at("duty")), row.duty);
    before = row.position;
  }
}

// Property: counting rising edges by direction gives the positions, as the user of a logic analyser
// would count.
TEST(VcdWriter, HasOneRisingEdgeForEachStep) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  const std::vector<TraceRow> rows = random_rows(seed, 3'000);
  const VcdFile file{written(rows, rows.back().time_ns, {})};
  double was_high = 0.0;
  int counted = 0;
  for (const auto& [time_ns, values] : file.states()) {
    const bool rises = values.at("Y.step") == 1 && was_high == 0;
    if (rises) counted += values.at("Y.dir") == 1 ? -1 : 1;
    was_high = values.at("Y.step");
  }
  EXPECT_NEAR(counted, rows.back().position[1], 0);
}

}  // namespace
}  // namespace sim
