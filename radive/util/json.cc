// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/json.h"

#include "radive/util/c_locale.h"

namespace radive {

Json ParseJson(std::string_view text) {
  const ScopedCLocale c_locale;
  return Json::parse(text.begin(), text.end(), nullptr, /*allow_exceptions=*/false);
}

std::string JsonText(const Json& json) {
  const ScopedCLocale c_locale;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace radive
