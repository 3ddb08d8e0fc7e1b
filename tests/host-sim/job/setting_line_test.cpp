#include "host-sim/job/setting_line.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace sim {
namespace {

TEST(SettingLine, ReadsNumberAndValue) {
  const SettingChange change = parse_setting("$110=12000.5", "--set");
  EXPECT_EQ(change.number, 110);
  EXPECT_FLOAT_EQ(change.value, 12000.5F);
}

TEST(SettingLine, RefusesWhatIsNoSetting) {
  for (const char* text : {"",
                           "$",
                           "$=1",
                           "110=5",
                           "$110",
                           "$110=",
                           "$x=1",
                           "$1 0=1",
                           "$110=1e9999",
                           "$110=nan",
                           "$110=inf",
                           "$110=5x",
                           "$-1=2",
                           "$99999=1"}) {
    EXPECT_THROW(static_cast<void>(parse_setting(text, "here")), std::invalid_argument) << text;
  }
}

TEST(SettingLine, NamesThePlaceInAFile) {
  const std::string file = testing::TempDir() + "kerfline_settings_test";
  std::ofstream{file} << "; comment\n\n$32=1 ; laser\r\n$bad\n";
  try {
    static_cast<void>(read_settings_file(file));
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string{error.what()}.find(file + ":4"), std::string::npos) << error.what();
  }
  std::remove(file.c_str());
}

TEST(SettingLine, NamesAFileThatIsNotThere) {
  EXPECT_THROW(static_cast<void>(read_settings_file("/nonexistent/x")), std::system_error);
  EXPECT_THROW(static_cast<void>(read_settings_file(testing::TempDir())), std::system_error);
  const std::string file =
      testing::TempDir() + "kerfline_settings_test." + std::to_string(::getpid());
  for (const char* nothing : {"", "; only a comment\n", "\n\n"}) {
    std::ofstream{file} << nothing;
    EXPECT_THROW(static_cast<void>(read_settings_file(file)), std::invalid_argument) << nothing;
  }
  std::ofstream{file} << "\xEF\xBB\xBF$32=1\r\n";
  EXPECT_EQ(read_settings_file(file).size(), 1U);
  std::remove(file.c_str());
}

}  // namespace
}  // namespace sim
