// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/dataset.h"
#include "radive/io/datasets/vod_poses.h"

namespace radive {
namespace {

bool ReadVodTruth(const std::filesystem::path& path,
                  int /*clip*/,
                  Reference* reference,
                  std::string* error) {
  return SetPoses(ReadVodPoses(path, error), /*has_stamps=*/false, reference);
}

}  // namespace

Dataset ViewOfDelftDataset() {
  Dataset dataset;
  dataset.name = "View-of-Delft";
  DatasetSensor& radar = dataset.sensors.emplace_back();
  radar.name = "View-of-Delft";
  radar.layouts = {"vod7"};
  radar.proof = {"vod7", "time", RecordProof::Kind::kScanIndex};
  radar.written.word = "vod";
  radar.written.folder = "radar/training/velodyne";
  radar.written.columns = "vod7";
  radar.written.naming = WrittenForm::Naming::kNumber5;
  radar.written.has_times = false;
  dataset.truth_files = {{"gt_poses_kitti.txt", ReferenceOptions::Format::kKitti}};
  dataset.truth.format = ReferenceOptions::Format::kVod;
  dataset.truth.files = "pose/*.json";
  dataset.truth.find = FindVodPoses;
  dataset.truth.read = ReadVodTruth;
  return dataset;
}

}  // namespace radive
