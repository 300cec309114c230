// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/input_report.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <variant>

#include "radive/io/open/detect_format.h"
#include "radive/io/open/open_scan_source.h"
#include "radive/pipeline/doppler_checked_source.h"
#include "radive/pipeline/plausibility.h"
#include "radive/util/json.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

constexpr double kGap = 1.8;  // times the median interval
constexpr std::size_t kMostWarnings = 5;
constexpr std::size_t kMostScans = 100;  // that are looked at

std::string Number(double value) { return FormatText("%.4g", value); }

std::string FormatWord(InputOptions options) {
  for (const OptionField& field : options.Fields()) {
    if (field.name == "format") return field.ToString();
  }
  return "?";
}

void MeasureStamps(const std::vector<std::int64_t>& stamps_ns, InputReport* report) {
  report->num_stamps = stamps_ns.size();
  std::vector<std::int64_t> intervals;
  for (std::size_t i = 1; i < stamps_ns.size(); ++i) {
    if (stamps_ns[i] > stamps_ns[i - 1]) {
      // Not signed: hostile stamps lie further apart than that.
      const std::uint64_t interval =
          static_cast<std::uint64_t>(stamps_ns[i]) - static_cast<std::uint64_t>(stamps_ns[i - 1]);
      intervals.push_back(static_cast<std::int64_t>(std::min<std::uint64_t>(interval, INT64_MAX)));
    } else {
      ++report->num_not_increasing;
    }
  }
  if (intervals.empty()) return;
  std::sort(intervals.begin(), intervals.end());
  const double median = static_cast<double>(intervals[intervals.size() / 2]) * 1e-9;
  report->rate = 1.0 / median;
  report->longest_interval = static_cast<double>(intervals.back()) * 1e-9;
  report->num_gaps = static_cast<int>(
      std::count_if(intervals.begin(), intervals.end(), [median](std::int64_t interval) {
        return static_cast<double>(interval) * 1e-9 > kGap * median;
      }));
}

// What the first scans say of their Doppler.
std::string DopplerText(const InputOptions& options, const std::vector<DopplerRemark>& remarks) {
  std::string text;
  for (const DopplerRemark& remark : remarks) {
    constexpr std::string_view kFront = "Doppler ";
    text += text.empty() ? "" : "; ";
    text +=
        remark.text.substr(remark.text.compare(0, kFront.size(), kFront) == 0 ? kFront.size() : 0);
  }
  if (options.doppler_sign == InputOptions::DopplerSign::kAuto) {
    return text.empty() ? "the first scans do not tell its sign" : text;
  }
  const bool is_minus = options.doppler_sign == InputOptions::DopplerSign::kMinus;
  return std::string("sign ") + (is_minus ? "-1" : "+1") + " as set; " +
         (text.empty() ? "the first scans neither confirm nor contradict it" : text);
}

std::string RangeText(const FieldSummary& field) {
  std::string text;
  if (field.min <= field.max) text = Number(field.min) + " .. " + Number(field.max);
  if (field.num_not_finite > 0) {
    text += (text.empty() ? "" : ", ") + std::to_string(field.num_not_finite) + " of " +
            std::to_string(field.num_values) + " no numbers";
  }
  return text.empty() ? "no values" : text;
}

class TextBlock {
 public:
  void Add(const std::string& name, const std::string& what) {
    if (what.empty()) return;
    text_ += FormatText("  %-9s ", (name.empty() ? "" : name + ":").c_str()) + what + "\n";
  }
  std::string text_;
};

std::string TimesText(const InputReport& report) {
  const std::string origin =
      report.facts.stamp_origin.empty() ? "" : ", stamps from " + report.facts.stamp_origin;
  if (report.rate <= 0.0) return "no two stamps in order" + origin;
  std::string text = Number(report.rate) + " Hz, ";
  text += report.num_gaps == 0 ? "no gaps"
                               : std::to_string(report.num_gaps) + " gaps, the longest " +
                                     Number(report.longest_interval) + " s";
  if (report.num_not_increasing > 0) {
    text += ", " + std::to_string(report.num_not_increasing) + " stamps repeat or go back";
  }
  return text + " (over " + std::to_string(report.num_stamps) + " stamps)" + origin;
}

}  // namespace

