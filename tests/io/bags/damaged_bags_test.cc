// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Damaged bags never crash a reader, never hang it, and never make it take more memory than they
// have bytes for: cut at every byte, every bit flipped, counts that are too large. Run it in the
// sanitizer build for its full worth.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "radive/io/bags/mcap_reader.h"
#include "radive/io/bags/ros1_bag_reader.h"
#include "radive/io/bags/sqlite_bag_reader.h"
#include "radive/io/bags/unpacking_message_source.h"
#include "tests/io/bags/bag_files.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using testing::BagForm;

// Memory that the tests may take beyond what the program takes at their start; the sanitizers
// reserve too much of it for a limit.
void LimitMemory() {
#if !defined(__SANITIZE_ADDRESS__)
  constexpr rlim_t kBytes = 300 << 20;
  std::ifstream statm("/proc/self/statm");
  rlim_t num_pages = 0;
  if (!(statm >> num_pages)) return;
  const rlim_t limit = num_pages * 4096 + kBytes;
  const rlimit limits = {limit, limit};
  setrlimit(RLIMIT_AS, &limits);
#endif
}

class DamagedBags : public ::testing::TestWithParam<BagForm> {
 protected:
  static void SetUpTestSuite() { LimitMemory(); }

  void SetUp() override {
    const testing::ScratchFolder folder;
    const std::filesystem::path path = folder.path() / GetParam().name;
    testing::WriteBag(path, GetParam(), testing::MadeScans(4, 3));
    bytes_ = testing::ReadFile(
        GetParam().format == BagFormat::kRosbag2 ? path / (GetParam().name + "_0.db3") : path);
  }

  std::unique_ptr<MessageSource> Open(const std::string& bytes, std::string* error) const {
    if (GetParam().format == BagFormat::kRosbag2) {
      auto bag = SqliteBagReader::OpenBytes(bytes, "bag", {}, error);
      if (bag == nullptr) return nullptr;
      return std::make_unique<UnpackingMessageSource>(std::move(bag), MessageLimits());
    }
    auto file = std::make_unique<MemoryFile>("bag", bytes);
    if (GetParam().format == BagFormat::kMcap) return McapReader::Open(std::move(file), {}, error);
    return Ros1BagReader::Open(std::move(file), {}, error);
  }

  // Opens and reads a damaged bag, all topics and then the clouds alone. Returns the number of
  // messages; what does not open says why.
  std::size_t Read(const std::string& bytes) const {
    std::string error;
    const std::unique_ptr<MessageSource> bag = Open(bytes, &error);
    if (bag == nullptr) {
      EXPECT_EQ(error.substr(0, 5), "bag: ");
      return 0;
    }
    std::vector<int> all;
    for (std::size_t i = 0; i < bag->topics().size(); ++i) all.push_back(static_cast<int>(i));
    bag->Select(all);
    Message message;
    std::size_t num_messages = 0;
    std::size_t num_bytes = 0;
    MessageSource::Status status;
    while ((status = bag->Next(&message)) == MessageSource::Status::kMessage) {
      ++num_messages;
      num_bytes += message.payload.size();
    }
    if (status == MessageSource::Status::kError) {
      EXPECT_EQ(bag->error().substr(0, 5), "bag: ");
    }
    EXPECT_LE(num_messages, 8u);
    EXPECT_LE(num_bytes, std::max(bytes.size(), std::size_t{20000}));

    std::unique_ptr<MessageSource> again = Open(bytes, &error);
    // SQLite may judge a damaged file differently the second time.
    if (again == nullptr) return num_messages;
    const auto source = BagSource::Create(std::move(again), "bag", InputOptions(), &error);
    RadarScan scan;
    std::size_t num_scans = 0;
    while (source != nullptr && source->Next(&scan) == ScanSource::Status::kScan) ++num_scans;
    EXPECT_LE(num_scans, 8u);
    return num_messages;
  }

  std::string bytes_;
};

#if !defined(__SANITIZE_ADDRESS__)
TEST_P(DamagedBags, AreReadWithLittleMemory) {
  EXPECT_THROW(std::string(std::size_t{400} << 20, 'x'), std::bad_alloc);
}
#endif

TEST_P(DamagedBags, CutAtEveryByte) {
  std::size_t most = 0;
  const std::size_t step = GetParam().format == BagFormat::kRosbag2 ? 61 : 1;
  for (std::size_t size = 0; size < bytes_.size(); size += step) {
    most = std::max(most, Read(bytes_.substr(0, size)));
  }
  EXPECT_EQ(Read(bytes_), 8u);
  // The index is behind the messages; of SQLite's pages all are needed.
  if (GetParam().format != BagFormat::kRosbag2) {
    EXPECT_EQ(most, 8u);
  }
}

TEST_P(DamagedBags, EveryBitFlipped) {
  const std::size_t step = GetParam().format == BagFormat::kRosbag2 ? 31 : 1;
  std::string damaged = bytes_;
  for (std::size_t bit = 0; bit < 8 * bytes_.size(); bit += step) {
    // The bag header of ROS 1 is padded with blanks.
    if (GetParam().format == BagFormat::kRosbag1 && bit > 8 * 200 && bit < 8 * 4000) continue;
    damaged[bit / 8] ^= static_cast<char>(1 << bit % 8);
    Read(damaged);
    damaged[bit / 8] = bytes_[bit / 8];
  }
}

// Every place that could be a count or a size claims 2 GiB, 4 GiB or more.
TEST_P(DamagedBags, CountsThatAreTooLarge) {
  const std::size_t step = GetParam().format == BagFormat::kRosbag2 ? 13 : 1;
  for (const char* large :
       {"\xFF\xFF\xFF\x7F", "\xFF\xFF\xFF\xFF", "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x7F"}) {
    const std::string count = large;
    for (std::size_t place = 0; place + count.size() <= bytes_.size(); place += step) {
      if (GetParam().format == BagFormat::kRosbag1 && place > 200 && place < 4000) continue;
      std::string damaged = bytes_;
      Read(damaged.replace(place, count.size(), count));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllForms,
                         DamagedBags,
                         ::testing::ValuesIn(testing::AllBagForms()),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           for (char& c : name) c = c == '.' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace radive
