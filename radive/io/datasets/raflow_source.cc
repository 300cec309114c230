// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/raflow_source.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include "radive/io/bytes/record_file.h"
#include "radive/io/datasets/raflow_json.h"
#include "radive/io/scans/scan_stamps.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestSearch = 6;

struct File {
  fs::path path;
  std::int64_t sequence = 0;
  std::int64_t sample = 0;
  std::int64_t interval_ns = 0;
  std::uint64_t first = 0;  // fingerprints of the two scans
  std::uint64_t second = 0;
};

// FNV-1a
std::uint64_t Fingerprint(const std::vector<char>& bytes) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
  }
  return hash;
}

bool ReadPair(const fs::path& path, RaFlowPair* pair, std::string* error) {
  std::string text;
  if (!ReadWholeFile(path, &text, error)) return false;
  std::string reason;
  if (ParseRaFlowPair(text, pair, &reason)) return true;
  *error = path.string() + ": " + reason;
  return false;
}

// The files at `path` or below it, in the order of folder, sequence and sample.
std::vector<File> FindFiles(const fs::path& path) {
  std::vector<File> files;
  const auto take = [&files](const fs::path& candidate) {
    File file;
    file.path = candidate;
    if (ParseRaFlowName(candidate.filename().string(), &file.sequence, &file.sample)) {
      files.push_back(std::move(file));
    }
  };
  std::error_code failure;
  if (!fs::is_directory(path, failure)) {
    take(path);
    return files;
  }
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator it(path, options, failure), end; !failure && it != end;
       it.increment(failure)) {
    if (it.depth() >= kDeepestSearch) it.disable_recursion_pending();
    take(it->path());
  }
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) {
    return std::make_tuple(a.path.parent_path(), a.sequence, a.sample) <
           std::make_tuple(b.path.parent_path(), b.sequence, b.sample);
  });
  return files;
}

bool Continues(const File& before, const File& file) {
  return file.path.parent_path() == before.path.parent_path() && file.sequence == before.sequence &&
         file.sample == before.sample + 1 && file.first == before.second;
}

// Clips as ranges [begin, end) of the files.
std::vector<std::pair<std::size_t, std::size_t>> FindClips(const std::vector<File>& files) {
  std::vector<std::pair<std::size_t, std::size_t>> clips;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i > 0 && Continues(files[i - 1], files[i])) {
      ++clips.back().second;
    } else {
      clips.emplace_back(i, i + 1);
    }
  }
  return clips;
}

struct Clip {
  std::vector<fs::path> files;
  std::vector<std::int64_t> stamps_ns;  // one more than files
  std::string description;
};

// The clip of that number from 1, or the longest if it is 0.
std::optional<Clip> ChooseClip(const fs::path& path, int number, std::string* error) {
  std::vector<File> files = FindFiles(path);
  if (files.empty()) {
    *error = path.string() +
             ": no scans found, expected files radar_seqs-S_samples-K.json (RaFlow) in it or below";
    return std::nullopt;
  }
  for (File& file : files) {
    RaFlowPair pair;
    if (!ReadPair(file.path, &pair, error)) return std::nullopt;
    file.interval_ns = pair.interval_ns;
    file.first = Fingerprint(pair.first.owned);
    file.second = Fingerprint(pair.second.owned);
  }
  const auto clips = FindClips(files);
  std::size_t chosen = static_cast<std::size_t>(number);
  if (chosen > clips.size()) {
    *error = "input.clip: " + path.string() + " has " + std::to_string(clips.size()) +
             " clips of consecutive scans, there is no number " + std::to_string(chosen);
    return std::nullopt;
  }
  if (chosen == 0) {
    const auto longest =
        std::max_element(clips.begin(), clips.end(), [](const auto& a, const auto& b) {
          return a.second - a.first < b.second - b.first;
        });
    chosen = static_cast<std::size_t>(longest - clips.begin()) + 1;
  }
  const auto [begin, end] = clips[chosen - 1];
  Clip clip;
  clip.stamps_ns = {0};
  for (std::size_t i = begin; i < end; ++i) {
    clip.files.push_back(files[i].path);
    clip.stamps_ns.push_back(clip.stamps_ns.back() + files[i].interval_ns);
  }
  clip.description =
      "RaFlow clip " + std::to_string(chosen) + " of " + std::to_string(clips.size()) +
      " (input.clip), samples " + std::to_string(files[begin].sample) + " to " +
      std::to_string(files[end - 1].sample) + " of sequence " +
      std::to_string(files[begin].sequence) + " in " + files[begin].path.parent_path().string();
  return clip;
}

}  // namespace

