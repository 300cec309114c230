// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/config/load_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "radive/config/describe_config.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using ::testing::HasSubstr;

std::string ErrorOfYaml(const std::string& yaml) {
  std::string error;
  EXPECT_FALSE(ParseRunConfig(yaml, "my.yaml", "", &error)) << yaml;
  return error;
}

std::string ErrorOfSet(const std::string& set_text) {
  std::string error;
  EXPECT_FALSE(ParseRunConfig("", "", set_text, &error)) << set_text;
  return error;
}

TEST(LoadRunConfig, WithoutFileAndSettingsGivesTheDefaults) {
  std::string error;
  const auto config = LoadRunConfig("", "", &error);
  ASSERT_TRUE(config) << error;
  EXPECT_EQ(EffectiveConfig(*config), EffectiveConfig(RunConfig()));
}

TEST(LoadRunConfig, ReadsStagesAndLaterSettingsWin) {
  std::string error;
  const auto config = ParseRunConfig("input:\n  rate: 15\noutput: {map: none}\n",
                                     "my.yaml",
                                     "output.map_resolution=0.5, input.rate=20,input.rate=12.5",
                                     &error);
  ASSERT_TRUE(config) << error;
  EXPECT_EQ(config->input.rate, 12.5);
  EXPECT_EQ(config->output.map, OutputOptions::Map::kNone);
  EXPECT_EQ(config->output.map_resolution, 0.5);
}

TEST(LoadRunConfig, TakesEmptyFilesAndEmptyStages) {
  std::string error;
  EXPECT_TRUE(ParseRunConfig("# nothing but a comment\n", "my.yaml", "", &error)) << error;
  EXPECT_TRUE(ParseRunConfig("input:\noutput:\n", "my.yaml", ",", &error)) << error;
}

TEST(LoadRunConfig, NamesUnknownKeysAndSuggestsTheNearest) {
  EXPECT_EQ(ErrorOfYaml("input:\n  rate: 15\n  fromat: raw\n"),
            "my.yaml:3: unknown key input.fromat, did you mean input.format?");
  EXPECT_EQ(ErrorOfYaml("inptu:\n  rate: 15\n"),
            "my.yaml:1: unknown stage inptu, did you mean input?");
  EXPECT_EQ(ErrorOfYaml("output:\n  rate: 15\n"),
            "my.yaml:2: unknown key output.rate, did you mean input.rate?");
  EXPECT_EQ(ErrorOfSet("input.zzzzzzzzz=1"),
            "--set: unknown key input.zzzzzzzzz; --help_config lists all keys");
  EXPECT_THAT(ErrorOfSet("zzzzzzzzz.rate=1"), HasSubstr("the stages are input, "));
}

TEST(LoadRunConfig, NamesValuesOfTheWrongType) {
  EXPECT_EQ(ErrorOfYaml("input:\n  rate: fast\n"),
            "my.yaml:2: input.rate must be a number, >= 0 and <= 1e+06, is fast");
  EXPECT_EQ(ErrorOfYaml("input:\n  rate: \"15\"\n"),
            "my.yaml:2: input.rate must be a number, >= 0 and <= 1e+06, is \"15\"");
  EXPECT_EQ(ErrorOfYaml("input:\n  rate:\n"),
            "my.yaml:2: input.rate must be a number, >= 0 and <= 1e+06, is empty");
  EXPECT_EQ(ErrorOfYaml("input:\n  rate: [1, 2]\n"),
            "my.yaml:2: input.rate must be a number, >= 0 and <= 1e+06, is [1, 2]");
  EXPECT_EQ(ErrorOfYaml("output:\n  map: pionts\n"),
            "my.yaml:2: output.map must be one of none | points | surface | mesh, is pionts (did "
            "you mean points?)");
  EXPECT_EQ(ErrorOfSet("input.planar=1"), "--set: input.planar must be true or false, is 1");
  EXPECT_EQ(ErrorOfYaml("input:\n  rate: {a: 1}\n"),
            "my.yaml:2: input.rate must be a value or a list of values, is a block");
}

TEST(LoadRunConfig, NamesValuesOutOfRange) {
  EXPECT_EQ(ErrorOfYaml("input:\n  rate: -1\n"),
            "my.yaml:2: input.rate must be >= 0 and <= 1e+06 Hz, is -1");
  EXPECT_EQ(ErrorOfSet("output.map_resolution=-0.5"),
            "--set: output.map_resolution must be >= 0 m, is -0.5");
  // Not a number never obeys a bound.
  EXPECT_THAT(ErrorOfSet("output.map_resolution=nan"), HasSubstr("must be a number"));
}

