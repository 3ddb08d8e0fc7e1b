#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace sim {

/// A file with a name unique to the running test, removed afterwards.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& ending) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string{test->test_suite_name()} + "." + test->name();
    // Names of tests with parameters contain `/`.
    std::replace(name.begin(), name.end(), '/', '.');
    path_ = testing::TempDir() + name + "." + std::to_string(::getpid()) + ending;
  }
  ~ScratchFile() { std::remove(path_.c_str()); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

  [[nodiscard]] std::string text() const {
    std::ifstream file{path_, std::ios::binary};
    return {std::istreambuf_iterator<char>{file}, {}};
  }

  void write(const std::string& text) const { std::ofstream{path_, std::ios::binary} << text; }

 private:
  std::string path_;
};

}  // namespace sim
