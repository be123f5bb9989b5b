// The same room drawn by the page's view and by three.js alone, a frame of each in turn.
import {
  AmbientLight,
  BoxGeometry,
  CanvasTexture,
  CylinderGeometry,
  DirectionalLight,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PlaneGeometry,
  Scene,
  SphereGeometry,
  Sprite,
  SpriteMaterial,
  WebGLRenderer,
} from "three";
import type { Robot, World } from "../../../ui/src/api/model";
import { fetchTexts } from "../../../ui/src/i18n";
import "../../../ui/src/kit/tokens.css";
import { IDLE, type Pose } from "../../../ui/src/run/reducer";
import { wholeRoom } from "../../../ui/src/scene/framing/content_bounds";
import { BOX_SOLIDS, chestOf, type Solid, wallOf } from "../../../ui/src/scene/mat/solids";
import { Cameras } from "../../../ui/src/scene/solid/cameras";
import { extend } from "../../../ui/src/run/trail";
import { drawGroundTexture } from "../../../ui/src/scene/solid/floor_texture";
import { readSolidColours } from "../../../ui/src/scene/solid/materials";
import { SolidView } from "../../../ui/src/scene/solid/view";
import "virtual:texts/pt-BR/start";

const poseAt = (frame: number): Pose => ({ x: 0.5 + 0.004 * frame, y: 0.1, yaw: 0.002 * frame });

function pageFloor(canvas: HTMLCanvasElement, world: World, robot: Robot): (frame: number) => void {
  let pose = poseAt(0);
  let view = { ...IDLE, run: "bench", phase: "running" as const };
  const solid = new SolidView(canvas, {
    poseAt: () => pose,
    still: () => false,
    level: 2,
    onLevel: () => {},
    onFirstFrame: () => {},
    onFailure: () => {
      throw new Error("a frame failed");
    },
  });
  solid.setWorld(world);
  solid.setRobot(robot);
  solid.resize(640, 480);
  return (frame) => {
    pose = poseAt(frame);
    view = { ...view, tick: frame, truth: pose, pose, path: extend(view.path, [pose.x, pose.y]) };
    solid.setView(view);
    solid.draw(performance.now());
  };
}

/** The same bodies, names and sky, each as three.js has it: a mesh for each body, a picture as background. */
function bareFloor(canvas: HTMLCanvasElement, world: World, robot: Robot): (frame: number) => void {
  const renderer = new WebGLRenderer({ canvas, antialias: false });
  renderer.setSize(640, 480, false);
  const cameras = new Cameras(canvas, () => true, () => {});
  cameras.setSubject(wholeRoom(world));
  cameras.resize({ width: 640, height: 480 });
  const scene = new Scene();
  scene.background = new CanvasTexture(drawn(4, 256, "#bfe0f2"));
  const sun = new DirectionalLight();
  sun.position.set(-0.45, 0.75, 1.2);
  scene.add(new AmbientLight(), sun);
  const [width, depth] = world.size_m as [number, number];
  const map = new CanvasTexture(drawGroundTexture(world, robot, readSolidColours(), 1024));
  scene.add(new Mesh(new PlaneGeometry(width, depth), new MeshBasicMaterial({ map })));
  for (const wall of world.walls) scene.add(bareWall(wall));
  for (const box of world.boxes) scene.add(bareBox(box));
  for (const { center } of world.zones) {
    const name = new Sprite(new SpriteMaterial({ map: new CanvasTexture(drawn(160, 66, "#ffffff")) }));
    name.position.set(center[0] ?? 0, center[1] ?? 0, 0.1);
    name.scale.set(0.6, 0.25, 1);
    scene.add(name);
  }
  const body = bareRobot(robot);
  scene.add(body);
  return (frame) => {
    const { x, y, yaw } = poseAt(frame);
    body.position.set(world.start.x_m + x, world.start.y_m + y, 0);
    body.rotation.z = yaw;
    renderer.render(scene, cameras.camera);
  };
}

function drawn(width: number, height: number, colour: string): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  const ctx = canvas.getContext("2d") as CanvasRenderingContext2D;
  ctx.fillStyle = colour;
  ctx.fillRect(0, 0, width, height);
  return canvas;
}

function bareWall({ from: [ax = 0, ay = 0], to: [bx = 0, by = 0] }: World["walls"][number]): Group {
  const wall = bareBodies(wallOf("#998c72")(Math.hypot(bx - ax, by - ay), 0.09));
  wall.position.set((ax + bx) / 2, (ay + by) / 2, 0);
  wall.rotation.z = Math.atan2(by - ay, bx - ax);
  return wall;
}

function bareBox({ kind, center, size, heading_deg }: World["boxes"][number]): Group {
  const [width = 0, depth = 0] = size;
  const box = bareBodies((kind ? BOX_SOLIDS[kind] : chestOf("#dcc9a6", "#b79f73"))(width, depth));
  box.position.set(center[0] ?? 0, center[1] ?? 0, 0);
  box.rotation.z = (heading_deg * Math.PI) / 180;
  return box;
}

function bareBodies(solids: readonly Solid[]): Group {
  const group = new Group();
  for (const { form, at, size, fill } of solids) {
    const shape = form === "ball" ? new SphereGeometry(0.5, 14, 10) : new BoxGeometry();
    const mesh = new Mesh(shape, new MeshLambertMaterial({ color: fill }));
    mesh.scale.set(...size);
    mesh.position.set(at[0], at[1], at[2] + size[2] / 2);
    group.add(mesh);
  }
  return group;
}

function bareRobot({ radius_m, wheels }: Robot): Group {
  const robot = new Group();
  const hull = new Mesh(new BoxGeometry(2 * radius_m, 1.4 * radius_m, 0.15), new MeshLambertMaterial({ color: "#9b1c1f" }));
  hull.position.z = 0.14;
  robot.add(hull);
  for (const wheel of wheels) {
    const shape = new CylinderGeometry(wheel.radius_m, wheel.radius_m, wheel.width_m, 24);
    const mesh = new Mesh(shape, new MeshLambertMaterial({ color: "#2a2727" }));
    mesh.position.set(wheel.x_m, wheel.y_m, wheel.radius_m);
    robot.add(mesh);
  }
  return robot;
}

/** Waits until the graphics card has drawn: only then may the picture be read. */
function finished(canvas: HTMLCanvasElement): void {
  const gl = canvas.getContext("webgl2");
  gl?.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
}

await fetchTexts("pt-BR");

/** Milliseconds of each frame, of the page's view and of the bare one. */
async function measure(world: World, robot: Robot, frames: number): Promise<[number[], number[]]> {
  const views = (["floor", "bare"] as const).map((id, index) => {
    const canvas = document.getElementById(id) as HTMLCanvasElement;
    const draw = (index === 0 ? pageFloor : bareFloor)(canvas, world, robot);
    return { canvas, draw, times: [] as number[] };
  });
  for (let frame = 0; frame < frames; frame++) {
    for (const { canvas, draw, times } of views) {
      const before = performance.now();
      draw(frame);
      finished(canvas);
      times.push(performance.now() - before);
    }
  }
  return views.map(({ times }) => times) as [number[], number[]];
}

Object.assign(window, { measure });
