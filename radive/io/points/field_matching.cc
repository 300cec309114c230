// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/field_matching.h"

#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

struct Alias {
  std::string_view name;  // lower case
  FieldRole role;
};

// Of each role the best name first.
constexpr Alias kAliases[] = {
    {"x", FieldRole::kX},
    {"car_loc_x", FieldRole::kX},
    {"y", FieldRole::kY},
    {"car_loc_y", FieldRole::kY},
    {"z", FieldRole::kZ},
    {"car_loc_z", FieldRole::kZ},
    {"range", FieldRole::kRange},
    {"r", FieldRole::kRange},
    {"azimuth", FieldRole::kAzimuth},
    {"az", FieldRole::kAzimuth},
    {"azimuth_angle", FieldRole::kAzimuth},
    {"azimuth_deg", FieldRole::kAzimuth},
    {"elevation", FieldRole::kElevation},
    {"el", FieldRole::kElevation},
    {"elevation_angle", FieldRole::kElevation},
    {"elevation_deg", FieldRole::kElevation},
    {"doppler", FieldRole::kDoppler},
    {"v_doppler_mps", FieldRole::kDoppler},
    {"velocity", FieldRole::kDoppler},
    {"radial_velocity", FieldRole::kDoppler},
    {"radial_speed", FieldRole::kDoppler},
    {"v_r", FieldRole::kDoppler},
    {"vr", FieldRole::kDoppler},
    {"range_rate", FieldRole::kDoppler},
    {"rangerate", FieldRole::kDoppler},
    {"v", FieldRole::kDoppler},
    {"vel", FieldRole::kDoppler},
    {"speed", FieldRole::kDoppler},
    {"car_vel_r", FieldRole::kDoppler},
    {"power", FieldRole::kPower},
    {"snr_db", FieldRole::kPower},
    {"snr", FieldRole::kPower},
    {"intensity", FieldRole::kPower},
    {"rcs", FieldRole::kPower},
    {"reflectivity", FieldRole::kPower},
    {"t", FieldRole::kTime},
    {"time", FieldRole::kTime},
    {"timestamp", FieldRole::kTime},
    {"timestamps", FieldRole::kTime},
    {"stamps", FieldRole::kTime},
    {"time_offset_ns", FieldRole::kTime},
    {"offset_time", FieldRole::kTime},
};

constexpr const char* kRoleNames[kNumFieldRoles] = {
    "x", "y", "z", "range", "azimuth", "elevation", "doppler", "power", "time"};

int IndexOfName(const std::vector<PointField>& fields, std::string_view lower_case) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (LowerCase(fields[i].name) == lower_case) return static_cast<int>(i);
  }
  return -1;
}

// "x, y, z, Doppler", cut where a hostile header has too many.
std::string Names(const std::vector<PointField>& fields) {
  constexpr std::size_t kMost = 40;
  std::string names;
  for (std::size_t i = 0; i < fields.size() && i < kMost; ++i) {
    names += (i == 0 ? "" : ", ") + Quoted(fields[i].name);
  }
  if (fields.empty()) return "none";
  return names + (fields.size() > kMost ? ", ..." : "");
}

bool ApplyChoices(const std::vector<PointField>& fields,
                  const FieldChoices& choices,
                  FieldMatch* match,
                  std::string* error) {
  for (const auto& [role, name] : choices) {
    const int index = name == "_" ? -1 : IndexOfName(fields, LowerCase(name));
    if (name != "_" && index < 0) {
      *error = "there is no field " + Quoted(name) + " (input.fields: " + NameOf(role) + "=" +
               name + "); the points have the fields " + Names(fields);
      return false;
    }
    match->Set(role, index);
  }
  return true;
}

}  // namespace

const char* NameOf(FieldRole role) { return kRoleNames[static_cast<std::size_t>(role)]; }

std::optional<FieldRole> RoleOfName(std::string_view name) {
  const std::string lower_case = LowerCase(name);
  for (const Alias& alias : kAliases) {
    if (alias.name == lower_case) return alias.role;
  }
  return std::nullopt;
}

std::optional<FieldChoices> ParseFieldChoices(const std::string& text, std::string* error) {
  FieldChoices choices;
  std::string_view rest = TrimBlanks(text);
  if (rest.size() >= 2 && rest.front() == '[' && rest.back() == ']') {
    rest = TrimBlanks(rest.substr(1, rest.size() - 2));
  }
  while (!rest.empty()) {
    const std::size_t comma = rest.find(',');
    const std::string_view choice = TrimBlanks(rest.substr(0, comma));
    rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
    const std::size_t equals = choice.find('=');
    const std::string role = LowerCase(TrimBlanks(choice.substr(0, equals)));
    const std::string_view name =
        equals == std::string_view::npos ? "" : TrimBlanks(choice.substr(equals + 1));
    std::size_t index = 0;
    while (index < kNumFieldRoles && role != kRoleNames[index]) ++index;
    if (index == kNumFieldRoles || name.empty()) {
      *error = "fields " + Quoted(text) + ": expected a list like [doppler=vel_r, power=snr] of x" +
               ", y, z, range, azimuth, elevation, doppler, power, time and the names of fields " +
               "(_ for none), found " + Quoted(choice);
      return std::nullopt;
    }
    choices.emplace_back(static_cast<FieldRole>(index), std::string(name));
  }
  return choices;
}

const char* FieldMatch::RoleOf(int index) const {
  for (std::size_t role = 0; role < kNumFieldRoles; ++role) {
    if (index_[role] == index) return kRoleNames[role];
  }
  return "";
}

std::optional<FieldMatch> MatchFields(const std::vector<PointField>& fields,
                                      const FieldChoices& choices,
                                      std::string* error) {
  FieldMatch match;
  for (const Alias& alias : kAliases) {
    if (!match.Has(alias.role)) match.Set(alias.role, IndexOfName(fields, alias.name));
  }
  if (!ApplyChoices(fields, choices, &match, error)) return std::nullopt;
  const bool is_cartesian = match.Has(FieldRole::kX) && match.Has(FieldRole::kY);
  const bool is_polar = match.Has(FieldRole::kRange) && match.Has(FieldRole::kAzimuth);
  if (!is_cartesian && !is_polar) {
    *error = "expected the fields x, y and z (or range, azimuth and elevation), found " +
             Names(fields) + "; input.fields can name them";
    return std::nullopt;
  }
  return match;
}

}  // namespace radive
