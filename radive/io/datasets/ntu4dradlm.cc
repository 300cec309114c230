// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/dataset.h"

namespace radive {

// Its scans are in ROS 1 bags, which need no row.
Dataset Ntu4dRadLmDataset() {
  Dataset dataset;
  dataset.name = "NTU4DRadLM";
  dataset.truth_files = {{"gt_odom.txt", ReferenceOptions::Format::kTum}};
  return dataset;
}

}  // namespace radive
