// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes small files radar_data.h5 into FOLDER/fuzz_hdf5/: contiguous and in packed chunks.

#include <hdf5.h>

#include <filesystem>
#include <string>
#include <vector>

namespace {

// A data set of rows of doubles under these names.
bool WriteTable(hid_t file,
                const char* name,
                const std::vector<const char*>& columns,
                const std::vector<double>& values,
                hid_t properties) {
  const hid_t row = H5Tcreate(H5T_COMPOUND, columns.size() * sizeof(double));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    H5Tinsert(row, columns[i], i * sizeof(double), H5T_NATIVE_DOUBLE);
  }
  const hsize_t count = values.size() / columns.size();
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t set = H5Dcreate2(file, name, row, space, H5P_DEFAULT, properties, H5P_DEFAULT);
  const bool ok = H5Dwrite(set, row, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0;
  H5Dclose(set);
  H5Sclose(space);
  H5Tclose(row);
  return ok;
}

bool WriteSeed(const std::filesystem::path& path, bool is_packed) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  if (is_packed) {
    const hsize_t chunk = 2;
    H5Pset_chunk(properties, 1, &chunk);
    H5Pset_deflate(properties, 1);
  }
  const bool ok =
      WriteTable(file,
                 "radar_data",
                 {"timestamp", "sensor_id", "range_sc", "azimuth_sc", "rcs", "vr"},
                 {100000, 2, 10, 0, 5, -3, 100000, 2, 20, 1.5, 6, 0, 170000, 2, 40, 0, 8, -4},
                 properties) &&
      WriteTable(file,
                 "odometry",
                 {"timestamp", "x_seq", "y_seq", "yaw_seq"},
                 {90000, 1, 2, 0, 180000, 3, 4, 1.5},
                 properties);
  H5Pclose(properties);
  return H5Fclose(file) >= 0 && ok;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 1;
  const std::filesystem::path folder = std::filesystem::path(argv[1]) / "fuzz_hdf5";
  std::filesystem::create_directories(folder);
  return WriteSeed(folder / "plain", false) && WriteSeed(folder / "packed", true) ? 0 : 1;
}
