// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "radive/io/scans/scan_writer.h"

namespace radive {

// Names of the formats that can be written:
//   raw                          radar/NNNNNN.bin, layout xyzdp5
//   pcd_ascii pcd_binary pcd_compressed, ply_ascii ply_binary ply_big_endian, csv, npy
//                                radar/NNNNNN.pcd and so on
//   hercules                     Radar/Continental/<19 digits of the stamp in ns>.bin
//   snail                        ars548/points/<seconds>.<nanoseconds>.pcd
//   aeva                         LiDAR/Aeva/<19 digits of the stamp in ns>.bin (HeRCULES)
//   tj4d                         training/velodyne/NNNNNN.bin
//   coloradar                    single_chip/pointclouds/data/radar_pointcloud_N.bin
//   vod                          radar/training/velodyne/NNNNN.bin
//   rosbag1, rosbag2, mcap ...   bags, see BagScanWriterNames() in bags/bag_scan_writer.h
// Files of points but vod keep their stamps in times.txt, a line a scan [ns].
const std::vector<std::string>& ScanWriterNames();

// Starts a drive in `folder`, which must exist. Null, with the reason in `error`, for an unknown
// format or a folder that cannot be written to.
std::unique_ptr<ScanWriter> OpenScanWriter(const std::string& format,
                                           const std::filesystem::path& folder,
                                           std::string* error);

}  // namespace radive
