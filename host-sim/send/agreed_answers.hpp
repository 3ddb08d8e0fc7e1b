#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// Facts that a Kerfline reports without a check, over a line that damages bytes: settings (`$$`),
/// offsets (`$#`), modes (`$G`), the state and the position (`?`, 0x87), and how far a job came
/// (`$RESUME`). The questions are asked in rounds. A fact is settled when it has arrived three
/// times alike, and in no other form as often.
class AgreedAnswers {
 public:
  /// @param resume `$RESUME` is one of the questions
  explicit AgreedAnswers(bool resume);

  /// Counts a line of the controller. Lines that state none of the facts are ignored.
  void read(std::string_view line);
  /// Ends a round: all questions have been acknowledged.
  void end_round() { ++rounds_; }

  /// Returns the names of the facts that are not settled, as `$130` or `[G54:`. Empty: all are. A
  /// fact that never arrived in the first four rounds, or less than once in eight, is one that this
  /// controller does not have.
  [[nodiscard]] std::vector<std::string> open() const;
  /// Returns a line for each settled fact, settings first, as the controller would send it.
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  /// How often each form of a fact has arrived.
  using Forms = std::map<std::string, std::size_t, std::less<>>;

  [[nodiscard]] bool is_missing(const Forms& forms) const;
  [[nodiscard]] static const std::string* settled_form(const Forms& forms);

  std::map<std::string, Forms, std::less<>> facts_;  ///< By name; '$' comes before '<' and '['.
  std::size_t rounds_ = 0;
};

}  // namespace sim
