// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/scans/input_options.h"
#include "radive/io/scans/scan_source.h"
#include "radive/io/trajectories/pose_table.h"
#include "radive/io/trajectories/reference.h"
#include "radive/io/trajectories/reference_options.h"

namespace radive {

// One radar of a vehicle: its number, which sensor.mounts and the scans name it by, and the options
// that read it alone.
struct RadarInput {
  int number = 0;
  InputOptions options;
};

// What in the numbers of a raw file proves that its records have this layout.
struct RecordProof {
  enum class Kind {
    kRange,     // `field` is |x y z|
    kScanIndex  // `field` counts scans back from 0
  };
  std::string layout;  // empty: nothing does
  std::string field;
  Kind kind = Kind::kRange;
};

// How radive_simulate writes the scans of a sensor.
struct WrittenForm {
  enum class Naming {
    kNumber6,          // 000000
    kNumber5,          // 00000
    kRadarPointcloud,  // radar_pointcloud_0
    kNanoseconds,      // stamp, 19 digits
    kSeconds           // stamp, SECONDS.NANOSECONDS
  };
  std::string word;     // of radive_simulate --format; empty: it cannot be written
  std::string folder;   // below the drive
  std::string columns;  // of a record, see ParseRawLayout()
  Naming naming = Naming::kNumber6;
  bool has_times = true;      // times.txt, a line a scan [ns]
  double power_offset = 0.0;  // what is stored is the power and this [dB]
};

// The scans of one sensor of a dataset, a file each.
struct DatasetSensor {
  std::string name;                   // "HeRCULES Aeva"
  std::vector<std::string> folders;   // that the sensor is known by, below the drive
  std::string below;                  // folder that may lie anywhere below the drive; empty: none
  std::string extension = ".bin";     // of the files
  std::vector<std::string> siblings;  // one of them must be in the drive's folder; empty: none
  InputOptions::Format format = InputOptions::Format::kRaw;

  // Of raw records, for input.layout; with several (releases of the dataset) the first that fits.
  std::vector<std::string> layouts;
  RecordProof proof;

  // Null: as any drive of the format. `options` are valid; null, with place and expectation in
  // `error`, when that fails.
  std::unique_ptr<ScanSource> (*open)(const std::filesystem::path& path,
                                      const InputOptions& options,
                                      std::string* error) = nullptr;
  WrittenForm written;

  // Whether the options ask for scans of this format and layout.
  bool HasFormOf(const InputOptions& options) const;
};

// Where the dataset puts its ground truth, below the folder of the drive.
struct TruthFile {
  std::string file;
  ReferenceOptions::Format format;
};

// Ground truth in a form that no other dataset has.
struct OwnTruth {
  ReferenceOptions::Format format = ReferenceOptions::Format::kAuto;  // kAuto: there is none
  std::string files;  // for messages: "pose/*.json"; empty where TruthFile says it

  // What Read() is to be given for the folder of a drive; nothing when the truth is not there.
  std::optional<std::filesystem::path> (*find)(const std::filesystem::path& folder) = nullptr;
  // Whether a file is one, by its name.
  bool (*is_file)(const std::filesystem::path& file) = nullptr;
  // The columns, where it is a table: from its line of names, or fixed.
  std::optional<PoseColumns> (*columns)(std::string_view names) = nullptr;
  // Null: such a table. `clip`: InputOptions::clip. False, with place and expectation in `error`,
  // when it cannot be read.
  bool (*read)(const std::filesystem::path& path,
               int clip,
               Reference* reference,
               std::string* error) = nullptr;
};

// One dataset: all that is peculiar to it, apart from how it is calibrated (configs/).
struct Dataset {
  std::string name;  // "HeRCULES"

  // input.radar all takes them together, by their numbers from 1, unless `list_radars` is set.
  std::vector<DatasetSensor> sensors;

  // Whether the files at `path`, in `folder` below it, are known by their names or first bytes;
  // `what` then says which. Null: they are not.
  bool (*recognise)(const std::filesystem::path& path,
                    const std::string& folder,
                    std::string* what) = nullptr;

  // The radars that the drive has. Nothing, with the reason in `error`, when it cannot be read.
  std::optional<std::vector<RadarInput>> (*list_radars)(const std::filesystem::path& path,
                                                        const InputOptions& options,
                                                        std::string* error) = nullptr;
  std::string radar_files;  // that list_radars() looks for, for messages

  std::vector<TruthFile> truth_files;
  OwnTruth truth;
};

// All datasets, in the order in which folders are compared with them.
const std::vector<Dataset>& Datasets();

}  // namespace radive
