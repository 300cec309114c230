// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace radive {

using Json = nlohmann::ordered_json;  // keys keep the order in which they were added

// The only ways between JSON and text. Neither depends on the locale, also while another thread
// changes it: the parser of the JSON library reads numbers by strtod(). They are compiled once,
// since they are most of what that library costs to compile.

// A discarded value, Json::is_discarded(), when the text is no JSON.
Json ParseJson(std::string_view text);

// Indented by two spaces, with a newline at the end. What is not UTF-8 becomes U+FFFD.
std::string JsonText(const Json& json);

}  // namespace radive