bool ParseRaFlowName(const std::string& name, std::int64_t* sequence, std::int64_t* sample) {
  constexpr std::string_view kFront = "radar_seqs-", kMiddle = "_samples-", kEnd = ".json";
  std::string_view rest = name;
  if (rest.substr(0, kFront.size()) != kFront) return false;
  rest.remove_prefix(kFront.size());
  const std::size_t middle = rest.find(kMiddle);
  const std::size_t end = rest.rfind(kEnd);
  if (middle == std::string_view::npos || end == std::string_view::npos ||
      end + kEnd.size() != rest.size() || end < middle + kMiddle.size()) {
    return false;
  }
  const auto first = ParseInteger(rest.substr(0, middle));
  const std::size_t begin = middle + kMiddle.size();
  const auto second = ParseInteger(rest.substr(begin, end - begin));
  if (!first || !second || *first < 0 || *second < 0) return false;
  *sequence = *first;
  *sample = *second;
  return true;
}

std::unique_ptr<RaFlowSource> RaFlowSource::Open(const fs::path& path,
                                                 const InputOptions& options,
                                                 std::string* error) {
  std::optional<Clip> clip =
      ChooseClip(options.folder.empty() ? path : path / options.folder, options.clip, error);
  if (!clip) return nullptr;
  return std::unique_ptr<RaFlowSource>(new RaFlowSource(
      std::move(clip->files), std::move(clip->stamps_ns), std::move(clip->description), options));
}

std::optional<RecordedTrajectory> ReadRaFlowPoses(const fs::path& path,
                                                  int clip_number,
                                                  std::string* error) {
  const std::optional<Clip> clip = ChooseClip(path, clip_number, error);
  if (!clip) return std::nullopt;
  RecordedTrajectory poses;
  for (std::size_t i = 0; i < clip->files.size(); ++i) {
    std::string text, reason;
    if (!ReadWholeFile(clip->files[i], &text, error)) return std::nullopt;
    MatrixPose first, second;
    if (!ParseRaFlowPoses(text, &first, &second, &reason)) {
      *error = clip->files[i].string() + ": " + reason;
      return std::nullopt;
    }
    poses.push_back({clip->stamps_ns[i], StampSeconds(clip->stamps_ns[i]), first});
    if (i + 1 < clip->files.size()) continue;
    poses.push_back({clip->stamps_ns[i + 1], StampSeconds(clip->stamps_ns[i + 1]), second});
  }
  return poses;
}

RaFlowSource::RaFlowSource(std::vector<fs::path> files,
                           std::vector<std::int64_t> stamps_ns,
                           std::string description,
                           const InputOptions& options)
    : files_(std::move(files)),
      stamps_ns_(std::move(stamps_ns)),
      description_(std::move(description)),
      converter_(options) {}

ScanSource::Status RaFlowSource::PassOver(RadarScan* scan) {
  if (next_ == stamps_ns_.size()) return Status::kEnd;
  const bool is_second = next_ == files_.size();
  const fs::path& file = files_[is_second ? next_ - 1 : next_];
  scan->stamp_ns = stamps_ns_[next_];
  scan->radar = 0;
  scan->has_doppler = true;
  scan->is_planar = false;
  scan->returns.clear();
  scan->place = file.string();
  ++next_;
  return Status::kScan;
}

ScanSource::Status RaFlowSource::Next(RadarScan* scan) {
  if (PassOver(scan) == Status::kEnd) return Status::kEnd;
  const bool is_second = next_ > files_.size();
  RaFlowPair pair;
  std::string reason;
  if (!ReadPair(scan->place, &pair, &reason) ||
      !converter_.Convert(is_second ? pair.second : pair.first, scan, &reason)) {
    warnings_.push_back(reason + "; taken as an empty scan");
  }
  return Status::kScan;
}

std::string RaFlowSource::Description() const { return description_; }

std::optional<int> RaFlowSource::NumScans() const { return static_cast<int>(stamps_ns_.size()); }

SourceFacts RaFlowSource::Facts() const {
  SourceFacts facts;
  facts.format = "RaFlow JSON";
  facts.place = description_;
  facts.stamp_origin = "the files' intervals, from 0";
  facts.fields = converter_.Summaries();
  facts.stamps_ns = stamps_ns_;
  return facts;
}

}  // namespace radive
