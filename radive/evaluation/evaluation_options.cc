// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/evaluation_options.h"

#include <glog/logging.h>

#include <algorithm>

namespace radive {
namespace {

OptionField::Choice ChoiceNamed(const std::vector<OptionField>& fields, const std::string& name) {
  const auto field = std::find_if(
      fields.begin(), fields.end(), [&](const OptionField& f) { return f.name == name; });
  CHECK(field != fields.end()) << "no such field: " << name;
  return std::get<OptionField::Choice>(field->value);
}

}  // namespace

std::vector<OptionField> EvaluationOptions::Fields() {
  std::vector<OptionField> fields = {
      {"metric", MakeChoice(&metric, {"ape", "rpe", "segments"}), "-", "Which errors to compute."},
      {"relation",
       MakeChoice(&relation,
                  {"trans_part",
                   "angle_deg",
                   "angle_rad",
                   "rot_part",
                   "full",
                   "point_distance",
                   "point_distance_ratio"}),
       "-",
       "What of a pose difference counts as the error."},
      {"match",
       MakeChoice(&match, {"stamp", "line", "interpolate"}),
       "-",
       "Which poses belong together: those with the nearest stamps, those of the same number, or "
       "the reference interpolated at the stamps of the estimate."},
      OptionField{
          "max_time_difference", &max_time_difference, "s", "Largest difference of matched stamps."}
          .AtLeast(0.0),
      OptionField{"max_gap", &max_gap, "s", "Longest interval of the reference to interpolate in."}
          .Above(0.0),
      {"align",
       MakeChoice(&align, {"none", "se3", "sim3", "scale_only", "origin"}),
       "-",
       "Alignment of the estimate to the reference."},
      OptionField{"align_first", &align_first, "poses", "Poses used to align, 0: all."}.AtLeast(0),
      {"plane",
       MakeChoice(&plane, {"none", "xy", "xz", "yz"}),
       "-",
       "Plane into which both trajectories are projected after the alignment."},
      {"pairs_from_reference",
       &pairs_from_reference,
       "-",
       "Choose the pairs of rpe on the reference instead of the estimate."},
  };
  for (OptionField& field : pairs.Fields()) fields.push_back(std::move(field));
  return fields;
}

bool EvaluationOptions::IsValid(std::string* error) const {
  if (!CheckOptions("evaluation", *this, error)) return false;
  if (align_first > 0 && (align == AlignmentMode::kNone || align == AlignmentMode::kOrigin)) {
    *error = "evaluation.align_first needs align se3, sim3 or scale_only, is " +
             std::to_string(align_first) + " with " + Word("align");
    return false;
  }
  return metric != EvaluationMetric::kRpe || pairs.IsValid(error);
}

bool EvaluationOptions::SetWord(const std::string& name,
                                const std::string& word,
                                std::string* error) {
  const OptionField::Choice choice = ChoiceNamed(Fields(), name);
  const auto found = std::find(choice.names.begin(), choice.names.end(), word);
  if (found == choice.names.end()) {
    *error = name + " must be one of";
    for (std::size_t i = 0; i < choice.names.size(); ++i) {
      *error += (i == 0 ? " " : " | ") + choice.names[i];
    }
    *error += ", is '" + word + "'";
    return false;
  }
  choice.set(static_cast<int>(found - choice.names.begin()));
  return true;
}

std::string EvaluationOptions::Word(const std::string& name) const {
  EvaluationOptions copy = *this;
  const OptionField::Choice choice = ChoiceNamed(copy.Fields(), name);
  return choice.names.at(static_cast<std::size_t>(choice.get()));
}

}  // namespace radive
