#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/job/program_judge.hpp"
#include "host-sim/send/job_lines.hpp"

namespace sim {

/// A program that the page has opened, ready to be sent. It occupies a small multiple of the size
/// of its file in memory.
struct ServedProgram {
  std::string id;  ///< A checksum of name and content.
  std::string name;
  std::string text;  ///< Text that prepare_program() has returned.
  JobLines lines{true};
  std::vector<std::string> notes;  ///< Sentences about parts of the file that were left out.
  /// Faults that prevent a job: wrong checks of lines, or a line that is too long.
  std::vector<std::string> barriers;
  bool block_delete = true;  ///< Whether lines that begin with `/` are skipped.
  bool has_slashes = false;  ///< Whether the program has lines that begin with `/`.
};

/// Prepares a program for sending. This takes long, so that it is done in another thread.
/// @param name name of the file
/// @param file content of the file
[[nodiscard]] std::shared_ptr<const ServedProgram> prepare_served(std::string name,
                                                                  std::string file,
                                                                  bool block_delete);

/// A judgement of a program, with the key of the program and the machine state (standpoint) for
/// which it is valid.
struct Judged {
  std::string key;
  Judgement judgement;
};

/// Returns a key of a program and a standpoint. It depends on those members of the standpoint on
/// which the judgement of the program depends.
[[nodiscard]] std::string judgement_key(const ServedProgram& program, const Standpoint& standpoint);

/// Passes programs from the threads that prepare them to the loop of the server.
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
