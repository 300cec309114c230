// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/scans/input_options.h"
#include "radive/io/scans/point_converter.h"
#include "radive/io/scans/scan_source.h"
#include "radive/sensor/recorded_trajectory.h"

namespace radive {

// The clips of RaFlow: files radar_seqs-S_samples-K.json in a folder or below it, each with two
// scans in a row. Where the first scan of file K + 1 is the second of file K, the drive goes on;
// such a run of files is a clip, and input.clip chooses one (the longest, if it is 0). The scans of
// a clip are the first of each file and the second of the last; stamps count from 0.
class RaFlowSource : public ScanSource {
 public:
  // `options` must be valid. Null, with the place and the expectation in `error`, when `path` holds
  // no such files, one of them cannot be read, or there is no such clip. Reads all files once.
  static std::unique_ptr<RaFlowSource> Open(const std::filesystem::path& path,
                                            const InputOptions& options,
                                            std::string* error);

  Status Next(RadarScan* scan) override;
  Status PassOver(RadarScan* scan) override;
  std::string Description() const override;
  std::optional<int> NumScans() const override;
  SourceFacts Facts() const override;

 private:
  RaFlowSource(std::vector<std::filesystem::path> files,
               std::vector<std::int64_t> stamps_ns,
               std::string description,
               const InputOptions& options);

  const std::vector<std::filesystem::path> files_;  // of the clip
  const std::vector<std::int64_t> stamps_ns_;       // one more than files [ns]
  const std::string description_;
  PointConverter converter_;
  std::size_t next_ = 0;
};

// The poses T_world_radar of the scans of a clip, with the stamps that RaFlowSource gives them;
// coarse: their translations are unfiltered satellite fixes. As Open() otherwise.
std::optional<RecordedTrajectory> ReadRaFlowPoses(const std::filesystem::path& path,
                                                  int clip,
                                                  std::string* error);

// True for the name of a file of RaFlow; gives its two numbers.
bool ParseRaFlowName(const std::string& name, std::int64_t* sequence, std::int64_t* sample);

}  // namespace radive
