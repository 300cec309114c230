// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/dataset.h"

namespace radive {

Dataset SnailRadarDataset() {
  Dataset dataset;
  dataset.name = "SNAIL-Radar";
  DatasetSensor& ars548 = dataset.sensors.emplace_back();
  ars548.name = "SNAIL-Radar ARS548";
  ars548.folders = {"ars548/points"};
  ars548.extension = ".pcd";
  ars548.format = InputOptions::Format::kPcd;
  ars548.written.word = "snail";
  ars548.written.folder = "ars548/points";
  ars548.written.columns =
      "x,y,z,doppler,intensity,range_std,azimuth_std,elevation_std,doppler_std";
  ars548.written.naming = WrittenForm::Naming::kSeconds;
  ars548.written.power_offset = 128.0;
  DatasetSensor& eagle = dataset.sensors.emplace_back();
  eagle.name = "SNAIL-Radar Oculii";
  eagle.folders = {"eagleg7/enhanced"};
  eagle.extension = ".pcd";
  eagle.format = InputOptions::Format::kPcd;
  dataset.truth_files = {{"ref_tls_T_xt32.csv", ReferenceOptions::Format::kTable},
                         {"utm50r_T_xt32.txt", ReferenceOptions::Format::kTum}};
  return dataset;
}

}  // namespace radive
