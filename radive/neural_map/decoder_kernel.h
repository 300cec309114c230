// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <glog/logging.h>

#include <Eigen/Core>
#include <utility>

#include "radive/neural_map/sdf_decoder.h"

namespace radive {

// A frozen SdfDecoder of compiled size, laid out for speed: value and closed-form derivatives. Same
// numbers as SdfDecoder::Evaluate but for rounding.
//
// The part of the hidden layer that depends on the feature alone is the same for all samples about
// a neural point: Feature() forms it once.
template <int kFeature, int kHidden>
class DecoderKernel {
 public:
  static constexpr int kFeatureDim = kFeature;
  static constexpr int kHiddenUnits = kHidden;
  using HiddenArray = Eigen::Array<double, kHidden, 1>;
  using FeatureVector = Eigen::Matrix<double, kFeature, 1>;

  DecoderKernel(const SdfDecoder& decoder, double unit)
      : DecoderKernel(decoder.parameters().data(), decoder.activation(), unit) {
    CHECK_EQ(decoder.feature_dim(), kFeature);
    CHECK_EQ(decoder.hidden(), kHidden);
  }

  // `p`: the parameters in the order of SdfDecoder.
  DecoderKernel(const double* p, SdfDecoder::Activation activation, double unit)
      : is_softsign_(activation == SdfDecoder::Activation::kSoftsign), unit_(unit) {
    for (int i = 0; i < kHidden; ++i, p += kFeature + 4) {
      for (int k = 0; k < kFeature; ++k) feature_weights_(i, k) = p[k];
      for (int k = 0; k < 3; ++k) position_weights_(i, k) = p[kFeature + k] / unit;
      bias_[i] = p[kFeature + 3];
    }
    for (int i = 0; i < kHidden; ++i) output_weights_[i] = unit * p[i];
    output_bias_ = unit * p[kHidden];
  }

  HiddenArray Feature(const double* feature) const {
    HiddenArray h = bias_;
    for (int k = 0; k < kFeature; ++k) h += feature_weights_.col(k) * feature[k];
    return h;
  }

  // D [m]; `feature_part` is Feature(f), `d` in the point's axes [m].
  double Value(const HiddenArray& feature_part, const Eigen::Vector3d& d) const {
    const HiddenArray h = Hidden(feature_part, d);
    if (is_softsign_) return output_bias_ + (output_weights_ * h / (1.0 + h.abs())).sum();
    return output_bias_ + (output_weights_ * h.max(0.0)).sum();
  }

  // D, and its derivatives with respect to the feature [m] and, unless null, to d [-].
  double Derivatives(const HiddenArray& feature_part,
                     const Eigen::Vector3d& d,
                     FeatureVector* by_feature,
                     Eigen::Vector3d* by_position) const {
    const HiddenArray h = Hidden(feature_part, d);
    HiddenArray slope;
    double value = output_bias_;
    if (is_softsign_) {
      const HiddenArray inverse = (1.0 + h.abs()).inverse();
      value += (output_weights_ * h * inverse).sum();
      slope = output_weights_ * inverse.square();
    } else {
      value += (output_weights_ * h.max(0.0)).sum();
      slope = (h > 0.0).select(output_weights_, HiddenArray::Zero());
    }
    for (int k = 0; k < kFeature; ++k) (*by_feature)[k] = (slope * feature_weights_.col(k)).sum();
    if (by_position != nullptr) {
      for (int k = 0; k < 3; ++k) (*by_position)[k] = (slope * position_weights_.col(k)).sum();
    }
    return value;
  }

  // Adds `scale` times the derivatives of D with respect to the decoder's parameters [m] to `row`,
  // in the order of SdfDecoder; `feature_part` is Feature(feature).
  void AddByParameters(const double* feature,
                       const HiddenArray& feature_part,
                       const Eigen::Vector3d& d,
                       double scale,
                       double* row) const {
    const HiddenArray h = Hidden(feature_part, d);
    HiddenArray activated, slope;
    if (is_softsign_) {
      const HiddenArray inverse = (1.0 + h.abs()).inverse();
      activated = h * inverse;
      slope = output_weights_ * inverse.square();
    } else {
      activated = h.max(0.0);
      slope = (h > 0.0).select(output_weights_, HiddenArray::Zero());
    }
    for (int i = 0; i < kHidden; ++i, row += kFeature + 4) {
      const double s = scale * slope[i];
      for (int k = 0; k < kFeature; ++k) row[k] += s * feature[k];
      for (int k = 0; k < 3; ++k) row[kFeature + k] += s * d[k] / unit_;
      row[kFeature + 3] += s;
    }
    for (int i = 0; i < kHidden; ++i) row[i] += scale * unit_ * activated[i];
    row[kHidden] += scale * unit_;
  }

 private:
  HiddenArray Hidden(const HiddenArray& feature_part, const Eigen::Vector3d& d) const {
    return feature_part + position_weights_.col(0) * d[0] + position_weights_.col(1) * d[1] +
           position_weights_.col(2) * d[2];
  }

  const bool is_softsign_;
  const double unit_;
  Eigen::Array<double, kHidden, kFeature> feature_weights_;
  Eigen::Array<double, kHidden, 3> position_weights_;
  HiddenArray bias_, output_weights_;
  double output_bias_ = 0.0;
};

// Calls `function` with the kernel of the decoder's size: function(const DecoderKernel<F, H>&).
template <typename Function>
auto WithDecoderKernel(const SdfDecoder& decoder, double unit, Function&& function) {
  if (decoder.feature_dim() == 4) {
    return decoder.hidden() == 16 ? function(DecoderKernel<4, 16>(decoder, unit))
                                  : function(DecoderKernel<4, 32>(decoder, unit));
  }
  return decoder.hidden() == 16 ? function(DecoderKernel<8, 16>(decoder, unit))
                                : function(DecoderKernel<8, 32>(decoder, unit));
}

}  // namespace radive
