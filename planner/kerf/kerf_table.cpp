#include "planner/kerf/kerf_table.hpp"

namespace cnc::kerf {

std::string_view describe(TableError error) {
  switch (error) {
    case TableError::kBadName:
      return "a name has 1 to 15 letters, digits, blanks and - _ . /";
    case TableError::kNoRows:
      return "a kerf table has at least one thickness";
    case TableError::kThicknessNotRising:
      return "thicknesses must rise from row to row, up to 100 mm";
    case TableError::kPowerNotRising:
      return "powers must rise within a thickness, up to 100 kW";
    case TableError::kBadSpeeds:
      return "speeds are 1 to 1000000 mm/min, the least first";
    case TableError::kBadPoints:
      return "measured speeds must rise from the least permissible to the greatest";
    case TableError::kBadKerf:
      return "the kerf must be above 0 and at most 10 mm in all of the region";
    case TableError::kBadShape:
      return "counts of rows, bands and points do not agree";
    case TableError::kBadSize:
      return "the image is not as long as its header says";
    case TableError::kNotATable:
      return "this is no kerf table";
    case TableError::kOtherVersion:
      return "the kerf table is of another version";
    case TableError::kBadSum:
      return "the kerf table's CRC-32 is wrong";
    case TableError::kTooManyRows:
      return "too many thicknesses";
    case TableError::kTooManyBands:
      return "too many powers";
    case TableError::kTooManyPoints:
      return "too many measured speeds";
  }
  return {};
}

}  // namespace cnc::kerf
