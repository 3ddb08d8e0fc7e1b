#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace cnc {

/// Lets a master set the controller's node number over the bus: layer setting services of CiA 305.
/// Two of them are missing. Fast scan is for nodes without a number, and every controller has one.
/// The bit rate is a property of the board.
///
/// A master selects one controller by its identity (or the only one on the bus), sets a number and
/// has it stored. The number takes effect at the next reset of the communication. Main loop.
class LssSlave {
 public:
  /// Identity that is unique to each device (object 0x1018).
  struct Identity {
    static constexpr std::uint32_t kProduct = 0x4B65'7266;  ///< "Kerf" in ASCII.

    std::uint32_t vendor = 0;  ///< Number that CiA gives to a member; 0 is given to none.
    std::uint32_t product = kProduct;
    std::uint32_t revision = 1;
    std::uint32_t serial = 0;

    [[nodiscard]] constexpr std::array<std::uint32_t, 4> numbers() const {
      return {vendor, product, revision, serial};
    }
  };
  using Payload = std::array<std::byte, 8>;

  explicit LssSlave(const Identity& identity) : identity_{identity.numbers()} {}

  /// Takes a frame from the master. Frames that are too short are ignored.
  /// @param node present node number
  /// @return the answer, if any
  [[nodiscard]] std::optional<Payload> take(std::span<const std::byte> payload, std::uint8_t node);

  /// Returns true once if the number that was set is to be stored. The caller sends stored() as the
  /// answer.
  [[nodiscard]] bool take_store_request() { return std::exchange(store_, false); }
  [[nodiscard]] static Payload stored(bool ok);

  /// Returns the number that was set last; 0 for none.
  [[nodiscard]] std::uint8_t set_node() const { return node_; }
  /// Returns whether a master is about to set a number; the node number must not change meanwhile.
  [[nodiscard]] bool configured_now() const { return configured_now_; }
  void end_configuration() { switch_mode(false); }

 private:
  void switch_mode(bool configure);
  [[nodiscard]] bool is_selected(std::size_t part, std::uint32_t number);
  [[nodiscard]] bool is_within(std::size_t bound, std::uint32_t number);
  [[nodiscard]] Payload configure_node(std::uint8_t node);

  std::array<std::uint32_t, 4> identity_;
  std::size_t selected_ = 0;  ///< Parts of the identity that matched so far.
  std::size_t within_ = 0;    ///< Bounds of the identity that matched so far.
  std::uint8_t node_ = 0;
  bool configured_now_ = false;
  bool store_ = false;
};

}  // namespace cnc
