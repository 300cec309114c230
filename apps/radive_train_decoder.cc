// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gflags/gflags.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "apps/app_main.h"
#include "radive/io/bytes/whole_file.h"
#include "radive/pipeline/decoder_lessons.h"
#include "radive/training/decoder_training.h"

DEFINE_int32(feature_dim, 4, "Numbers in a feature: 4 or 8.");
DEFINE_int32(hidden, 0, "Hidden units: 16 or 32; 0: four times the feature dimension.");
DEFINE_string(activation, "softsign", "softsign | relu.");
DEFINE_string(orientation, "normal", "Axes of the neural points: normal | identity.");
DEFINE_int32(seed, 1, "Seed of the simulated drives, the samples and the first weights.");
DEFINE_string(output, "", "File for the decoder. Required.");

namespace {

int Fail(const std::string& message) {
  std::fprintf(stderr, "radive_train_decoder: %s\n", message.c_str());
  return radive::Code(radive::ExitStatus::kFailure);
}

}  // namespace

int main(int argc, char** argv) {
  radive::InitApp(&argc,
                  &argv,
                  "Trains a decoder of the neural map on simulated streets.\n"
                  "  radive_train_decoder --feature_dim=4 --output=DECODER.txt\n\n"
                  "Deterministic: the same command gives the same file.");
  if (FLAGS_output.empty()) return Fail("--output is required: the file for the decoder");
  const int hidden = FLAGS_hidden != 0 ? FLAGS_hidden : 4 * FLAGS_feature_dim;
  if (!radive::SdfDecoder::IsCompiledSize(FLAGS_feature_dim, hidden)) {
    return Fail("--feature_dim must be 4 or 8 and --hidden 16 or 32, are " +
                std::to_string(FLAGS_feature_dim) + " and " + std::to_string(hidden));
  }
  if (FLAGS_activation != "softsign" && FLAGS_activation != "relu") {
    return Fail("--activation must be softsign or relu, is " + FLAGS_activation);
  }
  if (FLAGS_orientation != "normal" && FLAGS_orientation != "identity") {
    return Fail("--orientation must be normal or identity, is " + FLAGS_orientation);
  }
  radive::NeuralMapOptions map_options;
  map_options.feature_dim = FLAGS_feature_dim;
  map_options.orientation = FLAGS_orientation == "normal"
                                ? radive::NeuralMapOptions::Orientation::kNormal
                                : radive::NeuralMapOptions::Orientation::kIdentity;
  radive::SdfTrainingOptions training;
  training.seed = FLAGS_seed;
  training.samples_per_point = 6;
  // The returns of a lesson are exact: a plane of few of them follows corners, a smooth one rounds
  // them off.
  training.label = radive::SdfTrainingOptions::Label::kPlane;
  radive::DecoderLessons lessons = radive::MakeDecoderLessons(map_options, training, FLAGS_seed);
  std::printf("%zu samples about %d neural points\n", lessons.samples.size(), lessons.map.size());

  radive::DecoderTrainingOptions options;
  options.hidden = hidden;
  options.activation = FLAGS_activation == "relu" ? radive::SdfDecoder::Activation::kRelu
                                                  : radive::SdfDecoder::Activation::kSoftsign;
  options.seed = FLAGS_seed;
  std::string comment =
      "made by: radive_train_decoder --feature_dim=" + std::to_string(FLAGS_feature_dim) +
      " --hidden=" + std::to_string(hidden) + " --activation=" + FLAGS_activation +
      " --orientation=" + FLAGS_orientation + " --seed=" + std::to_string(FLAGS_seed) + "\n";
  const auto report = [&comment](const std::string& phase, double rms) {
    char line[128];
    std::snprintf(line, sizeof(line), "%s: label rms %.4f m\n", phase.c_str(), rms);
    std::fputs(line, stdout);
    std::fflush(stdout);
    comment += line;
  };
  const radive::SdfDecoder decoder =
      radive::TrainNewDecoder(lessons.samples, training, options, &lessons.map, report);

  const std::filesystem::path path = FLAGS_output;
  std::string error;
  if (!radive::WriteWholeFile(path, decoder.ToText(comment), &error)) return Fail(error);
  return radive::EndApp(radive::ExitStatus::kSuccess);
}
