// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <locale>
#include <string>

#include "tests/scratch_folder.h"

namespace radive::testing {

// Makes de_DE.UTF-8 and fr_FR.UTF-8, which have a decimal comma, known to setlocale(); the C and
// the C++ locale of the process are those of before when the object goes.
class ForeignLocales {
 public:
  ForeignLocales() {
    setenv("LOCPATH", scratch_.path().c_str(), 1);
    for (const std::string name : {"de_DE", "fr_FR"}) {
      const std::string target = (scratch_.path() / (name + ".UTF-8")).string();
      const std::string command = "localedef -i " + name + " -f UTF-8 " + target + " 2>&1";
      are_there_ = are_there_ && std::system((command + " >/dev/null").c_str()) == 0 &&
                   std::setlocale(LC_ALL, (name + ".UTF-8").c_str()) != nullptr &&
                   std::localeconv()->decimal_point == std::string(",");
    }
    std::setlocale(LC_ALL, "C");
  }
  ~ForeignLocales() {
    std::locale::global(std::locale::classic());
    std::setlocale(LC_ALL, "C");
    unsetenv("LOCPATH");
  }
  ForeignLocales(const ForeignLocales&) = delete;
  ForeignLocales& operator=(const ForeignLocales&) = delete;

  // False where Debian's package `locales` is missing.
  bool are_there() const { return are_there_; }

 private:
  ScratchFolder scratch_;
  bool are_there_ = true;
};

}  // namespace radive::testing