std::string InputReport::ToText() const {
  TextBlock block;
  block.text_ = "input " + path + "\n";
  block.Add("format", format + (layout.empty() ? "" : " (" + layout + ")") + "; " + reason);
  block.Add("from", facts.place);
  for (const FieldSummary& field : facts.fields) {
    block.Add(&field == &facts.fields.front() ? "fields" : "",
              field.name + " " + field.type + " " + RangeText(field) +
                  (field.role.empty() ? "" : " -> " + field.role));
  }
  block.Add("axes", facts.axes);
  block.Add("Doppler", has_doppler ? doppler : "none");
  block.Add("scans",
            (num_scans ? std::to_string(*num_scans) : "unknown number") + ", " +
                Number(returns_per_scan) + " returns each (mean of the first " +
                std::to_string(num_scans_read) + "), " + (is_planar ? "2D" : "3D"));
  block.Add("times", TimesText(*this));
  block.Add("no drive", facts.why_no_drive);
  for (std::size_t i = 0; i < warnings.size() && i < kMostWarnings; ++i) {
    block.Add("warning", warnings[i]);
  }
  if (warnings.size() > kMostWarnings) {
    block.Add("warning", std::to_string(warnings.size() - kMostWarnings) + " more");
  }
  return block.text_;
}

std::string InputReport::ToJson() const {
  Json fields = Json::array();
  for (const FieldSummary& field : facts.fields) {
    Json entry = {{"name", field.name}, {"type", field.type}, {"role", field.role}};
    if (field.min <= field.max) {
      entry["min"] = field.min;
      entry["max"] = field.max;
    }
    entry["num_not_finite"] = field.num_not_finite;
    fields.push_back(entry);
  }
  Json json = {{"path", path},
               {"format", format},
               {"layout", layout},
               {"reason", reason},
               {"from", facts.place},
               {"fields", fields},
               {"axes", facts.axes},
               {"has_doppler", has_doppler},
               {"doppler", doppler},
               {"dimensions", is_planar ? 2 : 3},
               {"num_scans", nullptr},
               {"num_scans_read", num_scans_read},
               {"returns_per_scan", returns_per_scan},
               {"stamps_from", facts.stamp_origin},
               {"num_stamps", num_stamps},
               {"rate", rate},
               {"num_gaps", num_gaps},
               {"longest_interval", longest_interval},
               {"num_not_increasing", num_not_increasing},
               {"why_no_drive", facts.why_no_drive},
               {"warnings", warnings}};
  if (num_scans) json["num_scans"] = *num_scans;
  // Names of fields and files may be any bytes.
  return JsonText(json);
}

std::optional<InputReport> InspectInput(const std::string& path,
                                        const InputOptions& options,
                                        const SensorOptions& sensor,
                                        const PreprocessingOptions& preprocessing,
                                        std::string* error) {
  InputReport report;
  report.path = path;
  InputOptions found = options;
  if (!found.IsValid(error) || !DetectFormat(path, &found, &report.reason, error)) {
    return std::nullopt;
  }
  const std::unique_ptr<ScanSource> source = OpenScanSource(path, found, error);
  if (source == nullptr) return std::nullopt;
  report.format = FormatWord(found);
  report.layout = found.layout;
  const bool is_given = found.doppler_sign != InputOptions::DopplerSign::kAuto;
  DopplerCheckedSource checked_source(
      source.get(),
      DopplerCheck(sensor,
                   preprocessing,
                   is_given ? DopplerCheck::Sign::kGiven : DopplerCheck::Sign::kUnknown));
  std::vector<std::int64_t> stamps_ns;
  std::size_t num_returns = 0;
  Plausibility plausibility;
  RadarScan scan;
  while (stamps_ns.size() < kMostScans) {
    const ScanSource::Status status = checked_source.Next(&scan);
    for (std::string& warning : checked_source.TakeWarnings()) report.warnings.push_back(warning);
    if (status == ScanSource::Status::kError) {
      *error = checked_source.error();
      return std::nullopt;
    }
    if (status == ScanSource::Status::kEnd) break;
    stamps_ns.push_back(scan.stamp_ns);
    num_returns += scan.returns.size();
    plausibility.AddScan(scan);
    report.has_doppler =
        report.has_doppler || scan.has_doppler || checked_source.check().Factor(scan.radar) == 0;
    report.is_planar = stamps_ns.size() == 1 ? scan.is_planar : report.is_planar && scan.is_planar;
  }
  if (stamps_ns.empty()) {
    *error = path + ": there are no scans";
    if (!report.warnings.empty()) *error += "; first warning: " + report.warnings.front();
    return std::nullopt;
  }
  report.num_scans_read = static_cast<int>(stamps_ns.size());
  report.returns_per_scan =
      static_cast<double>(num_returns) / static_cast<double>(stamps_ns.size());
  for (std::string& warning : plausibility.Warnings()) {
    report.warnings.push_back(std::move(warning));
  }
  report.num_scans = source->NumScans();
  report.facts = source->Facts();
  MeasureStamps(report.facts.stamps_ns.empty() ? stamps_ns : report.facts.stamps_ns, &report);
  report.doppler = DopplerText(found, checked_source.TakeRemarks());
  return report;
}

}  // namespace radive
