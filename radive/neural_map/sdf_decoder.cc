// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/sdf_decoder.h"

#include <glog/logging.h>

#include <cmath>
#include <optional>
#include <sstream>

#include "radive/util/number_text.h"

namespace radive {
namespace {

constexpr const char* kTitle = "radive sdf decoder 1";

// A line as its words, without the comment.
std::vector<std::string> Words(const std::string& line) {
  std::istringstream stream(line.substr(0, line.find('#')));
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool ParseNumber(const std::string& word, double* value) {
  const std::optional<double> number = ParseDouble(word);
  *value = number.value_or(0.0);
  return number && std::isfinite(*number);
}

// Reads the lines of a decoder file one after the other.
class Reader {
 public:
  Reader(const std::string& text, std::string place) : stream_(text), place_(std::move(place)) {}

  // The words of the next line that is not empty; empty at the end.
  std::vector<std::string> Next() {
    for (std::string line; std::getline(stream_, line);) {
      ++number_;
      std::vector<std::string> words = Words(line);
      if (!words.empty()) return words;
    }
    ++number_;
    return {};
  }

  // The numbers of the next line, which must be "KEYWORD N1 .. Ncount".
  bool Numbers(const std::string& keyword, int count, std::vector<double>* values) {
    const std::vector<std::string> words = Next();
    bool ok = static_cast<int>(words.size()) == count + 1 && words[0] == keyword;
    values->assign(static_cast<std::size_t>(count), 0.0);
    for (std::size_t i = 0; ok && i < values->size(); ++i) {
      ok = ParseNumber(words[i + 1], &(*values)[i]);
    }
    return ok;
  }

  std::string Expected(const std::string& what) const {
    return place_ + ":" + std::to_string(number_) + ": expected " + what;
  }

 private:
  std::istringstream stream_;
  const std::string place_;
  int number_ = 0;
};

}  // namespace

SdfDecoder::SdfDecoder(int feature_dim, int hidden, Activation activation)
    : feature_dim_(feature_dim), hidden_(hidden), activation_(activation) {
  CHECK(IsCompiledSize(feature_dim, hidden)) << feature_dim << " x " << hidden;
  parameters_.assign(static_cast<std::size_t>(NumParameters(feature_dim, hidden)), 0.0);
}

std::string SdfDecoder::ToText(const std::string& comment) const {
  std::string text = std::string(kTitle) + "\n";
  std::istringstream comment_lines(comment);
  for (std::string line; std::getline(comment_lines, line);) text += "# " + line + "\n";
  text += "feature_dim " + std::to_string(feature_dim_) + "\nhidden " + std::to_string(hidden_) +
          "\nactivation " + (activation_ == Activation::kSoftsign ? "softsign" : "relu") + "\n";
  const std::size_t row_size = static_cast<std::size_t>(feature_dim_) + 4;
  const std::size_t hidden_size = static_cast<std::size_t>(hidden_);
  for (std::size_t i = 0; i < hidden_size; ++i) {
    text += "unit";
    for (std::size_t k = 0; k < row_size; ++k)
      text += FormatText(" %.17g", parameters_[i * row_size + k]);
    text += FormatText(" %.17g", parameters_[hidden_size * row_size + i]);
    text += "\n";
  }
  text += "output";
  return text + FormatText(" %.17g\n", parameters_.back());
}

std::optional<SdfDecoder> SdfDecoder::FromText(const std::string& text,
                                               const std::string& place,
                                               std::string* error) {
  Reader reader(text, place);
  const auto fail = [&](const std::string& what) {
    *error = reader.Expected(what);
    return std::nullopt;
  };
  if (reader.Next() != Words(kTitle)) return fail(std::string("\"") + kTitle + "\"");
  std::vector<double> values;
  if (!reader.Numbers("feature_dim", 1, &values) || (values[0] != 4.0 && values[0] != 8.0)) {
    return fail("feature_dim 4 or 8");
  }
  const int feature_dim = static_cast<int>(values[0]);
  if (!reader.Numbers("hidden", 1, &values) || (values[0] != 16.0 && values[0] != 32.0)) {
    return fail("hidden 16 or 32");
  }
  const int hidden = static_cast<int>(values[0]);
  const std::vector<std::string> activation = reader.Next();
  if (activation.size() != 2 || activation[0] != "activation" ||
      (activation[1] != "softsign" && activation[1] != "relu")) {
    return fail("activation softsign or relu");
  }
  SdfDecoder decoder(
      feature_dim, hidden, activation[1] == "relu" ? Activation::kRelu : Activation::kSoftsign);
  const std::size_t row_size = static_cast<std::size_t>(feature_dim) + 4;
  for (std::size_t i = 0; i < static_cast<std::size_t>(hidden); ++i) {
    if (!reader.Numbers("unit", feature_dim + 5, &values)) {
      return fail("unit and " + std::to_string(feature_dim + 5) + " finite numbers");
    }
    for (std::size_t k = 0; k < row_size; ++k) decoder.parameters_[i * row_size + k] = values[k];
    decoder.parameters_[static_cast<std::size_t>(hidden) * row_size + i] = values[row_size];
  }
  if (!reader.Numbers("output", 1, &values)) return fail("output and a finite number");
  decoder.parameters_.back() = values[0];
  if (!reader.Next().empty()) return fail("nothing more");
  return decoder;
}

}  // namespace radive
