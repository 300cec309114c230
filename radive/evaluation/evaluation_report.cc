// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/evaluation_report.h"

#include <map>

#include "radive/util/angle_units.h"
#include "radive/util/json.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

// "APE of trans_part, align se3, plane xy"
std::string Title(const EvaluationOptions& options) {
  std::string title;
  switch (options.metric) {
    case EvaluationMetric::kApe:
      title = "Absolute pose error, " + options.Word("relation");
      break;
    case EvaluationMetric::kRpe:
      title = "Relative pose error, " + options.Word("relation") + " over " +
              FormatText("%g ", options.pairs.delta) + options.Word("delta_unit") +
              (options.pairs.all_pairs ? ", all pairs" : "") +
              (options.pairs_from_reference ? ", pairs from reference" : "");
      break;
    case EvaluationMetric::kSegments:
      title = "KITTI segment errors";
      break;
  }
  title += "; align " + options.Word("align");
  if (options.align_first > 0) title += " on the first " + std::to_string(options.align_first);
  if (options.plane != Plane::kNone) title += "; plane " + options.Word("plane");
  return title + "\n";
}

std::string SegmentTable(const SegmentDrift& drift) {
  struct Sum {
    int count = 0;
    double translation = 0.0;
    double rotation = 0.0;
  };
  std::map<double, Sum> by_length;
  for (const SegmentError& segment : drift.segments) {
    Sum& sum = by_length[segment.length];
    ++sum.count;
    sum.translation += segment.translation;
    sum.rotation += segment.rotation;
  }
  std::string table = "  length [m]  segments  translation [%]  rotation [deg/m]\n";
  for (const auto& [length, sum] : by_length) {
    table += FormatText("  %10.0f  %8d  %15.6f  %16.8f\n",
                        length,
                        sum.count,
                        100.0 * sum.translation / sum.count,
                        Degrees(sum.rotation / sum.count));
  }
  return table + FormatText("  %10s  %8zu  %15.6f  %16.8f\n",
                            "all",
                            drift.segments.size(),
                            100.0 * drift.translation,
                            Degrees(drift.rotation));
}

}  // namespace

std::string EvaluationTable(const EvaluationResult& result, const EvaluationOptions& options) {
  std::string table = Title(options);
  table += FormatText("  %d matched poses, of %d in the reference and %d in the estimate\n",
                      result.num_matched,
                      result.num_reference,
                      result.num_estimate);
  if (result.alignment.scale != 1.0) table += FormatText("  scale %.9g\n", result.alignment.scale);
  if (result.drift) return table + SegmentTable(*result.drift);

  const ErrorStatistics& s = result.statistics;
  const std::pair<const char*, double> rows[] = {{"rmse", s.rmse},
                                                 {"mean", s.mean},
                                                 {"median", s.median},
                                                 {"std", s.std},
                                                 {"min", s.min},
                                                 {"max", s.max}};
  const char* unit = result.unit.c_str();
  for (const auto& [name, value] : rows)
    table += FormatText("  %-7s %16.9f %s\n", name, value, unit);
  table += FormatText("  %-7s %16.9f %s^2\n", "sse", s.sse, unit);
  return table + FormatText("  %-7s %6d\n", "errors", s.count);
}

std::string EvaluationJson(const EvaluationResult& result, const EvaluationOptions& options) {
  const ErrorStatistics& s = result.statistics;
  Json json = {{"metric", options.Word("metric")},
               {"relation", options.Word("relation")},
               {"unit", result.unit},
               {"rmse", s.rmse},
               {"mean", s.mean},
               {"median", s.median},
               {"std", s.std},
               {"min", s.min},
               {"max", s.max},
               {"sse", s.sse},
               {"matched", result.num_matched},
               {"count", s.count}};
  if (result.drift) {
    json["relation"] = "translation_percent";
    json["mean_translation_percent"] = 100.0 * result.drift->translation;
    json["mean_rotation_deg_per_m"] = Degrees(result.drift->rotation);
  }
  json["warnings"] = result.warnings;
  // Names of files may be any bytes.
  return JsonText(json);
}

}  // namespace radive
