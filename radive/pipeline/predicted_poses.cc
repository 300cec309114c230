// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/predicted_poses.h"

#include "radive/util/number_text.h"
#include "radive/util/seconds.h"

namespace radive {
namespace {

// Longer than this, and more than so many scans.
constexpr double kLongestTime = 2.0;  // [s]
constexpr int kMostPredicted = 5;
// Many short ones: more than this share of a drive.
constexpr double kLargestShare = 0.4;
constexpr int kFewestScans = 20;

}  // namespace

void PredictedPoses::Add(const OdometryResult& result, const std::string& place) {
  ++num_scans_;
  if (result.status == OdometryResult::Status::kSkipped) return;
  if (result.status != OdometryResult::Status::kPredicted) {
    EndStretch();
    return;
  }
  if (length_++ == 0) {
    begin_ns_ = result.stamp_ns;
    reason_ = result.reason;
    place_ = place;
  }
  end_ns_ = result.stamp_ns;
  if (num_predicted_++ == 0) first_ = (place.empty() ? "" : place + ": ") + result.reason;
}

void PredictedPoses::EndStretch() {
  const double seconds = Seconds(end_ns_) - Seconds(begin_ns_);
  if (length_ > kMostPredicted && seconds > kLongestTime) {
    counted_.Add("stretches of predicted poses",
                 (place_.empty() ? "" : place_ + ": ") + "from here on " + std::to_string(length_) +
                     FormatText(" scans (%.1f s) were not registered, and their poses are "
                                "predicted: ",
                                seconds) +
                     reason_);
    has_warned_ = true;
  }
  length_ = 0;
}

void PredictedPoses::Finish() {
  EndStretch();
  const bool are_many = num_scans_ >= kFewestScans && num_predicted_ > kLargestShare * num_scans_;
  if (are_many && !has_warned_) {
    counted_.Add("drives with predicted poses",
                 FormatText("%d of %d scans were not registered, and their poses are predicted; "
                            "the first: ",
                            num_predicted_,
                            num_scans_) +
                     first_);
  }
  counted_.Finish();
}

}  // namespace radive
