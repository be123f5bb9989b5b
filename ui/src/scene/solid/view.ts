import { Group, type Sprite } from "three";
import type { Robot, World } from "../../api/model";
import { IDLE, type Pose, type RunView } from "../../run/reducer";
import type { Point } from "../../run/trail";
import { BoxInterpolator } from "../box_interpolator";
import type { Bundle } from "../bundle/bundle";
import type { Colours } from "../colours";
import type { Companion } from "../companion";
import { startOf, toWorld } from "../frames";
import { contentBounds, wholeRoom } from "../framing/content_bounds";
import type { Size } from "../framing/viewport";
import type { Livery } from "../livery/livery";
import type { Measurements } from "../ranges_view";
import type { CameraMode } from "../tools/view_mode";
import { Belief } from "./belief";
import { BundleModel } from "./bundle_model";
import { Cameras } from "./cameras";
import { Fans } from "./fans";
import { FloorModel } from "./floor_model";
import { disposeSprite, labelSprite, sizeLabel } from "./labels";
import { type Atmosphere, readAtmosphere, readSolidColours } from "./materials";
import { FrameTimer, LAST_LEVEL, qualityOf } from "./quality";
import { type Lamp, RobotModel } from "./robot_model";
import { Shadow } from "./shadow";
import { Surface } from "./surface";
import { Trails } from "./trails";

/** Redraws continue for this time after the last change, until the interpolated pose has arrived; ms. */
const LINGER_MS = 250;
/** Height of the sign of a beep, pixels. */
const BEEP_PX = 34;

export interface SolidOptions {
  /** The robot's pose at a time of the screen's clock, start frame. */
  poseAt(now: number): Pose;
  /** Whether nothing may move by itself. */
  still(): boolean;
  /** Step of the quality to begin with. */
  readonly level: number;
  /** Called when frames take too long; the view has taken the step if it could do so itself. */
  onLevel(level: number): void;
  onFirstFrame(): void;
  /** Called instead of a frame that cannot be drawn. */
  onFailure(): void;
}

/** Who drives where. */
type Actors = Pick<Companion, "world" | "robot" | "livery">;

/** A run on the floor: what the robot and its path need besides the room. */
interface Runner {
  readonly frame: Group;
  readonly trails: Trails;
  readonly robot: RobotModel | null;
  readonly shadow: Shadow | null;
}

