// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/number_text.h"

#include <algorithm>
#include <charconv>
#include <cstdarg>
#include <cstddef>
#include <cstdio>

#include "radive/util/c_locale.h"

namespace radive {

std::string FormatText(const char* form, ...) {
  const ScopedCLocale c_locale;
  char text[256];
  std::va_list values;
  va_start(values, form);
  const auto size =
      static_cast<std::size_t>(std::max(0, std::vsnprintf(text, sizeof(text), form, values)));
  va_end(values);
  if (size < sizeof(text)) return std::string(text, size);
  std::string long_text(size, '\0');
  va_start(values, form);
  std::vsnprintf(long_text.data(), size + 1, form, values);
  va_end(values);
  return long_text;
}

std::string ShortText(double value) {
  char text[32];
  const std::to_chars_result end =
      std::to_chars(text, text + sizeof(text), value, std::chars_format::general, 9);
  return {text, end.ptr};
}

}  // namespace radive
