// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/run_record.h"

#include <tuple>

#include "radive/util/json.h"

namespace radive {
namespace {

// Both directions of the mapping visit the fields in this one place.
template <typename Record, typename Visit>
void VisitFields(Record& record, const Visit& visit) {
  visit("sequence", record.sequence);
  visit("variant", record.variant);
  visit("seed", record.seed);
  visit("status", record.status);
  visit("message", record.message);
  visit("ate_t", record.scores.ate_t);
  visit("ate_r", record.scores.ate_r);
  visit("rpe_t", record.scores.rpe_t);
  visit("rpe_r", record.scores.rpe_r);
  visit("drift_t", record.scores.drift_t);
  visit("drift_r", record.scores.drift_r);
  visit("scans", record.scans);
  visit("registered", record.registered);
  visit("path_length", record.scores.path_length);
  visit("warnings", record.warnings);
  visit("input_hash", record.input_hash);
  visit("config_hash", record.config_hash);
  visit("program_hash", record.program_hash);
}

template <typename Timing, typename Visit>
void VisitTiming(Timing& timing, const Visit& visit) {
  visit("wall_s", timing.wall_s);
  visit("cpu_s", timing.cpu_s);
  visit("ms_per_scan_median", timing.ms_per_scan_median);
  visit("ms_per_scan_p95", timing.ms_per_scan_p95);
  visit("max_rss_mb", timing.max_rss_mb);
}

struct JsonWriter {
  Json* json;
  template <typename Value>
  void operator()(const char* name, const Value& value) const {
    (*json)[name] = value;
  }
  template <typename Value>
  void operator()(const char* name, const std::optional<Value>& value) const {
    (*json)[name] = value ? Json(*value) : Json();
  }
};

// Throws what Json throws for a missing key or a wrong type.
struct JsonReader {
  const Json* json;
  template <typename Value>
  void operator()(const char* name, Value& value) const {
    value = json->at(name).get<Value>();
  }
  template <typename Value>
  void operator()(const char* name, std::optional<Value>& value) const {
    const auto entry = json->find(name);
    const bool has_value = entry != json->end() && !entry->is_null();
    value = has_value ? std::optional<Value>(entry->get<Value>()) : std::nullopt;
  }
};

}  // namespace

bool RunRecord::HasHashesOf(const RunRecord& other) const {
  return input_hash == other.input_hash && config_hash == other.config_hash &&
         program_hash == other.program_hash;
}

bool operator<(const RunRecord& a, const RunRecord& b) {
  return std::tie(a.sequence, a.variant, a.seed) < std::tie(b.sequence, b.variant, b.seed);
}

Json RunRecordToJson(const RunRecord& record) {
  Json json = Json::object();
  VisitFields(record, JsonWriter{&json});
  Json timing = Json::object();
  VisitTiming(record.timing, JsonWriter{&timing});
  json["timing"] = timing;
  return json;
}

std::optional<RunRecord> RunRecordFromJson(const Json& json) {
  RunRecord record;
  try {
    VisitFields(record, JsonReader{&json});
    VisitTiming(record.timing, JsonReader{&json.at("timing")});
  } catch (const Json::exception&) {
    return std::nullopt;
  }
  return record;
}

}  // namespace radive
