// space.js - drawings in space, by three.js.  A file of its own, loaded only by
// pages that have such a figure: README.md says what it weighs.

import * as THREE from 'three';
import { COLOURS, colour, dark, make } from './node.js';

const SUN = new THREE.Vector3(0.5, 1, 0.42).normalize();
const NARROW = 1.4;             // width by height; below, the camera steps back
const STILL = 5;                // px; a shorter way of the finger is a tap

function material(options) {
  return new THREE.MeshStandardMaterial({ roughness: 0.62, metalness: 0, side: THREE.DoubleSide, ...options });
}

// One mesh of all triangles, whose lists are copied at every drawing.
class Growing {
  constructor(scene, kind, look, sizes) {
    this.geometry = new THREE.BufferGeometry();
    this.sizes = sizes;
    this.node = new kind(this.geometry, look);
    this.node.frustumCulled = false;
    scene.add(this.node);
  }
  attribute(name, values) {
    let known = this.geometry.getAttribute(name);
    if (!known || known.array.length < values.length) {
      known = new THREE.BufferAttribute(new Float32Array(2 * values.length), 3).setUsage(THREE.DynamicDrawUsage);
      this.geometry.setAttribute(name, known);
    }
    known.array.set(values);
    known.needsUpdate = true;
  }
  index(values) {
    let known = this.geometry.getIndex();
    if (!known || known.array.length < values.length) {
      known = new THREE.BufferAttribute(new Uint32Array(2 * values.length), 1).setUsage(THREE.DynamicDrawUsage);
      this.geometry.setIndex(known);
    }
    known.array.set(values);
    known.needsUpdate = true;
    this.geometry.setDrawRange(0, values.length);
  }
  show(lists) {
    for (const [name, values] of Object.entries(lists)) {
      if (name === 'index') this.index(values); else this.attribute(name, values);
    }
    if (!lists.index) this.geometry.setDrawRange(0, lists.position.length / 3);
    this.node.visible = lists.position.length > 0;
  }
}

// Many balls or tubes, each `size` numbers of a list.
class Many {
  constructor(scene, geometry, size, place) {
    Object.assign(this, { scene, geometry, size, place, room: 0 });
  }
  show(list) {
    const count = list.length / this.size;
    if (count > this.room) {
      if (this.node) { this.scene.remove(this.node); this.node.dispose(); }
      this.room = 2 * count;
      this.node = new THREE.InstancedMesh(this.geometry, material({}), this.room);
      this.node.castShadow = this.node.receiveShadow = true;
      this.node.frustumCulled = false;
      this.scene.add(this.node);
    }
    if (!this.node) return;
    const pose = new THREE.Matrix4(), tint = new THREE.Color();
    for (let k = 0; k < count; k++) {
      const at = this.size * k;
      this.node.setMatrixAt(k, this.place(list.subarray(at, at + this.size), pose));
      this.node.setColorAt(k, tint.fromArray(list, at + this.size - 4));
    }
    this.node.count = count;
    this.node.instanceMatrix.needsUpdate = true;
    if (count) this.node.instanceColor.needsUpdate = true;
  }
}

const UP = new THREE.Vector3(0, 1, 0), NO_TURN = new THREE.Quaternion();
const ballPose = ([x, y, z, r], pose) => pose.compose(new THREE.Vector3(x, y, z), NO_TURN, new THREE.Vector3(r, r, r));
function tubePose([ax, ay, az, bx, by, bz, r], pose) {
  const a = new THREE.Vector3(ax, ay, az), way = new THREE.Vector3(bx, by, bz).sub(a), length = way.length();
  const turn = new THREE.Quaternion().setFromUnitVectors(UP, way.clone().divideScalar(length || 1));
  return pose.compose(a.addScaledVector(way, 0.5), turn, new THREE.Vector3(r, length, r));
}

export class Space {
  // core is made later: it is set when it is there.
  constructor(figure, stage, panel) {
    const [distance, turn, rise, x, y, z, floor] = panel.camera;
    Object.assign(this, { figure, stage, distance, turn, rise, target: new THREE.Vector3(x, y, z), hasFloor: floor });
    this.canvas = make('canvas', { tabindex: 0, role: 'img', 'aria-label': panel.says + '. Arrow keys turn the view.' });
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(34, 1, distance / 50, distance * 20);
    this.light();
    this.mesh = new Growing(this.scene, THREE.Mesh, material({ vertexColors: true }), {});
    this.mesh.node.castShadow = this.mesh.node.receiveShadow = true;
    this.edges = new Growing(this.scene, THREE.LineSegments, new THREE.LineBasicMaterial({ vertexColors: true, transparent: true, opacity: 0.7, toneMapped: false }), {});
    this.balls = new Many(this.scene, new THREE.SphereGeometry(1, 28, 18), 8, ballPose);
    this.tubes = new Many(this.scene, new THREE.CylinderGeometry(1, 1, 1, 18), 11, tubePose);
    stage.append(this.canvas);
    this.listen();
    new ResizeObserver(() => this.size()).observe(stage);
  }

