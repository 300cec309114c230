// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/run_study.h"

#include <unistd.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "radive/studies/judge_run.h"
#include "radive/studies/program_hash.h"
#include "radive/studies/result_tables.h"
#include "radive/studies/run_archive.h"
#include "radive/studies/study_input.h"
#include "radive/studies/study_runs.h"
#include "radive/util/child_process.h"
#include "radive/util/file_lock.h"
#include "radive/util/progress.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr unsigned kPollInterval = 2000;  // between two looks at the children [us]
constexpr double kRetryInterval = 0.1;    // before what another process holds is tried again [s]

// An input that several runs share.
struct SharedInput {
  explicit SharedInput(StudyInput study_input) : input(std::move(study_input)) {}

  StudyInput input;
  bool is_being_prepared = false;
  double next_try = 0.0;            // [s]
  std::optional<std::string> hash;  // once it is ready
  std::string failure;              // why it never will be
};

// A child at work: on a run, or on an input when `run` is null.
struct Job {
  std::unique_ptr<ChildProcess> child;
  FileLock lock;
  const StudyRun* run = nullptr;
  SharedInput* input = nullptr;
  RunRecord record;  // of the run, with names and hashes
};

class StudyRunner {
 public:
  StudyRunner(const Study& study, const StudyRequest& request) : study_(study), request_(request) {}

  StudyStatus Run(std::string* error) {
    const auto all = ListRuns(study_, error);
    if (!all) return StudyStatus::kFailed;
    const auto program_hash = ProgramHash(request_.program, error);
    const auto own_hash = program_hash ? ProgramHash("/proc/self/exe", error) : std::nullopt;
    if (!own_hash || !MakeStudyFolder(study_, request_.output, error)) return StudyStatus::kFailed;
    archive_ = std::make_unique<RunArchive>(
        RunArchive::Options{request_.output, *program_hash, request_.kept, request_.retry});
    simulator_hash_ = *own_hash;
    const std::vector<StudyRun> runs = Shard(*all, request_.shard, request_.num_shards);
    Start(runs);
    const bool interrupted = !Work();
    jobs_.clear();  // kills what is still running
    progress_->Finish();
    std::string table_error;
    const bool tables =
        WriteTables(study_, *all, request_.output, archive_->unsaved(), &table_error);
    if (!tables) Tell(table_error);
    Tell(Summary());
    if (interrupted) return StudyStatus::kInterrupted;
    return tables && num_failed_ == 0 ? StudyStatus::kDone : StudyStatus::kSomeFailed;
  }

 private:
  // Sorts out what is complete already, so that the progress shows what is to be done.
  void Start(const std::vector<StudyRun>& runs) {
    for (const StudyRun& run : runs) {
      SharedInput* const input = InputOf(run);
      const std::string config_hash = ConfigHash(study_, run);
      RunRecord record = NewRecord(run, *input, config_hash);
      if (IsComplete(run, *input, &record)) {
        Count(record);
        ++num_before_;
      } else {
        pending_.push_back({&run, input, config_hash, 0.0});
      }
    }
    const auto mode = request_.quiet ? Progress::Mode::kQuiet : Progress::ModeFor(stderr);
    progress_ = std::make_unique<Progress>(stderr, mode, static_cast<int>(pending_.size()), "runs");
    if (num_before_ > 0) {
      Tell(std::to_string(num_before_) + " of " + std::to_string(runs.size()) +
           " runs are complete and unchanged");
    }
  }

  SharedInput* InputOf(const StudyRun& run) {
    StudyInput input(request_.output, run, simulator_hash_);
    std::unique_ptr<SharedInput>& shared = inputs_[input.name()];
    if (shared == nullptr) {
      shared = std::make_unique<SharedInput>(std::move(input));
      if (!shared->input.IsAbsent()) shared->hash = shared->input.KnownHash();
    }
    return shared.get();
  }

  // False when stopped.
  bool Work() {
    const std::size_t num_to_do = pending_.size();
    while (!pending_.empty() || !jobs_.empty()) {
      if (request_.stop != nullptr && request_.stop->load()) return false;
      const bool has_ended = EndJobs();
      const bool has_started = StartJobs();
      std::size_t num_running = 0;
      for (const Job& job : jobs_) num_running += job.run != nullptr ? 1 : 0;
      progress_->Update(static_cast<int>(num_to_do - pending_.size() - num_running));
      if (!has_ended && !has_started) usleep(kPollInterval);
    }
    return true;
  }

