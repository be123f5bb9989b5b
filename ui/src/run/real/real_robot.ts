import { computed, effect, signal } from "@preact/signals";
import type { RealRobot } from "../../api/model";
import { robotsApi } from "../../api/robots";
import { group } from "../../shell/session";
import { live, liveRun, stop } from "../live";
import { isLive } from "../reducer";
import { haltKeys, joggedLink } from "./jog";

/**
 * The link of the simulator, which every page starts with: no real robot moves because somebody
 * chose it earlier.
 */
export const SIMULATOR = "sim";

/** The name of the room's world document in the list of runs: pinel_desktop/robot/robot_profile.py. */
export const ROOM_WORLD = "room";

/** The kinds of real robots, as in the server's last response. */
export const realRobots = signal<readonly RealRobot[]>([]);

const choice = signal(SIMULATOR);

/** Whether the group has gone through the check list since it chose the robot. */
export const isChecked = signal(false);

/** Whether a run on the chosen robot has started: the first run is slow. */
const hasRun = signal(false);

/** The real robot of the next run; null for the simulator. */
export const chosenRobot = computed<RealRobot | null>(
  () => realRobots.value.find((one) => one.link === choice.value && one.is_set_up) ?? null,
);

/**
 * Link of the real robot that may move: of the live run, else the chosen robot, else the jogged
 * one. Null if all is simulated.
 */
export const activeRealLink = computed<string | null>(() => {
  const run = isLive(live.value) ? liveRun.value : null;
  if (run && run.link !== SIMULATOR) return run.link;
  return chosenRobot.value?.link ?? joggedLink.value;
});

export function chooseRobot(link: string): void {
  choice.value = link;
  isChecked.value = false;
  hasRun.value = false;
}

/**
 * Id of the group that chose. Another group must choose its robot and go through the check list
 * itself: no real robot moves because of an earlier group.
 */
let chosenBy: string | null = null;
effect(() => {
  const here = group.value?.id ?? null;
  if (here !== chosenBy) chooseRobot(SIMULATOR);
  chosenBy = here;
});

export async function loadRealRobots(): Promise<void> {
  realRobots.value = await robotsApi.all();
}

/** Options of a run request for the chosen robot; empty for the simulator. */
export function robotOfRun(): { robot?: string; slow?: boolean } {
  const robot = chosenRobot.peek();
  return robot ? { robot: robot.link, slow: !hasRun.peek() } : {};
}

/** Records that a run on the chosen robot has started. */
export function robotHasRun(): void {
  if (chosenRobot.peek()) hasRun.value = true;
}

/** Maximum speed of the next run on the chosen robot, m/s; 0 for the simulator. */
export const nextSpeed = computed(() => {
  const { value: robot } = chosenRobot;
  if (!robot) return 0;
  return hasRun.value ? robot.max_v_mps : robot.slow_v_mps;
});

/** The key that stops a real robot on every screen. */
export const EMERGENCY_KEY = "F9";

/** Stops the live run and the jogged robot, before anything else. */
export async function emergencyStop(): Promise<void> {
  const jogged = joggedLink.peek();
  await Promise.all([stop(), jogged && haltKeys(jogged)]);
}
