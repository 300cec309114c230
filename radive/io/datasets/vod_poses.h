// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "radive/geometry/matrix_pose.h"
#include "radive/sensor/recorded_trajectory.h"

namespace radive {

// Takes a pose file of View-of-Delft apart: JSON objects one behind the other, each with a name and
// 16 numbers, the rows of a 4x4 matrix. Gives the one called odomToCamera, which despite its name
// maps camera coordinates to those of the odometry frame. False, with the expectation in `error`,
// when there is none.
bool ParseVodPose(std::string_view text, MatrixPose* T_odom_camera, std::string* error);

// Finds the line "Tr_velo_to_cam: " with the 12 numbers of a 3x4 matrix in a KITTI calibration
// file: T_camera_radar in the radar's folder, T_camera_lidar in the lidar's. False, with the
// expectation in `error`, when there is none.
bool ParseVodCalibration(std::string_view text, MatrixPose* T_camera_sensor, std::string* error);

// The folder with the pose files of View-of-Delft at `path`: itself, pose/, training/pose/ or
// radar/training/pose/. Nothing when there is none.
std::optional<std::filesystem::path> FindVodPoses(const std::filesystem::path& path);

// T_odom_radar of each frame, in the order of the numbers in the file names, without stamps:
// odomToCamera of pose/NNNNN.json times Tr_velo_to_cam of calib/NNNNN.txt beside the folder.
// Nothing, with file and expectation in `error`, when one of them cannot be read.
std::optional<RecordedTrajectory> ReadVodPoses(const std::filesystem::path& pose_folder,
                                               std::string* error);

}  // namespace radive
