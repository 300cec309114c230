// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/point_converter.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "radive/io/bytes/byte_order.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

FieldChoices ChoicesOf(const InputOptions& options) {
  std::string error;
  std::optional<FieldChoices> choices = ParseFieldChoices(options.fields, &error);
  CHECK(choices) << "input options were not checked: " << error;
  return *std::move(choices);
}

bool SameFields(const std::vector<PointField>& a, const std::vector<PointField>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(), [](const PointField& one, const PointField& other) {
        return one.offset == other.offset && one.type == other.type && one.count == other.count &&
               one.name == other.name;
      });
}

// How to read the fields of a role out of a record; the number is NaN when there is none.
struct AnyNumber {
  const PointField* field = nullptr;
  bool is_big_endian = false;
  double unit = 1.0;

  double operator()(const char* record) const {
    if (field == nullptr) return std::numeric_limits<double>::quiet_NaN();
    return unit * ReadNumber(record + field->offset, field->type, is_big_endian);
  }
};

// The same for little-endian float32, as nearly all data are: an unaligned load.
struct Float32Number {
  bool is_there = false;
  std::size_t offset = 0;

  double operator()(const char* record) const {
    if (!is_there) return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(NumberAt<float>(record + offset));
  }
};

template <typename Number>
struct Readers {
  Number x, y, z, doppler, power;
};

template <typename Number>
void ReadCartesian(const PointTable& table,
                   const Readers<Number>& read,
                   bool planar,
                   double doppler_sign,
                   std::vector<RadarReturn>* returns) {
  returns->resize(table.num_points);
  const char* record = table.data;
  for (RadarReturn& ret : *returns) {
    ret.position.x() = read.x(record);
    ret.position.y() = read.y(record);
    ret.position.z() = planar ? 0.0 : read.z(record);
    ret.doppler = doppler_sign * read.doppler(record);
    ret.power = read.power(record);
    record += table.stride;
  }
}

AnyNumber AnyReader(const PointTable& table, const FieldMatch& match, FieldRole role) {
  if (!match.Has(role)) return {};
  const PointField& field = table.fields[static_cast<std::size_t>(match[role])];
  return {&field, table.is_big_endian, UnitOfName(role, field.name)};
}

Float32Number Float32Reader(const PointTable& table, const FieldMatch& match, FieldRole role) {
  if (!match.Has(role)) return {};
  return {true, table.fields[static_cast<std::size_t>(match[role])].offset};
}

// False, with the reason in `error`, when the angles are no radians.
bool ReadPolar(const PointTable& table,
               const FieldMatch& match,
               bool planar,
               double doppler_sign,
               std::vector<RadarReturn>* returns,
               std::string* error) {
  constexpr double kLargestAngle = 6.4;    // a turn, rounded up [rad]
  constexpr std::size_t kShareBeyond = 4;  // one in so many: single ones stand for "invalid"
  std::size_t num_beyond = 0;
  double largest = 0.0;  // [rad]
  const auto reader = [&](FieldRole role) { return AnyReader(table, match, role); };
  const AnyNumber range_of = reader(FieldRole::kRange);
  const AnyNumber azimuth_of = reader(FieldRole::kAzimuth);
  const AnyNumber elevation_of = reader(FieldRole::kElevation);
  const AnyNumber doppler_of = reader(FieldRole::kDoppler);
  const AnyNumber power_of = reader(FieldRole::kPower);
  returns->resize(table.num_points);
  const char* record = table.data;
  for (RadarReturn& ret : *returns) {
    const double range = range_of(record);
    const double azimuth = azimuth_of(record);
    const double elevation = planar ? 0.0 : elevation_of(record);
    if (std::abs(azimuth) > kLargestAngle) {
      ++num_beyond;
      largest = std::max(largest, std::abs(azimuth));
    }
    const double horizontal = planar ? range : range * std::cos(elevation);
    ret.position = {horizontal * std::cos(azimuth),
                    horizontal * std::sin(azimuth),
                    planar ? 0.0 : range * std::sin(elevation)};
    ret.doppler = doppler_sign * doppler_of(record);
    ret.power = power_of(record);
    record += table.stride;
  }
  if (num_beyond * kShareBeyond <= table.num_points) return true;
  *error = FormatText("the azimuths go up to %.4g: degrees? Expected radians in ", largest) +
           Quoted(table.fields[static_cast<std::size_t>(match[FieldRole::kAzimuth])].name) +
           ", or the unit in its name (azimuth_deg)";
  returns->clear();
  return false;
}

template <typename Number, typename MakeReader>
Readers<Number> CartesianReaders(const PointTable& table,
                                 const FieldMatch& match,
                                 const MakeReader& make) {
  return {make(table, match, FieldRole::kX),
          make(table, match, FieldRole::kY),
          make(table, match, FieldRole::kZ),
          make(table, match, FieldRole::kDoppler),
          make(table, match, FieldRole::kPower)};
}

