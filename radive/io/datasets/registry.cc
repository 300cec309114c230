// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "radive/io/bytes/text_lines.h"
#include "radive/io/datasets/dataset.h"

namespace radive {

// Each in the file of its name.
Dataset RadarScenesDataset(), RaFlowDataset(), HerculesDataset(), SnailRadarDataset(),
    ColoRadarDataset(), DopplerIcpDataset(), BoreasDataset(), Tj4dRadSetDataset(),
    MscRad4rDataset(), ViewOfDelftDataset(), Ntu4dRadLmDataset(), SimulatedDriveDataset();

const std::vector<Dataset>& Datasets() {
  // Known by the names of files, then of folders, then by what their records prove.
  static const auto* const datasets = new std::vector<Dataset>{RadarScenesDataset(),
                                                               RaFlowDataset(),
                                                               HerculesDataset(),
                                                               SnailRadarDataset(),
                                                               ColoRadarDataset(),
                                                               DopplerIcpDataset(),
                                                               BoreasDataset(),
                                                               Tj4dRadSetDataset(),
                                                               MscRad4rDataset(),
                                                               ViewOfDelftDataset(),
                                                               Ntu4dRadLmDataset(),
                                                               SimulatedDriveDataset()};
  return *datasets;
}

bool DatasetSensor::HasFormOf(const InputOptions& options) const {
  return format == options.format &&
         (layouts.empty() ||
          std::find(layouts.begin(), layouts.end(), LowerCase(options.layout)) != layouts.end());
}

}  // namespace radive
