// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The readers on real drives: numbers of scans and returns, and the sign of the Doppler.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "radive/io/open/open_scan_source.h"
#include "tests/io/scan_files.h"
#include "tests/shared_data.h"

namespace radive {
namespace {

struct VelocityFit {
  Eigen::Vector3d v_radar = Eigen::Vector3d::Zero();  // [m/s]
  double inlier_share = 0.0;                          // of the returns in the gate of view
};

// Fits v_r = -d . v to a scan: from the median of -v_r / d_x ahead, then least squares on what lies
// within `gate` [m/s]. `oculii`: takes only returns where that sensor can measure (3 to 400 m,
// 56.5 deg to the sides, 22.5 deg up and down).
VelocityFit FitVelocity(const RadarScan& scan, double gate, bool oculii) {
  std::vector<std::pair<Eigen::Vector3d, double>> returns;
  std::vector<double> forward;
  for (const RadarReturn& r : scan.returns) {
    const double range = r.position.norm();
    const Eigen::Vector3d d = r.position / range;
    const bool in_view = range > 3.0 && range < 400.0 && d.x() > 0.0 &&
                         std::abs(std::atan2(d.y(), d.x())) < 0.986 && std::abs(d.z()) < 0.383;
    if (range < 0.1 || (oculii && !in_view)) continue;
    returns.emplace_back(d, r.doppler);
    if (d.x() > 0.7) forward.push_back(-r.doppler / d.x());
  }
  VelocityFit fit;
  if (forward.empty()) return fit;
  std::sort(forward.begin(), forward.end());
  fit.v_radar.x() = forward[forward.size() / 2];
  for (const double width : {20 * gate, 5 * gate, 2 * gate, gate, gate, gate}) {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();
    int num_inliers = 0;
    for (const auto& [d, doppler] : returns) {
      if (std::abs(doppler + d.dot(fit.v_radar)) > width) continue;
      information += d * d.transpose();
      vector -= d * doppler;
      ++num_inliers;
    }
    // Planar scans say nothing of z: the smallest change, none, is taken there.
    fit.v_radar = information.completeOrthogonalDecomposition().solve(vector);
    fit.inlier_share = num_inliers / static_cast<double>(returns.size());
  }
  return fit;
}

std::vector<RadarScan> ReadDrive(const std::string& relative, const InputOptions& options) {
  std::string error;
  const auto source = OpenScanSource((testing::SharedData() / relative).string(), options, &error);
  if (source == nullptr) {
    ADD_FAILURE() << error;
    return {};
  }
  std::vector<RadarScan> scans = testing::ReadAll(source.get());
  EXPECT_EQ(source->NumScans(), static_cast<int>(scans.size()));
  EXPECT_TRUE(source->TakeWarnings().empty());
  return scans;
}

std::size_t NumReturns(const std::vector<RadarScan>& scans) {
  std::size_t sum = 0;
  for (const RadarScan& scan : scans) sum += scan.returns.size();
  return sum;
}

// The numbers of returns below are the sizes of the files over those of the records.

TEST(RealScans, ViewOfDelftWithoutDoppler) {
  RADIVE_SKIP_WITHOUT("vod-radar-xyz");
  struct Drive {
    const char* name;
    std::size_t num_scans;
    std::size_t num_returns;
  };
  for (const Drive& drive : {Drive{"delft_04", 396, 79222},
                             Drive{"delft_06", 331, 72676},
                             Drive{"delft_12", 337, 83177},
                             Drive{"delft_24", 346, 118771},
                             Drive{"delft_26", 257, 48252}}) {
    InputOptions options;
    options.layout = "xyz3";
    options.rate = 10.0;
    const auto scans = ReadDrive(std::string("vod-radar-xyz/") + drive.name, options);
    ASSERT_EQ(scans.size(), drive.num_scans) << drive.name;
    EXPECT_EQ(NumReturns(scans), drive.num_returns) << drive.name;
    for (std::size_t k = 0; k < scans.size(); ++k) {
      EXPECT_EQ(scans[k].stamp_ns, static_cast<std::int64_t>(k) * 100000000);
      EXPECT_FALSE(scans[k].has_doppler);
    }
  }
}

TEST(RealScans, ViewOfDelftWithDoppler) {
  RADIVE_SKIP_WITHOUT("vod-example-frames");
  InputOptions options;
  options.layout = "vod7";
  options.rate = 10.0;
  const auto scans = ReadDrive("vod-example-frames", options);
  ASSERT_EQ(scans.size(), 3u);
  EXPECT_EQ(scans[0].returns.size(), 322u);
  EXPECT_EQ(scans[1].returns.size(), 352u);
  EXPECT_EQ(scans[2].returns.size(), 242u);
  const Eigen::Vector3d expected[] = {
      {1.92, 0.02, -0.02}, {2.94, -0.54, -0.06}, {2.61, 0.14, 0.13}};
  for (std::size_t k = 0; k < 3; ++k) {
    const VelocityFit fit = FitVelocity(scans[k], 0.2, /*oculii=*/false);
    EXPECT_LT((fit.v_radar - expected[k]).norm(), 0.05) << fit.v_radar.transpose();
  }
}

TEST(RealScans, MscRad4r) {
  RADIVE_SKIP_WITHOUT("mscrad4r-urban-c0");
  InputOptions options;
  options.layout = "xyzdp5";
  options.rate = 15.0;
  const auto scans = ReadDrive("mscrad4r-urban-c0", options);
  ASSERT_EQ(scans.size(), 310u);
  EXPECT_EQ(scans[300].stamp_ns, 20000000000);
  EXPECT_EQ(NumReturns(scans), 2061972u);
  EXPECT_EQ(scans[0].returns.size(), 9404u);
  EXPECT_EQ(scans[60].returns.size(), 7971u);
  EXPECT_EQ(scans[300].returns.size(), 6303u);
  for (const auto& [k, speed] : {std::pair(0, 0.0), std::pair(60, 4.86), std::pair(300, 11.89)}) {
    const VelocityFit fit = FitVelocity(scans[static_cast<std::size_t>(k)], 0.3, /*oculii=*/true);
    EXPECT_NEAR(fit.v_radar.x(), speed, 0.05) << k;
    EXPECT_GT(fit.inlier_share, 0.55) << k;
  }
}

TEST(RealScans, Tj4dRadSet) {
  RADIVE_SKIP_WITHOUT("tj4dradset-sample");
  InputOptions options;
  options.layout = "tj4d8";
  options.rate = 10.0;
  const auto scans = ReadDrive("tj4dradset-sample", options);
  ASSERT_EQ(scans.size(), 41u);
  EXPECT_EQ(NumReturns(scans), 108222u);
  for (const RadarScan& scan : scans) {
    const VelocityFit fit = FitVelocity(scan, 0.3, /*oculii=*/true);
    EXPECT_GT(fit.v_radar.x(), 16.9);
    EXPECT_LT(fit.v_radar.x(), 17.8);
    EXPECT_GT(fit.inlier_share, 0.9);
  }
  EXPECT_NEAR(FitVelocity(scans.front(), 0.3, /*oculii=*/true).v_radar.x(), 16.98, 0.05);
  EXPECT_NEAR(FitVelocity(scans.back(), 0.3, /*oculii=*/true).v_radar.x(), 17.50, 0.05);
}

TEST(RealScans, RadarScenes) {
  RADIVE_SKIP_WITHOUT("radarscenes");
  struct Radar {
    const char* number;
    std::size_t num_scans;
    std::size_t num_returns;
  };
  InputOptions options;
  options.format = InputOptions::Format::kRadarScenes;
  for (const Radar& radar : {Radar{"1", 1636, 150532},
                             Radar{"2", 1606, 363083},
                             Radar{"3", 1618, 362245},
                             Radar{"4", 1618, 195856}}) {
    options.radar = radar.number;
    const auto scans = ReadDrive("radarscenes/seq105", options);
    EXPECT_EQ(scans.size(), radar.num_scans);
    EXPECT_EQ(NumReturns(scans), radar.num_returns);
  }
  options.radar = "2";
  const auto scans = ReadDrive("radarscenes/seq105", options);
  EXPECT_EQ(scans.front().stamp_ns, 68314000);
  EXPECT_EQ(scans.back().stamp_ns, 121835686000);
  EXPECT_EQ(scans.front().returns.size(), 241u);
  EXPECT_EQ(scans.back().returns.size(), 175u);
  // The car drives 20.65 m/s and turns with 0.0101 rad/s; the radar sits at (3.86, -0.70) m, turned
  // by -0.4362 rad: (20.657, 0.039) m/s in car axes, so (18.707, 8.763) m/s in its own.
  const VelocityFit fit = FitVelocity(scans.front(), 0.5, /*oculii=*/false);
  EXPECT_NEAR(fit.v_radar.x(), 18.707, 0.1);
  EXPECT_NEAR(fit.v_radar.y(), 8.763, 0.1);
  EXPECT_GT(fit.inlier_share, 0.8);
}

}  // namespace
}  // namespace radive
