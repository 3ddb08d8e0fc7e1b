#include "hal/host/file_store.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace hal::host {
namespace {

class FileStoreTest : public testing::Test {
 protected:
  FileStoreTest() { std::filesystem::remove(path); }
  ~FileStoreTest() override { std::filesystem::remove(path); }

  static std::vector<std::byte> bytes(std::string_view text) {
    std::vector<std::byte> all;
    for (const char c : text) all.push_back(static_cast<std::byte>(c));
    return all;
  }
  static std::string load(RecordStore& store, std::uint16_t number) {
    std::array<std::byte, RecordStore::kLongestRecord> record{};
    const std::size_t size = store.load(number, record);
    return {reinterpret_cast<const char*>(record.data()), size};
  }

  // The process number makes the name unique, because tests run in parallel.
  const std::string path = testing::TempDir() + "file_store_test." + std::to_string(::getpid());
};

TEST_F(FileStoreTest, KeepsRecordsFromOneRunToTheNext) {
  {
    FileStore store{path};
    EXPECT_EQ(load(store, 7), "");
    EXPECT_TRUE(store.save(7, bytes("seven")));
    EXPECT_TRUE(store.save(0xFFFF, bytes(std::string("\0\xFF\n", 3))));
    EXPECT_TRUE(store.save(8, bytes("eight")));
    EXPECT_TRUE(store.save(8, {}));
  }
  FileStore again{path};
  EXPECT_EQ(load(again, 7), "seven");
  EXPECT_EQ(load(again, 0xFFFF), std::string("\0\xFF\n", 3));
  EXPECT_EQ(load(again, 8), "");
  EXPECT_EQ(again.records().size(), 2U);
}

TEST_F(FileStoreTest, LeavesNothingElseBehind) {
  const std::string folder = path + ".folder";
  std::filesystem::create_directory(folder);
  {
    FileStore store{folder + "/store"};
    EXPECT_TRUE(store.save(1, bytes("x")));
    const auto files = std::filesystem::directory_iterator{folder};
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);
  }
  std::filesystem::remove_all(folder);
}

TEST_F(FileStoreTest, ChangesNothingWhereItCannotWrite) {
  const std::string folder = path + ".folder";
  std::filesystem::create_directory(folder);
  FileStore store{folder + "/store"};
  std::filesystem::remove_all(folder);
  EXPECT_FALSE(store.save(1, bytes("x")));
  EXPECT_EQ(load(store, 1), "");
}

TEST_F(FileStoreTest, ThrowsWhereNoFileCanBe) {
  for (const std::string& place :
       {path + ".missing/file", testing::TempDir(), std::string{"/dev/null"}}) {
    try {
      FileStore store{place};
      ADD_FAILURE() << place;
    } catch (const std::runtime_error& problem) {
      EXPECT_NE(std::string{problem.what()}.find(place), std::string::npos) << problem.what();
    }
  }
}

TEST_F(FileStoreTest, IsLockedAsLongAsItLives) {
  const std::string link = path + ".link";
  std::filesystem::create_symlink(path, link);
  {
    FileStore store{path};
    EXPECT_THROW(FileStore{path}, std::runtime_error);
    EXPECT_TRUE(store.save(1, bytes("x")));  // The store replaces the file by a new one.
    EXPECT_THROW(FileStore{link}, std::runtime_error);
  }
  EXPECT_EQ(FileStore{link}.records().size(), 1U);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  std::filesystem::remove(link);
}

/// A damaged file is never read as a store with fewer records.
TEST_F(FileStoreTest, RefusesWhatIsCutOffOrChanged) {
  {
    FileStore store{path};
    EXPECT_TRUE(store.save(1, bytes("one")));
    EXPECT_TRUE(store.save(300, bytes("three hundred")));
  }
  std::string whole;
  std::getline(std::ifstream{path}, whole, '\0');
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ (1 << (i % 8)));
    for (const std::string& bad : {whole.substr(0, i), changed}) {
      std::ofstream{path, std::ios::trunc} << bad;
      EXPECT_THROW(FileStore{path}, std::runtime_error) << i;
    }
  }
  std::ofstream{path, std::ios::trunc} << whole;
  EXPECT_EQ(FileStore{path}.records().size(), 2U);
}

TEST_F(FileStoreTest, ReadsTheFirstFormatAndSavesTheSecond) {
  std::ofstream{path} << "7:736576656e\n";
  {
    FileStore store{path};
    EXPECT_EQ(load(store, 7), "seven");
    EXPECT_TRUE(store.save(8, bytes("8")));
  }
  std::string first;
  std::getline(std::ifstream{path}, first);
  EXPECT_EQ(first, "kerfline store 2");
  EXPECT_EQ(FileStore{path}.records().size(), 2U);
}

TEST_F(FileStoreTest, RefusesARecordThatIsTooLong) {
  FileStore store{path};
  EXPECT_FALSE(store.save(1, bytes(std::string(RecordStore::kLongestRecord + 1, 'x'))));
  EXPECT_TRUE(store.save(1, bytes(std::string(RecordStore::kLongestRecord, 'x'))));
}

TEST_F(FileStoreTest, RefusesAFileThatIsNoStore) {
  for (const char* line : {"hello", "7:", "7:0", "7:0g", "65536:00", "-1:00", "7:00 "}) {
    std::ofstream{path} << "1:00\n" << line << '\n';
    try {
      FileStore store{path};
      ADD_FAILURE() << line;
    } catch (const std::runtime_error& problem) {
      EXPECT_NE(std::string{problem.what()}.find(":2: "), std::string::npos) << problem.what();
    }
  }
}

}  // namespace
}  // namespace hal::host
