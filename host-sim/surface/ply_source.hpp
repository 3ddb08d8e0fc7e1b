#pragma once

#include <fmt/format.h>

#include <string>

#include "host-sim/surface/byte_reader.hpp"
#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/ply_header.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::surface {

/// Reads the numbers of a PLY text. Throws std::invalid_argument for a word that is not a number,
/// and at the end of the text.
class PlyText {
 public:
  PlyText(const PlyHeader& header, const std::string& name)
      : name_{name}, words_{header.body, header.lines + 1} {}

  double take(PlyScalar /*scalar*/) {
    const std::string_view word = words_.next();
    if (const auto value = parsed_number(word)) return *value;
    refuse(name_,
           words_.line(),
           word.empty() ? "ends too early" : fmt::format("`{}` is not a number", shown(word)),
           "export the mesh again");
  }
  /// Returns the line of the last number, counted from 1.
  [[nodiscard]] std::size_t line() const { return words_.line(); }
  [[nodiscard]] std::size_t left() const { return words_.rest().size(); }

 private:
  const std::string& name_;
  TextWords words_;
};

/// Reads the numbers of a binary PLY file. Throws std::invalid_argument at the end of the file.
class PlyBytes {
 public:
  PlyBytes(const PlyHeader& header, const std::string& name)
      : name_{name},
        reader_{header.body,
                header.format == PlyFormat::kBigEndian ? ByteOrder::kBigEndian
                                                       : ByteOrder::kLittleEndian} {}

  double take(PlyScalar scalar) {
    if (reader_.left() < size_of(scalar)) {
      refuse(name_, 0, "ends too early", "the file is cut off; export it again");
    }
    switch (scalar) {
      case PlyScalar::kInt8:
        return static_cast<std::int8_t>(reader_.take<std::uint8_t>());
      case PlyScalar::kUint8:
        return reader_.take<std::uint8_t>();
      case PlyScalar::kInt16:
        return static_cast<std::int16_t>(reader_.take<std::uint16_t>());
      case PlyScalar::kUint16:
        return reader_.take<std::uint16_t>();
      case PlyScalar::kInt32:
        return static_cast<std::int32_t>(reader_.take<std::uint32_t>());
      case PlyScalar::kUint32:
        return reader_.take<std::uint32_t>();
      case PlyScalar::kFloat:
        return reader_.take_float();
      case PlyScalar::kDouble:
        return reader_.take_double();
    }
    return 0.0;
  }
  [[nodiscard]] static std::size_t line() { return 0; }
  [[nodiscard]] std::size_t left() const { return reader_.left(); }

 private:
  const std::string& name_;
  ByteReader reader_;
};

}  // namespace sim::surface
