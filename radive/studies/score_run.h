// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "radive/evaluation/evaluation_options.h"
#include "radive/io/open/read_reference.h"
#include "radive/pipeline/run_scores.h"
#include "radive/studies/run_record.h"

namespace radive {

// All errors of an estimate against its reference; those that need rotations stay empty when the
// reference has none. `options` say how to match, align, project and choose the pairs; their
// metric and relation are not used. Nothing, with the reason in `error`, when the trajectories
// have no poses in common or too few.
std::optional<RunScores> ScoreRun(const RunEstimate& estimate,
                                  const Reference& reference,
                                  const EvaluationOptions& options,
                                  std::string* error);

}  // namespace radive
