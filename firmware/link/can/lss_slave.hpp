#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace cnc {

/// Gives a controller its node number over the bus: layer setting services of CiA 305, without
/// fast scan, which is for nodes that have none yet (every controller has one), and without bit
/// rates, which are the board's.
///
/// A master selects one controller by its identity, or the only one on the bus, sets a number
/// and has it stored. The number counts from the next reset of the communication on. Main loop.
class LssSlave {
 public:
  /// What no two devices share (object 0x1018).
  struct Identity {
    static constexpr std::uint32_t kProduct = 0x4B65'7266;  ///< "Kerf".

    std::uint32_t vendor = 0;  ///< CiA gives numbers to members; 0 is nobody's.
    std::uint32_t product = kProduct;
    std::uint32_t revision = 1;
    std::uint32_t serial = 0;

    [[nodiscard]] constexpr std::array<std::uint32_t, 4> numbers() const {
      return {vendor, product, revision, serial};
    }
  };
  using Payload = std::array<std::byte, 8>;

  explicit LssSlave(const Identity& identity) : identity_{identity.numbers()} {}

  /// A frame of the master's. @param node the number that counts now
  /// @return what is answered, if anything. Frames that are too short are passed over.
  [[nodiscard]] std::optional<Payload> take(std::span<const std::byte> payload, std::uint8_t node);

  /// True once when the number that was set is to be stored; stored() has the answer to that.
  [[nodiscard]] bool take_store_request() { return std::exchange(store_, false); }
  [[nodiscard]] static Payload stored(bool ok);

  /// The number that was set last; 0 for none.
  [[nodiscard]] std::uint8_t set_node() const { return node_; }
  /// Somebody is about to set a number: it does not change meanwhile.
  [[nodiscard]] bool configured_now() const { return configured_now_; }
  void end_configuration() { switch_mode(false); }

 private:
  void switch_mode(bool configure);
  [[nodiscard]] bool is_selected(std::size_t part, std::uint32_t number);
  [[nodiscard]] bool is_within(std::size_t bound, std::uint32_t number);
  [[nodiscard]] Payload configure_node(std::uint8_t node);

  std::array<std::uint32_t, 4> identity_;
  std::size_t selected_ = 0;  ///< Parts of the identity that were right so far,
  std::size_t within_ = 0;    ///< bounds of it that were.
  std::uint8_t node_ = 0;
  bool configured_now_ = false;
  bool store_ = false;
};

}  // namespace cnc
