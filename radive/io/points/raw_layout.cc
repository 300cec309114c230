// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/raw_layout.h"

#include <glog/logging.h>

#include <array>
#include <string_view>
#include <utility>

#include "radive/io/bytes/text_lines.h"
#include "radive/io/points/field_matching.h"

namespace radive {
namespace {

constexpr std::pair<std::string_view, std::string_view> kNamedLayouts[] = {
    {"xyz3", "x,y,z"},
    {"xyzdp5", "x,y,z,doppler,power"},
    {"vod7", "x,y,z,RCS,v_r,v_r_compensated,time"},
    {"tj4d8", "x,y,z,v_r,range,power,alpha,beta"},
    {"mscrad17",
     "x,y,z,_,_,_,_,alpha,beta,range,doppler,power,recoveredSpeed,dotFlags,denoiseFlag,_,_"},
    {"coloradar5", "x,y,z,intensity,doppler"},
    {"dualradar5", "x,y,z,rcs,v_r"},
    {"dicp4", "x,y,z,doppler"},
    {"kitti4", "x,y,z,intensity"},
    {"hercules29", "x,y,z,v,r,RCS:int8,azimuth,elevation"},
    {"aeva29", "x,y,z,reflectivity,velocity,time_offset_ns:int32,line_index:uint8,intensity"},
    {"aeva", "x,y,z,reflectivity,velocity,time_offset_ns:int32,line_index:uint8,intensity"},
    {"aeva25", "x,y,z,reflectivity,velocity,time_offset_ns:int32,line_index:uint8"},
    {"boreas_aeva40", "x,y,z,v,intensity,signal_quality,reflectivity,time,point_flags:uint64"},
    {"boreas_aeva7", "x,y,z,intensity,doppler,laser_number,time"},
};

std::string NamesOfLayouts() {
  std::string names;
  for (const std::string& name : RawLayoutNames()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

// "rcs:int8" -> the name and the type; none for an unknown type.
std::optional<PointField> ParseColumn(std::string_view text) {
  PointField field;
  const std::size_t colon = text.find(':');
  field.name = TrimBlanks(text.substr(0, colon));
  if (colon == std::string_view::npos) return field;
  const std::string type = LowerCase(TrimBlanks(text.substr(colon + 1)));
  for (int i = 0; i <= static_cast<int>(NumericType::kFloat64); ++i) {
    field.type = static_cast<NumericType>(i);
    if (type == NameOf(field.type)) return field;
  }
  return std::nullopt;
}

// Says why the user's column cannot be taken after those that are there; empty: it can.
std::string Objection(const PointField& field, const std::vector<PointField>& before) {
  const std::optional<FieldRole> role = RoleOfName(field.name);
  if (!role) {
    return "expected " + NamesOfLayouts() + ", or a list of the columns x, y, z, doppler, power " +
           "and _ (to ignore one), found " + Quoted(field.name);
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (RoleOfName(before[i].name) == role) {
      return "column " + Quoted(field.name) + " says the same as column " + Quoted(before[i].name) +
             "; call one of them _ to ignore it";
    }
  }
  return "";
}

// `allow_any`: columns may have names that say nothing.
std::optional<RawLayout> ParseColumns(const std::string& text, bool allow_any, std::string* error) {
  RawLayout layout;
  layout.name = text;
  std::string_view columns = TrimBlanks(text);
  bool is_named = false;
  const std::string lower_case = LowerCase(columns);
  for (const auto& [name, expansion] : kNamedLayouts) {
    if (lower_case != name) continue;
    columns = expansion;
    is_named = true;
  }
  if (columns.size() >= 2 && columns.front() == '[' && columns.back() == ']') {
    columns = columns.substr(1, columns.size() - 2);
  }
  const std::string where = "layout " + Quoted(text);
  for (std::string_view rest = columns;;) {
    const std::size_t comma = rest.find(',');
    const std::string_view column = TrimBlanks(rest.substr(0, comma));
    std::optional<PointField> field = ParseColumn(column);
    if (!field) {
      *error =
          where + ": expected a type like int8 or float64 after the colon, found " + Quoted(column);
      return std::nullopt;
    }
    field->offset = layout.record_size;
    layout.record_size += SizeOf(field->type);
    if (field->name != "_") {
      const std::string objection = is_named || allow_any ? "" : Objection(*field, layout.fields);
      if (!objection.empty()) {
        *error = where + ": " + objection;
        return std::nullopt;
      }
      layout.fields.push_back(*std::move(field));
    }
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  std::string reason;
  if (!MatchFields(layout.fields, {}, &reason)) {
    *error = where + ": must have the columns x and y, or range and azimuth";
    return std::nullopt;
  }
  return layout;
}

}  // namespace

RawLayout KnownLayout(const std::string& text) {
  std::string error;
  std::optional<RawLayout> layout = ParseColumns(text, /*allow_any=*/true, &error);
  CHECK(layout) << "input options were not checked: " << error;
  return *std::move(layout);
}

std::vector<std::string> LayoutsOfSize(std::size_t size) {
  std::vector<std::string> names;
  for (const std::string& name : RawLayoutNames()) {
    if (size > 0 && size % KnownLayout(name).record_size == 0) names.push_back(name);
  }
  return names;
}

const std::vector<std::string>& RawLayoutNames() {
  static const std::vector<std::string>* const names = [] {
    auto* const list = new std::vector<std::string>();
    for (const auto& layout : kNamedLayouts) list->emplace_back(layout.first);
    return list;
  }();
  return *names;
}

std::optional<RawLayout> ParseRawLayout(const std::string& text, std::string* error) {
  return ParseColumns(text, /*allow_any=*/false, error);
}

}  // namespace radive
