// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace radive {

// Largest K of the interpolation between neural points.
constexpr int kMaxSdfNeighbors = 8;

// The SDF decoder D_theta of the paper: a network with one hidden layer, from the feature f of a
// neural point and a position d relative to it to a signed distance,
//
//   D(f, d) = u (c + sum_i v_i a(w_i . f + z_i . d / u + b_i))
//
// a      softsign, x / (1 + |x|), or ReLU
// u      unit of length: the resolution of the neural map, so that one decoder serves all [m]
// d      position relative to the neural point, in its axes [m]
// theta  row by row (w_i, z_i, b_i), then all v_i, then c: `parameters`, dimensionless
class SdfDecoder {
 public:
  enum class Activation { kSoftsign, kRelu };

  // All parameters zero. Feature dimension 4 or 8, hidden units 16 or 32: the compiled sizes.
  SdfDecoder(int feature_dim, int hidden, Activation activation);

  static bool IsCompiledSize(int feature_dim, int hidden) {
    return (feature_dim == 4 || feature_dim == 8) && (hidden == 16 || hidden == 32);
  }
  static int NumParameters(int feature_dim, int hidden) {
    return hidden * (feature_dim + 3 + 1) + hidden + 1;
  }

  int feature_dim() const { return feature_dim_; }
  int hidden() const { return hidden_; }
  Activation activation() const { return activation_; }
  const std::vector<double>& parameters() const { return parameters_; }
  std::vector<double>& parameters() { return parameters_; }

  // D at `feature` and `d` [m], with `unit` [m]. Templated on the scalar of the feature and of the
  // parameters, so that Jets pass; `parameters` has the order given above.
  template <typename T>
  T Evaluate(const T* parameters,
             const T* feature,
             const Eigen::Matrix<T, 3, 1>& d,
             double unit) const {
    const int row_size = feature_dim_ + 4;
    const T* output_weights = parameters + hidden_ * row_size;
    T sum = output_weights[hidden_];
    for (int i = 0; i < hidden_; ++i) {
      const T* row = parameters + i * row_size;
      T x = row[feature_dim_ + 3];
      for (int k = 0; k < feature_dim_; ++k) x += row[k] * feature[k];
      for (int k = 0; k < 3; ++k) x += row[feature_dim_ + k] * d[k] / unit;
      sum += output_weights[i] * Activate(x);
    }
    return unit * sum;
  }

  // The same with this decoder's own parameters.
  double Evaluate(const double* feature, const Eigen::Vector3d& d, double unit) const {
    return Evaluate<double>(parameters_.data(), feature, d, unit);
  }

  // As a text file: "radive sdf decoder 1", then lines of a keyword and its values; # begins a
  // comment.
  //
  //   feature_dim 4
  //   hidden 16
  //   activation softsign          or relu
  //   unit W1 .. W4 Z1 Z2 Z3 B V   one line a hidden unit
  //   output C                     last
  //
  // `comment` goes below the first line, each of its lines behind "# ". Reading back gives the same
  // bits.
  std::string ToText(const std::string& comment) const;

  // Reads ToText(). On failure says "PLACE:LINE: what was expected" in `error`.
  static std::optional<SdfDecoder> FromText(const std::string& text,
                                            const std::string& place,
                                            std::string* error);

 private:
  template <typename T>
  T Activate(const T& x) const {
    if (activation_ == Activation::kRelu) return x > T(0.0) ? x : T(0.0);
    // Both branches by hand: the absolute value of a Jet at zero is not needed.
    return x > T(0.0) ? x / (T(1.0) + x) : x / (T(1.0) - x);
  }

  int feature_dim_;
  int hidden_;
  Activation activation_;
  std::vector<double> parameters_;
};

}  // namespace radive
