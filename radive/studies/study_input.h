// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "radive/studies/study_runs.h"

namespace radive {

// The input of a run and what is known of it. Runs of the same sequence share it; those of a
// simulated one with the same seed do.
//
//   OUTPUT/data/SEQUENCE/SEED/      simulated scans, by radive/pipeline/simulation_writer.h
//   OUTPUT/inputs/SEQUENCE/SEED.json    hash of the input, and when it must be taken again
//
// SEED is 0 for recorded drives.
class StudyInput {
 public:
  // `simulator_hash` tells one version of the simulator from another.
  StudyInput(const std::filesystem::path& output,
             const StudyRun& run,
             const std::string& simulator_hash);

  // The same for all runs that share the input: "SEQUENCE/SEED".
  const std::string& name() const { return name_; }
  const std::filesystem::path& folder() const { return folder_; }        // or file, of the scans
  const std::filesystem::path& reference() const { return reference_; }  // empty: none
  std::filesystem::path LockFile() const { return Note(".lock"); }

  // True for a recorded drive that is not on this machine.
  bool IsAbsent() const;

  // Hash of input and reference; nothing while Prepare() has not been called, or they have changed
  // since.
  std::optional<std::string> KnownHash() const;

  // Simulates what is to be simulated, and hashes. Takes long; whoever calls it holds LockFile().
  // False, with the reason in `error`, when that fails.
  bool Prepare(std::string* error) const;

  // Makes the folder in which LockFile() is.
  bool MakeFolders(std::string* error) const;

 private:
  std::filesystem::path Note(const std::string& extension) const;
  std::optional<std::string> Signature() const;
  bool Simulate(std::string* error) const;

  const std::filesystem::path output_;
  const std::string name_;
  const bool is_simulated_;
  const std::string scenario_;
  SimulationOptions simulation_;
  const std::string simulator_hash_;
  std::filesystem::path folder_;
  std::filesystem::path reference_;
};

}  // namespace radive
