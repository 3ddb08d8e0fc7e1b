#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/job/judged_path.hpp"
#include "host-sim/job/standpoint.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// The faults of a program, in the order of its lines.
struct Judgement {
  /// Axes beyond the travel, paths of G41 and G42 that cannot be driven, and the first
  /// ProgramJudge::kMaxRefused refused lines.
  std::vector<Fault> faults;
  std::size_t more = 0;  ///< Number of refused lines that `faults` does not list.

  [[nodiscard]] bool fine() const { return faults.empty(); }
  /// Returns the faults as text for the operator: `line 4: Y needs …`, the travel first, and at the
  /// end `and 35 more lines that are refused`.
  [[nodiscard]] std::vector<std::string> texts() const;
};

/// Judges a program before it is run, for the page of `kerfline serve` and for `kerfline send`. It
/// finds every line that the controller would refuse, and checks the whole path against the travel.
/// `kerfline check` queries a simulated controller about the lines, and uses the same JudgedPath.
///
/// A G41 without a width, which depends on the kerf tables of the controller, is left to the
/// controller.
class ProgramJudge {
 public:
  static constexpr std::size_t kMaxRefused = 100;

  explicit ProgramJudge(const Standpoint& standpoint);

  /// Takes the next line of the program; the first is 1.
  void take(std::size_t line, std::string_view text);
  /// Ends the program and returns its faults.
  /// @param program the whole text, for columns
  [[nodiscard]] Judgement end(const std::string& file, std::string_view program);

 private:
  void refuse(std::size_t line, const cnc::gcode::Fault& fault);

  cnc::gcode::Interpreter reader_;
  JudgedPath path_;
  Judgement judgement_{};
};

/// Judges a whole program. When `cancelled` becomes true, stops and returns the faults found so
/// far.
/// @param program as prepare_program() leaves it
[[nodiscard]] Judgement judge_program(const std::string& file,
                                      std::string_view program,
                                      const Standpoint& standpoint,
                                      const std::atomic<bool>* cancelled = nullptr);

}  // namespace sim
