// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gflags/gflags.h>
#include <glog/logging.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "radive/util/exit_status.h"

// Start of every program: logging, flags, --help and --version.
//
//   DEFINE_string(input, "", "Dataset folder or scan folder. Required.");
//
//   int main(int argc, char** argv) {
//     radive::InitApp(&argc, &argv, "Radar odometry over one sequence.\n  radive_odometry ...");
//
// --help prints the usage and the flags defined in the program's own file (gflags would print
// those of glog too) and exits with 0; so does --version. A flag that does not exist, a value of
// the wrong type and an argument beyond `max_arguments` end the program with an error message
// and ExitStatus::kFailure.

namespace radive {
namespace app_internal {

// Prints `text` word by word from column `indent` on, in lines of at most 96 characters.
inline void PrintWrapped(const std::string& text, size_t indent) {
  std::istringstream words(text);
  size_t column = 0;
  for (std::string word; words >> word; column += word.size()) {
    if (column > 0 && column + 1 + word.size() > 96) {
      std::printf("\n");
      column = 0;
    }
    if (column == 0) {
      std::printf("%*s%s", static_cast<int>(indent), "", word.c_str());
      column = indent;
    } else {
      std::printf(" %s", word.c_str());
      ++column;
    }
  }
  std::printf("\n");
}

inline void PrintHelp(const std::string& usage, const std::string& app_file) {
  std::printf("%s\n\nFlags:\n", usage.c_str());
  std::vector<gflags::CommandLineFlagInfo> flags;
  gflags::GetAllFlags(&flags);
  for (const gflags::CommandLineFlagInfo& flag : flags) {
    if (flag.filename != app_file) continue;
    const std::string shown_default =
        flag.default_value.empty() ? "" : ", default " + flag.default_value;
    std::printf("  --%s  (%s%s)\n", flag.name.c_str(), flag.type.c_str(), shown_default.c_str());
    PrintWrapped(flag.description, 6);
  }
  std::printf("  --version\n  --help\n");
}

inline bool IsFlagSet(const char* name) {
  std::string value;
  return gflags::GetCommandLineOption(name, &value) && value == "true";
}

// All values of --set, with commas between them: of a flag that is given twice gflags would take
// the last value alone.
inline std::string JoinedSettings(int argc, char** argv) {
  std::string joined;
  for (int i = 1; i < argc; ++i) {
    std::string flag = argv[i];
    if (flag == "--") break;
    flag.erase(0, std::min(flag.find_first_not_of('-'), std::size_t{2}));
    const bool is_apart = flag == "set" && argv[i][0] == '-' && i + 1 < argc;
    if (!is_apart && (flag.compare(0, 4, "set=") != 0 || argv[i][0] != '-')) continue;
    joined += (joined.empty() ? "" : ",") + (is_apart ? std::string(argv[++i]) : flag.substr(4));
  }
  return joined;
}

}  // namespace app_internal

// What main() returns after it has printed: `status`, or ExitStatus::kFailure with a message when
// the standard output did not take everything (a full disk).
inline int EndApp(ExitStatus status) {
  errno = 0;
  const bool is_flushed = std::fflush(stdout) == 0;
  const int reason = errno;
  if (is_flushed && std::ferror(stdout) == 0) return Code(status);
  std::fprintf(stderr,
               "%s: standard output: cannot be written%s%s\n",
               gflags::ProgramInvocationShortName(),
               is_flushed ? "" : ": ",
               is_flushed ? "" : std::strerror(reason));
  return Code(status == ExitStatus::kSuccess ? ExitStatus::kFailure : status);
}

// `app_file` is the file that defines the program's flags: leave it at its default and call this
// from that file.
inline void InitApp(int* argc,
                    char*** argv,
                    const std::string& usage,
                    int max_arguments = 0,
                    const char* app_file = __builtin_FILE()) {
  std::setlocale(LC_ALL, "C");  // a library that is loaded too may have set another
  FLAGS_logtostderr = true;
  google::InitGoogleLogging((*argv)[0]);
  const std::string path = (*argv)[0];
  const std::string program = path.substr(path.find_last_of('/') + 1);
  gflags::SetUsageMessage(usage);
  gflags::SetVersionString(RADIVE_VERSION);
  const std::string settings = app_internal::JoinedSettings(*argc, *argv);
  gflags::ParseCommandLineNonHelpFlags(argc, argv, /*remove_flags=*/true);

  if (app_internal::IsFlagSet("help") || app_internal::IsFlagSet("helpshort") ||
      app_internal::IsFlagSet("helpfull")) {
    app_internal::PrintHelp(usage, app_file);
    std::exit(EndApp(ExitStatus::kSuccess));
  }
  if (app_internal::IsFlagSet("version")) {
    std::printf("%s %s\n", program.c_str(), RADIVE_VERSION);
    std::exit(EndApp(ExitStatus::kSuccess));
  }
  if (!settings.empty()) gflags::SetCommandLineOption("set", settings.c_str());
  if (*argc > 1 + max_arguments) {
    std::fprintf(stderr,
                 "%s: unexpected argument '%s' (inputs are --flags; see --help)\n",
                 program.c_str(),
                 (*argv)[1 + max_arguments]);
    std::exit(Code(ExitStatus::kFailure));
  }
}

}  // namespace radive
