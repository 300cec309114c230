// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/radarscenes_hdf5.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>
#include <cstddef>

#include "radive/io/open/open_scan_source.h"
#include "radive/io/open/read_reference.h"
#include "tests/io/scan_files.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A detection and a state of the car as RadarScenes stores them, with a column between that is not
// looked at.
struct Detection {
  std::int64_t timestamp;  // [us]
  std::uint8_t sensor_id;
  float range_sc, azimuth_sc, rcs, vr, vr_compensated;
};
struct CarState {
  std::int64_t timestamp;  // [us]
  float x_seq, y_seq, yaw_seq, vx, yaw_rate;
};

template <typename Row>
void WriteTable(hid_t file, const char* name, hid_t type, const std::vector<Row>& rows) {
  const hsize_t count = rows.size();
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()), 0);
  H5Dclose(set);
  H5Sclose(space);
}

void WriteFile(const std::filesystem::path& path,
               const std::vector<Detection>& detections,
               const std::vector<CarState>& states,
               const char* doppler_name = "vr") {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t detection = H5Tcreate(H5T_COMPOUND, sizeof(Detection));
  H5Tinsert(detection, "timestamp", offsetof(Detection, timestamp), H5T_NATIVE_INT64);
  H5Tinsert(detection, "sensor_id", offsetof(Detection, sensor_id), H5T_NATIVE_UINT8);
  H5Tinsert(detection, "range_sc", offsetof(Detection, range_sc), H5T_NATIVE_FLOAT);
  H5Tinsert(detection, "azimuth_sc", offsetof(Detection, azimuth_sc), H5T_NATIVE_FLOAT);
  H5Tinsert(detection, "rcs", offsetof(Detection, rcs), H5T_NATIVE_FLOAT);
  H5Tinsert(detection, doppler_name, offsetof(Detection, vr), H5T_NATIVE_FLOAT);
  H5Tinsert(detection, "vr_compensated", offsetof(Detection, vr_compensated), H5T_NATIVE_FLOAT);
  WriteTable(file, "radar_data", detection, detections);
  const hid_t state = H5Tcreate(H5T_COMPOUND, sizeof(CarState));
  H5Tinsert(state, "timestamp", offsetof(CarState, timestamp), H5T_NATIVE_INT64);
  H5Tinsert(state, "x_seq", offsetof(CarState, x_seq), H5T_NATIVE_FLOAT);
  H5Tinsert(state, "y_seq", offsetof(CarState, y_seq), H5T_NATIVE_FLOAT);
  H5Tinsert(state, "yaw_seq", offsetof(CarState, yaw_seq), H5T_NATIVE_FLOAT);
  H5Tinsert(state, "vx", offsetof(CarState, vx), H5T_NATIVE_FLOAT);
  WriteTable(file, "odometry", state, states);
  H5Tclose(state);
  H5Tclose(detection);
  H5Fclose(file);
}

// Two scans of radar 2, and between them one of radar 4.
const std::vector<Detection> kDetections = {{100000, 2, 10, 0, 5, -3, 0},
                                            {100000, 2, 20, 1.5707963F, 6, 0, 0},
                                            {110000, 4, 30, 0, 7, 1, 0},
                                            {170000, 2, 40, 0, 8, -4, 0}};
const std::vector<CarState> kStates = {{90000, 1, 2, 0, 9, 0}, {110000, 3, 4, 1.5707963F, 9, 0}};

class RadarScenesHdf5 : public ::testing::Test {
 protected:
  void Write() { WriteFile(folder_.path() / "radar_data.h5", kDetections, kStates); }

  std::unique_ptr<ScanSource> Open() {
    std::string error;
    auto source = OpenScanSource(folder_.string(), options_, &error);
    EXPECT_NE(source, nullptr) << error;
    return source;
  }
  std::string Error() {
    std::string error;
    EXPECT_EQ(OpenScanSource(folder_.string(), options_, &error), nullptr);
    return error;
  }

  const testing::TempFolder folder_;
  InputOptions options_;
};

TEST_F(RadarScenesHdf5, IsDetectedAndReadScanByScan) {
  Write();
  const auto source = Open();
  EXPECT_EQ(source->NumScans(), 2);
  EXPECT_THAT(source->Description(), HasSubstr("RadarScenes radar 2, 2 scans"));
  const std::vector<RadarScan> scans = testing::ReadAll(source.get());
  ASSERT_EQ(scans.size(), 2u);
  EXPECT_THAT(testing::Stamps(scans), ElementsAre(100000000, 170000000));
  EXPECT_EQ(scans[0].radar, 2);
  EXPECT_TRUE(scans[0].is_planar && scans[0].has_doppler);
  ASSERT_EQ(scans[0].returns.size(), 2u);
  EXPECT_EQ(scans[0].returns[0].position, Eigen::Vector3d(10, 0, 0));
  EXPECT_EQ(scans[0].returns[0].doppler, -3.0);
  EXPECT_EQ(scans[0].returns[0].power, 5.0);
  EXPECT_NEAR(scans[0].returns[1].position.y(), 20.0, 1e-5);
  EXPECT_EQ(scans[1].returns.at(0).position.x(), 40.0);

  // The file itself does as well.
  std::string error;
  EXPECT_NE(OpenScanSource((folder_.path() / "radar_data.h5").string(), options_, &error), nullptr)
      << error;
  const auto again = Open();
  EXPECT_EQ(again->Skip(1), ScanSource::Status::kScan);
  EXPECT_EQ(testing::FirstX(testing::ReadAll(again.get())), std::vector<double>{40.0});
}

