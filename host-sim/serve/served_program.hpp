#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/job/program_judge.hpp"
#include "host-sim/send/job_lines.hpp"

namespace sim {

/// A program that the page has opened, ready to be sent. It takes a small multiple of the size of
/// its file.
struct ServedProgram {
  std::string id;  ///< A checksum of name and content.
  std::string name;
  std::string text;  ///< Text that prepare_program() has returned.
  JobLines lines{true};
  std::vector<std::string> notes;  ///< Sentences about parts of the file that were left out.
  /// Faults with which no sender may begin: wrong checks, or a line that is too long.
  std::vector<std::string> barriers;
  bool block_delete = true;  ///< Lines with / are skipped.
  bool has_slashes = false;  ///< The program has lines with /.
};

/// Prepares a program, which takes time.
/// @param name name of the file
/// @param file content of the file
[[nodiscard]] std::shared_ptr<const ServedProgram> prepare_served(std::string name,
                                                                  std::string file,
                                                                  bool block_delete);

/// A judgement, and the key of the program and the standpoint for which it holds.
struct Judged {
  std::string key;
  Judgement judgement;
};

/// Returns a key for a program and for all of a standpoint on which a judgement depends.
[[nodiscard]] std::string judgement_key(const ServedProgram& program, const Standpoint& standpoint);

/// Hands programs from threads that have prepared them to the loop.
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
