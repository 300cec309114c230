// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/load_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "radive/studies/study_runs.h"
#include "tests/scratch_folder.h"
#include "tests/studies/study_file.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::LoadStudyText;
using testing::ScratchFolder;
using testing::WriteTextFile;
namespace fs = std::filesystem;

constexpr char kSequences[] = "sequences:\n  - {name: a, input: drive_a}\n";

TEST(LoadStudy, ReadsEveryKey) {
  const ScratchFolder scratch;
  const Study study = LoadStudyText(scratch.path(), R"(
config: base.yaml
set: {output.map: none, sensor.sigma_range: 0.25}
seeds: 3-5
frames: 100
timeout: 2.5
threads: 2
absent: mark
perturb: {drop: 0.02, max_start_shift: 7}
evaluate: {plane: none, delta: 100, delta_unit: m}
published: figures.csv
sequences:
  - name: recorded
    input: drive
    reference: "{name}.txt"
    config: other.yaml
    set: {input.layout: "[x,y,z,doppler,power]"}
    frames: 50
  - scenario: street_sparse
    simulate: {frames: 20, moving_cars: 0}
  - scenario: street_dense
    name: fixed
    drives: [4, 7]
variants:
  - name: ours
  - {name: sdf, label: SDF submap, set: {submap.type: sdf}, frames: 10}
)");
  EXPECT_EQ(study.name, "study");
  EXPECT_EQ(study.set, "output.map=none,sensor.sigma_range=0.25");
  EXPECT_THAT(study.seeds, ElementsAre(3, 4, 5));
  EXPECT_EQ(study.timeout, 2.5);
  EXPECT_EQ(study.threads, 2);
  EXPECT_EQ(study.absent, Study::Absent::kMark);
  EXPECT_EQ(study.perturb.drop, 0.02);
  EXPECT_EQ(study.perturb.max_start_shift, 7);
  EXPECT_EQ(study.evaluation.align, AlignmentMode::kSe3);
  EXPECT_EQ(study.evaluation.plane, Plane::kNone);
  EXPECT_EQ(study.evaluation.pairs.delta, 100.0);
  EXPECT_EQ(study.published, scratch.path() / "figures.csv");

  ASSERT_EQ(study.sequences.size(), 4u);
  const StudySequence& recorded = study.sequences[0];
  EXPECT_EQ(recorded.input, scratch.path() / "drive");
  EXPECT_EQ(recorded.reference, scratch.path() / "recorded.txt");
  EXPECT_EQ(recorded.config, (scratch.path() / "other.yaml").string());
  EXPECT_EQ(recorded.set, "input.layout=\"[x,y,z,doppler,power]\"");
  const StudySequence& simulated = study.sequences[1];
  EXPECT_EQ(simulated.name, "street_sparse");
  EXPECT_EQ(simulated.simulation.sensor, SensorType::kArs548);
  EXPECT_EQ(simulated.simulation.frames, 20);
  EXPECT_EQ(simulated.config, (scratch.path() / "base.yaml").string());
  EXPECT_FALSE(simulated.has_fixed_drive);
  EXPECT_EQ(study.sequences[3].name, "fixed_7");
  EXPECT_EQ(study.sequences[3].simulation.seed, 7);
  EXPECT_TRUE(study.sequences[3].has_fixed_drive);

  ASSERT_EQ(study.variants.size(), 2u);
  EXPECT_EQ(study.variants[0].label, "ours");
  EXPECT_EQ(study.variants[1].label, "SDF submap");
  EXPECT_EQ(study.variants[1].set, "submap.type=sdf");
  EXPECT_EQ(study.variants[1].frames, 10);
}

TEST(LoadStudy, HasDefaults) {
  const ScratchFolder scratch;
  const Study study = LoadStudyText(scratch.path(), kSequences);
  EXPECT_THAT(study.seeds, ElementsAre(0));
  ASSERT_EQ(study.variants.size(), 1u);
  EXPECT_EQ(study.variants[0].name, "default");
  EXPECT_EQ(study.sequences[0].config, "");
  EXPECT_EQ(study.evaluation.plane, Plane::kXy);
}

