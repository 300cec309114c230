// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/radarscenes_hdf5.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <system_error>
#include <utility>

#include "radive/geometry/roll_pitch_yaw.h"
#include "radive/io/bytes/byte_order.h"
#include "radive/io/scans/scan_stamps.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr char kDetections[] = "radar_data";
constexpr std::uint64_t kRowsAtOnce = 65536;
constexpr double kLatest = 9e15;  // [us]: 285 years, exact in a double

enum Column { kTime, kSensor, kRange, kAzimuth, kDoppler, kPower, kNumColumns };

std::unique_ptr<Hdf5Table> OpenDetections(const fs::path& file, std::string* error) {
  return Hdf5Table::Open(
      file, kDetections, {"timestamp", "sensor_id", "range_sc", "azimuth_sc", "vr", "rcs"}, error);
}

// Calls `visit` with time [us], sensor and number of each row. False when a row cannot be read.
template <typename Visit>
bool VisitRows(const Hdf5Table& table, const Visit& visit) {
  std::vector<double> values;
  for (std::uint64_t first = 0; first < table.num_rows(); first += kRowsAtOnce) {
    const std::uint64_t count = std::min(kRowsAtOnce, table.num_rows() - first);
    if (!table.Read(first, count, &values)) return false;
    for (std::uint64_t i = 0; i < count; ++i) {
      const double* const row = values.data() + i * kNumColumns;
      visit(row[kTime], row[kSensor], first + i);
    }
  }
  return true;
}

bool IsStamp(double microseconds) { return std::abs(microseconds) < kLatest; }

// Looks for rows of a radar that are not in the order of time, or not with the rest of their scan.
class RowOrder {
 public:
  explicit RowOrder(int radar) : radar_(radar) {}

  void Add(double time, std::optional<int> sensor, std::uint64_t row) {
    const bool begins_scan = time != time_ || sensor != sensor_;
    const bool is_ours = sensor == radar_ || sensor_ == radar_;
    const bool shares_time = time == time_ && sensor != sensor_ && is_ours;
    const bool is_again = begins_scan && sensor == radar_ && !times_.insert(time).second;
    if (!sensor || !IsStamp(time) || !(time >= time_) || shares_time || is_again) {
      if (num_odd_++ == 0) first_odd_ = row;
    }
    time_ = time;
    sensor_ = sensor;
  }

  // Empty: there are none.
  std::string Warning() const {
    if (num_odd_ == 0) return "";
    return std::to_string(num_odd_) +
           " rows are not in the order of time, lie apart from the rest of their scan or are of no "
           "radar or time, the first is row " +
           std::to_string(first_odd_) + "; scans may be lost, or split";
  }

 private:
  const int radar_;
  double time_ = -HUGE_VAL;  // of the row before
  std::optional<int> sensor_ = -1;
  std::set<double> times_;  // of the scans
  std::uint64_t num_odd_ = 0;
  std::uint64_t first_odd_ = 0;
};

// NaN and hostile numbers are no sensor.
std::optional<int> SensorOf(double number) {
  if (!(number >= 0.0 && number <= 999.0) || number != std::floor(number)) return std::nullopt;
  return static_cast<int>(number);
}

std::string NamesOf(const std::vector<int>& radars) {
  std::string names;
  for (const int radar : radars) names += (names.empty() ? "" : ", ") + std::to_string(radar);
  return names.empty() ? "none" : names;
}

}  // namespace

std::optional<fs::path> FindRadarScenesHdf5(const fs::path& path, const std::string& folder) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) {
    std::string start(4, '\0');
    std::ifstream(path, std::ios::binary).read(start.data(), 4);
    return start == "\x89HDF" ? std::make_optional(path) : std::nullopt;
  }
  const fs::path file = path / folder / "radar_data.h5";
  return fs::is_regular_file(file, ignored) ? std::make_optional(file) : std::nullopt;
}