TEST(LoadRunConfig, NamesRepeatedKeys) {
  EXPECT_EQ(ErrorOfYaml("input:\n  rate: 15\n  rate: 20\n"), "my.yaml:3: input.rate is set twice");
  EXPECT_EQ(ErrorOfYaml("input:\n  rate: 15\ninput:\n  radar: 1\n"),
            "my.yaml:3: stage input appears twice");
}

TEST(LoadRunConfig, NamesWhatIsNotAConfiguration) {
  EXPECT_THAT(ErrorOfYaml("input: [1\n"), HasSubstr("not valid YAML"));
  EXPECT_THAT(ErrorOfYaml("input: 3\n"), HasSubstr("my.yaml:1: stage input must hold"));
  EXPECT_THAT(ErrorOfYaml("- a\n- b\n"), HasSubstr("my.yaml:1: expected stages"));
  EXPECT_THAT(ErrorOfYaml("input:\n  rate: 1\n---\ninput:\n  rate: 2\n"), HasSubstr("one YAML"));
  EXPECT_EQ(ErrorOfSet("input.rate"), "--set: expected stage.field=value, got \"input.rate\"");
  EXPECT_EQ(ErrorOfSet("rate=1"), "--set: expected stage.field=value, got \"rate=1\"");
}

TEST(LoadRunConfig, NamesAFileThatCannotBeRead) {
  const testing::ScratchFolder scratch;
  std::string error;
  EXPECT_FALSE(LoadRunConfig((scratch.path() / "none.yaml").string(), "", &error));
  EXPECT_THAT(error, HasSubstr("none.yaml: cannot read the configuration file: No such file"));
  EXPECT_FALSE(LoadRunConfig(scratch.path().string(), "", &error));
  EXPECT_THAT(error, HasSubstr("is a folder"));
}

TEST(LoadRunConfig, BoundsWhatItReadsAndQuotes) {
  const testing::ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "long.yaml";
  std::ofstream(file) << "#" << std::string(1 << 20, 'x');
  std::string error;
  EXPECT_FALSE(LoadRunConfig(file.string(), "", &error));
  EXPECT_THAT(error, HasSubstr("cannot read the configuration file: larger than 1048576 bytes"));
  EXPECT_FALSE(LoadRunConfig("/dev/zero", "", &error));
  EXPECT_THAT(error, HasSubstr("/dev/zero: cannot read the configuration file: larger than"));

  const std::string word(100000, 'a');
  for (const std::string& text : {"submap:\n  num_keyframes: " + word,
                                  "submap:\n  type: " + word,
                                  "submap:\n  ? " + word + "\n  : 1",
                                  "? " + word + "\n: {}",
                                  "sensor:\n  mounts: [" + word + "]"}) {
    const std::string message = ErrorOfYaml(text);
    EXPECT_THAT(message, HasSubstr(std::string(60, 'a').substr(0, 55)));
    EXPECT_LT(message.size(), 1000U);
  }
  EXPECT_LT(ErrorOfSet("submap.type=" + word).size(), 1000U);
  EXPECT_LT(ErrorOfSet(word).size(), 1000U);
}

TEST(LoadRunConfig, BoundsTheMesh) {
  EXPECT_THAT(ErrorOfSet("submap.type=sdf,output.map=mesh,output.mesh_resolution=1e-3"),
              HasSubstr("output.mesh_resolution must be >= a tenth of neural_map.resolution "
                        "(0.5 m), is 0.001 m"));
}

// A value that differs from the default, obeys the bounds and is awkward to print.
void ChangeValue(OptionField* field) {
  struct Changer {
    const OptionField& field;
    double Other(double value) const {
      for (const double other : {value + 1.0 / 3.0,
                                 value * (1.0 + 1e-15) + 1e-300,
                                 value / 3.0,
                                 field.min + 0.1,
                                 field.max,
                                 field.min}) {
        const bool above = field.exclude_min ? other > field.min : other >= field.min;
        if (other != value && above && other <= field.max && std::isfinite(other)) return other;
      }
      return value;
    }
    void operator()(double* value) const { *value = Other(*value); }
    void operator()(int* value) const {
      *value = *value + 1 <= field.max ? *value + 1 : *value - 1;
    }
    void operator()(bool* value) const { *value = !*value; }
    void operator()(std::string* value) const { *value += " a \"quoted\" \\ text: [1, 2]\n#"; }
    void operator()(std::vector<double>* value) const {
      for (double& entry : *value) entry = Other(entry);
      if (field.list_size < 0) value->push_back(Other(0.1));
    }
    void operator()(const OptionField::Choice& choice) const {
      choice.set((choice.get() + 1) % static_cast<int>(choice.names.size()));
    }
  };
  std::visit(Changer{*field}, field->value);
}

