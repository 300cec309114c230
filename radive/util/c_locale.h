// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <locale.h>

namespace radive {

// While one lives, the C functions that this thread calls see the "C" locale, whatever the program
// that uses the library has set with setlocale(), and whatever its other threads set meanwhile.
class ScopedCLocale {
 public:
  ScopedCLocale() : previous_(uselocale(Classic())) {}
  ~ScopedCLocale() { uselocale(previous_); }
  ScopedCLocale(const ScopedCLocale&) = delete;
  ScopedCLocale& operator=(const ScopedCLocale&) = delete;

 private:
  static locale_t Classic() {
    static const locale_t classic = newlocale(LC_ALL_MASK, "C", nullptr);
    return classic;
  }

  const locale_t previous_;
};

}  // namespace radive