TEST(LoadStudy, GlobsAndRootsGiveThePlaces) {
  const ScratchFolder scratch;
  for (const char* drive : {"day_10", "day_2", "other"}) {
    fs::create_directories(scratch.path() / "data" / "city" / drive);
  }
  const fs::path file = WriteTextFile(scratch.path() / "studies" / "mine.yaml",
                                      "sequences:\n"
                                      "  - glob: city/day_*\n"
                                      "    name: city_\n"
                                      "    reference: '{input}/gt.txt'\n"
                                      "  - {name: b, input: city/other, reference: b.txt}\n");
  std::string error;
  const auto study = LoadStudy(file, {scratch.path() / "data", scratch.path() / "truth"}, &error);
  ASSERT_TRUE(study) << error;
  ASSERT_EQ(study->sequences.size(), 3u);
  EXPECT_EQ(study->sequences[0].name, "city_day_2");
  EXPECT_EQ(study->sequences[1].name, "city_day_10");
  EXPECT_EQ(study->sequences[1].input, scratch.path() / "data/city/day_10");
  EXPECT_EQ(study->sequences[1].reference, scratch.path() / "data/city/day_10/gt.txt");
  EXPECT_EQ(study->sequences[2].reference, scratch.path() / "truth/b.txt");
}

TEST(LoadStudy, SaysWhereAndWhatIsWrong) {
  const ScratchFolder scratch;
  const auto fails_with = [&](const std::string& text, const std::string& message) {
    const fs::path file = WriteTextFile(scratch.path() / "study.yaml", text);
    std::string error;
    EXPECT_FALSE(LoadStudy(file, {}, &error)) << text;
    EXPECT_THAT(error, HasSubstr(file.string() + ":" + message));
  };
  const std::string sequences = kSequences;
  fails_with("seeds: 1\n", "1: there are no sequences");
  fails_with("- 1\n", "1: expected \"sequences:\"");
  fails_with("sequences: 3\n", "1: sequences must be a list");
  fails_with(sequences + "sedes: 1\n", "3: unknown key study.sedes, did you mean study.seeds?");
  fails_with(sequences + "seeds: 4-2\n", "3: seeds must be a number, a range like 0-4");
  fails_with(sequences + "seeds: [1, 1]\n", "3: seeds must be");
  fails_with(sequences + "seeds: 1\nseeds: 2\n", "4: study.seeds is set twice");
  fails_with(sequences + "timeout: -1\n", "3: study.timeout must be >= 0");
  fails_with(sequences + "absent: maybe\n", "3: study.absent must be one of fail | mark");
  fails_with(sequences + "perturb: {drop: 2}\n", "3: perturb.drop must be");
  fails_with(sequences + "evaluate: {plane: ab}\n", "3: evaluate.plane must be one of none | xy");
  fails_with(sequences + "evaluate: {metric: rpe}\n", "3: unknown key evaluate.metric");
  fails_with(sequences + "set: {submap: 3}\n", "3: expected stage.field: value, got \"submap\"");
  fails_with(sequences + "set:\n  submap.type: sfd\n",
             "4: submap.type must be one of raw | sdf, is sfd (did you mean sdf?)");
  fails_with(sequences + "variants:\n  - name: x\n    set:\n      submap.typ: sdf\n",
             "6: unknown key submap.typ, did you mean submap.type?");
  fails_with(sequences + "variants:\n  - name: x\n  - name: x\n",
             "5: there are two variants named x");
  fails_with(sequences + "variants:\n  - name: a/b\n", "4: the name of a variant must be letters");
  fails_with("sequences:\n  - name: a\n",
             "2: a sequence must have one of input, glob and scenario");
  fails_with("sequences:\n  - {input: a, scenario: street_dense}\n", "2: a sequence must have one");
  fails_with("sequences:\n  - {input: a, simulate: {frames: 3}}\n",
             "2: simulate and drives are for");
  fails_with("sequences:\n  - scenario: street_desne\n", "2: scenario must be one of street_dense");
  fails_with("sequences:\n  - scenario: street_dense\n    simulate:\n      frames: -1\n",
             "4: simulate.frames must be >= 1");
  fails_with("sequences:\n  - {scenario: street_dense, reference: a.txt}\n",
             "2: a scenario brings");
  fails_with("sequences:\n  - {name: a, input: b, inptu: c}\n", "2: unknown key sequence.inptu");
  fails_with("sequences:\n  - glob: nothing_*\n", "2: " + (scratch.path() / "nothing_*").string());
  fails_with("sequences:\n  - {input: a, name: a, variants: b}\n",
             "2: variants must be a list of names");
  fails_with("sequences:\n  - {input: a, name: a, variants: [b]}\n",
             "2: sequence a names the variant b, which the study does not have");
  fails_with("sequences: [\n", "2: not valid YAML");
}

