// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// What stands in the 3D view: map points, trajectory, ground truth and the vehicle.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  ConeGeometry,
  Group,
  Mesh,
  MeshBasicMaterial,
  Points,
  PointsMaterial,
} from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';

import { positionAt } from './scene_data.js';

// Low to high: the middle of viridis, which is readable on light and dark.
const HEIGHT_COLOURS = ['#414487', '#2a788e', '#22a884', '#7ad151'].map((hex) => new Color(hex));

function heightColour(share, out) {
  const at = Math.min(Math.max(share, 0), 0.9999) * (HEIGHT_COLOURS.length - 1);
  const low = Math.floor(at);
  return out.lerpColors(HEIGHT_COLOURS[low], HEIGHT_COLOURS[low + 1], at - low);
}

function pointColours(data) {
  const colours = new Uint8Array(data.points.length);
  const colour = new Color();
  const [low, high] = data.heights;
  for (let i = 0; i < data.points.length; i += 3) {
    const z = data.boxLow[2] + (data.points[i + 2] / 65535) * data.boxSize[2];
    heightColour((z - low) / (high - low), colour);
    colours[i] = 255 * colour.r;
    colours[i + 1] = 255 * colour.g;
    colours[i + 2] = 255 * colour.b;
  }
  return colours;
}

function line(width) {
  return new Line2(new LineGeometry(), new LineMaterial({ linewidth: width }));
}

function setLine(target, positions) {
  target.geometry.dispose();
  target.geometry = new LineGeometry();
  if (positions.length >= 6) target.geometry.setPositions(positions);
  target.visible = positions.length >= 6;
  target.frustumCulled = false;
}

export class World extends Group {
  constructor() {
    super();
    this.past = line(3);
    this.future = line(1.2);
    this.truth = line(5);
    this.faint = new Points(
      new BufferGeometry(),
      new PointsMaterial({ size: 1.5, sizeAttenuation: false, transparent: true, opacity: 0.16 }),
    );
    this.bright = new Points(
      new BufferGeometry(),
      new PointsMaterial({ size: 2.2, sizeAttenuation: false, vertexColors: true }),
    );
    this.faint.material.depthWrite = false;
    this.vehicle = new Group();
    const nose = new Mesh(new ConeGeometry(0.9, 3.4, 20), new MeshBasicMaterial());
    nose.rotation.z = -Math.PI / 2; // a cone points along y, a vehicle along x
    this.nose = nose;
    this.vehicle.add(nose);
    // Lines are drawn over the points and over each other in this order, or they would flicker.
    [this.truth, this.future, this.past, nose].forEach((object, i) => {
      object.renderOrder = i + 1;
      object.material.depthTest = false;
      object.material.transparent = true; // drawn after all that is not
    });
    this.add(this.truth, this.faint, this.bright, this.future, this.past, this.vehicle);
  }

  setColours(ink, estimate, truth) {
    this.past.material.color.set(estimate);
    this.future.material.color.set(estimate);
    this.nose.material.color.set(estimate);
    this.truth.material.color.set(truth);
    this.faint.material.color.set(ink);
  }

  setScene(data) {
    this.data = data;
    const positions = [];
    for (let i = 0; i < data.stamps.length; ++i) positions.push(...positionAt(data, i));
    setLine(this.past, positions);
    setLine(this.future, positions);
    setLine(this.truth, Array.from(data.truth));
    const points = new BufferAttribute(data.points, 3, true);
    const colours = new BufferAttribute(pointColours(data), 3, true);
    for (const cloud of [this.faint, this.bright]) {
      cloud.geometry.dispose();
      cloud.geometry = new BufferGeometry();
      cloud.geometry.setAttribute('position', points);
      cloud.position.set(...data.boxLow);
      cloud.scale.set(...data.boxSize);
      cloud.frustumCulled = false;
    }
    this.bright.geometry.setAttribute('color', colours);
  }

  // The drive up to pose i.
  setPose(i) {
    const pose = this.data.poses;
    this.past.geometry.instanceCount = i;
    this.bright.geometry.setDrawRange(0, this.data.shown[i]);
    this.vehicle.position.set(...positionAt(this.data, i));
    this.vehicle.quaternion.set(pose[7 * i + 3], pose[7 * i + 4], pose[7 * i + 5], pose[7 * i + 6]);
  }

  // The vehicle stays visible from afar.
  setDistance(distance) {
    this.vehicle.scale.setScalar(Math.max(1, distance / 70));
  }
}
