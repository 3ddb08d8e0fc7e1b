#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cnc::can {

/// Identifiers of frames in CANopen's predefined connection set (CiA 301), 11 bits each. If two
/// nodes send at the same time, the frame with the smaller identifier is sent first. A node number
/// is 1 to 127; `+ node` means that the node number is added to the identifier.
inline constexpr std::uint32_t kNetwork = 0x000;  ///< NMT: command, then node (0 means all nodes).
inline constexpr std::uint32_t kFailSafe =
    0x001;  ///< Global fail-safe: stops all nodes; the frame's content has no meaning.
inline constexpr std::uint32_t kEmergency = 0x080;  ///< + node: error code, register, alarm.
inline constexpr std::uint32_t kRealtime = 0x200;   ///< + node: realtime bytes to the node.
inline constexpr std::uint32_t kTextFrom = 0x480;   ///< + node: text from the node, ISO 15765-2.
inline constexpr std::uint32_t kTextTo = 0x500;     ///< + node: lines to the node, ISO 15765-2.
inline constexpr std::uint32_t kHeartbeat = 0x700;  ///< + node: state of the node.
inline constexpr std::uint32_t kHostHeartbeat = 0x77F;
inline constexpr std::uint32_t kLssFrom = 0x7E4;  ///< Answers from a node to the master (CiA 305).
/// Requests from the master to set node numbers (CiA 305).
inline constexpr std::uint32_t kLssTo = 0x7E5;

inline constexpr std::uint8_t kLastNode = 0x7E;  ///< Node number 0x7F is reserved for the host.
inline constexpr std::uint8_t kUsualNode = 0x11;

inline constexpr std::size_t kUrgent = 3;
/// Returns the identifiers of frames that a node must receive; the first kUrgent are urgent. A
/// filter may reject all other frames.
[[nodiscard]] constexpr std::array<std::uint32_t, 6> heard_by_node(std::uint8_t node) {
  return {kNetwork, kFailSafe, kRealtime + node, kTextTo + node, kHostHeartbeat, kLssTo};
}

/// Returns the identifiers of frames that the node with number `node` sends to a host.
[[nodiscard]] constexpr std::array<std::uint32_t, 3> heard_by_host(std::uint8_t node) {
  return {kEmergency + node, kTextFrom + node, kHeartbeat + node};
}

/// Command in the first byte of a kNetwork frame.
enum class NetworkCommand : std::uint8_t {
  kStart = 0x01,  ///< A host is present.
  kStop = 0x02,   ///< Emergency stop.
  kResetNode = 0x81,
  kResetCommunication = 0x82,
};

/// State of a node, the content of its heartbeat.
enum class NodeState : std::uint8_t {
  kBooting = 0x00,
  kStopped = 0x04,  ///< The node has an alarm.
  kOperational = 0x05,
  kPreOperational = 0x7F,  ///< No host communicates with the node.
};

/// Error codes of an emergency message (CiA 301, 7.2.7.1).
inline constexpr std::uint16_t kNoError = 0x0000;
inline constexpr std::uint16_t kFramesLost = 0x8110;
inline constexpr std::uint16_t kHostSilent = 0x8130;
inline constexpr std::uint16_t kDeviceSpecific = 0xFF00;

}  // namespace cnc::can
