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

// 1 and 0 from square to square, and between them where they are too small to be seen.
const BANDS = `float band(float x) {
  return clamp((abs(fract(0.5 * x) - 0.5) - 0.25) * 2.0 / max(fwidth(x), 1e-4) + 0.5, 0.0, 1.0); }`;

// What covers a surface (live_weave): the squares and threads of a cloth, or tiles.
function covered(look) {
  look.onBeforeCompile = shader => {
    shader.vertexShader = 'attribute vec3 weave; varying vec3 woven;\n' +
      shader.vertexShader.replace('#include <begin_vertex>', '#include <begin_vertex>\nwoven = weave;');
    shader.fragmentShader = `varying vec3 woven;\n${BANDS}
      vec3 cover(vec3 tint) {
        float across = band(woven.x), along = band(woven.y);
        if (woven.z > 1.5) return tint * (1.0 - 0.09 * abs(across - along));
        vec2 thread = woven.xy * 15.0, wide = fwidth(thread);
        float fine = 1.0 - smoothstep(0.25, 0.6, max(wide.x, wide.y)), over = sin(6.2832 * thread.x) * sin(6.2832 * thread.y);
        vec3 cloth = mix(pow(tint, vec3(0.5)), 0.85 * tint, 0.5 * (across + along)) * (1.0 - 0.12 * fine * (0.5 + 0.5 * over));
        return woven.z > 0.5 ? cloth : tint;
      }
` + shader.fragmentShader.replace('#include <color_fragment>', '#include <color_fragment>\ndiffuseColor.rgb = cover(diffuseColor.rgb);');
  };
  return look;
}

