// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The sums of NdtSums, for the files that define RADIVE_KERNELS.

#pragma once

#include "radive/kernels/pack.h"

namespace radive::RADIVE_KERNELS {

struct PackVector {
  Pack x, y, z;
};

struct PackSymmetric {
  Pack xx, xy, xz, yy, yz, zz;
};

// Beyond this squared Mahalanobis distance a pair has no more than 1e-13 of its weight: its cost is
// the full depth and its derivatives are zero to rounding.
constexpr double kFarAway = 60.0;

inline PackVector LoadVector(const Lanes* fields) {
  return {Load(fields), Load(fields + 1), Load(fields + 2)};
}

inline PackSymmetric LoadSymmetric(const Lanes* fields) {
  return {Load(fields),
          Load(fields + 1),
          Load(fields + 2),
          Load(fields + 3),
          Load(fields + 4),
          Load(fields + 5)};
}

inline PackVector Rotate(const double* R, const PackVector& v) {
  return {R[0] * v.x + R[1] * v.y + R[2] * v.z,
          R[3] * v.x + R[4] * v.y + R[5] * v.z,
          R[6] * v.x + R[7] * v.y + R[8] * v.z};
}

// R S R^T.
inline PackSymmetric Rotate(const double* R, const PackSymmetric& S) {
  const PackVector x = Rotate(R, PackVector{S.xx, S.xy, S.xz});  // columns of R S
  const PackVector y = Rotate(R, PackVector{S.xy, S.yy, S.yz});
  const PackVector z = Rotate(R, PackVector{S.xz, S.yz, S.zz});
  const PackVector row_x = Rotate(R, PackVector{x.x, y.x, z.x});  // rows of R S R^T
  const PackVector row_y = Rotate(R, PackVector{x.y, y.y, z.y});
  return {row_x.x, row_x.y, row_x.z, row_y.y, row_y.z, R[6] * x.z + R[7] * y.z + R[8] * z.z};
}

// The sums of the pairs of one pack, still apart for its four scan Gaussians.
struct PackSums {
  Pack height = All(0.0);         // p
  PackVector force = {};          // p q
  PackSymmetric stiffness = {};   // p Sigma^-1
  PackSymmetric off_centre = {};  // p q q^T
};

template <bool kDividesByDeterminant>
inline PackSums SumRows(const Lanes* row,
                        int num_rows,
                        const PackVector& mean,
                        const PackSymmetric& G) {
  PackSums sums;
  for (int k = 0; k < num_rows; ++k, row += NdtPacks::kPairFields) {
    const PackVector b = LoadVector(row);
    const PackSymmetric B = LoadSymmetric(row + 3);
    const Pack dx = mean.x - b.x, dy = mean.y - b.y, dz = mean.z - b.z;
    const Pack xx = G.xx + B.xx, xy = G.xy + B.xy, xz = G.xz + B.xz;
    const Pack yy = G.yy + B.yy, yz = G.yz + B.yz, zz = G.zz + B.zz;
    // The inverse is the matrix of these over the determinant.
    const Pack cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
    const Pack cyy = xx * zz - xz * xz, cyz = xy * xz - xx * yz, czz = xx * yy - xy * xy;
    const Pack determinant = xx * cxx + xy * cxy + xz * cxz;
    const Pack inverse = 1.0 / determinant;
    const Pack ux = cxx * dx + cxy * dy + cxz * dz;
    const Pack uy = cxy * dx + cyy * dy + cyz * dz;
    const Pack uz = cxz * dx + cyz * dy + czz * dz;
    const Pack m = inverse * (dx * ux + dy * uy + dz * uz);
    const Bits is_near = m < kFarAway;
    if (Which(is_near) == 0) continue;
    Pack height = Load(row + 9);
    if constexpr (kDividesByDeterminant) height = height * Sqrt(inverse);
    // Pairs out of reach may have any height, and rows without a pair a determinant of zero.
    const Pack p = Where(is_near, height * Exp(-0.5 * m));
    const Pack scale = Where(is_near, inverse);
    const Pack ps = p * scale;  // q = scale u
    const Pack pss = ps * scale, vx = pss * ux, vy = pss * uy, vz = pss * uz;
    sums.height += p;
    sums.force.x += ps * ux;
    sums.force.y += ps * uy;
    sums.force.z += ps * uz;
    sums.off_centre.xx += vx * ux;
    sums.off_centre.xy += vx * uy;
    sums.off_centre.xz += vx * uz;
    sums.off_centre.yy += vy * uy;
    sums.off_centre.yz += vy * uz;
    sums.off_centre.zz += vz * uz;
    sums.stiffness.xx += ps * cxx;
    sums.stiffness.xy += ps * cxy;
    sums.stiffness.xz += ps * cxz;
    sums.stiffness.yy += ps * cyy;
    sums.stiffness.yz += ps * cyz;
    sums.stiffness.zz += ps * czz;
  }
  return sums;
}

// sums += J^T K J with J = [-[a]_x, I], upper triangle.
inline void AddAtLever(const PackSymmetric& K, const PackVector& a, Pack (*sums)[6]) {
  const PackVector kx = {K.xx, K.xy, K.xz}, ky = {K.xy, K.yy, K.yz}, kz = {K.xz, K.yz, K.zz};
  const Pack cross[3][3] = {
      {a.y * kz.x - a.z * ky.x, a.y * kz.y - a.z * ky.y, a.y * kz.z - a.z * ky.z},
      {a.z * kx.x - a.x * kz.x, a.z * kx.y - a.x * kz.y, a.z * kx.z - a.x * kz.z},
      {a.x * ky.x - a.y * kx.x, a.x * ky.y - a.y * kx.y, a.x * ky.z - a.y * kx.z}};  // [a]_x K
  sums[0][0] += cross[0][2] * a.y - cross[0][1] * a.z;
  sums[0][1] += cross[0][0] * a.z - cross[0][2] * a.x;
  sums[0][2] += cross[0][1] * a.x - cross[0][0] * a.y;
  sums[1][1] += cross[1][0] * a.z - cross[1][2] * a.x;
  sums[1][2] += cross[1][1] * a.x - cross[1][0] * a.y;
  sums[2][2] += cross[2][1] * a.x - cross[2][0] * a.y;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) sums[i][3 + j] += cross[i][j];
  }
  sums[3][3] += K.xx;
  sums[3][4] += K.xy;
  sums[3][5] += K.xz;
  sums[4][4] += K.yy;
  sums[4][5] += K.yz;
  sums[5][5] += K.zz;
}

