// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes small point files for the fuzz targets to start from: seed_points FOLDER.

#include <cstdio>
#include <filesystem>
#include <string>

#include "radive/io/point_file_writer.h"
#include "radive/io/whole_file.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

std::vector<RadarReturn> Returns() {
  std::vector<RadarReturn> returns(4);
  for (std::size_t i = 0; i < returns.size(); ++i) {
    returns[i].position = {10.0 + static_cast<double>(i), -1.25, 0.5};
    returns[i].doppler = -9.75;
    returns[i].power = 20.0;
  }
  return returns;
}

bool Write(const fs::path& path, const std::string& bytes) {
  fs::create_directories(path.parent_path());
  std::string error;
  if (WriteWholeFile(path, bytes, &error)) return true;
  std::fprintf(stderr, "seed_points: %s\n", error.c_str());
  return false;
}

std::string Npy(const char* order) {
  const std::string header =
      "{'descr': '<f4', 'fortran_order': " + std::string(order) + ", 'shape': (4, 5), }\n";
  return std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(header.size()) + '\0' + header +
         RawBytes(Returns());
}

bool WriteSeeds(const fs::path& folder) {
  const std::vector<RadarReturn> returns = Returns();
  const std::string scan =
      R"({"car_loc_x":[1,2],"car_loc_y":[3,4],"car_loc_z":[0,0],"car_vel_r":[-1,-1],)"
      R"("rcs":[5,6],"power":[7,8]})";
  return Write(folder / "fuzz_pcd/ascii", PcdBytes(returns, PcdEncoding::kAscii)) &&
         Write(folder / "fuzz_pcd/binary", PcdBytes(returns, PcdEncoding::kBinary)) &&
         Write(folder / "fuzz_pcd/compressed", PcdBytes(returns, PcdEncoding::kCompressed)) &&
         Write(folder / "fuzz_pcd/snail", SnailPcdBytes(returns)) &&
         Write(folder / "fuzz_ply/ascii", PlyBytes(returns, PlyEncoding::kAscii)) &&
         Write(folder / "fuzz_ply/little", PlyBytes(returns, PlyEncoding::kLittleEndian)) &&
         Write(folder / "fuzz_ply/big", PlyBytes(returns, PlyEncoding::kBigEndian)) &&
         Write(
             folder / "fuzz_ply/lists",
             "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uchar int i\n"
             "element vertex 1\nproperty float x\nproperty list ushort float w\nproperty float y\n"
             "end_header\n" +
                 std::string("\1\0\0\0\0xxxx\1\0wwwwyyyy", 19)) &&
         Write(folder / "fuzz_csv/commas", CsvBytes(returns)) &&
         Write(folder / "fuzz_csv/comment", "# x y doppler\n1 2 3\n4 nan -6e1\n") &&
         Write(folder / "fuzz_npy/rows", Npy("False")) &&
         Write(folder / "fuzz_npy/columns", Npy("True")) &&
         Write(folder / "fuzz_yaml/detections",
               "sec: 1\ndetections:\n  - range: 10\n    azimuth_angle: 0.5\n    valid: true\n"
               "  - range: 20\n    azimuth_angle: -0.5\nend: 1\n") &&
         Write(folder / "fuzz_json/pair",
               "{\"pc1\":" + scan + ",\"pc2\":" + scan + ",\"interval\":0.1}");
}

}  // namespace
}  // namespace radive

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "seed_points FOLDER\n");
    return 1;
  }
  return radive::WriteSeeds(argv[1]) ? 0 : 1;
}