// The floor: tiles of a metre (or of a part of one), that fade before its edge, so that
// there is a horizon, and no end.
function groundLook(far) {
  const every = far > 8 ? 1 : far > 2.5 ? 0.5 : far > 0.8 ? 0.125 : 0.025;
  return new THREE.ShaderMaterial({
    transparent: true, depthWrite: false, extensions: { derivatives: true },
    uniforms: { tone: { value: 0 }, far: { value: far }, every: { value: every }, ink: { value: new THREE.Color() }, light: { value: new THREE.Color() } },
    vertexShader: `varying vec3 at; varying vec2 flat_at; void main() {
      vec4 w = modelMatrix * vec4(position, 1.0); at = w.xyz; flat_at = position.xy; gl_Position = projectionMatrix * viewMatrix * w; }`,
    fragmentShader: `varying vec3 at; varying vec2 flat_at; uniform float far, every; uniform vec3 ink, light; uniform float tone; ${BANDS}
      void main() {
        float tile = abs(band(at.x / every) - band(at.z / every)), fade = 1.0 - smoothstep(0.35 * far, 1.6 * far, length(flat_at));
        gl_FragColor = vec4(mix(light, ink, tone * tile), fade);
        #include <colorspace_fragment>
      }`,
  });
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
  constructor(scene, geometry, size, place, look = {}) {
    Object.assign(this, { scene, geometry, size, place, look, room: 0 });
  }
  show(list) {
    const count = list.length / this.size;
    if (count > this.room) {
      if (this.node) { this.scene.remove(this.node); this.node.dispose(); }
      this.room = 2 * count;
      this.node = new THREE.InstancedMesh(this.geometry, material(this.look), this.room);
      this.node.castShadow = this.node.receiveShadow = !this.look.transparent;
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

// All that a figure draws, or the pale twin of it, which throws no shadow.
class Drawing {
  constructor(scene, look = {}) {
    const pale = look.transparent;
    this.mesh = new Growing(scene, THREE.Mesh, covered(material({ vertexColors: true, ...look })), {});
    this.mesh.node.castShadow = this.mesh.node.receiveShadow = !pale;
    this.edges = new Growing(scene, THREE.LineSegments, new THREE.LineBasicMaterial({ vertexColors: true, transparent: true, opacity: pale ? 0.3 : 0.7, toneMapped: false }), {});
    this.balls = new Many(scene, BALL, 8, ballPose, look);
    this.tubes = new Many(scene, TUBE, 11, tubePose, look);
  }
  show(lists) {
    this.mesh.show({ position: lists.place, normal: lists.normal, color: lists.tint, weave: lists.weave, index: lists.corner });
    this.edges.show({ position: lists.edge, color: lists.edgeTint });
    this.balls.show(lists.ball);
    this.tubes.show(lists.tube);
  }
}

const BALL = new THREE.SphereGeometry(1, 32, 20), TUBE = new THREE.CylinderGeometry(1, 1, 1, 20);
const PALE = { transparent: true, opacity: 0.3, depthWrite: false };
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
    const [distance, turn, rise, x, y, z, hasFloor, low] = panel.camera;
    Object.assign(this, { figure, stage, distance, turn, rise, target: new THREE.Vector3(x, y, z), hasFloor, low, isTapped: panel.ground, zoom: 1, fingers: new Map() });
    this.canvas = make('canvas', { tabindex: 0, role: 'img', 'aria-label': panel.says + '. Arrow keys turn the view, + and - change its size.' });
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(34, 1, distance / 50, distance * 20);
    this.light();
    this.all = new Drawing(this.scene);
    stage.append(this.canvas);
    this.listen();
    new ResizeObserver(() => this.size()).observe(this.canvas);
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
    this.overhead();
    this.shade = new THREE.ShadowMaterial({ toneMapped: false });
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(40 * far, 40 * far), this.shade);
    this.ground = new THREE.Mesh(new THREE.CircleGeometry(1.6 * far, 96), groundLook(far));
    for (const node of [floor, this.ground]) {
      node.rotation.x = -Math.PI / 2;
      node.visible = !!this.hasFloor;
    }
    this.ground.renderOrder = -1;
    this.ground.position.set(this.target.x, this.low, this.target.z);
    floor.position.y = this.low;
    floor.receiveShadow = true;
    this.scene.add(this.sky, this.sun, this.sun.target, floor, this.ground);
  }

  // The sky straight above throws the soft shadow by which one sees what touches.
  overhead() {
    const far = this.distance, box = (this.above = new THREE.DirectionalLight(0xffffff, 1)).shadow.camera;
    this.above.position.copy(this.target).addScaledVector(UP, 2 * far);
    this.above.target.position.copy(this.target);
    this.above.castShadow = !!this.hasFloor;
    [box.left, box.right, box.bottom, box.top, box.near, box.far] = [-far / 2, far / 2, -far / 2, far / 2, far / 2, 4 * far];
    this.above.shadow.mapSize.set(512, 512);
    this.above.shadow.radius = 9;
    this.above.shadow.bias = -0.001;
    this.above.shadow.normalBias = far * 0.006;
    this.scene.add(this.above, this.above.target);
  }

  // Colours of bodies and light, for light or dark pages.
  restyle() {
    COLOURS.forEach((name, k) => {
      const c = new THREE.Color(colour(this.figure, 'solid-' + name) || colour(this.figure, name));
      for (const core of [this.core, this.ghost]) core?.call('paint', k, c.r, c.g, c.b);
    });
    this.ground.material.uniforms.ink.value.set(colour(this.figure, 'quiet'));
    this.ground.material.uniforms.tone.value = dark.matches ? 0.03 : 0.085;
    this.ground.material.uniforms.light.value.set(colour(this.figure, 'floor'));
    this.renderer.setClearColor(colour(this.figure, 'stage'), 1);
    this.sky.groundColor.set(dark.matches ? 0x2a2622 : 0xb9b2a6);
    this.sky.color.set(dark.matches ? 0xb8c4d8 : 0xffffff);
    this.sky.intensity = dark.matches ? 1.0 : 1.6;
    this.above.intensity = dark.matches ? 0.5 : 0.75;
    this.sun.intensity = dark.matches ? 1.9 : 1.7;
    this.shade.opacity = dark.matches ? 0.42 : 0.24;
  }

  draw(lists, ghost) {
    this.all.show(lists);
    if (ghost) (this.pale ||= new Drawing(this.scene, PALE)).show(ghost);
    this.look();
  }

  look() {
    const { clientWidth: wide, clientHeight: high } = this.canvas;
    if (!wide || !high) return;
    const far = this.distance / this.zoom * (wide / high < NARROW ? 1.25 : 1), flat = Math.cos(this.rise);
    this.camera.aspect = wide / high;
    this.camera.updateProjectionMatrix();
    this.camera.position.set(Math.sin(this.turn) * flat, Math.sin(this.rise), Math.cos(this.turn) * flat)
      .multiplyScalar(far).add(this.target);
    this.camera.lookAt(this.target);
    this.renderer.render(this.scene, this.camera);
  }

  size() {
    this.renderer.setPixelRatio(Math.min(devicePixelRatio || 1, 2));
    this.renderer.setSize(this.canvas.clientWidth, this.canvas.clientHeight, false);
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

  zoomBy(times) {
    this.zoom = Math.min(4, Math.max(0.5, this.zoom * times));
    this.look();
  }

  // Two fingers: their distance is the zoom.
  pinch(event) {
    const apart = () => { const [a, b] = this.fingers.values(); return Math.hypot(a[0] - b[0], a[1] - b[1]); };
    const before = apart();
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    this.zoomBy(apart() / (before || 1));
  }

  // What is under the finger is dragged in the plane that faces the eye.
  grab(event) {
    const number = this.pick(event);
    this.held = { number, x: event.clientX, y: event.clientY, gone: 0 };
    if (number < 0) return;
    const { origin, direction } = this.ray(event), normal = this.camera.getWorldDirection(new THREE.Vector3());
    const hit = origin.clone().addScaledVector(direction, this.core.peek().hit);
    this.held.hit = hit;
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
    if (!held) return;
    if (held.number < 0) { if (event && held.gone <= STILL && this.isTapped) this.tapFloor(event); return; }
    if (held.gone > STILL) this.acted('release', held.number);
    else if (event) this.acted('tap', held.number, ...this.ray(event).direction, ...held.hit);
  }

  tapFloor(event) {
    const ray = this.ray(event), at = ray.intersectPlane(new THREE.Plane(UP, -this.low), new THREE.Vector3());
    if (at && at.distanceTo(this.target) < this.distance) this.acted('tap', -1, ...ray.direction, ...at);
  }

  listen() {
    const canvas = this.canvas;
    canvas.addEventListener('pointerdown', event => {
      canvas.setPointerCapture(event.pointerId);
      this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
      if (this.fingers.size === 1) this.grab(event); else this.let(null);
    });
    canvas.addEventListener('pointermove', event => {
      if (this.fingers.size === 2 && this.fingers.has(event.pointerId)) this.pinch(event);
      else if (this.held) this.drag(event);
    });
    const up = event => { this.fingers.delete(event.pointerId); this.let(event.type === 'pointerup' ? event : null); };
    canvas.addEventListener('pointerup', up);
    canvas.addEventListener('pointercancel', up);
    // The wheel turns pages; with Ctrl, or where nothing else is to be seen, it zooms.
    canvas.addEventListener('wheel', event => {
      if (!event.ctrlKey && !document.fullscreenElement) return;
      event.preventDefault();
      this.zoomBy(Math.exp(-event.deltaY * 0.002));
    }, { passive: false });
    // A finger on nothing scrolls the page; on a body it holds it.
    canvas.addEventListener('touchstart', event => { if (event.touches.length > 1 || this.pick(event.touches[0]) >= 0) event.preventDefault(); }, { passive: false });
    canvas.addEventListener('keydown', event => {
      const times = { '+': 1.15, '=': 1.15, '-': 1 / 1.15 }[event.key];
      if (times) { this.zoomBy(times); return; }
      const way = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
      if (!way) return;
      event.preventDefault();
      this.turnBy(...way);
    });
  }
}

window.tumble.Space = Space;
