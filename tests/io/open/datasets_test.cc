// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Every row of the datasets: what it names is there, and what it says of folders, records and
// ground truth holds for a drive of its form.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "radive/io/datasets/dataset.h"
#include "radive/io/open/all_radars.h"
#include "radive/io/open/detect_format.h"
#include "radive/io/open/open_scan_source.h"
#include "radive/io/open/open_scan_writer.h"
#include "radive/io/open/read_reference.h"
#include "radive/io/points/raw_layout.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using testing::TempFolder;
using ReferenceFormat = ReferenceOptions::Format;

// Four returns a scan, so that records can prove their layout.
std::vector<RadarScan> ShortDrive() {
  std::vector<RadarScan> scans(3);
  for (std::size_t k = 0; k < scans.size(); ++k) {
    scans[k].stamp_ns = 1700000000000000000 + static_cast<std::int64_t>(k) * 100000000;
    for (int i = 0; i < 4; ++i) {
      RadarReturn& ret = scans[k].returns.emplace_back();
      ret.position = {10.0 + i, 2.0 - i, 0.5};
      ret.doppler = -3.0 + i;
      ret.power = 10.0 + i;
    }
  }
  return scans;
}

// The smallest files of ground truth of that form, the first of which is called `name`; the
// position at the end is (1, 2).
void WriteTruth(const TempFolder& folder, const std::string& name, ReferenceFormat format) {
  const std::string below = name.substr(0, name.rfind('/') + 1);
  switch (format) {
    case ReferenceFormat::kTum:
    case ReferenceFormat::kDicp:
      return folder.Write(name, "1700000000.5 1 2 3 0 0 0 1\n");
    case ReferenceFormat::kKitti:
      return folder.Write(name, "1 0 0 1 0 1 0 2 0 0 1 3\n");
    case ReferenceFormat::kTable:
      return folder.Write(name, "1.5,1,2,3,0,0,0,1,4,5,6\n");
    case ReferenceFormat::kBoreas:
      return folder.Write(name, "names\n1606417097528152,1,2,3,0,0,0,0,0,0\n");
    case ReferenceFormat::kColoRadar:
      folder.Write(below + "timestamps.txt", "1700000000.5\n");
      return folder.Write(name, "1 2 3 0 0 0 1\n");
    case ReferenceFormat::kRadarScenes:
      return folder.Write("radar1_scans.csv", "timestamp_odom,x,y,yaw\n0.5,1,2,0\n");
    case ReferenceFormat::kVod: {
      const std::string rigid = "1,0,0,1, 0,1,0,2, 0,0,1,3, 0,0,0,1";
      folder.Write("radar/training/calib/00000.txt", "Tr_velo_to_cam: 1 0 0 0 0 1 0 0 0 0 1 0\n");
      return folder.Write("radar/training/pose/00000.json", "{\"odomToCamera\": [" + rigid + "]}");
    }
    case ReferenceFormat::kRaFlow: {
      const std::string scan =
          R"({"car_loc_x":[1],"car_loc_y":[3],"car_loc_z":[0],"car_vel_r":[-1],"rcs":[5],)"
          R"("power":[7],"pose":[[1,0,0,1],[0,1,0,2],[0,0,1,7],[0,0,0,1]]})";
      return folder.Write("radar_seqs-0_samples-1.json",
                          "{\"pc1\":" + scan + ",\"pc2\":" + scan + ",\"interval\":0.1}");
    }
    case ReferenceFormat::kEuroc:
    case ReferenceFormat::kBag:
    case ReferenceFormat::kAuto:
      break;
  }
  FAIL() << "write a truth of this form here: " << static_cast<int>(format);
}

void ExpectTruth(const TempFolder& folder, const std::string& what) {
  std::string error;
  const auto reference = ReadReference(folder.path(), {}, 0, &error);
  ASSERT_TRUE(reference) << what << ": " << error;
  ASSERT_FALSE(reference->poses.empty()) << what;
  EXPECT_EQ(reference->poses.back().T_world_body.translation.head<2>(), Eigen::Vector2d(1, 2))
      << what;
}

TEST(Datasets, RowsAreWhole) {
  std::set<std::string> names, words;
  std::set<ReferenceFormat> truths;
  for (const Dataset& dataset : Datasets()) {
    EXPECT_TRUE(names.insert(dataset.name).second) << dataset.name;
    EXPECT_FALSE(dataset.name.empty());
    const OwnTruth& truth = dataset.truth;
    const bool has_truth = truth.format != ReferenceFormat::kAuto || !dataset.truth_files.empty();
    EXPECT_TRUE(!dataset.sensors.empty() || has_truth) << dataset.name;
    EXPECT_EQ(dataset.recognise != nullptr && dataset.sensors.size() != 1, false) << dataset.name;
    EXPECT_EQ(dataset.list_radars == nullptr, dataset.radar_files.empty()) << dataset.name;
    for (const DatasetSensor& sensor : dataset.sensors) {
      EXPECT_FALSE(sensor.name.empty()) << dataset.name;
      EXPECT_NE(sensor.format, InputOptions::Format::kAuto) << sensor.name;
      EXPECT_TRUE(dataset.recognise != nullptr || !sensor.folders.empty() ||
                  !sensor.proof.layout.empty())
          << sensor.name << ": nothing tells that a drive is one of these";
      std::string error;
      for (const std::string& layout : sensor.layouts) {
        EXPECT_TRUE(ParseRawLayout(layout, &error)) << sensor.name << ": " << error;
      }
      const bool is_raw = sensor.format == InputOptions::Format::kRaw;
      EXPECT_TRUE(!is_raw || !sensor.layouts.empty()) << sensor.name << ": which columns?";
      const WrittenForm& written = sensor.written;
      EXPECT_EQ(written.word.empty(), written.columns.empty()) << sensor.name;
      EXPECT_EQ(written.word.empty(), written.folder.empty()) << sensor.name;
      EXPECT_TRUE(written.word.empty() || words.insert(written.word).second) << sensor.name;
    }
    if (truth.format == ReferenceFormat::kAuto) continue;
    EXPECT_TRUE(truths.insert(truth.format).second) << dataset.name;
    EXPECT_TRUE(truth.read != nullptr || truth.columns != nullptr) << dataset.name;
    EXPECT_EQ(truth.find == nullptr, truth.files.empty()) << dataset.name;
    const auto is_own = [&](const TruthFile& known) { return known.format == truth.format; };
    EXPECT_TRUE(truth.find != nullptr ||
                std::any_of(dataset.truth_files.begin(), dataset.truth_files.end(), is_own))
        << dataset.name << ": where is the ground truth?";
  }
}

