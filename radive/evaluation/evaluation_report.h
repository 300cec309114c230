// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "radive/evaluation/evaluate.h"

namespace radive {

// A short table with units, for people.
std::string EvaluationTable(const EvaluationResult& result, const EvaluationOptions& options);

// One JSON object: rmse, mean, median, std, min, max, sse (of the errors in "unit"), matched
// (poses), count (errors), metric, relation, unit. For segments also mean_rotation_deg_per_m and
// mean_translation_percent. warnings: a list of sentences. Numbers read back as the same doubles.
// Ends with a line end.
std::string EvaluationJson(const EvaluationResult& result, const EvaluationOptions& options);

}  // namespace radive
