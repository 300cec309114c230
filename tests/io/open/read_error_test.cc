// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The disk fails while a drive is read: pread() of this program gives EIO when a test asks for it.

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>

#include "radive/io/open/open_scan_source.h"
#include "radive/io/open/open_scan_writer.h"
#include "tests/io/scan_files.h"

namespace {

std::atomic<int> num_preads{0};
std::atomic<int> last_good_pread{-1};  // below 0: all are good

ssize_t Pread(const char* name, int file, void* bytes, size_t count, off_t offset) {
  if (last_good_pread >= 0 && num_preads >= last_good_pread) {
    errno = EIO;
    return -1;
  }
  ++num_preads;
  using Function = ssize_t (*)(int, void*, size_t, off_t);
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name))(file, bytes, count, offset);
}

}  // namespace

// Those of the shared libraries, too, call these.
extern "C" {
ssize_t pread(int file, void* bytes, size_t count, off_t offset) {
  return Pread("pread", file, bytes, count, offset);
}
ssize_t pread64(int file, void* bytes, size_t count, off_t offset) {
  return Pread("pread64", file, bytes, count, offset);
}
}

namespace radive {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// Writes 50 scans of 40 returns.
void WriteDrive(const std::string& form, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::string error;
  const std::unique_ptr<ScanWriter> writer = OpenScanWriter(form, folder, &error);
  ASSERT_NE(writer, nullptr) << error;
  for (int k = 0; k < 50; ++k) {
    RadarScan scan;
    scan.stamp_ns = 100000000LL * k;
    scan.has_doppler = true;
    for (int i = 0; i < 40; ++i) {
      RadarReturn entry;
      entry.position = {5.0 + i, 0.25 * k, 1.0};
      scan.returns.push_back(entry);
    }
    ASSERT_TRUE(writer->Add(scan, &error)) << error;
  }
  ASSERT_TRUE(writer->Finish(&error)) << error;
}

// Scans of the drive that are read, and the error at its end; "" without one.
std::pair<int, std::string> Read(const std::string& path) {
  std::string error;
  const std::unique_ptr<ScanSource> source = OpenScanSource(path, InputOptions(), &error);
  if (source == nullptr) return {0, error};
  RadarScan scan;
  int count = 0;
  ScanSource::Status status;
  while ((status = source->Next(&scan)) == ScanSource::Status::kScan) ++count;
  return {count, status == ScanSource::Status::kError ? source->error() : ""};
}

class ReadError : public ::testing::TestWithParam<const char*> {};

// At whichever read the disk fails for good, the drive ends with an error, not with fewer scans.
TEST_P(ReadError, OfABagIsNoDamage) {
  const testing::TempFolder folder;
  const std::filesystem::path drive = folder.path() / "drive";
  WriteDrive(GetParam(), drive);
  num_preads = 0;
  last_good_pread = -1;
  ASSERT_EQ(Read(drive.string()), std::make_pair(50, std::string()));
  const int num_needed = num_preads;
  ASSERT_GT(num_needed, 1);
  for (int number = 0; number < num_needed; ++number) {
    num_preads = 0;
    last_good_pread = number;
    const auto [count, error] = Read(drive.string());
    last_good_pread = -1;
    EXPECT_THAT(error, HasSubstr((drive / "drive").string())) << number;
    EXPECT_LT(count, 51);
  }
  // The last one is certainly behind those of opening.
  num_preads = 0;
  last_good_pread = num_needed - 1;
  const std::string error = Read(drive.string()).second;
  last_good_pread = -1;
  EXPECT_THAT(error, AllOf(HasSubstr("cannot be read"), HasSubstr("Input/output error")));
}

INSTANTIATE_TEST_SUITE_P(
    Bags, ReadError, ::testing::Values("rosbag1", "rosbag1_bz2", "rosbag2", "mcap", "mcap_zstd"));

}  // namespace
}  // namespace radive
