// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/results_database.h"

#include <sqlite3.h>

#include <memory>
#include <optional>
#include <system_error>

#include "radive/io/bytes/whole_file.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

struct Close {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

// A database that remembers whether anything went wrong.
class Writer {
 public:
  explicit Writer(const fs::path& file) {
    sqlite3* raw = nullptr;
    is_ok_ = sqlite3_open(file.c_str(), &raw) == SQLITE_OK;
    database_.reset(raw);
    // The file gets its name when it is complete, so a journal has nothing to protect.
    Run("PRAGMA journal_mode = OFF");
    Run("PRAGMA synchronous = OFF");
    Run("BEGIN");
  }

  void Run(const char* sql) {
    is_ok_ = is_ok_ && sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr) == SQLITE_OK;
  }

  void Prepare(const char* sql) {
    sqlite3_stmt* raw = nullptr;
    is_ok_ = is_ok_ && sqlite3_prepare_v2(database_.get(), sql, -1, &raw, nullptr) == SQLITE_OK;
    statement_.reset(raw);
    column_ = 0;
  }

  Writer& operator<<(const std::string& text) {
    if (is_ok_) {
      sqlite3_bind_text(statement_.get(), ++column_, text.c_str(), -1, SQLITE_TRANSIENT);
    }
    return *this;
  }
  Writer& operator<<(double value) {
    if (is_ok_) sqlite3_bind_double(statement_.get(), ++column_, value);
    return *this;
  }
  Writer& operator<<(int value) {
    if (is_ok_) sqlite3_bind_int(statement_.get(), ++column_, value);
    return *this;
  }
  template <typename Value>
  Writer& operator<<(const std::optional<Value>& value) {
    if (value) return *this << *value;
    if (is_ok_) sqlite3_bind_null(statement_.get(), ++column_);
    return *this;
  }

  void EndRow() {
    is_ok_ = is_ok_ && sqlite3_step(statement_.get()) == SQLITE_DONE;
    if (is_ok_) sqlite3_reset(statement_.get());
    column_ = 0;
  }

  // Empty when all went well.
  std::string Finish() {
    Run("COMMIT");
    return is_ok_ ? "" : sqlite3_errmsg(database_.get());
  }

 private:
  std::unique_ptr<sqlite3, Close> database_;
  std::unique_ptr<sqlite3_stmt, Close> statement_;
  bool is_ok_ = false;
  int column_ = 0;
};

void WriteResults(const std::vector<RunRecord>& records, Writer* writer) {
  writer->Run(
      "CREATE TABLE results(sequence TEXT NOT NULL, variant TEXT NOT NULL, seed INTEGER NOT NULL, "
      "status TEXT NOT NULL, message TEXT NOT NULL, ate_t REAL, ate_r REAL, rpe_t REAL, "
      "rpe_r REAL, drift_t REAL, drift_r REAL, scans INTEGER, registered INTEGER, "
      "path_length REAL, input_hash TEXT NOT NULL, config_hash TEXT NOT NULL, "
      "program_hash TEXT NOT NULL, PRIMARY KEY (sequence, variant, seed))");
  writer->Prepare("INSERT INTO results VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  for (const RunRecord& record : records) {
    *writer << record.sequence << record.variant << record.seed << record.status << record.message
            << record.scores.ate_t << record.scores.ate_r << record.scores.rpe_t
            << record.scores.rpe_r << record.scores.drift_t << record.scores.drift_r << record.scans
            << record.registered << record.scores.path_length << record.input_hash
            << record.config_hash << record.program_hash;
    writer->EndRow();
  }
}

void WriteTimings(const std::vector<RunRecord>& records, Writer* writer) {
  writer->Run(
      "CREATE TABLE timings(sequence TEXT NOT NULL, variant TEXT NOT NULL, seed INTEGER NOT NULL, "
      "wall_s REAL, cpu_s REAL, ms_per_scan_median REAL, ms_per_scan_p95 REAL, max_rss_mb REAL, "
      "PRIMARY KEY (sequence, variant, seed))");
  writer->Prepare("INSERT INTO timings VALUES (?,?,?,?,?,?,?,?)");
  for (const RunRecord& record : records) {
    if (record.status != "ok") continue;
    const RunTiming& timing = record.timing;
    *writer << record.sequence << record.variant << record.seed << timing.wall_s << timing.cpu_s
            << timing.ms_per_scan_median << timing.ms_per_scan_p95 << timing.max_rss_mb;
    writer->EndRow();
  }
}

}  // namespace

bool WriteResultsDatabase(const fs::path& file,
                          const std::vector<RunRecord>& records,
                          std::string* error) {
  const fs::path partial = file.string() + ".partial";
  std::error_code code;
  fs::remove(partial, code);
  std::string reason;
  {
    Writer writer(partial);
    WriteResults(records, &writer);
    WriteTimings(records, &writer);
    reason = writer.Finish();
  }
  if (reason.empty()) return RenameDurably(partial, file, error);
  *error = file.string() + ": cannot be written: " + reason;
  fs::remove(partial, code);
  return false;
}

}  // namespace radive
