// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/run_sequence.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radive/config/describe_config.h"
#include "radive/io/trajectories/trajectory_io.h"
#include "radive/odometry/odometry.h"
#include "radive/pipeline/doppler_checked_source.h"
#include "radive/pipeline/map_files.h"
#include "radive/pipeline/output_frame.h"
#include "radive/pipeline/plausibility.h"
#include "radive/pipeline/predicted_poses.h"
#include "radive/pipeline/result_writer.h"
#include "radive/pipeline/run_report.h"
#include "radive/pipeline/run_scores.h"
#include "radive/util/progress.h"
#include "radive/util/stopwatch.h"

namespace radive {
namespace {

// One run: the loop over the scans, and the files it leaves.
class SequenceRun {
 public:
  SequenceRun(const RunConfig& config, const RunRequest& request, ScanSource* source)
      : config_(config),
        request_(request),
        stored_(source),
        checked_source_(source, MakeDopplerCheck(config)),
        source_(config.odometry.ego_velocity.enabled ? &checked_source_ : source),
        odometry_(WithRecord(config)),
        map_(config.output.map_resolution),
        progress_(stderr,
                  request.quiet ? Progress::Mode::kQuiet : Progress::ModeFor(stderr),
                  NumScansToRun()) {}

  RunStatus Run(std::string* error) {
    // A run that cannot begin leaves the folder, and earlier results in it, as they are.
    if (!ReadItsReference(error) || !SkipStart(error) || !writer_.Open(request_.output, error)) {
      return RunStatus::kFailed;
    }
    progress_.Message(stored_->Description());
    RunStatus status = AddScans(error);
    checked_source_.Conclude();
    TellAboutSource();
    predicted_.Finish();
    for (const std::string& warning : predicted_.TakeWarnings()) Warn(warning);
    const std::vector<std::string> implausible = plausibility_.Warnings();
    for (const std::string& warning : implausible) Warn(warning);
    // Of zero scans that were asked for, zero poses are the result.
    if (status == RunStatus::kDone && request_.num_frames.value_or(1) > 0) {
      const std::string reason = report_.WhyNoResult();
      if (!reason.empty()) {
        *error = request_.input + ": " + reason;
        for (const std::string& warning : implausible) *error += "; " + warning;
        status = RunStatus::kNoResult;
      }
    }
    progress_.Finish();
    // Nothing to say of a drive of which nothing was seen: earlier results are worth more.
    if (status == RunStatus::kInterrupted && report_.num_scans() == 0) return status;
    // The disk is full: earlier results stay, and the scans are in the partial files.
    if (has_failed_to_write_) return status;
    std::string write_error;
    if (!WriteFiles(status, *error, &write_error) && status != RunStatus::kFailed) {
      *error = write_error;
      status = RunStatus::kFailed;
    }
    return status;
  }

  const std::string& scores() const { return scores_; }

 private:
  static OdometryOptions WithRecord(const RunConfig& config) {
    OdometryOptions options = config.odometry;
    options.sdf_submap.record = config.output.NeedsSurface();
    options.sdf_submap.record_grid_spacing =
        config.output.map == OutputOptions::Map::kMesh ? config.output.mesh_resolution : 0.0;
    return options;
  }

  static DopplerCheck MakeDopplerCheck(const RunConfig& config) {
    const bool is_given = config.input.doppler_sign != InputOptions::DopplerSign::kAuto;
    return DopplerCheck(config.odometry.sensor,
                        config.odometry.preprocessing,
                        is_given ? DopplerCheck::Sign::kGiven : DopplerCheck::Sign::kUnknown);
  }

  std::optional<int> NumScansToRun() const {
    std::optional<int> total = stored_->NumScans();
    if (total) total = std::max(0, *total - request_.start);
    if (request_.num_frames)
      total = std::min(total.value_or(*request_.num_frames), *request_.num_frames);
    return total;
  }

  bool ReadItsReference(std::string* error) {
    if (request_.reference.empty()) return true;
    reference_ = ReadReference(request_.reference, config_.reference, config_.input.clip, error);
    if (!reference_) return false;
    for (const std::string& warning : reference_->warnings) Warn(warning);
    return true;
  }

  bool IsStopped() const { return request_.stop != nullptr && request_.stop->load(); }

  bool SkipStart(std::string* error) {
    if (request_.start == 0) return true;
    const ScanSource::Status status = stored_->Skip(request_.start);
    if (status == ScanSource::Status::kError) {
      *error = stored_->error();
      return false;
    }
    const std::optional<int> total = stored_->NumScans();
    if (status == ScanSource::Status::kEnd || (total && request_.start >= *total)) {
      *error = request_.input + ": no scan is left after leaving out the first " +
               std::to_string(request_.start) +
               (total ? " of " + std::to_string(*total) : std::string());
      return false;
    }
    return true;
  }

