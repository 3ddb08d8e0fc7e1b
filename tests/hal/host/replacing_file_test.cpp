#include "hal/host/replacing_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace hal::host {
namespace {

class ReplacingFileTest : public testing::Test {
 protected:
  ReplacingFileTest() { std::filesystem::create_directory(folder); }
  ~ReplacingFileTest() override { std::filesystem::remove_all(folder); }

  static std::string text_of(const std::string& file) {
    std::string text;
    std::getline(std::ifstream{file}, text, '\0');
    return text;
  }
  [[nodiscard]] std::ptrdiff_t files() const {
    const auto all = std::filesystem::directory_iterator{folder};
    return std::distance(begin(all), end(all));
  }

  const std::string folder = testing::TempDir() + "replacing_file." + std::to_string(::getpid());
  const std::string path = folder + "/file";
};

TEST_F(ReplacingFileTest, TakesItsPlaceWhenItIsWhole) {
  std::ofstream{path} << "old";
  {
    ReplacingFile file{path};
    file.write("new");
    EXPECT_EQ(text_of(path), "old");
    file.commit();
    EXPECT_EQ(text_of(path), "new");
  }
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplacingFileTest, LeavesNothingUnlessItIsWhole) {
  std::ofstream{path} << "old";
  {
    ReplacingFile file{path};
    file.write("new");
  }
  EXPECT_EQ(text_of(path), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplacingFileTest, FollowsLinksAlsoToNoFile) {
  std::filesystem::create_directory(folder + "/far");
  std::filesystem::create_symlink("far/file", path);
  for (int i = 0; i < 2; ++i) {
    ReplacingFile file{path};
    file.write("new");
    file.commit();
    EXPECT_TRUE(std::filesystem::is_symlink(path));
    EXPECT_EQ(text_of(folder + "/far/file"), "new");
  }
}

TEST_F(ReplacingFileTest, KeepsTheModeOfTheOldFile) {
  std::ofstream{path} << "old";
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  ReplacingFile file{path};
  file.commit();
  struct ::stat found {};
  ASSERT_EQ(::stat(path.c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0777U, 0640U);
}

TEST_F(ReplacingFileTest, NamesThePlaceThatTakesNoFile) {
  std::filesystem::create_symlink(path, path);
  for (const std::string& place : {folder, folder + "/no/such", path}) {
    try {
      ReplacingFile file{place};
      ADD_FAILURE() << place;
    } catch (const std::system_error& error) {
      EXPECT_NE(std::string{error.what()}.find(place), std::string::npos) << error.what();
    }
  }
}

TEST_F(ReplacingFileTest, IsRemovedWhenTheDiskIsFull) {
  std::ofstream{path} << "old";
  ::rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const ::rlimit least{.rlim_cur = 10, .rlim_max = before.rlim_max};
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &least), 0);
  {
    ReplacingFile file{path};
    EXPECT_THROW(file.write(std::string(100, 'x')), std::system_error);
  }
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_EQ(text_of(path), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(ReplacingFileTest, IsRemovedBySignals) {
  std::ofstream{path} << "old";
  const auto killed = [this](int signal) {
    ReplacingFile::remove_unfinished_on_signals();
    ReplacingFile file{path};
    file.write("new");
    static_cast<void>(::raise(signal));
  };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_EXIT(killed(signal), testing::KilledBySignal(signal), "");
    EXPECT_EQ(files(), 1) << signal;
  }
  EXPECT_EQ(text_of(path), "old");
}

TEST_F(ReplacingFileTest, WritesToDevicesDirectly) {
  ReplacingFile null{"/dev/null"};
  null.write("anything");
  null.commit();
  ReplacingFile full{"/dev/full"};
  EXPECT_THROW(full.write("anything"), std::system_error);
}

}  // namespace
}  // namespace hal::host
