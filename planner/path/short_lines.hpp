#pragma once

#include <array>
#include <cstddef>

#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Lets the element after a line that is shorter than half a step of each motor begin where the
/// line does. No motor can follow such a line, but each of its corners would cost a near stop.
///
/// An element thus begins at most half a step of each motor beside its programmed start, and ends
/// at its programmed end; its tolerance is less by the distance of the two starts. A line at which
/// beam, feed or outputs change stays as it is, and so does the last before a pause.
class ShortLines {
 public:
  /// @param limits must outlive this.
  explicit ShortLines(const motion::Limits& limits) : limits_{limits} {}

  /// All that put() has settled has been taken.
  [[nodiscard]] bool has_room() const { return settled_ == 0; }
  /// @pre has_room(), and it begins where the one before ended
  void put(const PathItem& item);
  /// The held line waits no longer. @pre has_room()
  void flush();
  void clear() { count_ = settled_ = 0; }

  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// The next item in order, until the next call of anything else; null when there is none.
  [[nodiscard]] const PathItem* next();
  /// Source line of the oldest item held; 0 for none.
  [[nodiscard]] motion::SourceLine line() const;

 private:
  [[nodiscard]] bool is_short(const PathElement& element) const;
  [[nodiscard]] PathItem& item_at(std::size_t index) { return items_[(oldest_ + index) % 2]; }
  void go_with_held(const PathItem& item);
  void forget_oldest();
  void drop_still();

  const motion::Limits& limits_;
  /// Settled ones, then perhaps a short line, or several that are short together.
  std::array<PathItem, 2> items_{};
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::size_t settled_ = 0;
};

}  // namespace cnc::path
