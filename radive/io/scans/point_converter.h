// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/io/points/field_matching.h"
#include "radive/io/points/point_table.h"
#include "radive/io/scans/input_options.h"
#include "radive/io/scans/source_facts.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

// Makes the returns of scans out of point tables, for all sources alike: finds the fields by name
// once (input.fields wins), converts every numeric type to double, polar points to x, y, z, and
// turns the Doppler by input.doppler_sign where that is fixed. Values that are no numbers are
// passed on.
class PointConverter {
 public:
  // `options` must be valid.
  explicit PointConverter(const InputOptions& options);

  // Sets has_doppler, is_planar and the returns of `scan`. False, with the fields in `error`, when
  // the table has no positions or a field reaches beyond the record; the scan is then empty.
  bool Convert(const PointTable& table, RadarScan* scan, std::string* error);

  // The fields of the last table and their values in the first kScansLookedAt tables.
  std::vector<FieldSummary> Summaries() const { return summaries_; }

  // Fields of the last table.
  const FieldMatch& match() const { return match_; }

 private:
  static constexpr int kScansLookedAt = 10;

  bool Match(const PointTable& table, std::string* error);
  // Where several names are those of Doppler: not the field that holds bins.
  void ChooseDoppler(const PointTable& table);
  void LookAt(const PointTable& table);

  const FieldChoices choices_;
  const double doppler_sign_;
  const bool planar_;
  bool has_matched_ = false;
  std::vector<PointField> fields_;  // that `match_` is for
  FieldMatch match_;
  bool has_chosen_doppler_ = false;
  int num_looked_at_ = 0;
  std::vector<FieldSummary> summaries_;
};

}  // namespace radive
