import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Pose } from "../../run/reducer";
import type { Box } from "../frames";
import type { Size } from "../framing/viewport";
import type { CameraMode } from "../tools/view_mode";

const FIELD_DEG = 42;
const NEAR_M = 0.04;
const FAR_M = 300;
/** Nearest distance that is drawn, as a part of that to the middle: a coarser depth mixes layers on the floor. */
const NEAR_PART = 0.08;
/** Largest distance of the camera, metres: the whole room on a narrow screen. */
const MAX_M = 100;
/**
 * Angles over the floor from which the camera begins, radians: the first one from which the room fills the height. It is
 * always south of the room, so that right and left are those of the drawing from above.
 */
const TILTS = [0.75, 0.88, 1.02, 1.15];
/** Part of the free height that counts as filled. */
const FILLED = 0.86;
/** Where buttons lie over the picture, pixels. */
const EDGE = { left: 14, right: 66, top: 66, bottom: 62 };
/** On a lower picture they lie over the room, which would be too small otherwise; pixels. */
const LOW_PX = 400;
/** Highest point that the picture must show, metres. */
const HEAD_M = 0.4;

/** Behind the robot: distance and height over it, in radii of the robot, so that walls do not hide it. */
const BEHIND = 5.8;
const ABOVE = 5.8;
/** Time constant with which the camera turns with the robot, ms. */
const TURN_MS = 320;

const EYE_FIELD_DEG = 62;
/** How far the robot's eye looks down, radians. */
const EYE_DOWN = 0.12;

const TURN_STEP = Math.PI / 24;
const ZOOM_STEP = 1.2;

/** The camera of the floor in 3D: it orbits the room, follows the robot, or is the robot's eye. */
export class Cameras {
  readonly camera = new PerspectiveCamera(FIELD_DEG, 1, NEAR_M, FAR_M);
  private readonly orbit: OrbitControls;
  private mode: CameraMode = "orbit";
  private subject: Box = { left: -4, right: 4, bottom: -4, top: 4 };
  /** Whether a person moved the camera: it then stays where it is. */
  private isManual = false;
  private heading: number | null = null;
  private size: Size = { width: 1, height: 1 };

  constructor(
    canvas: HTMLCanvasElement,
    private readonly still: () => boolean,
    onChange: () => void,
  ) {
    this.camera.up.set(0, 0, 1);
    this.orbit = new OrbitControls(this.camera, canvas);
    Object.assign(this.orbit, {
      minDistance: 0.5,
      maxDistance: MAX_M,
      maxPolarAngle: 1.52,
      zoomSpeed: 0.9,
    });
    this.orbit.addEventListener("start", () => {
      this.isManual = true;
    });
    this.orbit.addEventListener("change", onChange);
    this.reset();
  }

  /** Chooses the part of the floor that the camera shows until a person moves it. */
  setSubject(subject: Box): void {
    this.subject = subject;
    if (!this.isManual && this.mode === "orbit") this.reset();
  }

  setMode(mode: CameraMode): void {
    if (mode === this.mode) return;
    this.mode = mode;
    this.reset();
  }

  resize(size: Size): void {
    this.size = size;
    this.camera.aspect = size.width / size.height;
    this.centrePicture();
    if (!this.isManual && this.mode === "orbit") this.reset();
  }

  /** Shows everything again from where the camera begins. */
  reset(): void {
    this.isManual = false;
    this.heading = null;
    this.orbit.enabled = this.mode !== "eye";
    this.orbit.enablePan = this.mode === "orbit";
    this.camera.fov = this.mode === "eye" ? EYE_FIELD_DEG : FIELD_DEG;
    this.centrePicture();
    if (this.mode === "orbit") this.showSubject();
  }

  /** Size of a pixel at one metre before the camera, metres. */
  get pixel(): number {
    return (2 * Math.tan((this.camera.fov * Math.PI) / 360)) / this.size.height;
  }

  zoom(factor: number): void {
    if (this.mode === "eye") return;
    this.isManual = true;
    if (factor > 1) this.orbit.dollyIn(factor);
    else this.orbit.dollyOut(1 / factor);
  }

  /** Turns the camera around what it shows, to the left and up, in steps. */
  turn(left: number, up: number): void {
    if (this.mode === "eye") return;
    this.isManual = true;
    this.orbit.rotateLeft(left * TURN_STEP);
    this.orbit.rotateUp(up * TURN_STEP);
  }

  zoomStep(direction: 1 | -1): void {
    this.zoom(ZOOM_STEP ** direction);
  }

  /**
   * Moves the camera with the robot; world frame. Returns true while it has not arrived.
   *
   * @param radius - radius of the robot, metres.
   * @param eye - height of its eye, metres.
   */
  follow(pose: Pose, [radius, eye]: readonly [number, number], elapsedMs: number): boolean {
    if (this.mode === "eye") this.toEye(pose, radius, eye);
    const moving = this.mode === "follow" && this.chase(pose, radius, elapsedMs);
    this.setNear();
    return moving;
  }

  dispose(): void {
    this.orbit.dispose();
  }

  private setNear(): void {
    const distance = this.camera.position.distanceTo(this.orbit.target);
    const near = this.mode === "eye" ? NEAR_M : Math.max(NEAR_M, NEAR_PART * distance);
    if (near === this.camera.near) return;
    this.camera.near = near;
    this.camera.updateProjectionMatrix();
  }

