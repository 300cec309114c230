// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/field_matching.h"

#include <algorithm>
#include <initializer_list>

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
    {"elevation", FieldRole::kElevation},
    {"el", FieldRole::kElevation},
    {"elevation_angle", FieldRole::kElevation},
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

struct Unit {
  std::string_view name;
  FieldRole role;  // kX for all lengths, kAzimuth for all angles
  double factor;
  bool is_suffix;  // is also known behind an underscore: azimuth_deg
};

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;

constexpr Unit kUnits[] = {
    {"m", FieldRole::kX, 1.0, true},
    {"meter", FieldRole::kX, 1.0, false},
    {"meters", FieldRole::kX, 1.0, false},
    {"metre", FieldRole::kX, 1.0, false},
    {"metres", FieldRole::kX, 1.0, false},
    {"mm", FieldRole::kX, 1e-3, true},
    {"cm", FieldRole::kX, 1e-2, true},
    {"km", FieldRole::kX, 1e3, false},
    {"rad", FieldRole::kAzimuth, 1.0, true},
    {"radian", FieldRole::kAzimuth, 1.0, false},
    {"radians", FieldRole::kAzimuth, 1.0, false},
    {"deg", FieldRole::kAzimuth, kRadiansPerDegree, true},
    {"degree", FieldRole::kAzimuth, kRadiansPerDegree, false},
    {"degrees", FieldRole::kAzimuth, kRadiansPerDegree, true},
    {"\xC2\xB0", FieldRole::kAzimuth, kRadiansPerDegree, false},  // the sign, UTF-8 and Latin-1
    {"\xB0", FieldRole::kAzimuth, kRadiansPerDegree, false},
    {"m/s", FieldRole::kDoppler, 1.0, false},
    {"mps", FieldRole::kDoppler, 1.0, true},
    {"m/sec", FieldRole::kDoppler, 1.0, false},
    {"ms-1", FieldRole::kDoppler, 1.0, false},
    {"km/h", FieldRole::kDoppler, 1.0 / 3.6, false},
    {"kmh", FieldRole::kDoppler, 1.0 / 3.6, true},
    {"kph", FieldRole::kDoppler, 1.0 / 3.6, true},
    {"cm/s", FieldRole::kDoppler, 1e-2, false},
    {"mm/s", FieldRole::kDoppler, 1e-3, false},
    {"db", FieldRole::kPower, 1.0, true},
    {"dbm", FieldRole::kPower, 1.0, true},
    {"dbsm", FieldRole::kPower, 1.0, true},
    {"s", FieldRole::kTime, 1.0, true},  // of stamps the numbers tell the unit
    {"sec", FieldRole::kTime, 1.0, true},
    {"ms", FieldRole::kTime, 1.0, true},
    {"us", FieldRole::kTime, 1.0, true},
    {"ns", FieldRole::kTime, 1.0, true},
};

// Which of the units' roles a role has.
FieldRole Quantity(FieldRole role) {
  switch (role) {
    case FieldRole::kY:
    case FieldRole::kZ:
    case FieldRole::kRange:
      return FieldRole::kX;
    case FieldRole::kElevation:
      return FieldRole::kAzimuth;
    default:
      return role;
  }
}

// "velocity (km/h)" -> "velocity" and "km/h". Takes lower case.
struct NameAndUnit {
  std::string_view name;
  std::string_view unit;
  bool is_bracketed = false;
};

NameAndUnit SplitUnit(std::string_view text) {
  text = TrimBlanks(text);
  if (text.empty()) return {text, "", false};
  const bool is_bracketed = text.back() == ']' || text.back() == ')';
  const std::size_t begin = is_bracketed ? text.find_last_of("[(") : text.rfind('_');
  if (begin == std::string_view::npos || begin == 0) return {text, "", false};
  std::string_view name = TrimBlanks(text.substr(0, begin));
  if (is_bracketed && !name.empty() && name.back() == '_') name.remove_suffix(1);
  const std::size_t end = text.size() - (is_bracketed ? 1 : 0);
  return {name, TrimBlanks(text.substr(begin + 1, end - begin - 1)), is_bracketed};
}

// The factor of a unit that fits the role. Of powers and times any unit will do: they are not
// compared with anything.
std::optional<double> FactorOf(FieldRole role, const NameAndUnit& name) {
  if (name.unit.empty()) return 1.0;
  for (const Unit& unit : kUnits) {
    if (unit.name == name.unit && unit.role == Quantity(role) &&
        (name.is_bracketed || unit.is_suffix)) {
      return unit.factor;
    }
  }
  const bool is_any = role == FieldRole::kPower || role == FieldRole::kTime;
  return name.is_bracketed && is_any ? std::optional(1.0) : std::nullopt;
}

// The role of a name with a unit behind.
bool HasAliasAndUnit(std::string_view lower_case, const Alias& alias) {
  const NameAndUnit name = SplitUnit(lower_case);
  return name.name == alias.name && FactorOf(alias.role, name);
}

// Lower case, without the "scalar_" that CloudCompare puts in front.
std::string PlainName(std::string_view name) {
  constexpr std::string_view kScalar = "scalar_";
  std::string plain = LowerCase(name);
  if (plain.compare(0, kScalar.size(), kScalar) == 0) plain.erase(0, kScalar.size());
  return plain;
}

int IndexOfAlias(const std::vector<PointField>& fields, const Alias& alias) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (HasAliasAndUnit(PlainName(fields[i].name), alias)) return static_cast<int>(i);
  }
  return -1;
}

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
  const std::string lower_case = PlainName(name);
  for (const Alias& alias : kAliases) {
    if (alias.name == lower_case) return alias.role;
  }
  for (const Alias& alias : kAliases) {
    if (HasAliasAndUnit(lower_case, alias)) return alias.role;
  }
  return std::nullopt;
}

double UnitOfName(FieldRole role, std::string_view name) {
  const std::string lower_case = PlainName(name);
  return FactorOf(role, SplitUnit(lower_case)).value_or(1.0);
}

bool HoldsPoses(const std::vector<PointField>& fields) {
  std::string names = " ";
  for (const PointField& field : fields) {
    std::string name = LowerCase(field.name);
    name.resize(SplitUnit(name).is_bracketed ? SplitUnit(name).name.size() : name.size());
    names += name + " ";
  }
  const auto has_all = [&](std::initializer_list<std::string_view> wanted) {
    return std::all_of(wanted.begin(), wanted.end(), [&](std::string_view name) {
      return names.find(" " + std::string(name) + " ") != std::string::npos;
    });
  };
  return has_all({"qx", "qy", "qz", "qw"}) || has_all({"q_x", "q_y", "q_z", "q_w"}) ||
         has_all({"roll", "pitch", "yaw"}) || has_all({"latitude", "longitude"}) ||
         has_all({"lat", "lon"}) || has_all({"ax", "ay", "az", "wx"}) ||
         has_all({"acc_x", "gyro_x"}) || has_all({"ax", "gx"});
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
  for (const Alias& alias : kAliases) {
    if (!match.Has(alias.role)) match.Set(alias.role, IndexOfAlias(fields, alias));
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