TEST(LoadStudy, NamesAFileThatIsNotThere) {
  std::string error;
  EXPECT_FALSE(LoadStudy("nowhere.yaml", {}, &error));
  EXPECT_THAT(error, HasSubstr("nowhere.yaml: cannot read the study file"));
}

std::vector<StudyRun> Runs(const Study& study) {
  std::string error;
  const auto runs = ListRuns(study, &error);
  EXPECT_TRUE(runs.has_value()) << error;
  return runs.value_or(std::vector<StudyRun>());
}

TEST(StudyRuns, AreSequencesTimesSeedsTimesVariants) {
  const ScratchFolder scratch;
  const Study study = LoadStudyText(scratch.path(),
                                    "seeds: 0-1\nframes: 40\n"
                                    "sequences:\n"
                                    "  - {name: a, input: a, frames: 30}\n"
                                    "  - {scenario: street_sparse}\n"
                                    "variants:\n"
                                    "  - name: u\n"
                                    "  - {name: v, set: {submap.type: sdf}, frames: 35}\n");
  const std::vector<StudyRun> runs = Runs(study);
  std::vector<std::string> names;
  for (const StudyRun& run : runs) names.push_back(run.Name());
  // The recorded drive gives the same result for each seed.
  EXPECT_THAT(names,
              ElementsAre("a/u/0",
                          "a/v/0",
                          "street_sparse/u/0",
                          "street_sparse/v/0",
                          "street_sparse/u/1",
                          "street_sparse/v/1"));
  EXPECT_EQ(runs[1].frames, 30);
  EXPECT_EQ(runs[2].frames, 40);
  EXPECT_EQ(runs[3].frames, 35);
  EXPECT_EQ(runs[1].config.odometry.submap.type, SubmapOptions::Type::kSdf);
  EXPECT_NE(ConfigHash(study, runs[0]), ConfigHash(study, runs[1]));
  EXPECT_EQ(ConfigHash(study, runs[0]), ConfigHash(study, Runs(study)[0]));
}

// A configuration says where the body of its data set's ground truth sits; that of the simulator is
// the radar.
TEST(StudyRuns, SimulatedTruthIsOfTheRadar) {
  const ScratchFolder scratch;
  const Study study = LoadStudyText(scratch.path(),
                                    "set: {reference.mounted_on: vehicle}\n"
                                    "sequences:\n"
                                    "  - {name: a, input: a}\n"
                                    "  - {scenario: street_planar}\n");
  const std::vector<StudyRun> runs = Runs(study);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].config.reference.mounted_on, ReferenceOptions::MountedOn::kVehicle);
  EXPECT_EQ(runs[1].config.reference.mounted_on, ReferenceOptions::MountedOn::kRadar);
}

TEST(StudyRuns, ASequenceMayHaveSomeVariantsOnly) {
  const ScratchFolder scratch;
  const Study study = LoadStudyText(scratch.path(),
                                    "sequences:\n"
                                    "  - {name: a, input: a, variants: [w, u]}\n"
                                    "  - {name: b, input: b}\n"
                                    "variants:\n  - name: u\n  - name: v\n  - name: w\n");
  std::vector<std::string> names;
  for (const StudyRun& run : Runs(study)) names.push_back(run.Name());
  EXPECT_THAT(names, ElementsAre("a/u/0", "a/w/0", "b/u/0", "b/v/0", "b/w/0"));
}

