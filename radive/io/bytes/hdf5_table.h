// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace radive {

// Some of the columns of a table in an HDF5 file: a one-dimensional data set of records with named
// numbers. Read row by row; the file stays open.
//
// libhdf5 is known to crash on files that were damaged on purpose. Open() therefore reads the whole
// table once in a process of its own, and refuses a file on which that one dies.
class Hdf5Table {
 public:
  // Null, with file, data set and expectation in `error`, when there is no such table, a column is
  // missing or holds no numbers, or the file is damaged.
  static std::unique_ptr<Hdf5Table> Open(const std::filesystem::path& path,
                                         const std::string& data_set,
                                         const std::vector<std::string>& columns,
                                         std::string* error);
  ~Hdf5Table();

  std::uint64_t num_rows() const { return num_rows_; }

  // The columns of the rows [first, first + count), which the table must have, row by row. False
  // when they cannot be read.
  bool Read(std::uint64_t first, std::uint64_t count, std::vector<double>* values) const;

 private:
  explicit Hdf5Table(std::size_t num_columns) : num_columns_(num_columns) {}
  static std::unique_ptr<Hdf5Table> OpenHere(const std::filesystem::path& path,
                                             const std::string& data_set,
                                             const std::vector<std::string>& columns,
                                             std::string* error);

  const std::size_t num_columns_;
  std::uint64_t num_rows_ = 0;
  // Handles of libhdf5; below 0: none.
  std::int64_t file_ = -1;
  std::int64_t data_set_ = -1;
  std::int64_t record_ = -1;  // type of a row in memory: the columns as double
};

}  // namespace radive
