// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/study_blocks.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "radive/config/run_config.h"
#include "radive/config/setting_text.h"
#include "radive/config/yaml_settings.h"
#include "radive/util/number_text.h"
#include "radive/util/text.h"

namespace radive {
namespace {

// "0-4", "3" or [0, 1, 2]: ascending or not, but without repetition.
bool ParseSeeds(const SettingText& text, std::vector<int>* seeds) {
  constexpr std::uint64_t kMaxSeed = 1000000;
  constexpr std::size_t kMostSeeds = 10000;
  seeds->clear();
  for (const std::string& word : text.words) {
    const std::size_t dash = text.is_list ? std::string::npos : word.find('-');
    const auto first = ParseCount(std::string_view(word).substr(0, dash));
    const auto last = dash == std::string::npos ? first : ParseCount(word.substr(dash + 1));
    if (!first || !last || *last < *first || *last > kMaxSeed) return false;
    if (*last - *first >= kMostSeeds - seeds->size()) return false;
    for (std::uint64_t seed = *first; seed <= *last; ++seed) {
      seeds->push_back(static_cast<int>(seed));
    }
  }
  std::vector<int> sorted = *seeds;
  std::sort(sorted.begin(), sorted.end());
  return !sorted.empty() && std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

}  // namespace

bool StudyBlocks::Fail(const YAML::Mark& mark, const std::string& message) const {
  *error_ = Place(mark) + message;
  return false;
}

std::string StudyBlocks::Place(const YAML::Mark& mark) const { return PlaceInYaml(file_, mark); }

bool StudyBlocks::Read(const YAML::Node& block,
                       const std::string& name,
                       std::vector<OptionField> fields,
                       const std::set<std::string>& special,
                       const ReadSpecial& read) const {
  if (!block.IsMap()) {
    return Fail(block.Mark(), name + " must hold lines \"key: value\"");
  }
  YAML::Node plain(YAML::NodeType::Map);
  std::set<std::string> seen;
  for (const auto& entry : block) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "?";
    if (!seen.insert(key).second)
      return Fail(entry.first.Mark(), name + "." + Excerpt(key) + " is set twice");
    if (special.count(key) > 0) {
      if (!read(key, entry.second, entry.first.Mark())) return false;
    } else {
      plain.force_insert(entry.first, entry.second);
    }
  }
  // For the suggestions in messages; values of these keys never come here.
  std::string unused;
  for (const std::string& key : special) fields.push_back({key, &unused, "-", ""});
  SettingStages stages = {{name, std::move(fields)}};
  return ApplyYamlStage(file_, name, plain, &stages, error_);
}

bool StudyBlocks::ReadSet(const YAML::Node& block, const YAML::Mark& mark, std::string* set) const {
  if (!block.IsMap()) return Fail(mark, "set must hold lines \"stage.field: value\"");
  RunConfig config;
  SettingStages stages = config.Stages();
  std::set<std::string> seen;
  for (const auto& entry : block) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "?";
    const std::size_t dot = key.find('.');
    if (dot == std::string::npos) {
      return Fail(entry.first.Mark(), "expected stage.field: value, got \"" + Excerpt(key) + "\"");
    }
    if (!seen.insert(key).second) return Fail(entry.first.Mark(), Excerpt(key) + " is set twice");
    SettingText text;
    const std::string stage = key.substr(0, dot);
    OptionField* field = FindField(stage, key.substr(dot + 1), &stages, error_);
    if (field == nullptr) return Fail(entry.first.Mark(), *error_);
    if (!ToSettingText(entry.second, &text)) {
      return Fail(entry.first.Mark(), key + " must be a value or a list of values");
    }
    if (!AssignField(stage, text, field, error_)) return Fail(entry.first.Mark(), *error_);
    *set += (set->empty() ? "" : ",") + key + "=" + field->ToString();
  }
  return true;
}

bool StudyBlocks::ReadSeeds(const YAML::Node& node,
                            const std::string& key,
                            const YAML::Mark& mark,
                            std::vector<int>* seeds) const {
  SettingText text;
  if (ToSettingText(node, &text) && ParseSeeds(text, seeds)) return true;
  return Fail(mark,
              key +
                  " must be a number, a range like 0-4 or a list like [0, 1, 2] without "
                  "repetition, at most 10000 from 0 to 1000000, is " +
                  (node.IsMap() ? "a block" : Excerpt(text.ToString())));
}

bool StudyBlocks::ReadNames(const YAML::Node& node,
                            const std::string& key,
                            const YAML::Mark& mark,
                            std::vector<std::string>* names) const {
  SettingText text;
  if (!ToSettingText(node, &text) || !text.is_list || text.words.empty()) {
    return Fail(mark, key + " must be a list of names, like [a, b]");
  }
  *names = text.words;
  return true;
}

}  // namespace radive
