// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gflags/gflags.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>

#include "apps/app_main.h"
#include "radive/studies/load_study.h"
#include "radive/studies/run_study.h"

DEFINE_string(output,
              "",
              "Folder of the study: new, or of an earlier call to go on with. Required.");
DEFINE_int32(jobs, 0, "Runs at a time, each a process; 0: as many as there are cores.");
DEFINE_string(shard, "0/1", "i/n: only the runs of part i of n, from 0.");
DEFINE_bool(collect, false, "Run nothing; write the tables from the runs there are.");
DEFINE_bool(retry, true, "Run once more what failed before.");
DEFINE_string(
    keep,
    "all",
    "all | trajectories | scores: what the folders of finished runs keep: everything, the "
    "trajectories and run.json, or run.json alone (with config.yaml and log.txt).");
DEFINE_string(data_root,
              "",
              "Where relative paths of inputs begin; default: $RADIVE_DATA_ROOT, or the folder of "
              "the study file.");
DEFINE_string(truth_root,
              "",
              "Where relative paths of references begin; default: $RADIVE_TRUTH_ROOT, or as "
              "--data_root.");
DEFINE_string(program, "", "radive_odometry to run; default: the one beside this program.");
DEFINE_bool(quiet, false, "No progress and remarks on stderr; errors are still printed.");

namespace {

using radive::ExitStatus;

std::atomic<bool> stop{false};

// The first signal asks for an orderly end; the second ends the program at once.
extern "C" void HandleSignal(int signal_number) {
  stop.store(true);
  std::signal(signal_number, SIG_DFL);
}

int Fail(const std::string& error) {
  std::fprintf(stderr, "radive_batch: %s\n", error.c_str());
  return radive::Code(ExitStatus::kFailure);
}

std::string FromFlagOrEnvironment(const std::string& flag, const char* variable) {
  const char* value = std::getenv(variable);
  return !flag.empty() || value == nullptr ? flag : value;
}

bool ReadFlags(radive::StudyRequest* request, std::string* error) {
  if (FLAGS_output.empty()) *error = "--output is missing; see --help";
  if (FLAGS_jobs < 0) *error = "--jobs must be >= 0, is " + std::to_string(FLAGS_jobs);
  request->output = FLAGS_output;
  const int num_cores = static_cast<int>(std::thread::hardware_concurrency());
  request->jobs = FLAGS_jobs > 0 ? FLAGS_jobs : std::max(1, num_cores);
  request->retry = FLAGS_retry;
  request->quiet = FLAGS_quiet;
  char end = '\0';
  const int count =
      std::sscanf(FLAGS_shard.c_str(), "%9d/%9d%c", &request->shard, &request->num_shards, &end);
  if (count != 2 || request->shard < 0 || request->shard >= request->num_shards) {
    *error = "--shard must be i/n with 0 <= i < n, is " + FLAGS_shard;
  }
  if (FLAGS_keep == "trajectories") {
    request->kept = radive::KeptFiles::kTrajectories;
  } else if (FLAGS_keep == "scores") {
    request->kept = radive::KeptFiles::kScores;
  } else if (FLAGS_keep != "all") {
    *error = "--keep must be one of all | trajectories | scores, is " + FLAGS_keep;
  }
  std::error_code code;
  request->program = FLAGS_program;
  if (FLAGS_program.empty()) {
    request->program =
        std::filesystem::read_symlink("/proc/self/exe", code).parent_path() / "radive_odometry";
  }
  if (error->empty() && !std::filesystem::is_regular_file(request->program, code)) {
    *error = request->program.string() + ": no such program; see --program";
  }
  return error->empty();
}

}  // namespace

int main(int argc, char** argv) {
  radive::InitApp(&argc,
                  &argv,
                  "Runs a study: every sequence with every variant and seed, each run a process.\n"
                  "  radive_batch STUDY.yaml --output=FOLDER --jobs=2\n\n"
                  "Goes on where an earlier call ended. docs/studies.md says what a study is and\n"
                  "what the folder holds. Exit status 2: some runs failed.",
                  /*max_arguments=*/1);
  std::string error;
  if (argc < 2) return Fail("the study file is missing; see --help");
  radive::StudyRequest request;
  if (!ReadFlags(&request, &error)) return Fail(error);
  radive::StudyRoots roots;
  roots.data = FromFlagOrEnvironment(FLAGS_data_root, "RADIVE_DATA_ROOT");
  roots.truth = FromFlagOrEnvironment(FLAGS_truth_root, "RADIVE_TRUTH_ROOT");
  const auto study = radive::LoadStudy(argv[1], roots, &error);
  if (!study) return Fail(error);

  std::signal(SIGINT, HandleSignal);
  std::signal(SIGTERM, HandleSignal);
  request.stop = &stop;
  const radive::StudyStatus status = FLAGS_collect ? radive::CollectStudy(*study, request, &error)
                                                   : radive::RunStudy(*study, request, &error);
  switch (status) {
    case radive::StudyStatus::kDone:
      return radive::EndApp(ExitStatus::kSuccess);
    case radive::StudyStatus::kSomeFailed:
      return radive::EndApp(ExitStatus::kNoResult);
    case radive::StudyStatus::kInterrupted:
      std::fprintf(stderr, "radive_batch: interrupted; the same command goes on from here\n");
      return radive::EndApp(ExitStatus::kInterrupted);
    case radive::StudyStatus::kFailed:
      return Fail(error);
  }
  return radive::EndApp(ExitStatus::kFailure);
}