  private toEye({ x, y, yaw }: Pose, radius: number, height: number): void {
    const ahead = [Math.cos(yaw), Math.sin(yaw)] as const;
    this.camera.position.set(x + 0.5 * radius * ahead[0], y + 0.5 * radius * ahead[1], height);
    const down = Math.tan(EYE_DOWN);
    this.camera.lookAt(x + 9 * ahead[0], y + 9 * ahead[1], height - 9 * down);
  }

  private chase({ x, y, yaw }: Pose, radius: number, elapsedMs: number): boolean {
    const { target } = this.orbit;
    const middle = new Vector3(x, y, radius);
    if (this.heading === null) {
      const back = BEHIND * radius;
      const offset = new Vector3(-back * Math.cos(yaw), -back * Math.sin(yaw), ABOVE * radius);
      target.copy(middle);
      this.camera.position.copy(middle).add(offset);
      this.heading = yaw;
      this.orbit.update();
      return false;
    }
    this.camera.position.add(middle).sub(target);
    target.copy(middle);
    const turn = Math.atan2(Math.sin(yaw - this.heading), Math.cos(yaw - this.heading));
    const isThere = Math.abs(turn) < 0.002;
    // the picture does not turn for who prefers that nothing swings
    const part = this.still() ? 0 : isThere ? 1 : 1 - Math.exp(-elapsedMs / TURN_MS);
    this.heading += turn * part;
    if (part > 0 && turn !== 0) this.orbit.rotateLeft(-turn * part);
    else this.orbit.update();
    return !isThere && part > 0;
  }

  /** Moves the middle of the picture to where no buttons lie; the robot's eye has the whole picture. */
  private centrePicture(): void {
    const { width, height } = this.size;
    const edge = this.edge;
    const [right, down] = [(edge.right - edge.left) / 2, (edge.bottom - edge.top) / 2];
    if (this.mode === "eye") this.camera.clearViewOffset();
    else this.camera.setViewOffset(width, height, right, down, width, height);
    this.camera.updateProjectionMatrix();
  }

  /** Shows the whole subject, as large as possible. */
  private showSubject(): void {
    const { left, right, bottom, top } = this.subject;
    const middle = new Vector3((left + right) / 2, (bottom + top) / 2, 0);
    const corners = [left, right].flatMap((x) =>
      [bottom, top].flatMap((y) => [0, HEAD_M].map((z) => new Vector3(x, y, z))),
    );
    for (const tilt of TILTS) if (this.isFilled(corners, middle, tilt)) break;
    this.orbit.target.copy(middle);
    this.orbit.update();
  }

  /** Goes as near as the subject allows; returns whether it fills the height. */
  private isFilled(corners: readonly Vector3[], subject: Vector3, tilt: number): boolean {
    let [near, far] = [0.5, MAX_M];
    for (let round = 0; round < 16; round++) {
      const distance = (near + far) / 2;
      if (this.isInPicture(corners, subject.clone(), distance, tilt)) far = distance;
      else near = distance;
    }
    const { low, high } = this.centre(corners, subject, far, tilt);
    return high - low > FILLED * this.free[1];
  }

  private isInPicture(
    corners: readonly Vector3[],
    middle: Vector3,
    distance: number,
    tilt: number,
  ) {
    const { low, high, side } = this.centre(corners, middle, distance, tilt);
    const [width, height] = this.free;
    return high - low < height && 2 * side < width;
  }

  private get edge(): typeof EDGE {
    const part = Math.min(1, this.size.height / LOW_PX) ** 2;
    return { ...EDGE, top: EDGE.top * part, bottom: EDGE.bottom * part };
  }

  /** Width and height of the picture without the buttons, from -1 to 1 as a camera counts. */
  private get free(): readonly [number, number] {
    const { width, height } = this.size;
    const { left, right, top, bottom } = this.edge;
    return [
      2 * Math.max(0.2, 1 - (left + right) / width),
      2 * Math.max(0.2, 1 - (top + bottom) / height),
    ];
  }

  /** Moves the middle so that the space above and below the room is alike. */
  private centre(corners: readonly Vector3[], middle: Vector3, distance: number, tilt: number) {
    for (let round = 0; round < 3; round++) {
      const { low, high } = this.extentOf(corners, middle, distance, tilt);
      const off = (low + high) / 2 - (this.edge.bottom - this.edge.top) / this.size.height;
      middle.y += (off * distance * Math.tan((FIELD_DEG * Math.PI) / 360)) / Math.sin(tilt);
    }
    return this.extentOf(corners, middle, distance, tilt);
  }

  private extentOf(corners: readonly Vector3[], middle: Vector3, distance: number, tilt: number) {
    this.camera.position
      .set(0, -Math.cos(tilt), Math.sin(tilt))
      .multiplyScalar(distance)
      .add(middle);
    this.camera.lookAt(middle);
    this.camera.updateMatrixWorld();
    const places = corners.map((corner) => corner.clone().project(this.camera));
    const heights = places.map(({ y }) => y);
    const middleX = (this.edge.left - this.edge.right) / this.size.width;
    return {
      low: Math.min(...heights),
      high: Math.max(...heights),
      side: Math.max(...places.map(({ x }) => Math.abs(x - middleX))),
    };
  }
}
