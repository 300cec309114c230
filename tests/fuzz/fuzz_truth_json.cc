// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "radive/io/datasets/dicp_calibration.h"
#include "radive/io/datasets/raflow_json.h"
#include "radive/io/datasets/vod_poses.h"

// Ground truth of View-of-Delft, RaFlow and Doppler-ICP. The first byte says which.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  radive::MatrixPose first, second;
  std::string error;
  bool ok = false;
  switch (data[0] % 4) {
    case 0:
      ok = radive::ParseVodPose(text, &first, &error);
      break;
    case 1:
      ok = radive::ParseVodCalibration(text, &first, &error);
      break;
    case 2:
      ok = radive::ParseRaFlowPoses(text, &first, &second, &error);
      break;
    default:
      ok = radive::ParseDicpCalibration(text, &first);
      break;
  }
  if (ok && !(first.rotation.allFinite() && first.translation.allFinite())) std::abort();
  return 0;
}
