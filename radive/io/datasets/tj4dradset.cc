// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/dataset.h"

namespace radive {

Dataset Tj4dRadSetDataset() {
  Dataset dataset;
  dataset.name = "TJ4DRadSet";
  DatasetSensor& eagle = dataset.sensors.emplace_back();
  eagle.name = "TJ4DRadSet";
  eagle.layouts = {"tj4d8"};
  eagle.proof = {"tj4d8", "range", RecordProof::Kind::kRange};
  eagle.written.word = "tj4d";
  eagle.written.folder = "training/velodyne";
  eagle.written.columns = "tj4d8";
  return dataset;
}

}  // namespace radive
