// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/judge_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <string>

#include "tests/scratch_folder.h"
#include "tests/studies/study_file.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using testing::ScratchFolder;
using testing::WriteTextFile;
namespace fs = std::filesystem;

class JudgeRunTest : public ::testing::Test {
 protected:
  JudgeRunTest() {
    sequence_.name = "a";
    variant_.name = "ours";
    study_.timeout = 3.0;
    study_.evaluation.align = AlignmentMode::kNone;
    run_.sequence = &sequence_;
    run_.variant = &variant_;
    run_.start = 1;
    // Three scans behind the first: 1 m ahead each, the last 0.3 m beside the reference.
    WriteTextFile(In("trajectory_tum.txt"),
                  "10.1 0 0 0 0 0 0 1\n10.2 1 0 0 0 0 0 1\n10.3 2 0.3 0 0 0 0 1\n");
    WriteTextFile(In("run.json"),
                  "{\"frames\": 3, \"start\": 1, \"max_frames\": null, \"status\": "
                  "{\"registered\": 2}, \"peak_memory_mb\": 12.5, \"trajectory\": "
                  "{\"T_frame_reference\": [0, 0, 0, 0, 0, 0, 1]}}");
    WriteTextFile(In("timing.csv"),
                  "index,read_ms,odometry_ms,total_ms\n0,1,5,6\n1,1,3,4\n2,1,4,5\n");
  }

  fs::path In(const std::string& name) const { return scratch_.path() / name; }

  RunRecord Judge(const RunEnd& end, const fs::path& reference = fs::path()) {
    RunRecord record;
    JudgeRun(study_, run_, end, scratch_.path(), reference, &reference_, &record);
    return record;
  }

  const ScratchFolder scratch_;
  Study study_;
  StudySequence sequence_;
  StudyVariant variant_;
  StudyRun run_;
  RecordedTrajectory reference_;
};

TEST_F(JudgeRunTest, CountsAndTimesWithoutReference) {
  RunEnd end;
  end.wall_s = 2.0;
  end.cpu_s = 1.5;
  const RunRecord record = Judge(end);
  EXPECT_EQ(record.status, "ok");
  EXPECT_EQ(record.scans, 3);
  EXPECT_EQ(record.registered, 2);
  EXPECT_FALSE(record.scores.ate_t);
  EXPECT_NEAR(*record.scores.path_length, 1.0 + std::hypot(1.0, 0.3), 1e-9);
  EXPECT_EQ(record.timing.wall_s, 2.0);
  EXPECT_EQ(record.timing.ms_per_scan_median, 4.0);
  EXPECT_EQ(record.timing.ms_per_scan_p95, 5.0);
  EXPECT_EQ(record.timing.max_rss_mb, 12.5);
}

// A reference of the whole drive, a line a scan without stamps: its first line is of the scan that
// was left out.
TEST_F(JudgeRunTest, MatchesReferencesWithoutStampsByScan) {
  const std::string rotation_x = "1 0 0 ";
  const auto line = [&](const std::string& x) { return rotation_x + x + " 0 1 0 0 0 0 1 0\n"; };
  const fs::path reference =
      WriteTextFile(In("poses.txt"), line("-1") + line("0") + line("1") + line("2"));
  const RunRecord record = Judge(RunEnd(), reference);
  EXPECT_EQ(record.status, "ok") << record.message;
  // Errors 0, 0 and 0.3 m; no rotation.
  EXPECT_NEAR(*record.scores.ate_t, 0.3 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(*record.scores.ate_r, 0.0, 1e-9);
  EXPECT_FALSE(record.scores.drift_t);  // under 100 m
  ASSERT_EQ(reference_.size(), 3u);
  EXPECT_EQ(reference_[0].stamp_ns, 10'100'000'000);
  EXPECT_EQ(reference_[2].T_world_body.translation.x(), 2.0);
}

// The reference is of a body 0.5 m behind: seen as the estimate, its poses lie 0.5 m ahead.
TEST_F(JudgeRunTest, GivesTheReferenceAsTheBodyOfTheEstimate) {
  WriteTextFile(In("run.json"),
                "{\"frames\": 3, \"start\": 1, \"max_frames\": null, \"status\": "
                "{\"registered\": 2}, \"peak_memory_mb\": 12.5, \"trajectory\": "
                "{\"T_frame_reference\": [-0.5, 0, 0, 0, 0, 0, 1]}}");
  const fs::path reference = WriteTextFile(
      In("gt.txt"), "10.1 -0.5 0 0 0 0 0 1\n10.2 0.5 0 0 0 0 0 1\n10.3 1.5 0 0 0 0 0 1\n");
  const RunRecord record = Judge(RunEnd(), reference);
  EXPECT_EQ(record.status, "ok") << record.message;
  EXPECT_NEAR(*record.scores.ate_t, 0.3 / std::sqrt(3.0), 1e-9);
  ASSERT_EQ(reference_.size(), 3u);
  EXPECT_NEAR(reference_[1].T_world_body.translation.x(), 1.0, 1e-12);
}

TEST_F(JudgeRunTest, SaysWhatWentWrong) {
  RunEnd end;
  end.output = "warning\nradive_odometry: a.bin: expected 20 bytes\n\n";
  end.exit_status = 1;
  EXPECT_EQ(Judge(end).status, "failed");
  EXPECT_EQ(Judge(end).message, "a.bin: expected 20 bytes");
  end.output = "";
  EXPECT_EQ(Judge(end).message, "exit status 1");
  end.signal = SIGABRT;
  EXPECT_EQ(Judge(end).status, "crashed");
  EXPECT_EQ(Judge(end).message, "signal 6 (Aborted)");
  end.timed_out = true;
  EXPECT_EQ(Judge(end).status, "timeout");
  EXPECT_EQ(Judge(end).message, "not done after 3 s");

  const RunRecord unread = Judge(RunEnd(), In("nowhere.txt"));
  EXPECT_EQ(unread.status, "failed");
  EXPECT_THAT(unread.message, HasSubstr("nowhere.txt"));
  const fs::path later = WriteTextFile(In("later.txt"), "99.1 0 0 0 0 0 0 1\n99.2 1 0 0 0 0 0 1\n");
  const RunRecord unmatched = Judge(RunEnd(), later);
  EXPECT_EQ(unmatched.status, "failed");
  EXPECT_THAT(unmatched.message, HasSubstr("no score: "));
  EXPECT_FALSE(unmatched.scores.path_length);
  fs::remove(In("run.json"));
  EXPECT_THAT(Judge(RunEnd()).message, HasSubstr("run.json: cannot read"));
}

}  // namespace
}  // namespace radive