// Numbers of bins are whole, and so are the zeros of a field that is not in use; speeds have
// fractions.
bool HasFractions(const PointTable& table, int index) {
  const PointField& field = table.fields[static_cast<std::size_t>(index)];
  if (field.count == 0) return false;
  const AnyNumber value_of = {&field, table.is_big_endian};
  for (std::size_t k = 0; k < table.num_points; ++k) {
    const double value = value_of(table.data + k * table.stride);
    if (std::isfinite(value) && value != std::round(value)) return true;
  }
  return false;
}

bool UsesOnlyFloat32(const PointTable& table, const FieldMatch& match) {
  if (table.is_big_endian) return false;
  for (const FieldRole role :
       {FieldRole::kX, FieldRole::kY, FieldRole::kZ, FieldRole::kDoppler, FieldRole::kPower}) {
    const int index = match[role];
    if (index < 0) continue;
    const PointField& field = table.fields[static_cast<std::size_t>(index)];
    if (field.type != NumericType::kFloat32 || UnitOfName(role, field.name) != 1.0) return false;
  }
  return true;
}

}  // namespace

PointConverter::PointConverter(const InputOptions& options)
    : choices_(ChoicesOf(options)),
      doppler_sign_(options.FixedDopplerSign()),
      planar_(options.planar) {}

bool PointConverter::Match(const PointTable& table, std::string* error) {
  if (!table.CheckFields(error)) return false;
  const bool is_known = has_matched_ && SameFields(fields_, table.fields);
  if (is_known && (has_chosen_doppler_ || table.num_points == 0)) return true;
  has_matched_ = false;
  const std::optional<FieldMatch> match = MatchFields(table.fields, choices_, error);
  if (!match) return false;
  match_ = *match;
  fields_ = table.fields;
  has_matched_ = true;
  has_chosen_doppler_ = table.num_points > 0;
  ChooseDoppler(table);
  summaries_.clear();
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    FieldSummary& summary = summaries_.emplace_back();
    summary.name = fields_[i].name;
    summary.type = NameOf(fields_[i].type);
    summary.role = match_.RoleOf(static_cast<int>(i));
    summary.min = std::numeric_limits<double>::infinity();
    summary.max = -summary.min;
  }
  return true;
}

void PointConverter::ChooseDoppler(const PointTable& table) {
  const int by_name = match_[FieldRole::kDoppler];
  const bool is_given = std::any_of(choices_.begin(), choices_.end(), [](const auto& choice) {
    return choice.first == FieldRole::kDoppler;
  });
  if (by_name < 0 || is_given || HasFractions(table, by_name)) return;
  for (int i = 0; i < static_cast<int>(table.fields.size()); ++i) {
    const bool is_doppler = RoleOfName(table.fields[static_cast<std::size_t>(i)].name) ==
                            std::optional(FieldRole::kDoppler);
    if (!is_doppler || !HasFractions(table, i)) continue;
    match_.Set(FieldRole::kDoppler, i);
    return;
  }
}

void PointConverter::LookAt(const PointTable& table) {
  if (num_looked_at_ == kScansLookedAt) return;
  ++num_looked_at_;
  for (std::size_t i = 0; i < table.fields.size(); ++i) {
    const AnyNumber value_of = {&table.fields[i], table.is_big_endian};
    if (table.fields[i].count == 0) continue;
    FieldSummary& summary = summaries_[i];
    for (std::size_t k = 0; k < table.num_points; ++k) {
      const double value = value_of(table.data + k * table.stride);
      ++summary.num_values;
      if (!std::isfinite(value)) {
        ++summary.num_not_finite;
        continue;
      }
      summary.min = std::min(summary.min, value);
      summary.max = std::max(summary.max, value);
    }
  }
}

bool PointConverter::Convert(const PointTable& table, RadarScan* scan, std::string* error) {
  scan->returns.clear();
  scan->has_doppler = false;
  scan->is_planar = false;
  if (!Match(table, error)) return false;
  LookAt(table);
  const bool is_cartesian = match_.Has(FieldRole::kX) && match_.Has(FieldRole::kY);
  const FieldRole height = is_cartesian ? FieldRole::kZ : FieldRole::kElevation;
  scan->has_doppler = match_.Has(FieldRole::kDoppler);
  scan->is_planar = planar_ || !match_.Has(height);
  if (!is_cartesian) {
    return ReadPolar(table, match_, scan->is_planar, doppler_sign_, &scan->returns, error);
  } else if (UsesOnlyFloat32(table, match_)) {
    const auto readers = CartesianReaders<Float32Number>(table, match_, Float32Reader);
    ReadCartesian(table, readers, scan->is_planar, doppler_sign_, &scan->returns);
  } else {
    const auto readers = CartesianReaders<AnyNumber>(table, match_, AnyReader);
    ReadCartesian(table, readers, scan->is_planar, doppler_sign_, &scan->returns);
  }
  return true;
}

}  // namespace radive