TEST_F(RadarScenesHdf5, AllItsRadarsAreOneStream) {
  Write();
  options_.radar = "all";
  const auto source = Open();
  EXPECT_THAT(testing::FirstX(testing::ReadAll(source.get())), ElementsAre(10.0, 30.0, 40.0));
  options_.radar = "3";
  EXPECT_THAT(Error(),
              HasSubstr("has no detections of radar 3 (input.radar); radars found in it: "
                        "2, 4"));
}

TEST_F(RadarScenesHdf5, WarnsWhenScansMayBeLost) {
  const auto warnings = [&](const std::vector<Detection>& detections,
                            const std::vector<CarState>& states) {
    WriteFile(folder_.path() / "radar_data.h5", detections, states);
    const auto source = Open();
    testing::ReadAll(source.get());
    return source->TakeWarnings();
  };
  EXPECT_THAT(warnings(kDetections, kStates), ElementsAre());
  std::vector<Detection> detections = kDetections;
  detections[1].timestamp = 99000;  // before the row in front of it
  EXPECT_THAT(warnings(detections, kStates), Contains(HasSubstr("1 rows are not in the order")));
  detections = kDetections;
  detections[1].sensor_id = 3;  // at the time of a scan of radar 2
  EXPECT_THAT(warnings(detections, kStates), Contains(HasSubstr("the first is row 1;")));
  detections = kDetections;
  detections[3].timestamp = 100000;  // a second part of the first scan, behind radar 4
  EXPECT_THAT(warnings(detections, kStates), Contains(HasSubstr("the first is row 3;")));
  std::vector<CarState> states = kStates;
  states[1].timestamp = 1180000;  // 1.01 s after the last detection
  EXPECT_THAT(warnings(kDetections, states),
              ElementsAre(HasSubstr("radar 2 begin 0.01 s after the odometry and end 1.01 s")));
  // As bytes read at the wrong place are: of some radar, in the order of time, but of no time.
  detections = kDetections;
  detections.push_back({65536445644800000, 0, 10, 0, 5, -3, 0});
  EXPECT_THAT(warnings(detections, kStates), Contains(HasSubstr("the first is row 4;")));
  states[1].timestamp = 65536445644800000;
  EXPECT_THAT(warnings(kDetections, states),
              ElementsAre(AllOf(HasSubstr("odometry, row 1: expected finite numbers"),
                                HasSubstr("nothing tells whether scans are lost"))));
}

TEST_F(RadarScenesHdf5, ItsOdometryIsTheGroundTruth) {
  Write();
  std::string error;
  const auto reference = ReadReference(folder_.path(), {}, 0, &error);
  ASSERT_TRUE(reference) << error;
  ASSERT_EQ(reference->poses.size(), 2u);
  EXPECT_EQ(reference->poses[0].stamp_ns, 90000000);
  EXPECT_EQ(reference->poses[1].T_world_body.translation, Eigen::Vector3d(3, 4, 0));
  EXPECT_NEAR(reference->poses[1].T_world_body.rotation(1, 0), 1.0, 1e-6);
}

TEST_F(RadarScenesHdf5, SaysWhatIsMissing) {
  WriteFile(folder_.path() / "radar_data.h5", kDetections, kStates, "velocity");
  EXPECT_THAT(Error(),
              HasSubstr("radar_data.h5: data set radar_data: expected a column of numbers "
                        "called vr"));
  folder_.Write("radar_data.h5", "\x89HDF\r\n\x1a\nnothing");
  EXPECT_THAT(Error(), HasSubstr("radar_data.h5: cannot be opened as an HDF5 file"));
  folder_.Write("radar_data.h5", testing::LfsPointer());
  EXPECT_THAT(Error(), HasSubstr("radar_data.h5: a Git-LFS pointer"));
  std::string error;
  EXPECT_EQ(Hdf5Table::Open(folder_.path() / "absent.h5", "radar_data", {"a"}, &error), nullptr);
  EXPECT_THAT(error, HasSubstr("absent.h5: cannot be opened"));
}

TEST_F(RadarScenesHdf5, DamagedFilesAreReadOrRefused) {
  Write();
  const std::filesystem::path path = folder_.path() / "radar_data.h5";
  const std::string whole = testing::ReadFile(path);
  ASSERT_GT(whole.size(), 1000u);
  int num_refused = 0;
  // Every 37th byte turned around, and the file cut off at as many places.
  for (std::size_t place = 0; place < whole.size(); place += 37) {
    for (const bool is_cut : {false, true}) {
      std::string bytes = is_cut ? whole.substr(0, place) : whole;
      if (!is_cut) bytes[place] = static_cast<char>(~bytes[place]);
      folder_.Write("radar_data.h5", bytes);
      std::string error;
      const auto source = OpenScanSource(folder_.string(), options_, &error);
      if (source == nullptr) {
        EXPECT_THAT(error, HasSubstr("radar_data.h5")) << place;
        ++num_refused;
        continue;
      }
      RadarScan scan;
      int num_scans = 0;
      while (source->Next(&scan) == ScanSource::Status::kScan) ++num_scans;
      EXPECT_LE(num_scans, 4) << place;
    }
  }
  EXPECT_GT(num_refused, 10);
}

}  // namespace
}  // namespace radive