// (A B)_ij - (A B)_ji for symmetric A and B, as the vector [12 - 21, 20 - 02, 01 - 10].
inline PackVector Commutator(const PackSymmetric& A, const PackSymmetric& B) {
  return {A.xy * B.xz + A.yy * B.yz + A.yz * B.zz - A.xz * B.xy - A.yz * B.yy - A.zz * B.yz,
          A.xz * B.xx + A.yz * B.xy + A.zz * B.xz - A.xx * B.xz - A.xy * B.yz - A.xz * B.zz,
          A.xx * B.xy + A.xy * B.yy + A.xz * B.yz - A.xy * B.xx - A.yy * B.xy - A.yz * B.xz};
}

template <bool kDividesByDeterminant>
void SumPacks(const NdtPacks& packs, const double* R, const double* t, NdtSums* sums) {
  Pack height = All(0.0);
  Pack gradient[6] = {}, hessian[6][6] = {}, off_centre[6][6] = {}, scatter[6][6] = {};
  const Lanes* row = packs.pairs;
  for (int i = 0; i < packs.num_packs; ++i) {
    const Lanes* scan = packs.scan + i * NdtPacks::kScanFields;
    const PackVector lever = Rotate(R, LoadVector(scan));
    const PackSymmetric G = Rotate(R, LoadSymmetric(scan + 3));
    const PackVector mean = {lever.x + t[0], lever.y + t[1], lever.z + t[2]};
    const PackSums pack = SumRows<kDividesByDeterminant>(row, packs.num_rows[i], mean, G);
    row += packs.num_rows[i] * NdtPacks::kPairFields;
    height += pack.height;
    const PackVector& f = pack.force;
    // How Sigma turns with the scan: the sum over the pairs of -p (G q) x q, and of the
    // determinant.
    PackVector torque = Commutator(G, pack.off_centre);
    torque = {-torque.x, -torque.y, -torque.z};
    if constexpr (kDividesByDeterminant) {
      const PackVector of_height = Commutator(G, pack.stiffness);
      torque = {torque.x + of_height.x, torque.y + of_height.y, torque.z + of_height.z};
    }
    const Pack g[6] = {torque.x + lever.y * f.z - lever.z * f.y,
                       torque.y + lever.z * f.x - lever.x * f.z,
                       torque.z + lever.x * f.y - lever.y * f.x,
                       f.x,
                       f.y,
                       f.z};
    for (int r = 0; r < 6; ++r) {
      gradient[r] += g[r];
      for (int c = r; c < 6; ++c) scatter[r][c] += g[r] * g[c];
    }
    AddAtLever(pack.stiffness, lever, hessian);
    AddAtLever(pack.off_centre, lever, off_centre);
  }
  sums->height = Sum(height);
  for (int r = 0; r < 6; ++r) {
    sums->gradient[r] = Sum(gradient[r]);
    for (int c = r; c < 6; ++c) {
      sums->hessian[r][c] = Sum(hessian[r][c]);
      sums->off_centre[r][c] = Sum(off_centre[r][c]);
      sums->scatter[r][c] = Sum(scatter[r][c]);
    }
  }
}

inline void SumNdtPairs(const NdtPacks& packs, const double* R, const double* t, NdtSums* sums) {
  if (packs.divides_by_determinant) {
    SumPacks<true>(packs, R, t, sums);
  } else {
    SumPacks<false>(packs, R, t, sums);
  }
}

}  // namespace radive::RADIVE_KERNELS
