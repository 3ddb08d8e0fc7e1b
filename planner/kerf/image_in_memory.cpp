#include <algorithm>

#include "planner/kerf/table_image.hpp"

/// By itself: the reader of images must not see who its source is, or the compiler guesses at it
/// and compares addresses, which tests/static/image_stack.py cannot follow.
namespace cnc::kerf {
namespace {

class SpanSource final : public ImageSource {
 public:
  explicit SpanSource(std::span<const std::byte> bytes) : bytes_{bytes} {}

  [[nodiscard]] std::size_t size() const override { return bytes_.size(); }
  void read(std::size_t at, std::span<std::byte> into) override {
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at), into.size(), into.begin());
  }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace

std::optional<TableFault> read_image(std::span<const std::byte> image, StoredTable& table) {
  SpanSource source{image};
  return read_image(source, table);
}

}  // namespace cnc::kerf
