// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/hdf5_table.h"

#include <glog/logging.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <functional>
#include <system_error>

#include "radive/io/bytes/record_file.h"

namespace radive {
namespace {

constexpr std::uint64_t kRowsAtOnce = 65536;
constexpr unsigned kLongestRead = 120;  // of a whole file [s]

// No messages of its own, and no code that a file names.
void QuietenLibrary() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);
}

// What `run` returns in a process of its own; false when that one dies or takes too long.
bool RunsInAChild(const std::function<bool()>& run) {
  const pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) {
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGALRM}) {
      std::signal(number, SIG_DFL);
    }
    const rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    alarm(kLongestRead);
    _exit(run() ? 0 : 1);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// Links and data sets may point to other files; these do not count.
bool IsStoredHere(hid_t file, const std::string& name) {
  H5L_info_t link;
  return H5Lget_info(file, name.c_str(), &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD;
}

bool IsPlainLayout(hid_t data_set) {
  const hid_t properties = H5Dget_create_plist(data_set);
  if (properties < 0) return false;
  const H5D_layout_t layout = H5Pget_layout(properties);
  const bool is_plain =
      (layout == H5D_CONTIGUOUS || layout == H5D_CHUNKED || layout == H5D_COMPACT) &&
      H5Pget_external_count(properties) == 0;
  H5Pclose(properties);
  return is_plain;
}

// Number of rows of a table; below 0: it is none.
std::int64_t CountRows(hid_t data_set) {
  const hid_t space = H5Dget_space(data_set);
  if (space < 0) return -1;
  const bool is_row = H5Sget_simple_extent_ndims(space) == 1;
  const std::int64_t count = is_row ? H5Sget_simple_extent_npoints(space) : -1;
  H5Sclose(space);
  return count;
}

// Whether the records have the column, as a number.
bool HasNumber(hid_t data_set, const std::string& column) {
  const hid_t type = H5Dget_type(data_set);
  if (type < 0) return false;
  bool has_number = false;
  const int index =
      H5Tget_class(type) == H5T_COMPOUND ? H5Tget_member_index(type, column.c_str()) : -1;
  if (index >= 0) {
    const H5T_class_t kind = H5Tget_member_class(type, static_cast<unsigned>(index));
    has_number = kind == H5T_INTEGER || kind == H5T_FLOAT;
  }
  H5Tclose(type);
  return has_number;
}

}  // namespace

std::unique_ptr<Hdf5Table> Hdf5Table::OpenHere(const std::filesystem::path& path,
                                               const std::string& data_set,
                                               const std::vector<std::string>& columns,
                                               std::string* error) {
  QuietenLibrary();
  std::unique_ptr<Hdf5Table> table(new Hdf5Table(columns.size()));
  table->file_ = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (table->file_ < 0) {
    *error = path.string() + ": cannot be opened as an HDF5 file";
    return nullptr;
  }
  const std::string where = path.string() + ": data set " + data_set + ": ";
  if (IsStoredHere(table->file_, data_set)) {
    table->data_set_ = H5Dopen2(table->file_, data_set.c_str(), H5P_DEFAULT);
  }
  const std::int64_t num_rows =
      table->data_set_ >= 0 && IsPlainLayout(table->data_set_) ? CountRows(table->data_set_) : -1;
  if (num_rows < 0) {
    *error = where + "expected a table in this file";
    return nullptr;
  }
  table->num_rows_ = static_cast<std::uint64_t>(num_rows);
  table->record_ = H5Tcreate(H5T_COMPOUND, columns.size() * sizeof(double));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!HasNumber(table->data_set_, columns[i]) ||
        H5Tinsert(table->record_, columns[i].c_str(), i * sizeof(double), H5T_NATIVE_DOUBLE) < 0) {
      *error = where + "expected a column of numbers called " + columns[i];
      return nullptr;
    }
  }
  return table;
}

std::unique_ptr<Hdf5Table> Hdf5Table::Open(const std::filesystem::path& path,
                                           const std::string& data_set,
                                           const std::vector<std::string>& columns,
                                           std::string* error) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure)) {
    *error = path.string() + ": cannot be opened, expected an HDF5 file";
    return nullptr;
  }
  if (IsLfsPointer(path, error)) return nullptr;
  const auto open_and_read = [&] {
    std::string ignored;
    const auto table = OpenHere(path, data_set, columns, &ignored);
    if (table == nullptr) return true;  // what is wrong is said below
    std::vector<double> values;
    for (std::uint64_t row = 0; row < table->num_rows(); row += kRowsAtOnce) {
      if (!table->Read(row, std::min(kRowsAtOnce, table->num_rows() - row), &values)) return false;
    }
    return true;
  };
  if (!RunsInAChild(open_and_read)) {
    *error = path.string() + ": damaged, data set " + data_set + " cannot be read";
    return nullptr;
  }
  return OpenHere(path, data_set, columns, error);
}

Hdf5Table::~Hdf5Table() {
  if (record_ >= 0) H5Tclose(record_);
  if (data_set_ >= 0) H5Dclose(data_set_);
  if (file_ >= 0) H5Fclose(file_);
}

bool Hdf5Table::Read(std::uint64_t first, std::uint64_t count, std::vector<double>* values) const {
  CHECK(first <= num_rows_ && count <= num_rows_ - first);
  values->clear();
  if (count == 0) return true;
  // A table that claims more rows than its file can hold does not get their memory.
  if (count > kRowsAtOnce) {
    std::vector<double> part;
    for (std::uint64_t done = 0; done < count; done += kRowsAtOnce) {
      if (!Read(first + done, std::min(kRowsAtOnce, count - done), &part)) return false;
      values->insert(values->end(), part.begin(), part.end());
    }
    return true;
  }
  values->resize(static_cast<std::size_t>(count) * num_columns_);
  const hid_t stored = H5Dget_space(data_set_);
  const hsize_t begin = first, size = count;
  const hid_t memory = H5Screate_simple(1, &size, nullptr);
  const bool ok =
      stored >= 0 && memory >= 0 &&
      H5Sselect_hyperslab(stored, H5S_SELECT_SET, &begin, nullptr, &size, nullptr) >= 0 &&
      H5Dread(data_set_, record_, memory, stored, H5P_DEFAULT, values->data()) >= 0;
  if (memory >= 0) H5Sclose(memory);
  if (stored >= 0) H5Sclose(stored);
  return ok;
}

}  // namespace radive
