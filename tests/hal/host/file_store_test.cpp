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

  // Tests run side by side.
  const std::string path = testing::TempDir() + "file_store_test." + std::to_string(::getpid());
};

TEST_F(FileStoreTest, KeepsRecordsFromOneRunToTheNext) {
  FileStore store{path};
  EXPECT_EQ(load(store, 7), "");
  EXPECT_TRUE(store.save(7, bytes("seven")));
  EXPECT_TRUE(store.save(0xFFFF, bytes(std::string("\0\xFF\n", 3))));
  EXPECT_TRUE(store.save(8, bytes("eight")));
  EXPECT_TRUE(store.save(8, {}));
  FileStore again{path};
  EXPECT_EQ(load(again, 7), "seven");
  EXPECT_EQ(load(again, 0xFFFF), std::string("\0\xFF\n", 3));
  EXPECT_EQ(load(again, 8), "");
  EXPECT_EQ(again.records().size(), 2U);
}

TEST_F(FileStoreTest, LeavesNothingElseBehind) {
  FileStore store{path};
  EXPECT_TRUE(store.save(1, bytes("x")));
  EXPECT_FALSE(std::filesystem::exists(path + ".new"));
}

TEST_F(FileStoreTest, ChangesNothingWhereItCannotWrite) {
  FileStore store{path + ".missing/file"};
  EXPECT_FALSE(store.save(1, bytes("x")));
  EXPECT_EQ(load(store, 1), "");
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
