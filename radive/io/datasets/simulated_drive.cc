// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/dataset.h"

namespace radive {

// What radive_simulate writes with --format=raw; its other forms are those of their datasets.
Dataset SimulatedDriveDataset() {
  Dataset dataset;
  dataset.name = "radive_simulate";
  DatasetSensor& radar = dataset.sensors.emplace_back();
  radar.name = "radive_simulate";
  radar.folders = {"radar"};
  radar.siblings = {"scenario.json"};
  radar.layouts = {"xyzdp5"};
  dataset.truth_files = {{"gt_tum.txt", ReferenceOptions::Format::kTum}};
  return dataset;
}

}  // namespace radive
