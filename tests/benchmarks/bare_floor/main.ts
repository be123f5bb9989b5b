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
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  WebGLRenderer,
} from "three";
import type { Robot, World } from "../../../ui/src/api/model";
import { fetchTexts } from "../../../ui/src/i18n";
import "../../../ui/src/kit/tokens.css";
import { IDLE, type Pose } from "../../../ui/src/run/reducer";
import { extend } from "../../../ui/src/run/trail";
import { drawGroundTexture } from "../../../ui/src/scene/solid/floor_texture";
import { readSolidColours } from "../../../ui/src/scene/solid/materials";
import { SolidView } from "../../../ui/src/scene/solid/view";
import "virtual:texts/pt-BR/start";

const WALL_M = 0.35;

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

function bareFloor(canvas: HTMLCanvasElement, world: World, robot: Robot): (frame: number) => void {
  const renderer = new WebGLRenderer({ canvas, antialias: false });
  renderer.setSize(640, 480, false);
  const camera = new PerspectiveCamera(42, 640 / 480, 0.04, 90);
  camera.up.set(0, 0, 1);
  camera.position.set(0, -7.4, 8.3);
  camera.lookAt(0, -0.4, 0);
  const scene = new Scene();
  const sun = new DirectionalLight();
  sun.position.set(-0.45, 0.75, 1.2);
  scene.add(new AmbientLight(), sun);
  const [width, depth] = world.size_m as [number, number];
  const map = new CanvasTexture(drawGroundTexture(world, robot, readSolidColours(), 1024));
  scene.add(new Mesh(new PlaneGeometry(width, depth), new MeshBasicMaterial({ map })));
  const box = (x: number, y: number, yaw: number, size: [number, number, number]) => {
    const mesh = new Mesh(new BoxGeometry(...size), new MeshLambertMaterial({ color: "#998c72" }));
    mesh.position.set(x, y, size[2] / 2);
    mesh.rotation.z = yaw;
    scene.add(mesh);
  };
  for (const { from: [ax, ay], to: [bx, by] } of world.walls as unknown as { from: number[]; to: number[] }[]) {
    const yaw = Math.atan2(by - ay, bx - ax);
    box((ax + bx) / 2, (ay + by) / 2, yaw, [Math.hypot(bx - ax, by - ay), 0.09, WALL_M]);
  }
  for (const { center, size, heading_deg } of world.boxes) {
    box(center[0] ?? 0, center[1] ?? 0, (heading_deg * Math.PI) / 180, [size[0] ?? 0, size[1] ?? 0, WALL_M]);
  }
  const body = bareRobot(robot);
  scene.add(body);
  return (frame) => {
    const { x, y, yaw } = poseAt(frame);
    body.position.set(world.start.x_m + x, world.start.y_m + y, 0);
    body.rotation.z = yaw;
    renderer.render(scene, camera);
  };
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
