#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/job/program_judge.hpp"
#include "host-sim/send/job_lines.hpp"

namespace sim {

/// A program that the page has opened, ready to be sent. It uses memory of a small multiple of its
/// file's size.
struct ServedProgram {
  std::string id;  ///< A checksum of name and content.
  std::string name;
  std::string text;  ///< Text that prepare_program() has returned.
  JobLines lines{true};
  std::vector<std::string> notes;  ///< Sentences about parts of the file that were left out.
  /// Faults with which no job may begin: wrong checks of lines, or a line that is too long.
  std::vector<std::string> barriers;
  bool block_delete = true;  ///< Whether lines that begin with `/` are skipped.
  bool has_slashes = false;  ///< Whether the program has lines that begin with `/`.
};

/// Prepares a program, which takes time.
/// @param name name of the file
/// @param file content of the file
[[nodiscard]] std::shared_ptr<const ServedProgram> prepare_served(std::string name,
                                                                  std::string file,
                                                                  bool block_delete);

/// A judgement of a program, and the key of program and standpoint for which it is valid.
struct Judged {
  std::string key;
  Judgement judgement;
};

/// Returns the key of a program and of the members of a standpoint on which its judgement depends.
[[nodiscard]] std::string judgement_key(const ServedProgram& program, const Standpoint& standpoint);

/// Passes programs from the threads that prepare them to the loop.
class ProgramInbox {
 public:
  struct Arrival {
    std::shared_ptr<const ServedProgram> program;
    Judged judged;
  };

  void put(Arrival arrival) {
    const std::lock_guard lock{mutex_};
    arrival_ = std::move(arrival);
  }
  /// Returns the last program that arrived, once. The program is null if none has arrived.
  [[nodiscard]] Arrival take() {
    const std::lock_guard lock{mutex_};
    return std::exchange(arrival_, {});
  }

 private:
  std::mutex mutex_;
  Arrival arrival_{};
};

}  // namespace sim
