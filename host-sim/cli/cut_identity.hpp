#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host-sim/job/program_digest.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// Reads the input files of one job and keeps the digests of those that decide its program.
class InputFiles {
 public:
  /// @param program the file of the program, whose folder is where the names of digests begin;
  /// empty where it goes to standard output
  explicit InputFiles(std::string program) : program_{std::move(program)} {}

  /// Returns the text of a file. Throws as read_text() does.
  [[nodiscard]] static std::string read(const std::string& file);
  /// Keeps the digest of a file, once.
  void add(const char* kind, const std::string& file, const std::string& text);
  [[nodiscard]] std::string read_and_add(const char* kind, const std::string& file);

  void add(ProgramDigest digest) { digests_.push_back(std::move(digest)); }
  [[nodiscard]] const std::vector<ProgramDigest>& digests() const { return digests_; }

 private:
  std::string program_;
  std::vector<ProgramDigest> digests_;
};

/// Returns the digest of a record of kerfs: of its image, as a controller would store it.
[[nodiscard]] ProgramDigest digest_of(const MaterialRecord& record);

/// Returns the digest of a machine's settings. @param is_given whether the call names some
[[nodiscard]] ProgramDigest settings_digest(const cnc::Settings& settings, bool is_given);

}  // namespace sim
