// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "radive/evaluation/evaluation_options.h"
#include "radive/sensor/recorded_trajectory.h"
#include "radive/studies/run_record.h"

namespace radive {

// All errors of an estimate against its reference. `options` say how to match, align, project and
// choose the pairs; their metric and relation are not used. Nothing, with the reason in `error`,
// when the trajectories have no poses in common or too few.
std::optional<RunScores> ScoreRun(const RecordedTrajectory& reference,
                                  const RecordedTrajectory& estimate,
                                  const EvaluationOptions& options,
                                  std::string* error);

}  // namespace radive
