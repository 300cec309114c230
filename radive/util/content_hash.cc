// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/content_hash.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <vector>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "radive/util/number_text.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kEnd = 64 << 10;  // what counts of either end of a file in a huge tree

struct TreeFile {
  fs::path path;
  std::string name;  // relative to the tree
  std::uintmax_t size = 0;
};

// All files of the tree by name; links are followed.
std::optional<std::vector<TreeFile>> ListTree(const fs::path& path, std::string* error) {
  std::vector<TreeFile> files;
  std::error_code code;
  const auto add = [&](const fs::path& file, const std::string& name) {
    const std::uintmax_t size = fs::file_size(file, code);
    if (!code) files.push_back({file, name, size});
  };
  if (fs::is_regular_file(path, code)) {
    add(path, path.filename().string());
  } else if (!code) {
    const auto follow = fs::directory_options::follow_directory_symlink;
    fs::recursive_directory_iterator entry(path, follow, code);
    for (; !code && entry != fs::recursive_directory_iterator(); entry.increment(code)) {
      std::error_code dangling;  // a link to nowhere is no file
      if (entry->is_regular_file(dangling)) {
        add(entry->path(), entry->path().lexically_relative(path).string());
      }
      if (code) break;
    }
  }
  if (code) {
    *error = path.string() + ": cannot be read: " + SystemMessage(code);
    return std::nullopt;
  }
  std::sort(files.begin(), files.end(), [](const TreeFile& a, const TreeFile& b) {
    return a.name < b.name;
  });
  return files;
}

// Adds up to `count` bytes of the file from `offset` on.
bool AddBytes(const fs::path& path,
              std::uintmax_t offset,
              std::uintmax_t count,
              ContentHash* hash,
              std::string* error) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  std::vector<char> buffer(1 << 18);
  bool ok = file != nullptr && fseeko(file.get(), static_cast<off_t>(offset), SEEK_SET) == 0;
  while (ok && count > 0) {
    const std::size_t wanted = std::min<std::uintmax_t>(count, buffer.size());
    const std::size_t got = std::fread(buffer.data(), 1, wanted, file.get());
    hash->Add({buffer.data(), got});
    count -= got;
    if (got < wanted) {
      ok = std::ferror(file.get()) == 0;
      break;
    }
  }
  if (!ok) *error = path.string() + ": cannot be read: " + SystemMessage(errno);
  return ok;
}

}  // namespace

struct ContentHash::State {
  XXH3_state_t xxh;
};

ContentHash::ContentHash() : state_(std::make_unique<State>()) { XXH3_128bits_reset(&state_->xxh); }
ContentHash::~ContentHash() = default;

void ContentHash::Add(std::string_view bytes) {
  XXH3_128bits_update(&state_->xxh, bytes.data(), bytes.size());
}

void ContentHash::AddPart(std::string_view text) {
  Add(std::to_string(text.size()) + ":");
  Add(text);
}

std::string ContentHash::Hex() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(&state_->xxh);
  return FormatText("%016llx%016llx",
                    static_cast<unsigned long long>(hash.high64),
                    static_cast<unsigned long long>(hash.low64));
}

std::string HashText(std::string_view text) {
  ContentHash hash;
  hash.Add(text);
  return hash.Hex();
}

std::optional<std::string> HashFile(const fs::path& file, std::string* error) {
  ContentHash hash;
  if (!AddBytes(file, 0, static_cast<std::uintmax_t>(-1), &hash, error)) return std::nullopt;
  return hash.Hex();
}

std::optional<std::string> HashTree(const fs::path& path,
                                    std::string* error,
                                    std::uintmax_t max_bytes) {
  const auto files = ListTree(path, error);
  if (!files) return std::nullopt;
  std::uintmax_t total = 0;
  for (const TreeFile& file : *files) total += file.size;
  const bool is_huge = total > max_bytes;
  ContentHash hash;
  for (const TreeFile& file : *files) {
    hash.AddPart(file.name);
    hash.AddPart(std::to_string(file.size));
    const bool has_middle = is_huge && file.size > 2 * kEnd;
    if (!AddBytes(file.path, 0, has_middle ? kEnd : file.size, &hash, error)) return std::nullopt;
    if (has_middle && !AddBytes(file.path, file.size - kEnd, kEnd, &hash, error)) {
      return std::nullopt;
    }
  }
  return hash.Hex();
}

std::optional<std::string> TreeSignature(const fs::path& path) {
  std::string ignored;
  const auto files = ListTree(path, &ignored);
  if (!files) return std::nullopt;
  ContentHash hash;
  for (const TreeFile& file : *files) {
    struct stat status {};
    if (stat(file.path.c_str(), &status) != 0) return std::nullopt;
    hash.AddPart(file.name);
    hash.AddPart(std::to_string(file.size));
    hash.AddPart(std::to_string(status.st_mtim.tv_sec));
    hash.AddPart(std::to_string(status.st_mtim.tv_nsec));
  }
  return hash.Hex();
}

}  // namespace radive
