#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cnc::can {

/// Nodes of CANopen's predefined connection set (CiA 301), 11-bit identifiers. What is smaller
/// wins the bus. A node is 1 to 127.
inline constexpr std::uint32_t kNetwork = 0x000;  ///< NMT: command, node (0: all).
inline constexpr std::uint32_t kFailSafe =
    0x001;  ///< Global fail-safe: whatever it holds, all stop.
inline constexpr std::uint32_t kEmergency = 0x080;  ///< + node: error code, register, alarm.
inline constexpr std::uint32_t kRealtime = 0x200;   ///< + node: realtime bytes to it.
inline constexpr std::uint32_t kTextFrom = 0x480;   ///< + node: what it says, ISO 15765-2.
inline constexpr std::uint32_t kTextTo = 0x500;     ///< + node: lines to it, ISO 15765-2.
inline constexpr std::uint32_t kHeartbeat = 0x700;  ///< + node: its state.
inline constexpr std::uint32_t kHostHeartbeat = 0x77F;
inline constexpr std::uint32_t kLssFrom = 0x7E4;  ///< What a node answers to
inline constexpr std::uint32_t kLssTo = 0x7E5;    ///< whoever gives out numbers (CiA 305).

inline constexpr std::uint8_t kLastNode = 0x7E;  ///< 0x7F is the host.
inline constexpr std::uint8_t kUsualNode = 0x11;

/// What a node takes from the bus; everything else may be kept away from it. What is urgent
/// first.
inline constexpr std::size_t kUrgent = 3;
[[nodiscard]] constexpr std::array<std::uint32_t, 6> heard_by_node(std::uint8_t node) {
  return {kNetwork, kFailSafe, kRealtime + node, kTextTo + node, kHostHeartbeat, kLssTo};
}

/// What a host takes that talks to this node.
[[nodiscard]] constexpr std::array<std::uint32_t, 3> heard_by_host(std::uint8_t node) {
  return {kEmergency + node, kTextFrom + node, kHeartbeat + node};
}

/// First byte of kNetwork.
enum class NetworkCommand : std::uint8_t {
  kStart = 0x01,  ///< A host is there.
  kStop = 0x02,   ///< Emergency stop.
  kResetNode = 0x81,
  kResetCommunication = 0x82,
};

/// Byte of a heartbeat.
enum class NodeState : std::uint8_t {
  kBooting = 0x00,
  kStopped = 0x04,  ///< An alarm.
  kOperational = 0x05,
  kPreOperational = 0x7F,  ///< Nobody talks to it.
};

/// Of an emergency message (CiA 301, 7.2.7.1).
inline constexpr std::uint16_t kNoError = 0x0000;
inline constexpr std::uint16_t kFramesLost = 0x8110;
inline constexpr std::uint16_t kHostSilent = 0x8130;
inline constexpr std::uint16_t kDeviceSpecific = 0xFF00;

}  // namespace cnc::can
