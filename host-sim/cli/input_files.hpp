#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host-sim/job/program_digest.hpp"

namespace sim {

/// Reads the input files of one job. Keeps the digests of the files on which the program depends.
class InputFiles {
 public:
  /// Creates an object without digests.
  /// @param program the file of the program, to whose folder the names in digests are relative;
  ///   empty if the program goes to standard output
  explicit InputFiles(std::string program) : program_{std::move(program)} {}

  /// Returns the text of a file. Throws as read_text() does.
  [[nodiscard]] static std::string read(const std::string& file, bool may_be_packed = false);
  /// Keeps the digest of a file, once.
  void add(const char* kind, const std::string& file, const std::string& text);
  [[nodiscard]] std::string read_and_add(const char* kind, const std::string& file);

  void add(ProgramDigest digest) { digests_.push_back(std::move(digest)); }
  [[nodiscard]] const std::vector<ProgramDigest>& digests() const { return digests_; }

 private:
  std::string program_;
  std::vector<ProgramDigest> digests_;
};

}  // namespace sim
