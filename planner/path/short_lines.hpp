#pragma once

#include <array>
#include <cstddef>

#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Handles lines that are shorter than half a step of each motor: the element after such a line
/// begins where the line does. No motor can follow such a line, but each of its corners would cost
/// a near stop.
///
/// So an element begins at most half a step of each motor away from its programmed start, and ends
/// at its programmed end. Its tolerance is reduced by the distance between the two starts. A line
/// at which beam, feed or outputs change stays as it is, and so does the last line before a pause.
class ShortLines {
 public:
  /// @param limits must outlive this.
  explicit ShortLines(const motion::Limits& limits) : limits_{limits} {}

  /// Returns whether all items that put() has settled have been taken.
  [[nodiscard]] bool has_room() const { return settled_ == 0; }
  /// Takes an item. @pre has_room(), and the item begins where the one before ended
  void put(const PathItem& item);
  /// Settles the held line. @pre has_room()
  void flush();
  void clear() { count_ = settled_ = 0; }

  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// Returns the next item in order; null when there is none. The item is valid until the next call
  /// of any member.
  [[nodiscard]] const PathItem* next();
  /// Returns the source line of the oldest held item; 0 if none is held.
  [[nodiscard]] motion::SourceLine line() const;

 private:
  [[nodiscard]] bool is_short(const PathElement& element) const;
  [[nodiscard]] PathItem& item_at(std::size_t index) { return items_[(oldest_ + index) % 2]; }
  void go_with_held(const PathItem& item);
  void forget_oldest();
  void drop_still();

  const motion::Limits& limits_;
  /// Settled items, followed perhaps by a short line, or by several lines that together are short.
  std::array<PathItem, 2> items_{};
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::size_t settled_ = 0;
};

}  // namespace cnc::path
