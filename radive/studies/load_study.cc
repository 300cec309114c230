// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/load_study.h"

#include <glob.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <set>
#include <utility>

#include "radive/config/yaml_settings.h"
#include "radive/simulation/scenarios.h"
#include "radive/studies/study_blocks.h"
#include "radive/util/natural_order.h"
#include "radive/util/text.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

// What is to be compared is always the same, and how poses are matched is a setting of the run.
const std::set<std::string> kNotOfTheStudy = {
    "metric", "relation", "match", "max_time_difference", "max_gap"};

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

class StudyReader {
 public:
  StudyReader(const fs::path& file, const StudyRoots& roots, std::string* error)
      : blocks_(file.string(), error),
        name_(file.stem().string()),
        folder_(file.parent_path()),
        error_(error) {
    data_root_ = roots.data.empty() ? folder_ : roots.data;
    truth_root_ = roots.truth.empty() ? data_root_ : roots.truth;
  }

  std::optional<Study> Read(const YAML::Node& root) {
    study_.name = name_;
    study_.evaluation.align = AlignmentMode::kSe3;
    study_.evaluation.plane = Plane::kXy;
    if (!root.IsMap()) {
      blocks_.Fail(root.Mark(), "expected \"sequences:\", \"variants:\" and other keys of a study");
      return std::nullopt;
    }
    if (ReadTop(root) && CheckNames()) return std::move(study_);
    return std::nullopt;
  }

 private:
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
      if (key == "set") return blocks_.ReadSet(node, at, &study_.set);
      if (key == "seeds") return blocks_.ReadSeeds(node, key, at, &study_.seeds);
      if (key == "perturb") return blocks_.Read(node, key, study_.perturb.Fields());
      if (key == "evaluate") return ReadEvaluation(node);
      (key == "sequences" ? sequences : variants).reset(node);
      return node.IsSequence() ||
             blocks_.Fail(at, key + " must be a list: lines that begin with \"- \"");
    };
    if (!blocks_.Read(root,
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
      study_.variants.push_back({"default", "default", "", 0, blocks_.Place(root.Mark())});
    }
    if (!study_.sequences.empty()) return true;
    return blocks_.Fail(root.Mark(),
                        "there are no sequences: expected \"sequences:\" with at least one");
  }

  bool ReadEvaluation(const YAML::Node& node) {
    std::vector<OptionField> fields;
    for (OptionField& field : study_.evaluation.Fields()) {
      if (kNotOfTheStudy.count(field.name) == 0) fields.push_back(std::move(field));
    }
    if (!blocks_.Read(node, "evaluate", std::move(fields))) return false;
    if (study_.evaluation.IsValid(error_) && study_.evaluation.pairs.IsValid(error_)) return true;
    return blocks_.Fail(node.Mark(), *error_);
  }

  bool ReadVariant(const YAML::Node& node) {
    StudyVariant variant;
    variant.place = blocks_.Place(node.Mark());
    std::vector<OptionField> fields = {
        {"name", &variant.name, "-", ""},
        {"label", &variant.label, "-", ""},
        OptionField{"frames", &variant.frames, "-", ""}.AtLeast(0),
    };
    const auto special = [&](const std::string&, const YAML::Node& set, const YAML::Mark& at) {
      return blocks_.ReadSet(set, at, &variant.set);
    };
    if (!blocks_.Read(node, "variant", std::move(fields), {"set"}, special)) return false;
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
    sequence.place = blocks_.Place(node.Mark());
    std::vector<OptionField> fields = {
        {"name", &sequence.name, "-", ""},
        {"input", &keys.input, "-", ""},
        {"glob", &keys.glob, "-", ""},
        {"scenario", &sequence.scenario, "-", ""},
        {"reference", &keys.reference, "-", ""},
        {"config", &keys.config, "-", ""},
        OptionField{"frames", &sequence.frames, "-", ""}.AtLeast(0),
    };
    YAML::Node simulate;
    const auto special =
        [&](const std::string& key, const YAML::Node& value, const YAML::Mark& at) {
          if (key == "set") return blocks_.ReadSet(value, at, &sequence.set);
          if (key == "drives") return blocks_.ReadSeeds(value, key, at, &keys.drives);
          if (key == "variants") return blocks_.ReadNames(value, key, at, &sequence.variants);
          simulate.reset(value);
          return true;
        };
    if (!blocks_.Read(node,
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
      return blocks_.Fail(node.Mark(), "a sequence must have one of input, glob and scenario");
    }
    if (sequence.is_simulated()) return AddSimulated(node, simulate, keys, sequence);
    if (simulate.IsMap() || !keys.drives.empty()) {
      return blocks_.Fail(node.Mark(), "simulate and drives are for a sequence with a scenario");
    }
    return AddRecorded(node, keys, sequence);
  }

  bool AddRecorded(const YAML::Node& node, const SequenceKeys& keys, StudySequence sequence) {
    std::vector<fs::path> inputs = {data_root_ / keys.input};
    if (!keys.glob.empty()) {
      inputs = Glob(data_root_ / keys.glob);
      if (inputs.empty() && study_.absent == Study::Absent::kFail) {
        return blocks_.Fail(node.Mark(),
                            (data_root_ / keys.glob).string() + " fits no folder and no file");
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
        const std::string name = ReplaceAll(keys.reference, "{name}", sequence.name);
        sequence.reference =
            (truth_root_ / ReplaceAll(name, "{input}", fs::absolute(input).string()))
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
      return blocks_.Fail(
          node.Mark(), "scenario must be one of " + names + ", is " + Excerpt(sequence.scenario));
    }
    if (!keys.reference.empty()) {
      return blocks_.Fail(node.Mark(), "a scenario brings its reference along; leave it out");
    }
    sequence.simulation = *options;
    std::vector<OptionField> fields;
    for (OptionField& field : sequence.simulation.Fields()) {
      if (field.name != "seed") fields.push_back(std::move(field));
    }
    if (simulate.IsDefined() && !simulate.IsNull() &&
        !blocks_.Read(simulate, "simulate", std::move(fields))) {
      return false;
    }
    if (!sequence.simulation.IsValid(error_)) return blocks_.Fail(node.Mark(), *error_);
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
          *error_ = sequence.place + "sequence " + sequence.name + " names the variant " +
                    Excerpt(name) + ", which the study does not have";
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
                Excerpt(name) + "\"";
    } else if (!names->insert(name).second) {
      *error_ = place + "there are two " + what + "s named " + name + "; names must differ";
    } else {
      return true;
    }
    return false;
  }

  const StudyBlocks blocks_;
  const std::string name_;
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
  if (!ReadTextFile(file.string(), "study file", kLargestSettings, &text, error))
    return std::nullopt;
  try {
    return StudyReader(file, roots, error).Read(YAML::Load(text));
  } catch (const YAML::Exception& exception) {
    *error = PlaceInYaml(file.string(), exception.mark) + "not valid YAML: " + exception.msg;
    return std::nullopt;
  }
}

}  // namespace radive