// A short drive as the row says it is written, with its ground truth beside it: found, read back.
TEST(Datasets, WhatIsWrittenIsRecognised) {
  const std::vector<RadarScan> drive = ShortDrive();
  int num_written = 0;
  for (const Dataset& dataset : Datasets()) {
    for (const DatasetSensor& sensor : dataset.sensors) {
      if (sensor.written.word.empty()) continue;
      ++num_written;
      const TempFolder folder;
      std::string error, reason;
      const auto writer = OpenScanWriter(sensor.written.word, folder.path(), &error);
      ASSERT_NE(writer, nullptr) << error;
      for (const RadarScan& scan : drive) ASSERT_TRUE(writer->Add(scan, &error)) << error;
      ASSERT_TRUE(writer->Finish(&error)) << error;
      InputOptions options;
      ASSERT_TRUE(DetectFormat(folder.path(), &options, &reason, &error)) << error;
      EXPECT_EQ(options.format, sensor.format) << sensor.name;
      EXPECT_THAT(sensor.layouts.empty() ? std::vector<std::string>{""} : sensor.layouts,
                  ::testing::Contains(options.layout))
          << sensor.name;
      if (!sensor.folders.empty()) {
        EXPECT_THAT(reason, HasSubstr(sensor.name));
      }
      const auto source = OpenScanSource(folder.string(), {}, &error);
      ASSERT_NE(source, nullptr) << sensor.name << ": " << error;
      const std::vector<RadarScan> read = testing::ReadAll(source.get());
      ASSERT_EQ(read.size(), drive.size()) << sensor.name;
      for (std::size_t k = 0; k < read.size(); ++k) {
        if (sensor.written.has_times) {
          EXPECT_EQ(read[k].stamp_ns, drive[k].stamp_ns) << sensor.name;
        }
        ASSERT_EQ(read[k].returns.size(), 4u) << sensor.name;
        for (std::size_t i = 0; i < 4; ++i) {
          EXPECT_EQ(read[k].returns[i].position, drive[k].returns[i].position) << sensor.name;
          EXPECT_EQ(read[k].returns[i].doppler, drive[k].returns[i].doppler) << sensor.name;
          EXPECT_EQ(read[k].returns[i].power,
                    drive[k].returns[i].power + sensor.written.power_offset)
              << sensor.name;
        }
      }
      for (const TruthFile& known : dataset.truth_files) {
        WriteTruth(folder, known.file, known.format);
        ExpectTruth(folder, sensor.name + ", " + known.file);
        std::filesystem::remove(folder.path() / known.file);
      }
    }
  }
  EXPECT_GE(num_written, 6);
}

TEST(Datasets, GroundTruthIsFoundWhereTheRowSaysItIs) {
  for (const Dataset& dataset : Datasets()) {
    for (const TruthFile& known : dataset.truth_files) {
      const TempFolder folder;
      WriteTruth(folder, known.file, known.format);
      ExpectTruth(folder, dataset.name + ", " + known.file);
    }
    if (dataset.truth.find == nullptr) continue;
    const TempFolder folder;
    WriteTruth(folder, "", dataset.truth.format);
    ExpectTruth(folder, dataset.name + ", " + dataset.truth.files);
  }
}

// Of a dataset with several sensors input.radar all takes each.
TEST(Datasets, SensorsAreNumbered) {
  for (const Dataset& dataset : Datasets()) {
    if (dataset.sensors.size() < 2) continue;
    const TempFolder folder;
    for (const DatasetSensor& sensor : dataset.sensors) {
      folder.Write(sensor.folders.front() + "/1700000000000000000" + sensor.extension, "x");
    }
    InputOptions options;
    options.radar = "all";
    std::string reason, error;
    ASSERT_TRUE(DetectFormat(folder.path(), &options, &reason, &error)) << error;
    const auto radars = ListRadars(folder.path(), options, &error);
    ASSERT_TRUE(radars) << error;
    ASSERT_EQ(radars->size(), dataset.sensors.size()) << dataset.name;
    for (std::size_t i = 0; i < radars->size(); ++i) {
      EXPECT_EQ((*radars)[i].number, static_cast<int>(i) + 1);
      EXPECT_EQ((*radars)[i].options.format, dataset.sensors[i].format);
      EXPECT_TRUE(dataset.sensors[i].HasFormOf((*radars)[i].options)) << dataset.name;
    }
  }
}

}  // namespace
}  // namespace radive
