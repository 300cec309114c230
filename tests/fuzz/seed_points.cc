// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes small point files for the fuzz targets to start from: seed_points FOLDER.

#include <cstdio>
#include <filesystem>
#include <string>

#include "radive/io/bytes/whole_file.h"
#include "radive/io/points/point_file_writer.h"

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
         RecordBytes(Returns(), KnownLayout("xyzdp5"));
}

bool WriteSeeds(const fs::path& folder) {
  const std::vector<RadarReturn> returns = Returns();
  const std::string scan =
      R"({"car_loc_x":[1,2],"car_loc_y":[3,4],"car_loc_z":[0,0],"car_vel_r":[-1,-1],)"
      R"("rcs":[5,6],"power":[7,8]})";
  return Write(folder / "fuzz_pcd/ascii", PcdBytes(returns, PcdEncoding::kAscii)) &&
         Write(folder / "fuzz_pcd/binary", PcdBytes(returns, PcdEncoding::kBinary)) &&
         Write(folder / "fuzz_pcd/compressed", PcdBytes(returns, PcdEncoding::kCompressed)) &&
         Write(folder / "fuzz_pcd/snail",
               PcdRecordBytes(returns, KnownLayout("x,y,z,doppler,intensity,range_std"))) &&
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
               "{\"pc1\":" + scan + ",\"pc2\":" + scan + ",\"interval\":0.1}") &&
         Write(folder / "fuzz_raw/hercules",
               std::string(1, 0) + RecordBytes(returns, KnownLayout("hercules29"))) &&
         Write(folder / "fuzz_raw/xyzdp5",
               std::string(1, 2) + RecordBytes(returns, KnownLayout("xyzdp5"))) &&
         Write(folder / "fuzz_raw/aeva", std::string(1, 5) + std::string(58, 'a')) &&
         Write(folder / "fuzz_scan_table/radarscenes",
               std::string(1, 0) + "scan,timestamp_rad,first_point,num_points\n1,0.5,0,241\n") &&
         Write(folder / "fuzz_scan_table/stamps", std::string(1, 1) + "# s\n1.5\n2.5e0\n") &&
         Write(folder / "fuzz_scan_table/name", std::string(1, 2) + "1706001762.429354169");
}

// The first byte stands for the format, see the targets.
bool WriteTruthSeeds(const fs::path& folder) {
  const std::string matrix = "[1,0,0,5, 0,1,0,6, 0,0,1,7, 0,0,0,1]";
  const std::string rows = "{\"pose\":[[1,0,0,5],[0,1,0,6],[0,0,1,7],[0,0,0,1]]}";
  const fs::path text = folder / "fuzz_trajectory";
  const fs::path json = folder / "fuzz_truth_json";
  return Write(text / "tum", std::string(1, 0) + "# t\n1706001762.099999905 1 2 3 0 0 0 1\n") &&
         Write(text / "kitti", std::string(1, 1) + "1 0 0 5 0 1 0 6 0 0 1 7\n") &&
         Write(text / "euroc", std::string(1, 2) + "1403715529107142912,1,2,3,1,0,0,0,9\n") &&
         Write(text / "boreas", std::string(1, 5) + "t\n1606417097528152,1,2,3,0,0,0,0,0,1,0\n") &&
         Write(text / "coloradar", std::string(1, 4) + "1 2 3 0 0 1 0\n") &&
         Write(text / "radarscenes",
               std::string(1, 3) + "timestamp_odom,x,y,yaw\n0.07,1,2,-0.1\n") &&
         Write(text / "named",
               std::string(1, 6) + "time,x,y,z,v,qx,qy,qz,qw\n1,2,3,4,5,0,0,0,1\n") &&
         Write(text / "unnamed", std::string(1, 6) + "1,2,3,4,5,6,7,0,0,0.6,0.8\n") &&
         Write(json / "vod", std::string(1, 0) + "{\"odomToCamera\": " + matrix + "}\n{}") &&
         Write(json / "calibration",
               std::string(1, 1) + "P0: 1\nTr_velo_to_cam: 1 0 0 5 0 1 0 6 0 0 1 7\n") &&
         Write(json / "raflow",
               std::string(1, 2) + "{\"pc1\":" + rows + ",\"pc2\":" + rows + "}") &&
         Write(json / "dicp",
               std::string(1, 3) +
                   "{\"T_V_to_S\":{\"translation\":{\"x\":1,\"y\":2,\"z\":3},"
                   "\"quaternion\":{\"w\":1,\"x\":0,\"y\":0,\"z\":0}}}") &&
         Write(folder / "fuzz_pose_message/pose", std::string(1, 0) + std::string(72, '\0')) &&
         Write(folder / "fuzz_pose_message/fix",
               std::string(1, 5) + std::string("\0\1\0\0", 4) + std::string(44, '\0'));
}

}  // namespace
}  // namespace radive

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "seed_points FOLDER\n");
    return 1;
  }
  return radive::WriteSeeds(argv[1]) && radive::WriteTruthSeeds(argv[1]) ? 0 : 1;
}
