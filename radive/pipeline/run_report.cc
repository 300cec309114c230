// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/run_report.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

#include "radive/util/json.h"
#include "radive/util/process_usage.h"

namespace radive {
namespace {

constexpr std::size_t kMaxRemarks = 50;  // warnings, notes, and different reasons in run.json

struct ToJsonValue {
  Json operator()(const double* value) const { return *value; }
  Json operator()(const int* value) const { return *value; }
  Json operator()(const bool* value) const { return *value; }
  Json operator()(const std::string* value) const { return *value; }
  Json operator()(const std::vector<double>* value) const { return *value; }
  Json operator()(const OptionField::Choice& value) const {
    return value.names[static_cast<std::size_t>(value.get())];
  }
};

Json ConfigJson(RunConfig config) {
  Json json = Json::object();
  for (const auto& [stage, fields] : config.Stages()) {
    for (const OptionField& field : fields) {
      json[stage][field.name] = std::visit(ToJsonValue(), field.value);
    }
  }
  return json;
}

// The smallest time that at least 95 % of the scans do not exceed.
double Percentile95(std::vector<float> times) {
  if (times.empty()) return 0.0;
  const auto rank =
      static_cast<std::ptrdiff_t>(std::ceil(0.95 * static_cast<double>(times.size()))) - 1;
  std::nth_element(times.begin(), times.begin() + rank, times.end());
  return static_cast<double>(times[static_cast<std::size_t>(rank)]);
}

// "12 returns left" and "13 returns left" are one reason.
std::string WithoutNumbers(std::string text) {
  const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
  text.erase(std::remove_if(text.begin(), text.end(), is_digit), text.end());
  return text;
}

}  // namespace

void RunReport::AddScan(const OdometryResult& result, double read_ms, const std::string& place) {
  using Status = OdometryResult::Status;
  const std::string status = ToString(result.status);
  ++statuses_[status];
  // The scan that starts the submap is registered with nothing.
  const bool is_located = result.status == Status::kStanding ||
                          (result.status == Status::kRegistered && result.num_pairs > 0);
  if (is_located) {
    ++num_located_;
  } else if (!result.reason.empty()) {
    FirstReason& kind = kinds_[WithoutNumbers(result.reason)];
    if (kind.count++ == 0) {
      kind.text = result.reason;
      kind.place = place;
    }
  }
  if (!result.reason.empty()) {
    std::map<std::string, int>& reasons = reasons_[status];
    const bool is_new = reasons.find(result.reason) == reasons.end();
    if (is_new) ++num_reasons_;
    ++reasons[is_new && num_reasons_ > kMaxRemarks ? "other reasons, see scans.csv"
                                                   : result.reason];
  }
  odometry_ms_.push_back(static_cast<float>(result.times_ms.total));
  read_ms_ += read_ms;
}

void RunReport::AddWarning(const std::string& warning) {
  ++num_warnings_;
  if (warnings_.size() < kMaxRemarks) warnings_.push_back(warning);
}

void RunReport::AddNote(const std::string& note) {
  if (notes_.size() < kMaxRemarks) notes_.push_back(note);
}

int RunReport::num_with_status(OdometryResult::Status status) const {
  const auto found = statuses_.find(ToString(status));
  return found == statuses_.end() ? 0 : found->second;
}

std::string RunReport::WhyNoResult() const {
  const bool is_one_scan =
      num_scans() == 1 && num_with_status(OdometryResult::Status::kRegistered) == 1;
  if (num_located_ > 0 || is_one_scan) return "";
  std::string text = num_scans() == 0 ? "there are no scans"
                                      : "none of " + std::to_string(num_scans()) +
                                            " scans was registered or found standing";
  const FirstReason* commonest = nullptr;
  for (const auto& [key, kind] : kinds_) {
    if (commonest == nullptr || kind.count > commonest->count) commonest = &kind;
  }
  if (commonest != nullptr) {
    text += "; most often (" + std::to_string(commonest->count) + " scans): " + commonest->text;
    if (!commonest->place.empty()) text += ", first in " + commonest->place;
  }
  if (!warnings_.empty()) text += "; first warning: " + warnings_.front();
  return text;
}

std::string RunReport::ToJson(const RunConfig& config, const Facts& facts) const {
  const double num_scans_or_one = std::max(1, num_scans());
  Json json;
  json["version"] = facts.version;
  json["command_line"] = facts.command_line;
  json["input"] = facts.input;
  json["source"] = facts.source;
  json["start"] = facts.start;
  json["max_frames"] = facts.max_frames ? Json(*facts.max_frames) : Json();
  json["frames"] = num_scans();
  const Eigen::Vector3d& t = facts.T_frame_reference.translation;
  const Eigen::Quaterniond& q = facts.T_frame_reference.rotation;
  json["trajectory"] = {{"frame", ConfigJson(config)["output"]["frame"]},
                        {"T_frame_reference", {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}}};
  json["interrupted"] = facts.interrupted;
  json["error"] = facts.error;
  for (const auto status : {OdometryResult::Status::kRegistered,
                            OdometryResult::Status::kPredicted,
                            OdometryResult::Status::kStanding,
                            OdometryResult::Status::kSkipped}) {
    json["status"][ToString(status)] = num_with_status(status);
  }
  json["reasons"] = reasons_;
  json["notes"] = notes_;
  json["num_warnings"] = num_warnings_;
  json["warnings"] = warnings_;
  json["mean_ms_per_frame"] =
      std::accumulate(odometry_ms_.begin(), odometry_ms_.end(), 0.0) / num_scans_or_one;
  json["p95_ms_per_frame"] = Percentile95(odometry_ms_);
  json["mean_read_ms_per_frame"] = read_ms_ / num_scans_or_one;
  json["wall_seconds"] = facts.wall_seconds;
  json["cpu_seconds"] = CpuSeconds();
  json["peak_memory_mb"] = PeakMemoryMegabytes();
  json["num_threads"] = config.odometry.num_threads;
  json["configuration"] = ConfigJson(config);
  return JsonText(json);
}

}  // namespace radive