  bool StartJobs() {
    bool moved = false;
    for (std::size_t i = 0; i < pending_.size() && HasRoom();) {
      const bool must_wait = Now() < pending_[i].next_try || pending_[i].input->is_being_prepared;
      if (must_wait || !TryStart(&pending_[i])) {
        ++i;
        continue;
      }
      pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
      moved = true;
    }
    return moved;
  }

  bool HasRoom() const { return static_cast<int>(jobs_.size()) < request_.jobs; }
  double Now() const { return stopwatch_.Milliseconds() / 1000.0; }

  struct Pending {
    const StudyRun* run;
    SharedInput* input;
    std::string config_hash;
    double next_try;  // [s]
  };

  // True when the run needs no more attention here: its process is running, or it is over.
  bool TryStart(Pending* pending) {
    const StudyRun& run = *pending->run;
    SharedInput* const input = pending->input;
    if (input->input.IsAbsent()) {
      Report(AbsentRecord(study_, run));
      return true;
    }
    if (!PrepareInput(input)) return false;
    RunRecord record = NewRecord(run, *input, pending->config_hash);
    const RunFolder folder(request_.output, run);
    std::string error;
    std::optional<FileLock> lock;
    if (folder.MakeParent(&error)) {
      lock = FileLock::Take(folder.LockFile(), FileLock::Wait::kNo, &error);
    }
    if (!lock && error.empty()) {  // another process is at it
      pending->next_try = Now() + kRetryInterval;
      return false;
    }
    if (lock && IsComplete(run, *input, &record)) {  // another process has done it
      Count(record);
      return true;
    }
    if (lock && input->failure.empty() && folder.Begin(run, &error)) {
      auto child = ChildProcess::Start(Command(run, input->input, folder), lock->fd(), &error);
      if (child != nullptr) {
        jobs_.push_back({std::move(child), *std::move(lock), &run, input, std::move(record)});
        return true;
      }
    }
    record.status = "failed";
    record.message = input->failure.empty() ? error : input->failure;
    if (lock) {
      archive_->Save(run, input->input.reference(), {}, record.message + "\n", &record);
    } else {
      archive_->KeepUnsaved(record);
    }
    Report(record);
    return true;
  }

  // True when it is known what to think of the input.
  bool PrepareInput(SharedInput* input) {
    if (input->hash || !input->failure.empty()) return true;
    if (input->is_being_prepared || Now() < input->next_try) return false;
    input->next_try = Now() + kRetryInterval;
    std::string error;
    std::optional<FileLock> lock;
    if (input->input.MakeFolders(&error)) {
      lock = FileLock::Take(input->input.LockFile(), FileLock::Wait::kNo, &error);
    }
    std::unique_ptr<ChildProcess> child;
    if (lock) {
      input->hash = input->input.KnownHash();
      if (input->hash) return true;
      const StudyInput& work = input->input;
      child = ChildProcess::Start(
          [&work](std::string* reason) { return work.Prepare(reason); }, lock->fd(), &error);
    }
    if (child != nullptr) {
      input->is_being_prepared = true;
      jobs_.push_back({std::move(child), *std::move(lock), nullptr, input, {}});
      return false;
    }
    input->failure = error;  // empty when another process is at it
    return !error.empty();
  }

  bool EndJobs() {
    bool moved = false;
    for (std::size_t i = 0; i < jobs_.size();) {
      Job& job = jobs_[i];
      const bool timed_out = study_.timeout > 0.0 && job.run != nullptr && !job.child->HasEnded() &&
                             job.child->Seconds() > study_.timeout;
      if (timed_out) {
        job.child->Kill();
        while (!job.child->HasEnded()) usleep(kPollInterval);
      }
      if (!job.child->HasEnded()) {
        ++i;
        continue;
      }
      job.run != nullptr ? EndRun(&job, timed_out) : EndInput(job);
      jobs_.erase(jobs_.begin() + static_cast<std::ptrdiff_t>(i));
      moved = true;
    }
    return moved;
  }

  void EndInput(const Job& job) {
    SharedInput* const input = job.input;
    input->is_being_prepared = false;
    if (job.child->exit_status() == 0) {
      input->hash = input->input.KnownHash();
      if (!input->hash) input->failure = input->input.folder().string() + ": keeps changing";
      return;
    }
    input->failure = job.child->Output();
    while (!input->failure.empty() && input->failure.back() == '\n') input->failure.pop_back();
    if (input->failure.empty()) {
      input->failure = input->input.folder().string() + ": cannot be prepared: signal " +
                       std::to_string(job.child->signal());
    }
  }