RadarScenesHdf5Source::RadarScenesHdf5Source(std::unique_ptr<Hdf5Table> table,
                                             fs::path file,
                                             int radar,
                                             const InputOptions& options)
    : table_(std::move(table)), file_(std::move(file)), radar_(radar), converter_(options) {
  for (const char* name : {"range", "azimuth", "vr", "rcs"}) {
    rows_.AddField(name, NumericType::kFloat64);
  }
}

std::unique_ptr<RadarScenesHdf5Source> RadarScenesHdf5Source::Open(const fs::path& file,
                                                                   const InputOptions& options,
                                                                   std::string* error) {
  const std::optional<std::int64_t> radar = ParseInteger(options.radar);
  CHECK(radar) << "input options were not checked: radar " << options.radar;
  std::unique_ptr<Hdf5Table> table = OpenDetections(file, error);
  if (table == nullptr) return nullptr;
  std::unique_ptr<RadarScenesHdf5Source> source(
      new RadarScenesHdf5Source(std::move(table), file, static_cast<int>(*radar), options));
  std::vector<int> radars;
  if (!source->FindScans(&radars, error)) return nullptr;
  if (!source->scans_.empty()) return source;
  *error = file.string() + ": has no detections of radar " + options.radar +
           " (input.radar); radars found in it: " + NamesOf(radars);
  return nullptr;
}

bool RadarScenesHdf5Source::FindScans(std::vector<int>* radars, std::string* error) {
  std::set<int> found;
  bool has_stamps = true;
  RowOrder order(radar_);
  const bool is_read = VisitRows(*table_, [&](double time, double sensor, std::uint64_t row) {
    const std::optional<int> radar = SensorOf(sensor);
    order.Add(time, radar, row);
    if (!radar) return;
    found.insert(*radar);
    if (*radar != radar_) return;
    has_stamps = has_stamps && IsStamp(time);
    if (!has_stamps) return;
    const std::int64_t stamp_ns = static_cast<std::int64_t>(time) * 1000;
    if (!scans_.empty() && scans_.back().stamp_ns == stamp_ns &&
        scans_.back().first_point + scans_.back().num_points == row) {
      ++scans_.back().num_points;
    } else {
      scans_.push_back({stamp_ns, row, 1, 0});
    }
  });
  radars->assign(found.begin(), found.end());
  if (is_read && has_stamps) {
    const std::string doubt = order.Warning();
    if (!doubt.empty())
      warnings_.push_back(file_.string() + ": data set " + kDetections + ": " + doubt);
    CompareWithOdometry();
    return true;
  }
  *error = file_.string() + ": data set " + kDetections +
           (is_read ? ": expected microseconds in timestamp" : " cannot be read");
  return false;
}

// A table that has lost its end is whole in itself, but not beside the odometry.
void RadarScenesHdf5Source::CompareWithOdometry() {
  constexpr double kMostMissing = 1.0;  // [s]
  if (scans_.empty()) return;
  std::string error;
  const auto poses = ReadRadarScenesOdometry(file_, &error);
  if (!poses) {
    warnings_.push_back(error + "; without it nothing tells whether scans are lost");
    return;
  }
  const double late_start = StampSeconds(scans_.front().stamp_ns) - poses->front().stamp_s;
  const double early_end = poses->back().stamp_s - StampSeconds(scans_.back().stamp_ns);
  if (late_start <= kMostMissing && early_end <= kMostMissing) return;
  const auto seconds = [](double t) { return FormatText("%.3g s", std::max(0.0, t)); };
  warnings_.push_back(file_.string() + ": the detections of radar " + std::to_string(radar_) +
                      " begin " + seconds(late_start) + " after the odometry and end " +
                      seconds(early_end) + " before it; scans may be lost");
}

