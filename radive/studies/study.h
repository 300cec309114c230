// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "radive/evaluation/evaluation_options.h"
#include "radive/simulation/simulation_options.h"

namespace radive {

// A drive of a study: recorded, or simulated anew for each seed.
struct StudySequence {
  std::string name;  // also the name of its folders

  std::filesystem::path input;      // recorded drives
  std::filesystem::path reference;  // empty: not scored

  std::string scenario;  // simulated drives; empty: a recorded one
  SimulationOptions simulation;
  bool has_fixed_drive = false;  // simulation.seed counts, instead of the seed of the run

  std::string config;                 // configuration file; empty: the defaults
  std::string set;                    // settings on top, as --set takes them
  int frames = 0;                     // largest number of scans; 0: all
  std::vector<std::string> variants;  // only these; empty: all
  std::string place;                  // "STUDY.yaml:12: ", for messages

  bool is_simulated() const { return !scenario.empty(); }
};

// A set of settings under which every sequence is run.
struct StudyVariant {
  std::string name;   // also the name of its folders
  std::string label;  // for tables
  std::string set;
  int frames = 0;
  std::string place;
};

// Makes each seed a slightly different drive, to measure how much a result depends on chance.
struct Perturbation {
  double drop = 0.0;        // share of the returns left out [-]
  int max_start_shift = 0;  // 0 to this many scans are left out at the beginning

  std::vector<OptionField> Fields();
  bool is_active() const { return drop > 0.0 || max_start_shift > 0; }
};

// What is to be run: every sequence with every variant and every seed.
struct Study {
  enum class Absent { kFail, kMark };

  std::string name;  // of the file, without ".yaml"
  std::vector<StudySequence> sequences;
  std::vector<StudyVariant> variants;  // the others are compared with the first
  std::vector<int> seeds = {0};
  Perturbation perturb;
  EvaluationOptions evaluation;  // without metric, relation and what the run's reference.* says

  std::string config;               // of sequences that name none
  std::string set;                  // of all runs
  int frames = 0;                   // largest number of scans; 0: all
  double timeout = 0.0;             // of a run [s]; 0: none
  int threads = 1;                  // of a run
  Absent absent = Absent::kFail;    // what becomes of a sequence that is not there
  std::filesystem::path published;  // table of published figures; empty: none
};

}  // namespace radive
