import { batch, computed, type ReadonlySignal } from "@preact/signals";
import type { Robot, Start, World } from "../api/model";
import { inspectedTick } from "../run/inspected_tick";
import * as robot from "../run/live";
import { chosenRobot } from "../run/real/real_robot";
import { isLive } from "../run/reducer";
import { startOf, toWorld } from "../scene/frames";
import type { RobotHold } from "../scene/Scene";
import { onTurn, turned } from "../scene/tools/measure";
import { shownRanges } from "../scene/tools/sensor_rings";
import type { OpenProgram } from "./program/open_program";

interface WorldSource {
  readonly world: ReadonlySignal<World | null>;
}

/** The start pose of the robot in a program: from the world, or set by dragging. */
export class StartChoice {
  /** The chosen start; null for the start of the world. */
  readonly start = computed<Start | null>(() =>
    this.open.mission.value || chosenRobot.value ? null : (this.open.setup.value.start ?? null),
  );
  /** The world with the effective start. */
  readonly world = computed<World | null>(() => {
    const { value: world } = this.worldSource.world;
    const { value: run } = robot.liveRun;
    if (!world) return null;
    const shown = robot.live.value.run !== null;
    const ran = shown && run && "world_document" in run ? run.world_document : null;
    if (ran) return { ...world, start: ran.start };
    return this.start.value ? { ...world, start: this.start.value } : world;
  });
  /** Whether a run is on the floor, or a start was chosen. */
  readonly canReset = computed(() => {
    const { value: view } = robot.live;
    return !isLive(view) && (view.run !== null || this.start.value !== null);
  });

  constructor(
    private readonly open: OpenProgram,
    private readonly worldSource: WorldSource,
  ) {}

  /** Current pose of the robot, as a start; null if it cannot be moved: in a run, a mission, at a past tick. */
  readonly hereNow = computed<Start | null>(() => {
    const { value: view } = robot.live;
    const { value: world } = this.world;
    if (isLive(view) || inspectedTick.value || !world || this.open.mission.value) return null;
    if (chosenRobot.value) return null; // a person puts a real robot at its start in the room
    if (view.run === null) return world.start;
    const start = startOf(world);
    const { x, y } = toWorld(start, view.truth.x, view.truth.y);
    const heading = ((start.yaw + view.truth.yaw) * 180) / Math.PI;
    return { x_m: x, y_m: y, heading_deg: turned(onTurn(heading)) };
  });

  /** Sets the start and clears the run from the floor. */
  put(start: Start): void {
    if (isLive(robot.live.peek())) return;
    batch(() => {
      if (robot.live.peek().run !== null) robot.clear();
      this.setStart(start);
    });
  }

  /** Resets the run; without a run, resets the start to the world's. */
  again(): void {
    if (robot.live.peek().run !== null) robot.clear();
    else this.setStart(null);
  }

  private setStart(start: Start | null): void {
    this.open.changeSetup({ start });
  }
}

/** Handling of the robot on the floor: dragging, sensors. */
export function holdOf(start: StartChoice, model: ReadonlySignal<Robot | null>): RobotHold {
  return {
    grip: computed(() => ({
      world: start.world.value,
      here: start.hereNow.value,
      isAtStart: robot.live.value.phase === "idle" && start.hereNow.value !== null,
      put: (newStart) => start.put(newStart),
    })),
    canReset: start.canReset,
    ranges: shownRanges(
      () => start.world.value,
      () => model.value,
    ),
    again: () => start.again(),
  };
}
