// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/result_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "radive/studies/results_database.h"
#include "radive/studies/run_record.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using testing::ScratchFolder;

RunRecord MadeRecord() {
  RunRecord record;
  record.sequence = "street";
  record.variant = "ours";
  record.seed = 3;
  record.status = "ok";
  record.scores.ate_t = 0.125;
  record.scores.ate_r = 2.0 / 3.0;
  record.scores.path_length = 100.5;
  record.scans = 40;
  record.registered = 38;
  record.warnings = 2;
  record.input_hash = "aa";
  record.config_hash = "bb";
  record.program_hash = "cc";
  record.timing = {1.5, 1.25, 2.0, 3.5, 11.0};
  return record;
}

RunRecord FailedRecord() {
  RunRecord record = MadeRecord();
  record.seed = 4;
  record.status = "failed";
  record.message = "a \"b\", c\nd";
  record.scores = RunScores();
  record.scans.reset();
  record.registered.reset();
  record.warnings.reset();
  return record;
}

TEST(ResultsCsv, HasARowARun) {
  EXPECT_EQ(ResultsCsv({MadeRecord(), FailedRecord()}),
            "sequence,variant,seed,status,message,ate_t,ate_r,rpe_t,rpe_r,drift_t,drift_r,scans,"
            "registered,path_length,warnings,input_hash,config_hash,program_hash\n"
            "street,ours,3,ok,,0.125,0.666666667,,,,,40,38,100.5,2,aa,bb,cc\n"
            "street,ours,4,failed,\"a \"\"b\"\", c d\",,,,,,,,,,,aa,bb,cc\n");
}

TEST(TimingsCsv, HasARowForEachRunThatIsOk) {
  EXPECT_EQ(TimingsCsv({MadeRecord(), FailedRecord()}),
            "sequence,variant,seed,wall_s,cpu_s,ms_per_scan_median,ms_per_scan_p95,max_rss_mb\n"
            "street,ours,3,1.5,1.25,2,3.5,11\n");
}

TEST(RunRecord, SurvivesJson) {
  for (const RunRecord& record : {MadeRecord(), FailedRecord()}) {
    const auto read = RunRecordFromJson(RunRecordToJson(record));
    ASSERT_TRUE(read);
    EXPECT_EQ(ResultsCsv({*read}), ResultsCsv({record}));
    EXPECT_EQ(read->scores.ate_r, record.scores.ate_r);
    EXPECT_EQ(read->timing.cpu_s, 1.25);
    EXPECT_TRUE(read->HasHashesOf(record));
  }
  EXPECT_FALSE(RunRecordFromJson(nlohmann::ordered_json::object()));
  auto json = RunRecordToJson(MadeRecord());
  json["seed"] = "three";
  EXPECT_FALSE(RunRecordFromJson(json));
}

TEST(RunRecord, OrdersBySequenceVariantAndNumberOfSeed) {
  RunRecord ten = MadeRecord();
  ten.seed = 10;
  EXPECT_TRUE(MadeRecord() < ten);
  ten.variant = "icp";
  EXPECT_FALSE(MadeRecord() < ten);
}

std::vector<std::string> Query(const std::string& file, const std::string& sql) {
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  std::vector<std::string> rows;
  const auto add = [](void* out, int count, char** values, char**) {
    std::string row;
    for (int i = 0; i < count; ++i) {
      row += (i == 0 ? "" : "|") + std::string(values[i] == nullptr ? "NULL" : values[i]);
    }
    static_cast<std::vector<std::string>*>(out)->push_back(row);
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), add, &rows, nullptr), SQLITE_OK) << sql;
  sqlite3_close(database);
  return rows;
}

TEST(ResultsDatabase, HoldsBothTables) {
  const ScratchFolder scratch;
  const std::string file = (scratch.path() / "results.sqlite").string();
  std::string error;
  // Twice: the second replaces the first.
  ASSERT_TRUE(WriteResultsDatabase(file, {MadeRecord()}, &error)) << error;
  ASSERT_TRUE(WriteResultsDatabase(file, {MadeRecord(), FailedRecord()}, &error)) << error;
  EXPECT_THAT(
      Query(file, "SELECT seed, status, message, ate_t, rpe_t, scans, program_hash FROM results"),
      ::testing::ElementsAre("3|ok||0.125|NULL|40|cc", "4|failed|a \"b\", c\nd|NULL|NULL|NULL|cc"));
  EXPECT_THAT(Query(file, "SELECT seed, cpu_s, ms_per_scan_p95 FROM timings"),
              ::testing::ElementsAre("3|1.25|3.5"));
}

TEST(ResultsDatabase, SaysThatItCannotBeWritten) {
  std::string error;
  EXPECT_FALSE(WriteResultsDatabase("/nowhere/results.sqlite", {MadeRecord()}, &error));
  EXPECT_THAT(error, ::testing::HasSubstr("/nowhere/results.sqlite: cannot be written"));
}

}  // namespace
}  // namespace radive