ScanSource::Status RadarScenesHdf5Source::PassOver(RadarScan* scan) {
  if (next_ == scans_.size()) return Status::kEnd;
  const RadarScenesScan& entry = scans_[next_++];
  scan->stamp_ns = entry.stamp_ns;
  scan->radar = radar_;
  scan->has_doppler = true;
  scan->is_planar = true;
  scan->returns.clear();
  scan->place = file_.string() + ": rows from " + std::to_string(entry.first_point);
  return Status::kScan;
}

ScanSource::Status RadarScenesHdf5Source::Next(RadarScan* scan) {
  if (PassOver(scan) == Status::kEnd) return Status::kEnd;
  const RadarScenesScan& entry = scans_[next_ - 1];
  std::vector<double> values;
  if (!table_->Read(entry.first_point, entry.num_points, &values)) {
    error_ = scan->place + " can no longer be read";
    return Status::kError;
  }
  std::string records;
  for (std::size_t i = 0; i < entry.num_points; ++i) {
    for (const Column column : {kRange, kAzimuth, kDoppler, kPower}) {
      AppendLittleEndian(values[i * kNumColumns + column], &records);
    }
  }
  rows_.owned.assign(records.begin(), records.end());
  rows_.data = rows_.owned.data();
  rows_.num_points = static_cast<std::size_t>(entry.num_points);
  std::string reason;
  if (converter_.Convert(rows_, scan, &reason)) return Status::kScan;
  error_ = scan->place + ": " + reason;
  return Status::kError;
}

std::string RadarScenesHdf5Source::Description() const {
  return "RadarScenes radar " + std::to_string(radar_) + ", " + std::to_string(scans_.size()) +
         " scans in " + file_.string();
}

SourceFacts RadarScenesHdf5Source::Facts() const {
  SourceFacts facts;
  facts.format = "RadarScenes radar " + std::to_string(radar_) + " (HDF5)";
  facts.place = file_.string();
  facts.stamp_origin = "timestamp";
  facts.fields = converter_.Summaries();
  for (const RadarScenesScan& scan : scans_) facts.stamps_ns.push_back(scan.stamp_ns);
  return facts;
}

std::optional<std::vector<int>> RadarsOfRadarScenesHdf5(const fs::path& file, std::string* error) {
  const std::unique_ptr<Hdf5Table> table = OpenDetections(file, error);
  if (table == nullptr) return std::nullopt;
  std::set<int> found;
  if (!VisitRows(*table, [&](double, double sensor, std::uint64_t) {
        if (const std::optional<int> radar = SensorOf(sensor)) found.insert(*radar);
      })) {
    *error = file.string() + ": data set " + kDetections + " cannot be read";
    return std::nullopt;
  }
  return std::vector<int>(found.begin(), found.end());
}

std::optional<RecordedTrajectory> ReadRadarScenesOdometry(const fs::path& file,
                                                          std::string* error) {
  const auto table =
      Hdf5Table::Open(file, "odometry", {"timestamp", "x_seq", "y_seq", "yaw_seq"}, error);
  std::vector<double> values;
  if (table == nullptr) return std::nullopt;
  if (table->num_rows() == 0 || !table->Read(0, table->num_rows(), &values)) {
    *error = file.string() + ": data set odometry holds no poses";
    return std::nullopt;
  }
  RecordedTrajectory poses;
  for (std::size_t i = 0; i < values.size(); i += 4) {
    if (!IsStamp(values[i]) || !std::isfinite(values[i + 1] + values[i + 2] + values[i + 3])) {
      *error = file.string() + ": data set odometry, row " + std::to_string(i / 4) +
               ": expected finite numbers";
      return std::nullopt;
    }
    const std::int64_t stamp_ns = static_cast<std::int64_t>(values[i]) * 1000;
    poses.push_back({stamp_ns,
                     StampSeconds(stamp_ns),
                     MatrixPose(RotationFromRollPitchYaw(0, 0, values[i + 3]).toRotationMatrix(),
                                {values[i + 1], values[i + 2], 0.0})});
  }
  return poses;
}

}  // namespace radive