  light() {
    const far = this.distance;
    this.sky = new THREE.HemisphereLight(0xffffff, 0xffffff, 1);
    this.sun = new THREE.DirectionalLight(0xfff6e8, 1);
    this.sun.position.copy(this.target).addScaledVector(SUN, 2 * far);
    this.sun.target.position.copy(this.target);
    this.sun.castShadow = true;
    const box = this.sun.shadow.camera;
    [box.left, box.right, box.bottom, box.top, box.near, box.far] = [-far / 1.8, far / 1.8, -far / 1.8, far / 1.8, far / 2, 4 * far];
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.radius = 5;
    this.sun.shadow.bias = -0.0008;
    this.sun.shadow.normalBias = far * 0.004;
    this.shade = new THREE.ShadowMaterial({ toneMapped: false });
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(40 * far, 40 * far), this.shade);
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = true;
    floor.visible = !!this.hasFloor;
    this.scene.add(this.sky, this.sun, this.sun.target, floor);
  }

  // Colours of bodies and light, for light or dark pages.
  restyle() {
    COLOURS.forEach((name, k) => {
      const c = new THREE.Color(colour(this.figure, 'solid-' + name) || colour(this.figure, name));
      this.core.call('paint', k, c.r, c.g, c.b);
    });
    this.sky.groundColor.set(dark.matches ? 0x2a2622 : 0xb9b2a6);
    this.sky.color.set(dark.matches ? 0xb8c4d8 : 0xffffff);
    this.sky.intensity = dark.matches ? 1.1 : 1.7;
    this.sun.intensity = dark.matches ? 2.1 : 2.0;
    this.shade.opacity = dark.matches ? 0.5 : 0.2;
  }

  draw(lists) {
    this.mesh.show({ position: lists.place, normal: lists.normal, color: lists.tint, index: lists.corner });
    this.edges.show({ position: lists.edge, color: lists.edgeTint });
    this.balls.show(lists.ball);
    this.tubes.show(lists.tube);
    this.look();
  }

  look() {
    const { clientWidth: wide, clientHeight: high } = this.canvas;
    if (!wide || !high) return;
    const far = this.distance * (wide / high < NARROW ? 1.25 : 1), flat = Math.cos(this.rise);
    this.camera.aspect = wide / high;
    this.camera.updateProjectionMatrix();
    this.camera.position.set(Math.sin(this.turn) * flat, Math.sin(this.rise), Math.cos(this.turn) * flat)
      .multiplyScalar(far).add(this.target);
    this.camera.lookAt(this.target);
    this.renderer.render(this.scene, this.camera);
  }

  size() {
    this.renderer.setPixelRatio(Math.min(devicePixelRatio || 1, 2));
    this.renderer.setSize(this.stage.clientWidth, this.stage.clientHeight, false);
    this.look();
  }

  // --- Fingers and keys -----------------------------------------------------------
  ray(event) {
    const box = this.canvas.getBoundingClientRect(), caster = new THREE.Raycaster();
    caster.setFromCamera(new THREE.Vector2((event.clientX - box.left) / box.width * 2 - 1,
      1 - (event.clientY - box.top) / box.height * 2), this.camera);
    return caster.ray;
  }

  pick(event) {
    if (!this.core) return -1;
    const { origin, direction } = this.ray(event);
    return this.core.call('pick', ...origin, ...direction);
  }

  turnBy(across, up) {
    this.turn += across;
    this.rise = Math.min(1.5, Math.max(0.03, this.rise + up));
    this.look();
  }

  // What is under the finger is dragged in the plane that faces the eye.
  grab(event) {
    const number = this.pick(event);
    this.held = { number, x: event.clientX, y: event.clientY, gone: 0 };
    if (number < 0) return;
    const { origin, direction } = this.ray(event), normal = this.camera.getWorldDirection(new THREE.Vector3());
    const hit = origin.clone().addScaledVector(direction, this.core.peek().hit);
    this.held.plane = new THREE.Plane().setFromNormalAndCoplanarPoint(normal, hit);
  }

  drag(event) {
    const held = this.held, dx = event.clientX - held.x, dy = event.clientY - held.y;
    held.gone += Math.abs(dx) + Math.abs(dy);
    [held.x, held.y] = [event.clientX, event.clientY];
    if (held.gone <= STILL) return;
    if (held.number < 0) { this.turnBy(-dx * 0.008, event.pointerType === 'touch' ? 0 : dy * 0.008); return; }
    const to = this.ray(event).intersectPlane(held.plane, new THREE.Vector3());
    if (to) this.acted('move', held.number, to.x, to.y, to.z);
  }

  let(event) {
    const held = this.held;
    this.held = null;
    if (!held || held.number < 0) return;
    if (held.gone > STILL) this.acted('release', held.number);
    else if (event) this.acted('tap', held.number, ...this.ray(event).direction);
  }

  listen() {
    const canvas = this.canvas;
    canvas.addEventListener('pointerdown', event => { canvas.setPointerCapture(event.pointerId); this.grab(event); });
    canvas.addEventListener('pointermove', event => { if (this.held) this.drag(event); });
    canvas.addEventListener('pointerup', event => this.let(event));
    canvas.addEventListener('pointercancel', () => this.let(null));
    // A finger on nothing scrolls the page; on a body it holds it.
    canvas.addEventListener('touchstart', event => { if (this.pick(event.touches[0]) >= 0) event.preventDefault(); }, { passive: false });
    canvas.addEventListener('keydown', event => {
      const way = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
      if (!way) return;
      event.preventDefault();
      this.turnBy(...way);
    });
  }
}

window.tumble.Space = Space;
