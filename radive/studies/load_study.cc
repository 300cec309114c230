// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/load_study.h"

#include <glob.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include "radive/config/run_config.h"
#include "radive/config/yaml_settings.h"
#include "radive/simulation/scenarios.h"
#include "radive/util/natural_order.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

// "0-4", "3" or [0, 1, 2]: ascending or not, but without repetition.
bool ParseSeeds(const SettingText& text, std::vector<int>* seeds) {
  constexpr int kMaxSeed = 1000000;
  seeds->clear();
  for (const std::string& word : text.words) {
    int first = 0;
    int last = 0;
    char end = '\0';
    const int count = std::sscanf(word.c_str(), "%9d-%9d%c", &first, &last, &end);
    if (count == 1 && std::to_string(first) == word) last = first;
    const bool is_range = count == 2 && !text.is_list && last >= first;
    if (!(is_range || (count == 1 && last == first)) || first < 0 || last > kMaxSeed) return false;
    for (int seed = first; seed <= last; ++seed) seeds->push_back(seed);
  }
  std::vector<int> sorted = *seeds;
  std::sort(sorted.begin(), sorted.end());
  return !sorted.empty() && std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

bool IsName(const std::string& name) {
  const std::string allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._+-";
  return !name.empty() && name.front() != '.' && name.front() != '-' && name.size() <= 100 &&
         name.find_first_not_of(allowed) == std::string::npos;
}

// Every folder and file that fits, in the order of their names.
std::vector<fs::path> Glob(const fs::path& pattern) {
  glob_t found{};
  std::vector<fs::path> paths;
  if (glob(pattern.c_str(), GLOB_NOSORT, nullptr, &found) == 0) {
    for (std::size_t i = 0; i < found.gl_pathc; ++i) paths.emplace_back(found.gl_pathv[i]);
  }
  globfree(&found);
  std::sort(paths.begin(), paths.end(), [](const fs::path& a, const fs::path& b) {
    return NaturalLess(a.native(), b.native());
  });
  return paths;
}

std::string Replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
  return text;
}

class StudyReader {
 public:
  StudyReader(const fs::path& file, const StudyRoots& roots, std::string* error)
      : file_(file.string()), folder_(file.parent_path()), error_(error) {
    data_root_ = roots.data.empty() ? folder_ : roots.data;
    truth_root_ = roots.truth.empty() ? data_root_ : roots.truth;
  }

  std::optional<Study> Read(const YAML::Node& root) {
    study_.name = fs::path(file_).stem().string();
    study_.evaluation.align = AlignmentMode::kSe3;
    study_.evaluation.plane = Plane::kXy;
    if (!root.IsMap()) {
      Fail(root.Mark(), "expected \"sequences:\", \"variants:\" and other keys of a study");
      return std::nullopt;
    }
    if (ReadTop(root) && CheckNames()) return std::move(study_);
    return std::nullopt;
  }

 private:
  bool Fail(const YAML::Mark& mark, const std::string& message) {
    *error_ = PlaceInYaml(file_, mark) + message;
    return false;
  }

