// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <system_error>

#include "radive/util/c_locale.h"

namespace radive {

// What the system says of an error, in English whatever the locale: the texts get into result
// files.
inline std::string SystemMessage(const std::error_code& code) {
  const ScopedCLocale c_locale;
  return code.message();
}

// ... of an error number (errno).
inline std::string SystemMessage(int number) {
  return SystemMessage(std::error_code(number, std::generic_category()));
}

}  // namespace radive
