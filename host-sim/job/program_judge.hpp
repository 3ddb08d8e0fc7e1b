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
  /// Faults about axes that exceed the travel, about paths of G41 and G42 that cannot be driven,
  /// and about the first ProgramJudge::kMaxRefused refused lines.
  std::vector<Fault> faults;
  std::size_t more = 0;  ///< Number of refused lines that `faults` does not list.

  [[nodiscard]] bool fine() const { return faults.empty(); }
  /// Returns the faults as texts for the operator, for example `line 4: Y needs …`. Faults about
  /// the travel come first. The last text may be `and 35 more lines that are refused`.
  [[nodiscard]] std::vector<std::string> texts() const;
};

/// Checks a program before it is run, for the page of `kerfline serve` and for `kerfline send`. It
/// finds every line that the controller would refuse, and checks the complete path against the
/// travel. `kerfline check` uses the same JudgedPath, but finds refused lines by sending them to a
/// simulated controller.
///
/// A G41 without a width is not checked, because it depends on the kerf tables of the controller.
class ProgramJudge {
 public:
  static constexpr std::size_t kMaxRefused = 100;

  explicit ProgramJudge(const Standpoint& standpoint);

  /// Checks the next line of the program. The number of the first line is 1.
  void take(std::size_t line, std::string_view text);
  /// Ends the program and returns its faults.
  /// @param program complete text of the program, from which the columns of faults are found
  [[nodiscard]] Judgement end(const std::string& file, std::string_view program);

 private:
  void refuse(std::size_t line, const cnc::gcode::Fault& fault);

  cnc::gcode::Interpreter reader_;
  JudgedPath path_;
  Judgement judgement_{};
};

/// Checks a complete program. When `cancelled` becomes true, stops and returns the faults that were
/// found until then.
/// @param program text that prepare_program() returned
[[nodiscard]] Judgement judge_program(const std::string& file,
                                      std::string_view program,
                                      const Standpoint& standpoint,
                                      const std::atomic<bool>* cancelled = nullptr);

}  // namespace sim