/** Draws the floor in 3D after a change, at most once per animation frame. */
export class SolidView {
  private readonly surface: Surface;
  private readonly cameras: Cameras;
  private readonly timer = new FrameTimer();
  private readonly boxInterpolator = new BoxInterpolator();
  private colours: Colours = readSolidColours();
  private atmosphere: Atmosphere = readAtmosphere(this.colours);
  private world: World | null = null;
  private robot: Robot | null = null;
  private livery: Livery | null = null;
  private view: RunView = IDLE;
  private whole: RunView = IDLE;
  private companion: Companion | null = null;
  private bundle: Bundle | null = null;
  private ranges: Measurements | null = null;
  private mode: CameraMode = "orbit";
  private level: number;
  private beepText = "";
  private floor: FloorModel | null = null;
  private runner: Runner | null = null;
  private ghost: Runner | null = null;
  private bundleModel: BundleModel | null = null;
  private fans: Fans | null = null;
  private belief: Belief | null = null;
  private beep: Sprite | null = null;
  private isStale = true;
  private isFramed = true;
  private isFirst = true;
  private handle = 0;
  private redrawUntil = 0;
  private lastFrame = 0;
  private follows = false;
  private size: Size = { width: 1, height: 1 };
  private magnification = 1;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly options: SolidOptions,
  ) {
    this.level = options.level;
    this.surface = new Surface(canvas, qualityOf(this.level));
    this.cameras = new Cameras(canvas, options.still, () => this.requestRedraw());
  }

  setWorld(world: World | null): void {
    if (world === this.world) return;
    const isOtherRoom = world === null || this.world?.walls !== world.walls;
    this.world = world;
    this.rebuild();
    if (isOtherRoom) this.cameras.reset();
  }

  setRobot(robot: Robot | null): void {
    if (robot === this.robot) return;
    this.robot = robot;
    this.rebuild();
  }

  setLivery(livery: Livery | null): void {
    const { colour, pattern } = this.livery ?? {};
    this.livery = livery;
    if (colour !== livery?.colour || pattern !== livery?.pattern) this.rebuild();
  }

  /** Draws a state of a run. The camera shows the path of `whole`. */
  setView(view: RunView, whole = view): void {
    this.view = view;
    this.whole = whole;
    this.isFramed = false;
    this.requestRedraw();
  }

  setCompanion(companion: Companion | null): void {
    const isOther =
      companion?.robot !== this.companion?.robot || companion?.world !== this.companion?.world;
    this.companion = companion;
    this.isFramed = false;
    if (isOther) this.rebuild();
    else this.requestRedraw();
  }

  setBundle(bundle: Bundle | null): void {
    this.bundle = bundle;
    this.bundleModel?.show(bundle);
    this.requestRedraw();
  }

  setRanges(ranges: Measurements | null): void {
    this.ranges = ranges;
    this.fans?.show(ranges);
    this.requestRedraw();
  }

  /** Sets the text at the robot while it beeps; "" while it does not. */
  setBeep(text: string): void {
    this.beepText = text;
    if (this.beep) disposeSprite(this.beep);
    const { tile, ink, font } = this.colours;
    this.beep = text ? labelSprite(text, { ink: tile, ground: ink, edge: tile, font }) : null;
    if (this.beep) {
      this.beep.position.z = (this.runner?.robot?.heights.eye ?? 0) + 0.05;
      this.runner?.robot?.group.add(this.beep);
    }
    this.requestRedraw();
  }

  setTheme(): void {
    this.colours = readSolidColours();
    this.atmosphere = readAtmosphere(this.colours);
    this.rebuild();
  }

  setCamera(mode: CameraMode): void {
    this.mode = mode;
    this.cameras.setMode(mode);
    this.isFramed = false;
    this.requestRedraw();
  }

  /** `magnification` is how much larger than usual texts are. */
  resize(width: number, height: number, magnification = 1): void {
    if (width === 0 || height === 0) return; // a hidden pane has no size
    this.surface.resize([width, height]);
    this.size = { width, height };
    this.magnification = magnification;
    this.cameras.resize(this.size);
    this.requestRedraw();
  }

  zoom(factor: number): void {
    this.cameras.zoom(factor);
    this.requestRedraw();
  }

  turn(left: number, up: number): void {
    this.cameras.turn(left, up);
    this.requestRedraw();
  }

  /** Shows everything from where the camera begins. */
  frame(): void {
    this.isFramed = false;
    this.cameras.reset();
    this.requestRedraw();
  }

  /** Draws the view as it is on a new canvas, for export. */
  picture({ width, height }: Size, ratio: number): HTMLCanvasElement {
    const { camera } = this.cameras;
    this.cameras.resize({ width, height });
    const picture = this.surface.picture(camera, [width * ratio, height * ratio]);
    this.cameras.resize(this.size);
    this.requestRedraw();
    return picture;
  }

  dispose(): void {
    cancelAnimationFrame(this.handle);
    this.clear();
    this.cameras.dispose();
    this.surface.dispose();
  }

  private rebuild(): void {
    this.isStale = true;
    this.isFramed = false;
    this.requestRedraw();
  }

  private requestRedraw(): void {
    this.redrawUntil = performance.now() + LINGER_MS;
    this.handle ||= requestAnimationFrame((now) => this.tick(now));
  }

  private tick(now: number): void {
    this.handle = 0;
    if (this.follows) this.measure(now - this.lastFrame);
    let moving = false;
    try {
      moving = this.draw(now);
    } catch {
      this.options.onFailure();
      return;
    }
    this.follows = moving || now < this.redrawUntil;
    if (this.follows) this.handle ||= requestAnimationFrame((next) => this.tick(next));
  }

  /** Goes down a step if frames take too long. Only another canvas could change its antialiasing. */
  private measure(gapMs: number): void {
    if (!this.timer.isTooSlow(gapMs) || this.level >= LAST_LEVEL) return;
    const before = qualityOf(this.level);
    this.level++;
    const quality = qualityOf(this.level);
    this.options.onLevel(this.level);
    if (quality.antialias !== before.antialias) return;
    this.surface.setQuality(quality);
    if (quality.floor[0] !== before.floor[0]) this.rebuild();
    this.showShadows();
  }

  /** Draws a frame; returns whether something still moves by itself. */
  draw(now: number): boolean {
    if (this.isStale) this.build();
    if (!this.isFramed) this.frameContent();
    const elapsed = Math.min(50, now - this.lastFrame);
    this.lastFrame = now;
    const still = this.options.still();
    const pushing = this.boxInterpolator.approach(this.view.boxes, elapsed, still);
    this.floor?.moveBoxes(this.boxInterpolator.poses);
    const pose = this.options.poseAt(now);
    this.place(this.runner, this.view, pose);
    if (this.companion) this.place(this.ghost, this.companion.view, this.companion.pose());
    this.ghost?.trails.showMeasured(this.companion?.measured);
    this.belief?.show(this.view, pose);
    const turning = this.moveCamera(pose, elapsed);
    const pixel = this.cameras.pixel * this.magnification;
    this.floor?.arrangeNames(this.cameras.camera, pixel);
    if (this.beep) sizeLabel(this.beep, BEEP_PX * pixel);
    this.surface.render(this.cameras.camera);
    if (this.isFirst) this.options.onFirstFrame();
    this.isFirst = false;
    return pushing || turning;
  }

  private place(runner: Runner | null, view: RunView, pose: Pose): void {
    if (!runner) return;
    const end: Point | null = view.run ? [pose.x, pose.y] : null;
    runner.trails.show(view, end);
    runner.robot?.moveTo(pose);
    runner.robot?.shine(lampOf(view, runner === this.runner && this.beepText !== ""));
    runner.shadow?.follow();
  }

  private moveCamera(pose: Pose, elapsed: number): boolean {
    const { robot } = this;
    const model = this.runner?.robot;
    if (model) model.group.visible = this.mode !== "eye";
    if (this.runner?.shadow) this.showShadows();
    if (!robot || !model) return false;
    const start = startOf(this.world);
    const here = { ...toWorld(start, pose.x, pose.y), yaw: start.yaw + pose.yaw };
    return this.cameras.follow(here, [robot.radius_m, model.heights.eye], elapsed);
  }

  private frameContent(): void {
    this.isFramed = true;
    const { world, whole, companion } = this;
    this.cameras.setSubject(world ? wholeRoom(world) : contentBounds(world, whole, companion));
  }

  private build(): void {
    this.clear();
    this.isStale = false;
    const { world, robot, colours, atmosphere } = this;
    this.surface.setAtmosphere(atmosphere);
    this.floor = new FloorModel(world, robot, colours, atmosphere, qualityOf(this.level));
    this.surface.scene.add(this.floor.group);
    this.bundleModel = new BundleModel(colours);
    this.bundleModel.show(this.bundle);
    this.surface.scene.add(this.bundleModel.group);
    this.runner = this.runnerOf({ world, robot, livery: this.livery }, false);
    const { companion } = this;
    this.ghost = companion && this.runnerOf(companion, true);
    if (robot && this.runner.robot) {
      this.fans = new Fans(robot, this.runner.robot.heights, colours);
      this.fans.show(this.ranges);
      this.runner.robot.group.add(this.fans.group);
      this.belief = new Belief(robot, colours);
      this.runner.frame.add(this.belief.group);
    }
    this.showShadows();
    if (this.beepText) this.setBeep(this.beepText);
  }

  private runnerOf({ world, robot, livery }: Actors, isGhost: boolean): Runner {
    const { colours, atmosphere } = this;
    const start = startOf(world);
    const frame = new Group();
    frame.position.set(start.x, start.y, 0);
    frame.rotation.z = start.yaw;
    const trails = new Trails(colours, { isDashed: isGhost });
    const model = robot && new RobotModel(robot, colours, atmosphere, livery, isGhost);
    const side = 2 * (robot?.radius_m ?? 0);
    const shadow =
      model && !isGhost && !atmosphere.isOutlined
        ? new Shadow(model.group, [side, side], colours)
        : null;
    frame.add(trails.group);
    if (model) frame.add(model.group);
    if (shadow) frame.add(shadow.mesh);
    this.surface.scene.add(frame);
    return { frame, trails, robot: model, shadow };
  }

  private showShadows(): void {
    const { shadows } = qualityOf(this.level);
    this.floor?.showShadows(shadows);
    if (this.runner?.shadow) this.runner.shadow.mesh.visible = shadows && this.mode !== "eye";
  }

  private clear(): void {
    if (this.beep) disposeSprite(this.beep);
    this.beep = null;
    for (const part of [this.floor, this.bundleModel, this.fans, this.belief]) part?.dispose();
    for (const runner of [this.runner, this.ghost]) {
      runner?.trails.dispose();
      runner?.shadow?.dispose();
      runner?.robot?.dispose();
      runner?.frame.removeFromParent();
    }
  }
}

const lampOf = ({ phase }: RunView, isBeeping: boolean): Lamp => {
  if (isBeeping) return "beeping";
  return phase === "running" ? "running" : "off";
};
