#include "host-sim/trace/input_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include "tests/host-sim/trace/scratch_file.hpp"

namespace sim {
namespace {

using testing::HasSubstr;

std::string reason_of(const std::string& file) {
  try {
    return "read: " + read_text(file);
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(InputFile, ReadsTextsOfAnyEncoding) {
  ScratchFile file{".txt"};
  for (const std::string text : {"",
                                 "G0 X1\n",
                                 "gr\xC3\xB6\xC3\x9F"
                                 "e",
                                 "gr\xF6\xDF"
                                 "e",
                                 "\xEF\xBB\xBF;\r\n\x1A"}) {
    file.write(text);
    EXPECT_EQ(read_text(file.path()), text);
  }
}

TEST(InputFile, NamesWhatCannotBeRead) {
  EXPECT_THAT(reason_of(testing::TempDir()), HasSubstr(testing::TempDir()));
  EXPECT_THAT(reason_of("/no/such"), HasSubstr("/no/such"));
  EXPECT_THAT(reason_of("/proc/self/mem"), HasSubstr("/proc/self/mem"));
}

TEST(InputFile, RefusesWhatIsNoText) {
  ScratchFile file{".bin"};
  std::string all;
  for (int i = 0; i < 512; ++i) all += static_cast<char>(i % 256);
  std::string wide;
  for (const char letter : std::string{"G0 X1 Y2 Z3\n"}) wide += {letter, '\0'};
  for (const std::string& binary : {all, wide, std::string(100, '\0')}) {
    file.write(binary);
    EXPECT_THAT(reason_of(file.path()), HasSubstr(file.path() + ": is a binary file"));
  }
}

/// The reader of the text handles control bytes, and reports their line.
TEST(InputFile, LeavesStrayControlBytesToTheReader) {
  ScratchFile file{".nc"};
  const std::string text{"G0 X1\0\n\x13G1 X2 F100\n", 20};
  file.write(text);
  EXPECT_EQ(read_text(file.path()), text);
}

}  // namespace
}  // namespace sim