TEST(StudyRuns, PerturbationIsTheSameForAllVariants) {
  const ScratchFolder scratch;
  const Study study = LoadStudyText(scratch.path(),
                                    "seeds: 0-199\nperturb: {drop: 0.02, max_start_shift: 7}\n"
                                    "sequences:\n  - {name: a, input: a}\n  - {name: b, input: b}\n"
                                    "variants:\n  - name: u\n  - name: v\n");
  const std::vector<StudyRun> runs = Runs(study);
  ASSERT_EQ(runs.size(), 800u);
  std::vector<int> counts(8);
  int differs = 0;
  for (std::size_t i = 0; i < 400; i += 2) {
    EXPECT_EQ(runs[i].start, runs[i + 1].start);
    EXPECT_EQ(runs[i].config.perturbation.drop, 0.02);
    EXPECT_EQ(runs[i].config.perturbation.seed, runs[i].seed);
    ++counts.at(static_cast<std::size_t>(runs[i].start));
    differs += runs[i].start != runs[i + 400].start ? 1 : 0;
  }
  for (const int count : counts) EXPECT_NEAR(count, 25, 15);  // 200 runs over 8 shifts
  EXPECT_GT(differs, 100);                                    // of sequence a and b
}

TEST(StudyRuns, ShardsTakeEachRunOnce) {
  const ScratchFolder scratch;
  const Study study = LoadStudyText(scratch.path(),
                                    "seeds: 0-9\nsequences:\n  - scenario: street_sparse\n"
                                    "variants:\n  - name: u\n  - name: v\n  - name: w\n");
  const std::vector<StudyRun> runs = Runs(study);
  ASSERT_EQ(runs.size(), 30u);
  std::vector<std::string> names;
  for (int i = 0; i < 4; ++i) {
    const std::vector<StudyRun> part = Shard(runs, i, 4);
    EXPECT_GE(part.size(), 7u);
    EXPECT_LE(part.size(), 8u);
    for (const StudyRun& run : part) names.push_back(run.Name());
  }
  std::vector<std::string> all;
  for (const StudyRun& run : runs) all.push_back(run.Name());
  EXPECT_THAT(names, ::testing::UnorderedElementsAreArray(all));
}

TEST(StudyRuns, NameTheSequenceWhoseSettingsDoNotFit) {
  const ScratchFolder scratch;
  const Study study =
      LoadStudyText(scratch.path(), "sequences:\n  - {name: a, input: a, config: nowhere.yaml}\n");
  std::string error;
  EXPECT_FALSE(ListRuns(study, &error));
  EXPECT_THAT(error, HasSubstr("study.yaml:2: sequence a, variant default: "));
  EXPECT_THAT(error, HasSubstr("nowhere.yaml: cannot read the configuration file"));
}

std::string ErrorOf(const fs::path& folder, const std::string& text) {
  std::string error;
  EXPECT_FALSE(LoadStudy(WriteTextFile(folder / "study.yaml", text), {}, &error)) << text;
  return error;
}

TEST(LoadStudy, NamesBlocksWhereNumbersBelong) {
  const ScratchFolder scratch;
  const std::string error = ErrorOf(scratch.path(), std::string("seeds: {a: 1}\n") + kSequences);
  EXPECT_THAT(error, HasSubstr("study.yaml:1: seeds must be a number, a range"));
  EXPECT_THAT(error, HasSubstr("is a block"));
  EXPECT_THAT(
      ErrorOf(scratch.path(), "sequences:\n  - {scenario: street_sparse, drives: {a: 1}}\n"),
      HasSubstr("study.yaml:2: drives must be a number, a range"));
  EXPECT_THAT(ErrorOf(scratch.path(), std::string("seeds: 0-999999\n") + kSequences),
              HasSubstr("at most 10000"));
}

}  // namespace
}  // namespace radive