  void EndRun(Job* job, bool timed_out) {
    const RunFolder folder(request_.output, *job->run);
    RunEnd end;
    end.exit_status = job->child->exit_status();
    end.signal = job->child->signal();
    end.timed_out = timed_out;
    end.output = job->child->Output();
    end.wall_s = job->child->Seconds();
    end.cpu_s = job->child->cpu_seconds();
    end.max_rss_mb = job->child->peak_memory_mb();
    RecordedTrajectory reference;
    JudgeRun(study_,
             *job->run,
             end,
             folder.partial(),
             job->input->input.reference(),
             &reference,
             &job->record);
    if (job->input->input.KnownHash() != job->record.input_hash) {
      job->input->hash.reset();  // is prepared anew for the runs to come
      if (job->record.status == "ok") {
        job->record.status = "failed";
        job->record.message = job->input->input.folder().string() + ": changed while it was read";
        job->record.scores = RunScores();
      }
    }
    archive_->Save(*job->run, job->input->input.reference(), reference, end.output, &job->record);
    Report(job->record);
  }

  std::vector<std::string> Command(const StudyRun& run,
                                   const StudyInput& input,
                                   const RunFolder& folder) const {
    return {request_.program.string(),
            "--input=" + input.folder().string(),
            "--config=" + (folder.partial() / "config.yaml").string(),
            "--output=" + folder.partial().string(),
            "--start=" + std::to_string(run.start),
            "--frames=" + std::to_string(run.frames > 0 ? run.frames : -1),
            "--threads=" + std::to_string(study_.threads),
            "--quiet"};
  }

  RunRecord NewRecord(const StudyRun& run,
                      const SharedInput& input,
                      const std::string& config_hash) const {
    return archive_->NewRecord(run, input.hash.value_or(""), config_hash);
  }

  bool IsComplete(const StudyRun& run, const SharedInput& input, RunRecord* record) const {
    if (input.hash) return archive_->IsComplete(run, record);
    return input.input.IsAbsent() && archive_->IsCompleteWithoutInput(run, record);
  }

  void Count(const RunRecord& record) {
    ++counts_[record.status];
    const bool is_fine = record.status == "ok" ||
                         (record.status == "absent" && study_.absent == Study::Absent::kMark);
    if (!is_fine) ++num_failed_;
  }

  void Report(const RunRecord& record) {
    Count(record);
    if (record.status == "ok") return;
    Tell(record.sequence + "/" + record.variant + "/" + std::to_string(record.seed) + ": " +
         record.status + (record.message.empty() ? "" : ": " + record.message));
  }

  void Tell(const std::string& message) { progress_->Message(message); }

  std::string Summary() const {
    std::string text;
    for (const auto& [status, count] : counts_) {
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + status;
    }
    return "runs: " + (text.empty() ? "none" : text) + "; tables in " + request_.output.string();
  }

  const Study& study_;
  const StudyRequest& request_;
  const Stopwatch stopwatch_;
  std::string simulator_hash_;
  std::unique_ptr<RunArchive> archive_;
  std::map<std::string, std::unique_ptr<SharedInput>> inputs_;
  std::vector<Pending> pending_;
  std::vector<Job> jobs_;
  std::map<std::string, int> counts_;  // runs by status
  int num_before_ = 0;
  int num_failed_ = 0;
  std::unique_ptr<Progress> progress_;
};

}  // namespace

StudyStatus RunStudy(const Study& study, const StudyRequest& request, std::string* error) {
  return StudyRunner(study, request).Run(error);
}

StudyStatus CollectStudy(const Study& study, const StudyRequest& request, std::string* error) {
  const auto runs = ListRuns(study, error);
  if (!runs || !MakeStudyFolder(study, request.output, error)) return StudyStatus::kFailed;
  TableCounts counts;
  if (!WriteTables(study, *runs, request.output, {}, error, &counts)) return StudyStatus::kFailed;
  if (!request.quiet) {
    std::fprintf(stderr,
                 "%d of %d runs, %d of them neither ok nor absent; tables in %s\n",
                 counts.found,
                 counts.all,
                 counts.failed,
                 request.output.c_str());
  }
  const bool complete = counts.found == counts.all && counts.failed == 0;
  return complete ? StudyStatus::kDone : StudyStatus::kSomeFailed;
}

}  // namespace radive
