#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace cnc {

/// Lets a master set the controller's node number over the bus, by the layer setting services of
/// CiA 305. Two services are not supported. Fast scan is not necessary, because it serves nodes
/// without a number, and every controller has a number. The bit rate cannot be set, because the
/// board determines it.
///
/// A master selects one controller by its identity. If there is only one controller on the bus, the
/// master may select it without the identity. The master then sets a number and requests that the
/// controller store it. The number takes effect at the next reset of the communication. Main loop.
class LssSlave {
 public:
  /// Identity that is unique to each device (object 0x1018).
  struct Identity {
    static constexpr std::uint32_t kProduct = 0x4B65'7266;  ///< "Kerf" in ASCII.

    std::uint32_t vendor = 0;  ///< Vendor number, assigned by CiA to its members; no member has 0.
    std::uint32_t product = kProduct;
    std::uint32_t revision = 1;
    std::uint32_t serial = 0;

    [[nodiscard]] constexpr std::array<std::uint32_t, 4> numbers() const {
      return {vendor, product, revision, serial};
    }
  };
  using Payload = std::array<std::byte, 8>;

  explicit LssSlave(const Identity& identity) : identity_{identity.numbers()} {}

  /// Processes a frame from the master. Frames that are too short are ignored.
  /// @param node present node number
  /// @return the answer, if any
  [[nodiscard]] std::optional<Payload> take(std::span<const std::byte> payload, std::uint8_t node);

  /// Returns true once if the master requested that the set number be stored. The caller then sends
  /// stored() as the answer.
  [[nodiscard]] bool take_store_request() { return std::exchange(store_, false); }
  [[nodiscard]] static Payload stored(bool ok);

  /// Returns the number that a master set last; 0 for none.
  [[nodiscard]] std::uint8_t set_node() const { return node_; }
  /// Returns whether a master has selected this controller to set a number. While it is selected,
  /// its node number must not change.
  [[nodiscard]] bool configured_now() const { return configured_now_; }
  void end_configuration() { switch_mode(false); }

 private:
  void switch_mode(bool configure);
  [[nodiscard]] bool is_selected(std::size_t part, std::uint32_t number);
  [[nodiscard]] bool is_within(std::size_t bound, std::uint32_t number);
  [[nodiscard]] Payload configure_node(std::uint8_t node);

  std::array<std::uint32_t, 4> identity_;
  std::size_t selected_ = 0;  ///< Number of parts of the identity that matched so far.
  std::size_t within_ = 0;    ///< Number of bounds of the identity that matched so far.
  std::uint8_t node_ = 0;
  bool configured_now_ = false;
  bool store_ = false;
};

}  // namespace cnc
