// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// How the files of a drive are to be read.
struct InputOptions {
  enum class Format {
    kAuto,         // found out, see detect_format.h
    kRaw,          // a file of records a scan, columns by `layout`
    kHercules,     // HeRCULES, Continental ARS548: a file of 29-byte records a scan
    kRadarScenes,  // a table of scans and a file of points a radar
    kPcd,          // self-describing files, one a scan
    kPly,
    kCsv,
    kNpy,
    kYaml,
    kRaFlow,   // RaFlow's JSON files with pairs of scans
    kRosbag1,  // ROS 1 bag, or a folder of them
    kRosbag2,  // rosbag 2: folder with metadata.yaml, or its files
    kMcap      // MCAP file, or a folder of them
  };
  enum class DopplerSign { kAuto, kPlus, kMinus };

  Format format = Format::kAuto;

  // Columns of raw records and of npy arrays, see ParseRawLayout() in raw_layout.h.
  // Empty: found out where the dataset is known.
  std::string layout;

  // Folder with the scan files, relative to the input; empty: found in the usual places. With radar
  // "all" a list of them.
  std::string folder;

  // Scans per second [Hz] where the data have no stamps: scan k gets the stamp k / rate. 0: not
  // known, 10 is assumed, with a warning.
  double rate = 0.0;

  // Which radar of the vehicle, for data with several: a number from 1, or "all", see all_radars.h.
  // Empty: the one that the dataset's row chooses, see datasets/dataset.h.
  std::string radar;

  // Of data in clips of consecutive scans: its number from 1; 0: the longest.
  int clip = 0;

  // What stored x y z are in FLU: a signed permutation such as +x+y+z or -y+x+z, whose entries say
  // where the canonical x, y and z come from; flu, rdf (right, down, forward), or auto, see axes.h.
  std::string axes = "auto";

  // What stored Doppler values are multiplied with to become range rates (positive receding).
  DopplerSign doppler_sign = DopplerSign::kAuto;

  // The data are of a sensor without elevation: z is set to 0.
  bool planar = false;

  // Which field of the points has which role, where the names do not tell, see
  // ParseFieldChoices() in field_matching.h.
  std::string fields;

  // Topic of a bag; empty: the only one with point clouds. With radar "all" a list of them.
  std::string topic;

  // Topic of a bag whose messages (std_msgs/Header) say when each scan began; empty: the only one
  // of that type, where the headers of the point clouds have no stamps; "none": no such topic.
  std::string trigger_topic;

  // Largest message that is read from a bag [bytes].
  int max_message_bytes = 256 << 20;

  // Sign that readers apply. Auto reads as stored: what decides it looks at the scans first.
  double FixedDopplerSign() const { return doppler_sign == DopplerSign::kMinus ? -1.0 : 1.0; }

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const;
};

}  // namespace radive
