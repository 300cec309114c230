// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radive/config/run_config.h"
#include "radive/studies/study.h"

namespace radive {

// One run of a study. Points into the study that it was listed from.
struct StudyRun {
  const StudySequence* sequence = nullptr;
  const StudyVariant* variant = nullptr;
  int seed = 0;

  RunConfig config;  // resolved, with the perturbation of the seed
  int start = 0;     // scans left out at the beginning
  int frames = 0;    // largest number of scans; 0: all

  std::string Name() const;  // "SEQUENCE/VARIANT/SEED", also its folder
};

// All runs: for each sequence and each seed one for each variant, so that those that are compared
// run one after the other. Nothing when the settings of a sequence and a variant do not fit
// each other, or a configuration file cannot be read: `error` names both.
std::optional<std::vector<StudyRun>> ListRuns(const Study& study, std::string* error);

// Number of scans left out at the beginning of `sequence` with this seed, 0 to `max_shift`.
int StartShift(const std::string& sequence, int seed, int max_shift);

// The part `index` of `count` of the runs; the parts differ in size by one run at most, and what
// takes long is spread over them by chance. `index` from 0 (checked).
std::vector<StudyRun> Shard(const std::vector<StudyRun>& runs, int index, int count);

// All that the results of the run follow from apart from input and program, hashed.
std::string ConfigHash(const Study& study, const StudyRun& run);

}  // namespace radive
