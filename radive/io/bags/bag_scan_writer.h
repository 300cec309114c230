// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "radive/io/scans/scan_writer.h"

namespace radive {

// Names of the bag formats of OpenScanWriter():
//   rosbag1 rosbag1_bz2 rosbag1_lz4  drive.bag
//   rosbag1_unindexed                drive.bag, as a recorder that crashed leaves it
//   rosbag2 rosbag2_zstd             metadata.yaml and its SQLite file
//   mcap mcap_lz4 mcap_zstd          drive.mcap
//   mcap_unindexed                   drive.mcap without index and summary
// Scans are messages PointCloud2 on the topic /radar, recorded at their stamps.
const std::vector<std::string>& BagScanWriterNames();

// Starts a bag in `folder`, which must exist. Null, with the reason in `error`, when it cannot be
// made; `format` must be one of the names.
std::unique_ptr<ScanWriter> OpenBagScanWriter(const std::string& format,
                                              const std::filesystem::path& folder,
                                              std::string* error);

}  // namespace radive