TEST(LoadRunConfig, ReadsTheDecoderFile) {
  const std::string file = std::string(RADIVE_CONFIGS) + "/decoders/sdf_4_identity.txt";
  std::string error;
  const auto config = LoadRunConfig("", "neural_map.decoder_file=" + file, &error);
  ASSERT_TRUE(config) << error;
  ASSERT_NE(config->odometry.neural_map.decoder, nullptr);
  EXPECT_EQ(config->odometry.neural_map.decoder->feature_dim(), 4);
  EXPECT_THAT(ErrorOfSet("neural_map.feature_dim=8,neural_map.decoder_file=" + file),
              HasSubstr("feature_dim is 8"));
  EXPECT_THAT(ErrorOfSet("neural_map.feature_dim=8,neural_map.orientation=identity"),
              HasSubstr("no such decoder is built in"));
  EXPECT_THAT(ErrorOfSet("neural_map.feature_dim=6"), HasSubstr("must be 4 or 8, is 6"));
  EXPECT_THAT(ErrorOfSet("neural_map.decoder_file=nowhere.txt"),
              HasSubstr("nowhere.txt: cannot read the decoder file"));
}

TEST(EffectiveConfig, ReadsBackIdenticallyFieldByField) {
  const std::string defaults = EffectiveConfig(RunConfig());
  const std::size_t num_stages = RunConfig().Stages().size();
  for (std::size_t s = 0; s < num_stages; ++s) {
    const std::size_t num_fields = RunConfig().Stages()[s].second.size();
    for (std::size_t f = 0; f < num_fields; ++f) {
      RunConfig config;
      auto stages = config.Stages();
      OptionField& field = stages[s].second[f];
      const auto* choice = std::get_if<OptionField::Choice>(&field.value);
      if (choice != nullptr && choice->names.size() == 1) continue;  // nothing to change it to
      ChangeValue(&field);
      const std::string text = EffectiveConfig(config);
      EXPECT_NE(text, defaults) << stages[s].first << "." << field.name << " did not change";
      std::string error;
      const auto read = ParseRunConfig(text, "effective", "", &error);
      if (!read) {
        // Some changes do not fit the other settings; then the values must still have been read.
        EXPECT_FALSE(config.IsValid(&error)) << error;
        continue;
      }
      EXPECT_EQ(EffectiveConfig(*read), text);
    }
  }
}

TEST(DescribeConfig, ListsEveryFieldWithItsDefaultAndReadsAsAConfiguration) {
  const std::string text = DescribeConfig();
  RunConfig defaults;
  for (const auto& [stage, fields] : defaults.Stages()) {
    EXPECT_THAT(text, HasSubstr("\n" + stage + ":\n"));
    for (const OptionField& field : fields) {
      EXPECT_THAT(text, HasSubstr("\n  " + field.name + ": " + field.ToString() + "\n"));
      EXPECT_THAT(text, HasSubstr("  # " + field.doc));
      EXPECT_FALSE(field.doc.empty()) << stage << "." << field.name;
      EXPECT_FALSE(field.unit.empty()) << stage << "." << field.name;
    }
  }
  EXPECT_THAT(text, HasSubstr("[Hz] (>= 0 "));
  std::string error;
  const auto read = ParseRunConfig(text, "help", "", &error);
  ASSERT_TRUE(read) << error;
  EXPECT_EQ(EffectiveConfig(*read), EffectiveConfig(RunConfig()));
}

TEST(ApplySettings, WorksOnStagesOfAnyProgram) {
  double speed = 1.0;
  const OptionField field = OptionField{"speed", &speed, "m/s", "Speed."}.AtMost(40.0);
  std::string error;
  EXPECT_TRUE(ApplySettings("simulation.speed=12.5", {{"simulation", {field}}}, &error)) << error;
  EXPECT_EQ(speed, 12.5);
  EXPECT_FALSE(ApplySettings("simulation.sped=1", {{"simulation", {field}}}, &error));
  EXPECT_THAT(error, HasSubstr("did you mean simulation.speed?"));
  EXPECT_FALSE(ApplySettings("simulation.speed=50", {{"simulation", {field}}}, &error));
  EXPECT_THAT(error, HasSubstr("simulation.speed must be <= 40"));
}

TEST(Configs, EveryShippedFileLoadsAndFixesWhatTheSensorFixes) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RADIVE_CONFIGS)) {
    if (entry.is_directory()) continue;  // decoders
    std::string error;
    const auto config = LoadRunConfig(entry.path().string(), "", &error);
    EXPECT_TRUE(config) << error;
    ++count;
  }
  EXPECT_GE(count, 7);
}

}  // namespace
}  // namespace radive
