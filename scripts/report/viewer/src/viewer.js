// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The 3D view of the report. Draws only when something has changed.

import { Box3, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

import { decodeScene, positionAt, speedAt } from './scene_data.js';
import { World } from './world.js';

const SECONDS_OF_PLAY = 24; // a whole drive, however long

class Viewer {
  constructor(root, scenes) {
    this.root = root;
    this.scenes = scenes;
    this.canvas = root.querySelector('canvas');
    this.slider = root.querySelector('input[type=range]');
    this.play = root.querySelector('[data-action=play]');
    this.select = root.querySelector('select');
    this.readout = root.querySelector('output');
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(45, 2, 0.5, 20000);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.maxPolarAngle = Math.PI / 2;
    this.controls.listenToKeyEvents(this.canvas);
    this.controls.addEventListener('change', () => this.invalidate());
    this.world = new World();
    this.scene.add(this.world);
    this.drawn = 0;
    this.connect();
    this.setTheme();
    this.choose(0);
  }

  connect() {
    this.scenes.forEach((scene, i) => this.select.add(new Option(scene.name, i)));
    this.select.hidden = this.scenes.length < 2;
    this.select.addEventListener('change', () => this.choose(Number(this.select.value)));
    this.slider.addEventListener('input', () => this.setPose(Number(this.slider.value)));
    this.play.addEventListener('click', () => this.setPlaying(!this.isPlaying));
    for (const button of this.root.querySelectorAll('[data-view]')) {
      button.addEventListener('click', () => this.look(button.dataset.view));
    }
    for (const box of this.root.querySelectorAll('input[type=checkbox]')) {
      box.addEventListener('change', () => this.setLayers());
    }
    this.canvas.addEventListener('keydown', (event) => this.zoomByKey(event));
    new ResizeObserver(() => this.resize()).observe(this.canvas.parentElement);
    const setTheme = () => this.setTheme();
    window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', setTheme);
    new MutationObserver(setTheme).observe(document.documentElement, {
      attributeFilter: ['data-theme'],
    });
  }

  setTheme() {
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => style.getPropertyValue(`--${name}`).trim();
    this.renderer.setClearColor(colour('canvas'));
    this.world.setColours(colour('muted'), colour('series-1'), colour('truth'));
    this.invalidate();
  }

  choose(index) {
    this.setPlaying(false);
    this.index = index;
    this.data = decodeScene(this.scenes[index]);
    this.world.setScene(this.data);
    const last = this.data.stamps.length - 1;
    this.slider.max = last;
    this.slider.value = last;
    this.hasTruth = this.data.truth.length > 0;
    this.root.querySelector('[data-layer=truth]').parentElement.hidden = !this.hasTruth;
    this.setLayers();
    this.setPose(last);
    this.look('oblique');
  }

  setLayers() {
    const is = (name) => this.root.querySelector(`[data-layer=${name}]`).checked;
    this.world.truth.visible = this.hasTruth && is('truth');
    this.world.bright.visible = is('map');
    this.world.faint.visible = is('map');
    this.isFollowing = is('follow');
    if (this.pose !== undefined) this.follow(this.pose);
    this.invalidate();
  }

  setPose(i) {
    this.follow(i);
    this.pose = i;
    this.world.setPose(i);
    const error = this.data.errors[i];
    const parts = [
      `${this.data.stamps[i].toFixed(1)} s`,
      `${this.data.distance[i].toFixed(0)} m`,
      `${speedAt(this.data, i).toFixed(1)} m/s`,
    ];
    if (Number.isFinite(error)) parts.push(`position error ${error.toFixed(2)} m`);
    this.readout.textContent = parts.join(' · ');
    this.slider.setAttribute('aria-valuetext', parts.join(', '));
    this.invalidate();
  }

  // Moves the camera with the vehicle.
  follow(i) {
    if (!this.isFollowing) return;
    const target = new Vector3(...positionAt(this.data, i));
    this.camera.position.add(target).sub(this.controls.target);
    this.controls.target.copy(target);
    this.controls.update();
  }

  look(view) {
    const box = new Box3(...this.data.view.map((corner) => new Vector3(...corner)));
    const size = box.getSize(new Vector3());
    const center = box.getCenter(new Vector3());
    if (view === 'vehicle') {
      center.set(...positionAt(this.data, this.pose));
      size.set(30, 30, 0);
    }
    const direction = new Vector3(...this.direction(view, size));
    const tangent = Math.tan((this.camera.fov * Math.PI) / 360);
    const width = Math.max(size.x, size.y) / Math.min(this.camera.aspect, 2.2);
    const depth = Math.min(size.x, size.y);
    const distance = Math.max(25, (0.64 * Math.max(width, depth)) / tangent);
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(direction.normalize(), distance);
    this.controls.update();
    this.invalidate();
  }

  // From where to look: the longer side of the drive lies across the picture.
  direction(view, size) {
    const isWide = size.x >= size.y;
    if (view === 'top') return isWide ? [0, -0.001, 1] : [-0.001, 0, 1];
    if (view === 'vehicle') {
      this.world.vehicle.updateMatrixWorld();
      const back = new Vector3(-1, 0, 0).applyQuaternion(this.world.vehicle.quaternion);
      return [back.x, back.y, 0.55];
    }
    return isWide ? [-0.25, -1, 0.85] : [-1, 0.25, 0.85];
  }

  zoomByKey(event) {
    const factor = { '+': 0.85, '-': 1 / 0.85 }[event.key];
    if (!factor) return;
    const offset = this.camera.position.clone().sub(this.controls.target);
    this.camera.position.copy(this.controls.target).addScaledVector(offset, factor);
    this.controls.update();
    this.invalidate();
  }

  setPlaying(isPlaying) {
    this.isPlaying = isPlaying;
    this.play.textContent = isPlaying ? 'Pause' : 'Play';
    this.play.setAttribute('aria-pressed', isPlaying);
    if (!isPlaying) return;
    const last = this.data.stamps.length - 1;
    const from = this.pose === last ? 0 : this.pose;
    const begin = performance.now();
    const step = (now) => {
      if (!this.isPlaying) return;
      const share = Math.max(0, now - begin) / (1000 * SECONDS_OF_PLAY);
      const i = Math.min(last, from + Math.floor(share * last));
      this.slider.value = i;
      this.setPose(i);
      if (i === last) this.setPlaying(false);
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (!clientWidth || !clientHeight) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    if (!this.hasSize) this.look('oblique');
    this.hasSize = true;
    this.invalidate();
  }

  invalidate() {
    if (this.isPending) return;
    this.isPending = true;
    requestAnimationFrame(() => {
      this.isPending = false;
      this.world.setDistance(this.camera.position.distanceTo(this.world.vehicle.position));
      this.renderer.render(this.scene, this.camera);
      ++this.drawn;
    });
  }

  // For the check in a browser.
  state() {
    return {
      pose: this.pose,
      vehicle: this.world.vehicle.position.toArray(),
      camera: this.camera.position.toArray(),
      points: this.data.shown[this.pose],
      drawn: this.drawn,
    };
  }
}

const root = document.getElementById('viewer');
if (root) {
  const scenes = JSON.parse(document.getElementById('viewer-data').textContent);
  try {
    window.radiveViewer = new Viewer(root, scenes);
  } catch (error) {
    root.dataset.failed = 'This browser has no WebGL: the 3D view is left out.';
    console.warn(error);
  }
}