  // Splits `block` into the keys in `special`, which `read` is called with, and settings, which go
  // to `fields`.
  template <typename ReadSpecial>
  bool ReadBlock(const YAML::Node& block,
                 const std::string& name,
                 std::vector<OptionField> fields,
                 const std::set<std::string>& special,
                 const ReadSpecial& read) {
    if (!block.IsMap()) {
      return Fail(block.Mark(), name + " must hold lines \"key: value\"");
    }
    YAML::Node plain(YAML::NodeType::Map);
    std::set<std::string> seen;
    for (const auto& entry : block) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "?";
      if (!seen.insert(key).second)
        return Fail(entry.first.Mark(), name + "." + key + " is set twice");
      if (special.count(key) > 0) {
        if (!read(key, entry.second, entry.first.Mark())) return false;
      } else {
        plain.force_insert(entry.first, entry.second);
      }
    }
    // For the suggestions in messages; values of these keys never come here.
    static std::string unused;
    for (const std::string& key : special) fields.push_back({key, &unused, "-", ""});
    SettingStages stages = {{name, std::move(fields)}};
    return ApplyYamlStage(file_, name, plain, &stages, error_);
  }

  // "submap.type: sdf" lines, to the text of --set.
  bool ReadSet(const YAML::Node& block, const YAML::Mark& mark, std::string* set) {
    if (!block.IsMap()) return Fail(mark, "set must hold lines \"stage.field: value\"");
    RunConfig config;
    SettingStages stages = config.Stages();
    std::set<std::string> seen;
    for (const auto& entry : block) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "?";
      const std::size_t dot = key.find('.');
      if (dot == std::string::npos) {
        return Fail(entry.first.Mark(), "expected stage.field: value, got \"" + key + "\"");
      }
      if (!seen.insert(key).second) return Fail(entry.first.Mark(), key + " is set twice");
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

  bool ReadSeeds(const YAML::Node& node,
                 const std::string& key,
                 const YAML::Mark& mark,
                 std::vector<int>* seeds) {
    SettingText text;
    if (ToSettingText(node, &text) && ParseSeeds(text, seeds)) return true;
    return Fail(mark,
                key +
                    " must be a number, a range like 0-4 or a list like [0, 1, 2] without "
                    "repetition, is " +
                    text.ToString());
  }

  bool ReadNames(const YAML::Node& node, const YAML::Mark& mark, std::vector<std::string>* names) {
    SettingText text;
    if (!ToSettingText(node, &text) || !text.is_list || text.words.empty()) {
      return Fail(mark, "variants of a sequence must be a list of their names");
    }
    *names = text.words;
    return true;
  }

  fs::path BesideStudy(const std::string& path) const {
    return path.empty() ? fs::path() : (folder_ / path).lexically_normal();
  }

  bool ReadTop(const YAML::Node& root) {
    std::string published;
    std::vector<OptionField> fields = {
        {"config", &study_.config, "-", ""},
        OptionField{"frames", &study_.frames, "-", ""}.AtLeast(0),
        OptionField{"timeout", &study_.timeout, "s", ""}.AtLeast(0.0),
        OptionField{"threads", &study_.threads, "-", ""}.AtLeast(1),
        {"absent", MakeChoice(&study_.absent, {"fail", "mark"}), "-", ""},
        {"published", &published, "-", ""},
    };
    YAML::Node sequences;
    YAML::Node variants;
    const auto special = [&](const std::string& key, const YAML::Node& node, const YAML::Mark& at) {
      if (key == "set") return ReadSet(node, at, &study_.set);
      if (key == "seeds") return ReadSeeds(node, key, at, &study_.seeds);
      if (key == "perturb") return ReadBlock(node, key, study_.perturb.Fields(), {}, NoSpecial);
      if (key == "evaluate") return ReadEvaluation(node);
      (key == "sequences" ? sequences : variants).reset(node);
      return node.IsSequence() || Fail(at, key + " must be a list: lines that begin with \"- \"");
    };
    if (!ReadBlock(root,
                   "study",
                   std::move(fields),
                   {"set", "seeds", "perturb", "evaluate", "sequences", "variants"},
                   special)) {
      return false;
    }
    study_.published = BesideStudy(published);
    for (const YAML::Node& node : sequences) {
      if (!ReadSequence(node)) return false;
    }
    for (const YAML::Node& node : variants) {
      if (!ReadVariant(node)) return false;
    }
    if (study_.variants.empty()) {
      study_.variants.push_back({"default", "default", "", 0, PlaceInYaml(file_, root.Mark())});
    }
    if (!study_.sequences.empty()) return true;
    return Fail(root.Mark(), "there are no sequences: expected \"sequences:\" with at least one");
  }

  static bool NoSpecial(const std::string&, const YAML::Node&, const YAML::Mark&) { return true; }

  bool ReadEvaluation(const YAML::Node& node) {
    std::vector<OptionField> fields;
    for (OptionField& field : study_.evaluation.Fields()) {
      if (field.name != "metric" && field.name != "relation" && field.name != "format") {
        fields.push_back(std::move(field));
      }
    }
    if (!ReadBlock(node, "evaluate", std::move(fields), {}, NoSpecial)) return false;
    if (study_.evaluation.IsValid(error_) && study_.evaluation.pairs.IsValid(error_)) return true;
    return Fail(node.Mark(), *error_);
  }

  bool ReadVariant(const YAML::Node& node) {
    StudyVariant variant;
    variant.place = PlaceInYaml(file_, node.Mark());
    std::vector<OptionField> fields = {
        {"name", &variant.name, "-", ""},
        {"label", &variant.label, "-", ""},
        OptionField{"frames", &variant.frames, "-", ""}.AtLeast(0),
    };
    const auto special = [&](const std::string&, const YAML::Node& set, const YAML::Mark& at) {
      return ReadSet(set, at, &variant.set);
    };
    if (!ReadBlock(node, "variant", std::move(fields), {"set"}, special)) return false;
    if (variant.label.empty()) variant.label = variant.name;
    study_.variants.push_back(std::move(variant));
    return true;
  }

  // The keys of a sequence that are not in StudySequence as they stand.
  struct SequenceKeys {
    std::string input;
    std::string glob;
    std::string reference;
    std::string config;
    std::vector<int> drives;
  };

  bool ReadSequence(const YAML::Node& node) {
    StudySequence sequence;
    SequenceKeys keys;
    sequence.place = PlaceInYaml(file_, node.Mark());
    std::vector<OptionField> fields = {
        {"name", &sequence.name, "-", ""},
        {"input", &keys.input, "-", ""},
        {"glob", &keys.glob, "-", ""},
        {"scenario", &sequence.scenario, "-", ""},
        {"reference", &keys.reference, "-", ""},
        {"reference_format",
         MakeChoice(&sequence.reference_format, {"tum", "kitti", "euroc"}),
         "-",
         ""},
        {"config", &keys.config, "-", ""},
        OptionField{"frames", &sequence.frames, "-", ""}.AtLeast(0),
    };
    YAML::Node simulate;
    const auto special =
        [&](const std::string& key, const YAML::Node& value, const YAML::Mark& at) {
          if (key == "set") return ReadSet(value, at, &sequence.set);
          if (key == "drives") return ReadSeeds(value, key, at, &keys.drives);
          if (key == "variants") return ReadNames(value, at, &sequence.variants);
          simulate.reset(value);
          return true;
        };
    if (!ReadBlock(node,
                   "sequence",
                   std::move(fields),
                   {"set", "drives", "simulate", "variants"},
                   special)) {
      return false;
    }
    sequence.config = BesideStudy(keys.config.empty() ? study_.config : keys.config).string();
    const int kinds = static_cast<int>(!keys.input.empty()) + static_cast<int>(!keys.glob.empty()) +
                      static_cast<int>(sequence.is_simulated());
    if (kinds != 1) {
      return Fail(node.Mark(), "a sequence must have one of input, glob and scenario");
    }
    if (sequence.is_simulated()) return AddSimulated(node, simulate, keys, sequence);
    if (simulate.IsMap() || !keys.drives.empty()) {
      return Fail(node.Mark(), "simulate and drives are for a sequence with a scenario");
    }
    return AddRecorded(node, keys, sequence);
  }

  bool AddRecorded(const YAML::Node& node, const SequenceKeys& keys, StudySequence sequence) {
    std::vector<fs::path> inputs = {data_root_ / keys.input};
    if (!keys.glob.empty()) {
      inputs = Glob(data_root_ / keys.glob);
      if (inputs.empty() && study_.absent == Study::Absent::kFail) {
        return Fail(node.Mark(), (data_root_ / keys.glob).string() + " fits no folder and no file");
      }
    }
    const std::string prefix = sequence.name;
    for (const fs::path& input : inputs) {
      const fs::path last =
          input.has_filename() ? input.filename() : input.parent_path().filename();
      if (!keys.glob.empty()) sequence.name = prefix + last.string();
      if (sequence.name.empty()) sequence.name = last.string();
      sequence.input = input.lexically_normal();
      if (!keys.reference.empty()) {
        const std::string name = Replaced(keys.reference, "{name}", sequence.name);
        sequence.reference = (truth_root_ / Replaced(name, "{input}", fs::absolute(input).string()))
                                 .lexically_normal();
      }
      study_.sequences.push_back(sequence);
    }
    return true;
  }

  bool AddSimulated(const YAML::Node& node,
                    const YAML::Node& simulate,
                    const SequenceKeys& keys,
                    StudySequence sequence) {
    const auto options = ScenarioOptions(sequence.scenario);
    if (!options) {
      std::string names;
      for (const std::string& name : ScenarioNames()) names += (names.empty() ? "" : " | ") + name;
      return Fail(node.Mark(), "scenario must be one of " + names + ", is " + sequence.scenario);
    }
    if (!keys.reference.empty()) {
      return Fail(node.Mark(), "a scenario brings its reference along; leave it out");
    }
    sequence.simulation = *options;
    std::vector<OptionField> fields;
    for (OptionField& field : sequence.simulation.Fields()) {
      if (field.name != "seed") fields.push_back(std::move(field));
    }
    if (simulate.IsDefined() && !simulate.IsNull() &&
        !ReadBlock(simulate, "simulate", std::move(fields), {}, NoSpecial)) {
      return false;
    }
    if (!sequence.simulation.IsValid(error_)) return Fail(node.Mark(), *error_);
    if (sequence.name.empty()) sequence.name = sequence.scenario;
    if (keys.drives.empty()) {
      study_.sequences.push_back(std::move(sequence));
      return true;
    }
    const std::string name = sequence.name;
    sequence.has_fixed_drive = true;
    for (const int drive : keys.drives) {
      sequence.name = name + "_" + std::to_string(drive);
      sequence.simulation.seed = drive;
      study_.sequences.push_back(sequence);
    }
    return true;
  }

  bool CheckNames() {
    std::set<std::string> sequences;
    for (const StudySequence& sequence : study_.sequences) {
      if (!CheckName(sequence.name, sequence.place, "sequence", &sequences)) return false;
    }
    std::set<std::string> variants;
    for (const StudyVariant& variant : study_.variants) {
      if (!CheckName(variant.name, variant.place, "variant", &variants)) return false;
    }
    for (const StudySequence& sequence : study_.sequences) {
      for (const std::string& name : sequence.variants) {
        if (variants.count(name) == 0) {
          *error_ = sequence.place + "sequence " + sequence.name + " names the variant " + name +
                    ", which the study does not have";
          return false;
        }
      }
    }
    return true;
  }

  bool CheckName(const std::string& name,
                 const std::string& place,
                 const std::string& what,
                 std::set<std::string>* names) {
    if (!IsName(name)) {
      *error_ = place + "the name of a " + what +
                " must be letters, digits and . _ + -, not begin with . or -, and have 1 to 100 "
                "characters, is \"" +
                name + "\"";
    } else if (!names->insert(name).second) {
      *error_ = place + "there are two " + what + "s named " + name + "; names must differ";
    } else {
      return true;
    }
    return false;
  }

  const std::string file_;
  const fs::path folder_;
  std::string* const error_;
  fs::path data_root_;
  fs::path truth_root_;
  Study study_;
};

}  // namespace

std::vector<OptionField> Perturbation::Fields() {
  return {
      OptionField{"drop", &drop, "-", "Share of the returns left out."}.AtLeast(0.0).AtMost(0.99),
      OptionField{
          "max_start_shift", &max_start_shift, "scans", "Most scans left out at the beginning."}
          .AtLeast(0)
          .AtMost(1000000),
  };
}

std::optional<Study> LoadStudy(const fs::path& file, const StudyRoots& roots, std::string* error) {
  std::string text;
  if (!ReadTextFile(file.string(), "study file", &text, error)) return std::nullopt;
  try {
    return StudyReader(file, roots, error).Read(YAML::Load(text));
  } catch (const YAML::Exception& exception) {
    *error = PlaceInYaml(file.string(), exception.mark) + "not valid YAML: " + exception.msg;
    return std::nullopt;
  }
}

}  // namespace radive
