// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/dataset.h"

namespace radive {

Dataset MscRad4rDataset() {
  Dataset dataset;
  dataset.name = "MSC-RAD4R";
  DatasetSensor& eagle = dataset.sensors.emplace_back();
  eagle.name = "MSC-RAD4R";
  eagle.layouts = {"mscrad17"};
  eagle.proof = {"mscrad17", "range", RecordProof::Kind::kRange};
  return dataset;
}

}  // namespace radive
