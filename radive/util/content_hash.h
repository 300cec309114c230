// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace radive {

// Hash of bytes, to tell whether something is still the same: XXH3, 128 bits, as 32 hexadecimal
// digits. No protection against forgery.
class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  ContentHash(const ContentHash&) = delete;
  ContentHash& operator=(const ContentHash&) = delete;

  // Adds bytes; "ab" + "c" counts as "abc".
  void Add(std::string_view bytes);

  // Adds text so that neighbours cannot run together: "ab", "c" differs from "a", "bc".
  void AddPart(std::string_view text);

  std::string Hex() const;

 private:
  struct State;
  const std::unique_ptr<State> state_;
};

std::string HashText(std::string_view text);

// Of the bytes of a file. Nothing, with the file and the reason in `error`, when it is unreadable.
std::optional<std::string> HashFile(const std::filesystem::path& file, std::string* error);

// Of a file, or of all files of a folder and of the folders in it: relative names, sizes and bytes.
// Times and the place of the folder do not count. When the files are larger than `max_bytes`
// together, each counts with its first and last 64 KiB: a change in the middle of a file that
// keeps its size then goes unseen.
std::optional<std::string> HashTree(const std::filesystem::path& path,
                                    std::string* error,
                                    std::uintmax_t max_bytes = std::uintmax_t{4} << 30);

// Of names, sizes and times of change: tells without reading whether HashTree() must be called
// again. Nothing when the path cannot be listed.
std::optional<std::string> TreeSignature(const std::filesystem::path& path);

}  // namespace radive
