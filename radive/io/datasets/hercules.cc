// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <utility>

#include "radive/io/datasets/dataset.h"
#include "radive/io/scans/raw_source.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr char kContinental[] = "Radar/Continental";
constexpr char kAeva[] = "LiDAR/Aeva";

// Recordings with 25 bytes end in August 2023; stamps before 2019 are of another clock [ns].
constexpr std::int64_t kFirstStampOf25Bytes = 1546300800000000000;
constexpr std::int64_t kLastStampOf25Bytes = 1691936557946849179;

// Aeva: records of 29 bytes, or of 25 in recordings up to the stamp above. What the size of a file
// divides by decides, the stamp where it divides by both or neither.
class AevaFileReader : public PointFileReader {
 public:
  AevaFileReader() : reader29_(KnownLayout("aeva29")), reader25_(KnownLayout("aeva25")) {}

  bool Read(std::string_view bytes,
            std::int64_t stamp_ns,
            PointTable* table,
            std::vector<std::string>* remarks,
            std::string* error) override {
    const bool fits29 = bytes.size() % 29 == 0;
    const bool fits25 = bytes.size() % 25 == 0;
    const bool is_old = stamp_ns >= kFirstStampOf25Bytes && stamp_ns <= kLastStampOf25Bytes;
    const bool is29 = fits29 != fits25 ? fits29 : !is_old;
    return (is29 ? reader29_ : reader25_).Read(bytes, stamp_ns, table, remarks, error);
  }

 private:
  RawFileReader reader29_;
  RawFileReader reader25_;
};

std::unique_ptr<ScanSource> OpenAeva(const fs::path& path,
                                     const InputOptions& options,
                                     std::string* error) {
  return OpenRawFiles(path,
                      RawFolders(options, {kAeva, "Aeva"}),
                      std::make_unique<AevaFileReader>(),
                      options,
                      "Aeva scans",
                      error);
}

// <stamp in ns>.bin of a Continental ARS548, in Radar/Continental or in any folder called
// Continental: each sensor comes as an archive of its own, which users unpack into folders of their
// own.
std::unique_ptr<ScanSource> OpenContinental(const fs::path& path,
                                            const InputOptions& options,
                                            std::string* error) {
  ScanFolderQuery query;
  query.candidates = {".", kContinental, "Continental"};
  query.name_below = "Continental";
  if (!options.folder.empty()) query.LookOnlyIn(options.folder);
  query.names_are_stamps = true;
  return OpenRawFiles(path,
                      query,
                      std::make_unique<RawFileReader>(KnownLayout("hercules29")),
                      options,
                      "HeRCULES Continental scans",
                      error);
}

}  // namespace

Dataset HerculesDataset() {
  Dataset dataset;
  dataset.name = "HeRCULES";
  DatasetSensor& continental = dataset.sensors.emplace_back();
  continental.name = "HeRCULES Continental";
  continental.folders = {kContinental, "Continental"};
  continental.below = "Continental";
  continental.format = InputOptions::Format::kHercules;
  continental.proof = {"hercules29", "r", RecordProof::Kind::kRange};
  continental.open = OpenContinental;
  continental.written.word = "hercules";
  continental.written.folder = kContinental;
  continental.written.columns = "hercules29";
  continental.written.naming = WrittenForm::Naming::kNanoseconds;
  DatasetSensor& aeva = dataset.sensors.emplace_back();
  aeva.name = "HeRCULES Aeva";
  aeva.folders = {kAeva, "Aeva"};
  aeva.layouts = {"aeva"};
  aeva.open = OpenAeva;
  aeva.written.word = "aeva";
  aeva.written.folder = kAeva;
  aeva.written.columns = "aeva29";
  aeva.written.naming = WrittenForm::Naming::kNanoseconds;
  dataset.truth_files = {{"PR_GT/Continental_gt.txt", ReferenceOptions::Format::kTum},
                         {"PR_GT/Aeva_gt.txt", ReferenceOptions::Format::kTum}};
  return dataset;
}

}  // namespace radive
