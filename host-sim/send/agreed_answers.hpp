#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// Collects the facts that Kerfline reports without a check, over a link that damages bytes. The
/// facts are settings (`$$`), offsets (`$#`), modes (`$G`), the state and the position (`?`, 0x87),
/// and the progress of a job (`$RESUME`). The sender repeats the questions in rounds. A form is the
/// text of a fact as it arrived. A fact is settled when one form of it has arrived three times or
/// more, and no other form has arrived as often.
class AgreedAnswers {
 public:
  /// @param resume whether `$RESUME` is one of the questions
  explicit AgreedAnswers(bool resume);

  /// Counts a line of the controller. Lines that state none of the facts are ignored.
  void read(std::string_view line);
  /// Ends a round: all questions have been acknowledged.
  void end_round() { ++rounds_; }

  /// Returns the names of the facts that are not settled, such as `$130` or `[G54:`. The result is
  /// empty when all facts are settled. A fact is left out if this controller does not have it: if
  /// the fact never arrived in the first four rounds, or if it arrived in at most one round in
  /// eight.
  [[nodiscard]] std::vector<std::string> open() const;
  /// Returns one line for each settled fact, settings first, as the controller would send it.
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  /// Number of arrivals of each form of a fact.
  using Forms = std::map<std::string, std::size_t, std::less<>>;

  [[nodiscard]] bool is_missing(const Forms& forms) const;
  [[nodiscard]] static const std::string* settled_form(const Forms& forms);

  /// Forms of each fact, by the name of the fact. In this order, names with '$' come before names
  /// with '<' and '['.
  std::map<std::string, Forms, std::less<>> facts_;
  std::size_t rounds_ = 0;
};

}  // namespace sim
