#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/job/program_judge.hpp"
#include "host-sim/send/job_lines.hpp"

namespace sim {

/// A program that the page has opened, ready to be sent. It takes a small multiple of its file's
/// size.
struct ServedProgram {
  std::string id;  ///< A check sum of name and content.
  std::string name;
  std::string text;  ///< As prepare_program() leaves it.
  JobLines lines{true};
  std::vector<std::string> notes;  ///< What was left out of the file, in words.
  /// Faults with which no sender may begin: wrong checks, a line that is too long.
  std::vector<std::string> barriers;
  bool block_delete = true;  ///< Lines with / are skipped,
  bool has_slashes = false;  ///< and there are some.
};

/// Takes time. @param name of the file @param file its bytes
[[nodiscard]] std::shared_ptr<const ServedProgram> prepare_served(std::string name,
                                                                  std::string file,
                                                                  bool block_delete);

/// A judgement, and the program and the standpoint that it holds for.
struct Judged {
  std::string key;
  Judgement judgement;
};

/// A name for a program and all of a standpoint that a judgement depends on.
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
  /// The last one, once; without a program where there is none.
  [[nodiscard]] Arrival take() {
    const std::lock_guard lock{mutex_};
    return std::exchange(arrival_, {});
  }

 private:
  std::mutex mutex_;
  Arrival arrival_{};
};

}  // namespace sim
