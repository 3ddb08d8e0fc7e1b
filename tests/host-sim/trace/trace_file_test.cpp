#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <system_error>

#include "host-sim/trace/trace_reader.hpp"
#include "host-sim/trace/trace_writer.hpp"
#include "tests/host-sim/trace/random_rows.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr cnc::AxisArray<float> kTraceScale{80.0F, 80.1F, 400.0F, 10.0F, 8.888889F, 1.0F / 3.0F};

bool are_equal(const TraceRow& a, const TraceRow& b) {
  return a.time_ns == b.time_ns && a.position == b.position && a.duty == b.duty;
}

TEST(TraceWriter, WritesExactlyTheseBytes) {
  const ScratchFile file{".csv"};
  const std::vector<std::string> comments{"kerfline sim part.nc", "two\nlines"};
  TraceWriter writer{file.path(), kTraceScale, comments};
  writer.on_row({0, {}, 0.0F});
  writer.on_row({1'000, {1, -1, 0, 0, 0, 0}, 0.1F});
  writer.on_row({2'500, {2, -2, 300, 4, 5, -6}, 1.0F});
  writer.on_end(3'000);
  EXPECT_EQ(file.text(),
            "# kerfline sim part.nc\n"
            "# two lines\n"
            "# steps_per_mm X=80 Y=80.1 Z=400 A=10 B=8.888889 C=0.33333334\n"
            "time_ns,x,y,z,a,b,c,s\n"
            "0,0,0,0,0,0,0,0\n"
            "1000,1,-1,0,0,0,0,0.1\n"
            "2500,2,-2,300,4,5,-6,1\n");
}

TEST(TraceReader, GivesBackWhatWasWritten) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  const ScratchFile file{".csv"};
  const std::vector<TraceRow> rows = random_rows(seed, 50'000);
  const std::vector<std::string> comments{"first", "", "third: ä"};
  TraceWriter writer{file.path(), kTraceScale, comments};
  for (const TraceRow& row : rows) writer.on_row(row);
  writer.on_end(rows.back().time_ns);

  TraceReader reader{file.path()};
  EXPECT_EQ(reader.comments(), comments);
  EXPECT_EQ(reader.steps_per_mm(), kTraceScale);
  TraceRow row;
  for (const TraceRow& expected : rows) {
    ASSERT_TRUE(reader.next(row));
    ASSERT_TRUE(are_equal(row, expected)) << "at " << expected.time_ns;
  }
  EXPECT_FALSE(reader.next(row));
}

TEST(TraceReader, GivesBackTheExtremes) {
  const ScratchFile file{".csv"};
  constexpr std::int32_t kMin = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t kGreatest = std::numeric_limits<std::int32_t>::max();
  const TraceRow extreme{std::numeric_limits<std::uint64_t>::max(),
                         {kMin, kGreatest, 0, kMin, kGreatest, 0},
                         std::numeric_limits<float>::denorm_min()};
  TraceWriter writer{file.path(), kTraceScale};
  writer.on_row(extreme);
  writer.on_end(extreme.time_ns);
  const std::vector<TraceRow> rows = read_trace_rows(file.path());
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_TRUE(are_equal(rows.front(), extreme));
}

TEST(TraceWriter, LeavesTheOldFileWhenTheRunBreaksOff) {
  const ScratchFile file{".csv"};
  file.write("old");
  { TraceWriter{file.path(), kTraceScale}.on_row({5, {1}, 0.0F}); }
  EXPECT_EQ(file.text(), "old");
}

TEST(TraceWriter, NamesTheFileThatItCannotCreate) {
  EXPECT_THAT([] { TraceWriter("/no/such/folder/t.csv", kTraceScale); },
              ThrowsMessage<std::system_error>(HasSubstr("cannot create /no/such/folder/t.csv")));
}

TEST(TraceWriter, NamesTheFileWhenTheDiskIsFull) {
  TraceWriter writer{"/dev/full", kTraceScale};
  EXPECT_THAT([&] { writer.on_end(0); },
              ThrowsMessage<std::system_error>(HasSubstr("cannot write /dev/full")));
}

struct BadTrace {
  const char* text;
  const char* complaint;
};

class BadTraceTest : public testing::TestWithParam<BadTrace> {};

TEST_P(BadTraceTest, IsRefusedWithItsLine) {
  const ScratchFile file{".csv"};
  file.write(GetParam().text);
  EXPECT_THAT([&] { static_cast<void>(read_trace_rows(file.path())); },
              ThrowsMessage<std::runtime_error>(HasSubstr(file.path() + GetParam().complaint)));
}

#define SCALE "# steps_per_mm X=1 Y=1 Z=1 A=1 B=1 C=1\n"
#define COLUMNS "time_ns,x,y,z,a,b,c,s\n"
INSTANTIATE_TEST_SUITE_P(
    TraceReader,
    BadTraceTest,
    testing::Values(BadTrace{"", ":1: expected the column names"},
                    BadTrace{COLUMNS, ":1: no line"},
                    BadTrace{"# steps_per_mm X=1 Y=1\n" COLUMNS, ":1: unreadable steps_per_mm"},
                    BadTrace{SCALE "time,x\n", ":2: expected the column names"},
                    BadTrace{SCALE COLUMNS "1,2,3\n", ":3: expected a time"},
                    BadTrace{SCALE COLUMNS "1,0,0,0,0,0,0,0,0\n", ":3: expected a time"},
                    BadTrace{SCALE COLUMNS "1,0,0,0,0,0,2147483648,0\n", ":3: expected a time"},
                    BadTrace{SCALE COLUMNS "7,0,0,0,0,0,0,0\n7,1,0,0,0,0,0,0\n",
                             ":4: time does not increase"}));

TEST(TraceReader, NamesTheFileThatItCannotOpen) {
  EXPECT_THAT([] { TraceReader("/no/such.csv"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("/no/such.csv: cannot open")));
}

}  // namespace
}  // namespace sim
