#pragma once

#include <array>
#include <cstddef>

#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Joins lines that are shorter than half a step of each motor to the element after them: this
/// element then begins at the start of the short line. No motor can follow such a line, but each of
/// its corners would nearly require a stop.
///
/// So an element begins at most half a step of each motor away from its programmed start, and ends
/// at its programmed end. Its tolerance is reduced by the distance between the two starts. A line
/// is not joined if beam, feed or outputs change after it, or if it is the last line before a
/// pause.
class ShortLines {
 public:
  /// @param limits must outlive this object
  explicit ShortLines(const motion::Limits& limits) : limits_{limits} {}

  /// Returns whether next() has returned all settled items.
  [[nodiscard]] bool has_room() const { return settled_ == 0; }
  /// Adds an item. @pre has_room(), and the item begins at the end of the item before
  void put(const PathItem& item);
  /// Settles the held line, because no further item is known. @pre has_room()
  void flush();
  void clear() { count_ = settled_ = 0; }

  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// Returns the next settled item in order, or null if there is none. The item is valid until the
  /// next call of any member.
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
  /// The settled items, and after them at most one short item: a short line, or several joined
  /// lines that together are short.
  std::array<PathItem, 2> items_{};
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::size_t settled_ = 0;
};

}  // namespace cnc::path