  RunStatus AddScans(std::string* error) {
    RadarScan scan;
    while (!request_.num_frames || report_.num_scans() < *request_.num_frames) {
      if (IsStopped()) return RunStatus::kInterrupted;
      const Stopwatch read_time;
      const ScanSource::Status status = source_->Next(&scan);
      const ScanInfo info = {scan.radar, read_time.Milliseconds()};
      TellAboutSource();
      if (status == ScanSource::Status::kEnd) break;
      if (status == ScanSource::Status::kError) {
        *error = source_->error();
        return RunStatus::kFailed;
      }
      plausibility_.AddScan(scan);
      if (const auto v_radar = checked_source_.check().MotionOfPoints(scan)) {
        odometry_.StartMotion(scan.radar, *v_radar);
      }
      OdometryResult result = odometry_.AddScan(scan);
      plausibility_.AddPose(result);
      predicted_.Add(result, scan.place);
      for (const std::string& warning : predicted_.TakeWarnings()) Warn(warning);
      checked_source_.AddVelocity(scan, result.ego_velocity);
      if (!frame_) frame_.emplace(config_, scan.radar);
      frame_->Apply(&result);
      for (const std::string& note : odometry_.TakeNotes()) Note(note);
      for (const std::string& warning : odometry_.TakeWarnings()) Warn(warning);
      if (config_.output.map == OutputOptions::Map::kPoints) map_.Add(result.keyframe_points);
      report_.AddScan(result, info.read_ms, scan.place);
      if (!writer_.AddScan(info, result, error)) {
        has_failed_to_write_ = true;
        return RunStatus::kFailed;
      }
      progress_.Update(report_.num_scans());
    }
    return RunStatus::kDone;
  }

  void Note(const std::string& note) {
    report_.AddNote(note);
    progress_.Message(note);
  }

  void Warn(const std::string& warning) {
    report_.AddWarning(warning);
    progress_.Message("warning: " + warning);
  }

  void TellAboutSource() {
    for (const std::string& warning : source_->TakeWarnings()) Warn(warning);
    for (const DopplerRemark& remark : checked_source_.TakeRemarks()) {
      if (remark.is_warning) {
        Warn(remark.text);
      } else {
        Note(remark.text);
      }
    }
  }

  // False when a file could not be written, then earlier results stay, or when there are no scores.
  bool WriteFiles(RunStatus status, const std::string& run_error, std::string* error) {
    if (!writer_.EndScans(error)) return false;
    std::vector<RadarSurface> surfaces;
    if (config_.output.NeedsSurface()) {
      surfaces = odometry_.TakeSurfaces();
      for (RadarSurface& surface : surfaces) frame_->Apply(&surface);
      if (surfaces.empty()) Warn("the neural submap has learned no surface: its map is empty");
    }
    for (const MapFile& file :
         MakeMapFiles(config_.output, config_.odometry.surface, map_.points(), surfaces)) {
      if (file.bytes && !writer_.WriteText(file.name, *file.bytes, error)) return false;
    }
    std::string no_scores;
    if (reference_ && run_error.empty()) {
      const std::string json = Scores(status, &no_scores);
      if (!json.empty() && !writer_.WriteText("scores.json", json, error)) return false;
      if (!no_scores.empty() && status == RunStatus::kInterrupted)
        Warn(std::exchange(no_scores, ""));
    }
    if (!writer_.WriteText("config.yaml", EffectiveConfig(config_), error)) return false;
    RunReport::Facts facts;
    facts.version = request_.version;
    facts.command_line = request_.command_line;
    facts.input = request_.input;
    facts.source = stored_->Description();
    facts.start = request_.start;
    facts.max_frames = request_.num_frames;
    if (frame_) facts.T_frame_reference = frame_->T_output_reference();
    facts.interrupted = status == RunStatus::kInterrupted;
    facts.error = run_error.empty() ? no_scores : run_error;
    facts.wall_seconds = wall_time_.Milliseconds() / 1000.0;
    if (!writer_.WriteText("run.json", report_.ToJson(config_, facts), error) ||
        !writer_.Publish(error)) {
      return false;
    }
    *error = no_scores;
    return no_scores.empty();
  }

  // The text of scores.json, of the trajectory as it was written, so that radive_evaluate gives the
  // same. Empty, with the reason, when there are none.
  std::string Scores(RunStatus status, std::string* error) {
    auto trajectory =
        ReadTrajectory(writer_.Partial("trajectory_tum.txt"), TrajectoryFormat::kTum, error);
    if (!trajectory) return "";
    RunEstimate estimate;
    estimate.poses = *std::move(trajectory);
    estimate.start = request_.start;
    estimate.is_partial = request_.num_frames || status == RunStatus::kInterrupted;
    if (frame_) estimate.T_output_reference = frame_->T_output_reference();
    std::string reason;
    const auto scores = ScoreEstimate(estimate, *reference_, config_.reference, &reason);
    if (!scores) {
      *error = request_.reference + ": no scores: " + reason;
      return "";
    }
    for (const std::string& warning : scores->front().result.warnings) {
      Warn(request_.reference + ": " + warning);
    }
    scores_ = ScoresText(*scores, *reference_);
    return ScoresJson(*scores, *reference_, request_.reference);
  }

  const RunConfig& config_;
  const RunRequest& request_;
  const Stopwatch wall_time_;
  ScanSource* const stored_;
  DopplerCheckedSource checked_source_;
  ScanSource* const source_;
  Odometry odometry_;
  std::optional<OutputFrame> frame_;  // from the first scan on
  std::optional<Reference> reference_;
  std::string scores_;
  MapThinner map_;
  ResultWriter writer_;
  RunReport report_;
  Plausibility plausibility_;
  PredictedPoses predicted_;
  Progress progress_;
  bool has_failed_to_write_ = false;
};

}  // namespace

RunStatus RunSequence(const RunConfig& config,
                      const RunRequest& request,
                      ScanSource* source,
                      std::string* error,
                      std::string* scores) {
  error->clear();
  if (!config.IsValid(error)) return RunStatus::kFailed;
  SequenceRun run(config, request, source);
  const RunStatus status = run.Run(error);
  if (scores != nullptr) *scores = run.scores();
  return status;
}

}  // namespace radive
