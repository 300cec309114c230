// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/sdf_decoder.h"

#include <gtest/gtest.h>

#include <limits>

#include "radive/neural_map/built_in_decoders.h"
#include "radive/neural_map/decoder_kernel.h"
#include "tests/neural_map/made_map.h"

namespace radive {
namespace {

using testing::RandomizedDecoder;

// One unit that looks at the height alone: w = 0, z = (0, 0, 3), b = -1, v = 2, c = 0.5. At a
// height of 0.5 m and a unit of 0.5 m the hidden sum is 3 - 1 = 2.
SdfDecoder HeightDecoder(SdfDecoder::Activation activation) {
  SdfDecoder decoder(4, 16, activation);
  decoder.parameters()[6] = 3.0;
  decoder.parameters()[7] = -1.0;
  decoder.parameters()[16 * 8] = 2.0;
  decoder.parameters().back() = 0.5;
  return decoder;
}

TEST(SdfDecoder, ValuesByHand) {
  const double feature[4] = {9.0, 9.0, 9.0, 9.0};  // without weight
  const Eigen::Vector3d up(7.0, 7.0, 0.5), down(7.0, 7.0, -0.5);
  const SdfDecoder softsign = HeightDecoder(SdfDecoder::Activation::kSoftsign);
  EXPECT_NEAR(softsign.Evaluate(feature, up, 0.5), 0.5 * (0.5 + 2.0 * (2.0 / 3.0)), 1e-12);
  EXPECT_NEAR(softsign.Evaluate(feature, down, 0.5), 0.5 * (0.5 - 2.0 * (4.0 / 5.0)), 1e-12);
  const SdfDecoder relu = HeightDecoder(SdfDecoder::Activation::kRelu);
  EXPECT_NEAR(relu.Evaluate(feature, up, 0.5), 0.5 * (0.5 + 2.0 * 2.0), 1e-12);
  EXPECT_NEAR(relu.Evaluate(feature, down, 0.5), 0.5 * 0.5, 1e-12);
}

TEST(SdfDecoder, KernelAgreesWithTheDecoderInAllSizes) {
  for (const int dim : {4, 8}) {
    for (const int hidden : {16, 32}) {
      for (const auto activation :
           {SdfDecoder::Activation::kSoftsign, SdfDecoder::Activation::kRelu}) {
        const SdfDecoder decoder = RandomizedDecoder(dim, hidden, activation, dim + hidden);
        std::vector<double> feature(static_cast<std::size_t>(dim));
        for (std::size_t i = 0; i < feature.size(); ++i)
          feature[i] = 0.3 - 0.2 * static_cast<double>(i);
        const Eigen::Vector3d d(0.4, -0.3, 0.2);
        WithDecoderKernel(decoder, 0.4, [&](const auto& kernel) {
          const auto part = kernel.Feature(feature.data());
          const double expected = decoder.Evaluate(feature.data(), d, 0.4);
          EXPECT_NEAR(kernel.Value(part, d), expected, 1e-12);
          typename std::decay_t<decltype(kernel)>::FeatureVector by_feature;
          Eigen::Vector3d by_position;
          EXPECT_NEAR(kernel.Derivatives(part, d, &by_feature, &by_position), expected, 1e-12);
          const double step = 1e-6;
          for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d shift = step * Eigen::Vector3d::Unit(k);
            const double slope = (decoder.Evaluate(feature.data(), d + shift, 0.4) -
                                  decoder.Evaluate(feature.data(), d - shift, 0.4)) /
                                 (2.0 * step);
            EXPECT_NEAR(by_position[k], slope, 1e-8);
          }
          for (std::size_t k = 0; k < feature.size(); ++k) {
            std::vector<double> more = feature, less = feature;
            more[k] += step;
            less[k] -= step;
            const double slope =
                (decoder.Evaluate(more.data(), d, 0.4) - decoder.Evaluate(less.data(), d, 0.4)) /
                (2.0 * step);
            EXPECT_NEAR(by_feature[static_cast<Eigen::Index>(k)], slope, 1e-8);
          }
        });
      }
    }
  }
}

TEST(SdfDecoder, TextGivesTheSameBitsBack) {
  const SdfDecoder decoder = RandomizedDecoder(8, 32, SdfDecoder::Activation::kRelu, 5);
  std::string error;
  const auto read = SdfDecoder::FromText(decoder.ToText("made here\nby hand"), "d.txt", &error);
  ASSERT_TRUE(read.has_value()) << error;
  EXPECT_EQ(read->feature_dim(), 8);
  EXPECT_EQ(read->hidden(), 32);
  EXPECT_EQ(read->activation(), SdfDecoder::Activation::kRelu);
  EXPECT_EQ(read->parameters(), decoder.parameters());
}

// The error of a text in which `from` is replaced by `to`.
std::string ErrorOf(const std::string& from, const std::string& to) {
  std::string text = SdfDecoder(4, 16, SdfDecoder::Activation::kSoftsign).ToText("");
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  std::string error;
  EXPECT_FALSE(SdfDecoder::FromText(text, "d.txt", &error).has_value());
  return error;
}

TEST(SdfDecoder, DamagedTextNamesThePlace) {
  EXPECT_EQ(ErrorOf("decoder 1", "decoder 2"), "d.txt:1: expected \"radive sdf decoder 1\"");
  EXPECT_EQ(ErrorOf("feature_dim 4", "feature_dim 5"), "d.txt:2: expected feature_dim 4 or 8");
  EXPECT_EQ(ErrorOf("hidden 16", "hidden"), "d.txt:3: expected hidden 16 or 32");
  EXPECT_EQ(ErrorOf("softsign", "tanh"), "d.txt:4: expected activation softsign or relu");
  EXPECT_EQ(ErrorOf("unit 0", "unit nan"), "d.txt:5: expected unit and 9 finite numbers");
  EXPECT_EQ(ErrorOf("unit 0", "unit 0x"), "d.txt:5: expected unit and 9 finite numbers");
  EXPECT_EQ(ErrorOf("output 0", "output 0\nunit 1"), "d.txt:22: expected nothing more");
  EXPECT_EQ(ErrorOf("output 0\n", ""), "d.txt:21: expected output and a finite number");
}

// A flat surface through a neural point, seen along its z axis: what the first features mean.
TEST(SdfDecoder, BuiltInDecodersKnowAPlane) {
  for (const int dim : {4, 8}) {
    const SdfDecoder decoder = BuiltInDecoder(dim, /*has_normals=*/true);
    const std::vector<double> feature(static_cast<std::size_t>(dim), 0.0);
    for (const double height : {-0.4, -0.2, 0.0, 0.2, 0.4}) {
      EXPECT_NEAR(decoder.Evaluate(feature.data(), {0.1, -0.2, height}, 0.5), height, 0.15);
    }
  }
}

}  // namespace
}  // namespace radive
