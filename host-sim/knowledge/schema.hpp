#pragma once

namespace sim {

/// Version of the tables below, in PRAGMA user_version. Version 1 can be read, too, and is
/// converted to version 2 at the first write.
inline constexpr int kSchemaVersion = 2;

/// The tables, which README.md describes. Integers are exact values in µm, mW, µm/min and nm.
/// Measured or fitted numbers are REAL, in the unit that ends their name: mm, W, mm/min or MPa.
inline constexpr const char* kSchema = R"sql(
CREATE TABLE import (
  id INTEGER PRIMARY KEY,
  file TEXT NOT NULL,
  crc32 INTEGER NOT NULL,
  bytes INTEGER NOT NULL,
  measured_by TEXT NOT NULL DEFAULT '',
  measured_on TEXT NOT NULL DEFAULT '',
  UNIQUE (crc32, bytes));
CREATE TABLE cut (
  id INTEGER PRIMARY KEY,
  import INTEGER NOT NULL REFERENCES import (id),
  line INTEGER NOT NULL,
  material TEXT NOT NULL,
  laser TEXT NOT NULL,
  gas_pressure_mpa REAL NOT NULL,
  thickness_um INTEGER NOT NULL,
  power_mw INTEGER NOT NULL,
  speed_um_min INTEGER NOT NULL,
  kerf_top_mm REAL NOT NULL,
  kerf_bottom_mm REAL NOT NULL,
  dross_area_mm2 REAL NOT NULL,
  straightness_mm REAL NOT NULL,
  rejection TEXT NOT NULL);
CREATE TABLE record (
  id INTEGER PRIMARY KEY,
  material TEXT NOT NULL,
  heat_unit TEXT NOT NULL CHECK (heat_unit IN ('W/(mm/min)', 'J/mm')),
  laser TEXT NOT NULL,
  gas_pressure_mpa REAL NOT NULL,
  calibrated INTEGER NOT NULL,
  provenance TEXT NOT NULL,
  UNIQUE (material, heat_unit));
CREATE TABLE thickness (
  id INTEGER PRIMARY KEY,
  record INTEGER NOT NULL REFERENCES record (id) ON DELETE CASCADE,
  thickness_um INTEGER NOT NULL,
  measured INTEGER NOT NULL,
  slope REAL NOT NULL,
  intercept_mm REAL NOT NULL,
  correlation REAL NOT NULL,
  residual_sd_mm REAL NOT NULL,
  greatest_residual_mm REAL NOT NULL,
  samples INTEGER NOT NULL,
  degrees INTEGER NOT NULL,
  mean_heat REAL NOT NULL,
  heat_squares REAL NOT NULL,
  UNIQUE (record, thickness_um));
CREATE TABLE power (
  id INTEGER PRIMARY KEY,
  thickness INTEGER NOT NULL REFERENCES thickness (id) ON DELETE CASCADE,
  power_mw INTEGER NOT NULL,
  least_speed_um_min INTEGER NOT NULL,
  most_speed_um_min INTEGER NOT NULL,
  UNIQUE (thickness, power_mw));
CREATE TABLE point (
  power INTEGER NOT NULL REFERENCES power (id) ON DELETE CASCADE,
  speed_um_min INTEGER NOT NULL,
  kerf_nm INTEGER NOT NULL,
  UNIQUE (power, speed_um_min));
)sql";

/// Table that version 2 adds. Its rows refer to a material by name, so that a new fit of the
/// material's record leaves them unchanged. NULL means not known.
inline constexpr const char* kOperationSchema = R"sql(
CREATE TABLE operation (
  id INTEGER PRIMARY KEY,
  material TEXT NOT NULL,
  kind TEXT NOT NULL CHECK (kind IN ('cut', 'fill', 'engrave')),
  description TEXT NOT NULL,
  laser TEXT NOT NULL,
  thickness_um INTEGER,
  power_percent REAL,
  speed_um_min INTEGER,
  passes INTEGER,
  interval_mm REAL,
  kerf_mm REAL,
  measured_here INTEGER NOT NULL,
  measured_by TEXT NOT NULL,
  measured_on TEXT NOT NULL,
  source TEXT NOT NULL);
PRAGMA user_version = 2;
)sql";

/// Converts version 1 to version 2.
inline constexpr const char* kImportOfVersion2 = R"sql(
ALTER TABLE import ADD COLUMN measured_by TEXT NOT NULL DEFAULT '';
ALTER TABLE import ADD COLUMN measured_on TEXT NOT NULL DEFAULT '';
)sql";

}  // namespace sim
