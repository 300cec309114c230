// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// ROS 1's own tool (Debian: python3-rosbag) reads the bags that we write, and we read those that it
// writes. Its path to Python and that of copy_rosbag.py are macros.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/io/bags/bag_files.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

bool RunPython(const std::string& arguments) {
  return std::system(
             (std::string(RADIVE_ROSBAG_PYTHON) + " " + arguments + " 2>/dev/null").c_str()) == 0;
}

TEST(RosbagExchange, BothReadWhatTheOtherWrites) {
  if (!RunPython("-c 'import rosbag'")) GTEST_SKIP() << "python3-rosbag is not installed";
  for (const testing::BagForm& form : testing::AllBagForms()) {
    if (form.format != BagFormat::kRosbag1 || !form.index) continue;
    SCOPED_TRACE(form.name);
    const testing::ScratchFolder folder;
    const std::string ours = (folder.path() / "ours.bag").string();
    const std::string theirs = (folder.path() / "theirs.bag").string();
    // Of ROS, a message at time 0 cannot be written.
    std::vector<RadarScan> scans = testing::MadeScans(20);
    for (RadarScan& scan : scans) scan.stamp_ns += 1706001762099999905;
    testing::WriteBag(ours, form, scans);
    ASSERT_TRUE(RunPython(std::string(RADIVE_COPY_ROSBAG) + " " + ours + " " + theirs + " " +
                          NameOf(form.compression)));
    std::string error;
    const auto read = [&](const std::string& path) {
      const auto bag = OpenMessageSource(path, BagFormat::kRosbag1, {}, &error);
      EXPECT_NE(bag, nullptr) << error;
      EXPECT_TRUE(bag->TakeWarnings().empty());
      return testing::ReadMessages(bag.get());
    };
    EXPECT_EQ(read(theirs), read(ours));
    const auto source = BagSource::Open(theirs, BagFormat::kRosbag1, InputOptions(), &error);
    ASSERT_NE(source, nullptr) << error;
    EXPECT_NE(source->Description().find("20 messages"), std::string::npos);
  }
}

}  // namespace
}  // namespace radive
