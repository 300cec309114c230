// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/study_runs.h"

#include <glog/logging.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "radive/config/describe_config.h"
#include "radive/config/load_config.h"
#include "radive/config/yaml_settings.h"
#include "radive/util/content_hash.h"
#include "radive/util/random.h"

namespace radive {
namespace {

// The least of the limits, where 0 is none.
int LeastLimit(std::initializer_list<int> limits) {
  int least = 0;
  for (const int limit : limits) {
    if (limit > 0 && (least == 0 || limit < least)) least = limit;
  }
  return least;
}

std::string Joined(const std::vector<std::string>& settings) {
  std::string text;
  for (const std::string& setting : settings) {
    if (!setting.empty()) text += (text.empty() ? "" : ",") + setting;
  }
  return text;
}

bool HasVariant(const StudySequence& sequence, const StudyVariant& variant) {
  const std::vector<std::string>& names = sequence.variants;
  return names.empty() || std::find(names.begin(), names.end(), variant.name) != names.end();
}

// `configs`: one for each variant.
std::vector<StudyRun> RunsOf(const Study& study,
                             const StudySequence& sequence,
                             const std::vector<RunConfig>& configs) {
  // Without chance a recorded drive would give the same bytes for each seed.
  const bool depends_on_seed =
      study.perturb.is_active() || (sequence.is_simulated() && !sequence.has_fixed_drive);
  std::vector<StudyRun> runs;
  for (const int seed : study.seeds) {
    for (std::size_t i = 0; i < study.variants.size(); ++i) {
      if (!HasVariant(sequence, study.variants[i])) continue;
      StudyRun run;
      run.sequence = &sequence;
      run.variant = &study.variants[i];
      run.seed = seed;
      run.config = configs[i];
      // A simulated truth is that of the radar, whatever the configuration says of its data set's.
      if (sequence.is_simulated()) run.config.reference = ReferenceOptions();
      if (study.perturb.drop > 0.0) {
        run.config.perturbation.drop = study.perturb.drop;
        run.config.perturbation.seed = seed;
      }
      run.start = StartShift(sequence.name, seed, study.perturb.max_start_shift);
      run.frames = LeastLimit({study.frames, sequence.frames, run.variant->frames});
      runs.push_back(std::move(run));
    }
    if (!depends_on_seed) break;
  }
  return runs;
}

}  // namespace

std::string StudyRun::Name() const {
  return sequence->name + "/" + variant->name + "/" + std::to_string(seed);
}

std::optional<std::vector<StudyRun>> ListRuns(const Study& study, std::string* error) {
  std::vector<StudyRun> runs;
  for (const StudySequence& sequence : study.sequences) {
    std::vector<RunConfig> configs;
    for (const StudyVariant& variant : study.variants) {
      auto config =
          LoadRunConfig(sequence.config, Joined({study.set, sequence.set, variant.set}), error);
      if (!config) {
        *error = sequence.place + "sequence " + sequence.name + ", variant " + variant.name + ": " +
                 *error;
        return std::nullopt;
      }
      configs.push_back(*std::move(config));
    }
    for (StudyRun& run : RunsOf(study, sequence, configs)) runs.push_back(std::move(run));
  }
  return runs;
}

int StartShift(const std::string& sequence, int seed, int max_shift) {
  if (max_shift <= 0) return 0;
  const std::uint64_t name = std::strtoull(HashText(sequence).substr(0, 16).c_str(), nullptr, 16);
  Random random(name ^ Random(static_cast<std::uint64_t>(seed)).Bits());
  return static_cast<int>(random.Index(static_cast<std::uint64_t>(max_shift) + 1));
}

std::vector<StudyRun> Shard(const std::vector<StudyRun>& runs, int index, int count) {
  CHECK(index >= 0 && index < count) << "shard " << index << " of " << count;
  // By hash: in the order of the list, a slow variant would fall to one part as a whole.
  std::vector<std::pair<std::string, std::size_t>> order;
  for (std::size_t i = 0; i < runs.size(); ++i) order.emplace_back(HashText(runs[i].Name()), i);
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> chosen;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    if (rank % static_cast<std::size_t>(count) == static_cast<std::size_t>(index)) {
      chosen.push_back(order[rank].second);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  std::vector<StudyRun> part;
  for (const std::size_t i : chosen) part.push_back(runs[i]);
  return part;
}

std::string ConfigHash(const Study& study, const StudyRun& run) {
  ContentHash hash;
  hash.AddPart(EffectiveConfig(run.config));
  const std::string& decoder_file = run.config.odometry.neural_map.decoder_file;
  std::string decoder;
  std::string ignored;
  if (!decoder_file.empty())
    ReadTextFile(decoder_file, "decoder file", kLargestSettings, &decoder, &ignored);
  hash.AddPart(decoder);
  for (const int number : {run.start, run.frames, study.threads}) {
    hash.AddPart(std::to_string(number));
  }
  EvaluationOptions evaluation = study.evaluation;
  for (const OptionField& field : evaluation.Fields()) hash.AddPart(field.ToString());
  return hash.Hex();
}

}  // namespace radive
