// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The arrays of a scene as scripts/report/viewer.py writes them.

function bytes(text) {
  const raw = atob(text);
  const out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) out[i] = raw.charCodeAt(i);
  return out.buffer;
}

// Metres from the start to each pose.
function travelled(poses) {
  const distance = new Float32Array(poses.length / 7);
  for (let i = 1; i < distance.length; ++i) {
    const step = Math.hypot(
      poses[7 * i] - poses[7 * i - 7],
      poses[7 * i + 1] - poses[7 * i - 6],
      poses[7 * i + 2] - poses[7 * i - 5],
    );
    distance[i] = distance[i - 1] + step;
  }
  return distance;
}

export function decodeScene(scene) {
  const poses = new Float32Array(bytes(scene.poses));
  return {
    stamps: new Float32Array(bytes(scene.stamps)),
    poses,
    distance: travelled(poses),
    errors: new Float32Array(bytes(scene.errors)),
    truth: new Float32Array(bytes(scene.truth)),
    points: new Uint16Array(bytes(scene.points)),
    shown: new Uint32Array(bytes(scene.shown)),
    boxLow: scene.box_low,
    boxSize: scene.box_size,
    heights: scene.heights,
    view: scene.view,
  };
}

// Speed [m/s] around pose i, over about half a second to each side.
export function speedAt(data, i) {
  let low = i;
  let high = i;
  while (low > 0 && data.stamps[i] - data.stamps[low] < 0.5) --low;
  while (high + 1 < data.stamps.length && data.stamps[high] - data.stamps[i] < 0.5) ++high;
  const time = data.stamps[high] - data.stamps[low];
  return time > 0 ? (data.distance[high] - data.distance[low]) / time : 0;
}

export function positionAt(data, i) {
  return [data.poses[7 * i], data.poses[7 * i + 1], data.poses[7 * i + 2]];
}
