// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "radive/io/points/point_table.h"

namespace radive {

// What a field of a point record can be to RaDiVe.
enum class FieldRole {
  kX,          // [m]
  kY,          // [m]
  kZ,          // [m]
  kRange,      // [m]
  kAzimuth,    // [rad], positive to the left
  kElevation,  // [rad], positive up
  kDoppler,    // range rate as measured, never compensated [m/s]
  kPower,      // power, SNR or radar cross section [dB or dBsm]
  kTime        // of the point within its scan, any unit; named in reports, not used
};
constexpr std::size_t kNumFieldRoles = 9;

// "x", ..., "time".
const char* NameOf(FieldRole role);

// The role that a field of this name has; none for the others, among them all compensated
// velocities. Case does not matter; only whole names count, apart from a unit behind: "x [m]",
// "velocity (km/h)", "azimuth_deg".
std::optional<FieldRole> RoleOfName(std::string_view name);

// What values of a field of this name are multiplied with to be in the unit of the role, as the
// unit behind the name says (mm, cm, km; deg; km/h, cm/s, mm/s); 1 without a unit.
double UnitOfName(FieldRole role, std::string_view name);

// True when the names are those of a table of poses, places on the earth or inertial measurements:
// it has quaternions, roll, pitch and yaw, latitude and longitude, or accelerations and rates.
bool HoldsPoses(const std::vector<PointField>& fields);

// Choices of the user (input.fields): which field has a role, by its name; "_" for none.
using FieldChoices = std::vector<std::pair<FieldRole, std::string>>;

// Reads "[doppler=vel_r, power=snr]" with or without brackets; empty: no choices. Nothing, and what
// is wrong in `error`, for anything else.
std::optional<FieldChoices> ParseFieldChoices(const std::string& text, std::string* error);

// Which field has which role.
class FieldMatch {
 public:
  FieldMatch() { index_.fill(-1); }

  // Position in the fields; -1: no field has the role.
  int operator[](FieldRole role) const { return index_[static_cast<std::size_t>(role)]; }
  void Set(FieldRole role, int index) { index_[static_cast<std::size_t>(role)] = index; }
  bool Has(FieldRole role) const { return (*this)[role] >= 0; }

  // The role of the field at `index`, for reports; "" when it has none.
  const char* RoleOf(int index) const;

 private:
  std::array<int, kNumFieldRoles> index_;
};

// Finds the roles of `fields` by their names, never by their positions: what `choices` say first,
// otherwise the first of the known names of a role that is there, in this order:
//
//   doppler    doppler v_doppler_mps velocity radial_velocity radial_speed v_r vr range_rate
//              rangeRate v vel speed car_vel_r
//              (of those that are there PointConverter prefers one with fractions: no bins)
//   power      power snr_db snr intensity rcs reflectivity
//   range      range r                 azimuth  azimuth az azimuth_angle azimuth_deg
//   elevation  elevation el elevation_angle elevation_deg
//   time       t time timestamp timestamps stamps time_offset_ns offset_time
//
// Nothing, with the names of all fields in `error`, when there are neither x and y nor range and
// azimuth, or a chosen field does not exist. Without z (or elevation) the sensor is planar.
std::optional<FieldMatch> MatchFields(const std::vector<PointField>& fields,
                                      const FieldChoices& choices,
                                      std::string* error);

}  // namespace radive
