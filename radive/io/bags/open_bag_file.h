// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/bags/message_source.h"

namespace radive {

enum class BagFormat {
  kRosbag1,  // a .bag file, or a folder of them: a split bag
  kRosbag2,  // a folder with metadata.yaml, a .db3 or .mcap file, or a folder of them
  kMcap      // an .mcap file, or a folder of them: a split recording
};

// The form of a bag by the name of its file: *.bag, and *.bag.active as long as its recorder has
// not closed it; *.db3 and *.mcap, also packed (.db3.zstd, .mcap.zst). Case does not matter.
// Nothing for other names.
std::optional<BagFormat> BagFormatOfName(std::string_view name);

// Files of one of these forms in `folder`, in the order of their names. Nothing twice: a packed
// file is left out where it lies unpacked beside, a .bag.active where the closed bag does. False,
// with the reason in `error`, when the folder cannot be listed.
bool ListBagFiles(const std::filesystem::path& folder,
                  BagFormat format,
                  std::vector<std::filesystem::path>* files,
                  std::string* error);

// Opens one file of a bag by its first bytes, whatever it is called. Packed ones are unpacked into
// a temporary file. Null, with the file and the reason in `error`, when that fails.
std::unique_ptr<MessageSource> OpenBagFile(const std::filesystem::path& path,
                                           const MessageLimits& limits,
                                           std::string* error);

}  // namespace radive
