// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/evaluation/alignment.h"
#include "radive/evaluation/pose_pairs.h"
#include "radive/evaluation/pose_relation.h"
#include "radive/evaluation/projection.h"
#include "radive/util/option_field.h"

namespace radive {

enum class EvaluationMetric { kApe, kRpe, kSegments };

enum class PoseMatch {
  kStamp,       // those with the nearest stamps
  kLine,        // those of the same number, where there are no stamps
  kInterpolate  // the reference is brought to the stamps of the estimate
};

// What to compare of two trajectories, and how. The defaults are those of evo.
struct EvaluationOptions {
  EvaluationMetric metric = EvaluationMetric::kApe;

  // The error within ape and rpe; segments have their own.
  PoseRelation relation = PoseRelation::kTransPart;

  // Which poses belong together. evo knows the first two.
  PoseMatch match = PoseMatch::kStamp;
  double max_time_difference = 0.01;  // between matched stamps [s]
  double max_gap = 1.0;               // longest interval of the reference to interpolate in [s]

  // Alignment of the estimate; a fit uses the first `align_first` matched poses, 0: all.
  AlignmentMode align = AlignmentMode::kNone;
  int align_first = 0;

  // Projection of both trajectories, after the alignment.
  Plane plane = Plane::kNone;

  // Pairs of poses for rpe, chosen on the estimate unless `pairs_from_reference`.
  PosePairOptions pairs;
  bool pairs_from_reference = false;

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const;

  // Sets the field `name`, whose value is a word ("metric", "relation", "match", "align",
  // "plane", "delta_unit"). False, with the words allowed in `error`, for another word.
  // A name that is none of these is a programmer's error.
  bool SetWord(const std::string& name, const std::string& word, std::string* error);

  // The word of such a field, for reports.
  std::string Word(const std::string& name) const;
};

}  // namespace radive
