// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/input_options.h"

#include "radive/io/bytes/text_lines.h"
#include "radive/io/points/field_matching.h"
#include "radive/io/points/raw_layout.h"
#include "radive/io/scans/axes.h"
#include "radive/io/scans/scan_stamps.h"

namespace radive {

namespace {

std::string KnownLayouts() {
  std::string names;
  for (const std::string& name : RawLayoutNames()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

std::vector<OptionField> InputOptions::Fields() {
  return {
      OptionField{"format",
                  MakeChoice(&format,
                             {"auto",
                              "raw",
                              "hercules",
                              "radarscenes",
                              "pcd",
                              "ply",
                              "csv",
                              "npy",
                              "yaml",
                              "raflow",
                              "rosbag1",
                              "rosbag2",
                              "mcap"}),
                  "-",
                  "Form of the data; auto finds it out and says why."},
      OptionField{
          "layout",
          &layout,
          "-",
          "Columns of raw records and npy arrays; empty: found out where the dataset is known: " +
              KnownLayouts() +
              " (aeva: aeva29 or aeva25), or a list of x, y, z, doppler, power and _ (ignored), "
              "such as [x,y,z,doppler,power,_,_]; float32, or with the type: rcs:int8."},
      OptionField{"fields",
                  &fields,
                  "-",
                  "Fields of the points that have other names than usual, or another choice among "
                  "them: [doppler=vel_r, power=snr]; _ for none. Roles: x, y, z, range, azimuth, "
                  "elevation, doppler, power, time."},
      OptionField{
          "folder",
          &folder,
          "-",
          "Folder with the scan files, relative to the input or to a folder below it; empty: "
          "the usual places are searched. With input.radar all a list: [one, other]."},
      OptionField{
          "rate",
          &rate,
          "Hz",
          "Scans per second, for data that store no stamps: scan k gets the stamp k / rate. 0: "
          "not known, 10 is assumed, with a warning."}
          .AtLeast(0.0)
          .AtMost(1e6),
      OptionField{
          "radar",
          &radar,
          "-",
          "Which radar of the vehicle, for data with several: its number from 1, or all, which "
          "makes motion.body the vehicle; empty: the dataset's usual one (of RadarScenes 2)."},
      OptionField{"clip",
                  &clip,
                  "-",
                  "Which clip, for data in clips of consecutive scans, from 1; 0: the longest."}
          .AtLeast(0),
      OptionField{
          "axes",
          &axes,
          "-",
          "Where x forward, y left and z up come from in the data: a signed permutation like "
          "+x+y+z or +z-x-y, flu, rdf (right, down, forward), or auto."},
      OptionField{"doppler_sign",
                  MakeChoice(&doppler_sign, {"auto", "+1", "-1"}),
                  "-",
                  "Factor that makes the stored Doppler a range rate, positive when moving away."},
      OptionField{
          "planar", &planar, "-", "Data of a sensor that measures no elevation: z is set to 0."},
      OptionField{"topic",
                  &topic,
                  "-",
                  "Topic of a bag with the point clouds; empty: the only one that has any. With "
                  "input.radar all a list: [/one, /other]."},
      OptionField{
          "trigger_topic",
          &trigger_topic,
          "-",
          "Topic of a bag (std_msgs/Header) that says when each scan began; empty: the only "
          "one, where the point clouds have no stamps; none: not used."},
      OptionField{"max_message_bytes",
                  &max_message_bytes,
                  "bytes",
                  "Largest message that is read from a bag; the chunks of a bag may be a little "
                  "larger."}
          .AtLeast(1024),
  };
}

bool InputOptions::IsValid(std::string* error) const {
  if (!CheckOptions("input", *this, error)) return false;
  std::string reason;
  if (!ParseFieldChoices(fields, &reason)) {
    *error = "input." + reason;
    return false;
  }
  if (axes != "auto" && !ParseAxes(axes)) {
    *error =
        "input.axes must be a signed permutation like +x+y+z or +z-x-y, flu, rdf or auto, is " +
        Quoted(axes);
    return false;
  }
  if (!layout.empty() && !ParseRawLayout(layout, &reason)) {
    *error = "input." + reason;
    return false;
  }
  const std::optional<std::int64_t> number = ParseInteger(radar);
  if (!radar.empty() && radar != "all" && !(number && *number >= 1 && *number <= 999)) {
    *error = "input.radar must be a number from 1, all or empty, is '" + radar + "'";
    return false;
  }
  return true;
}

}  // namespace radive
