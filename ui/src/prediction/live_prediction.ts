import { computed, effect, signal } from "@preact/signals";
import type { RunPrediction, World } from "../api/model";
import { predictionsApi } from "../api/real_runs";
import { shown } from "../run/inspected_tick";
import { live, liveRun } from "../run/live";
import { record } from "../run/live_record";
import { SIMULATOR } from "../run/real/real_robot";
import { isLive } from "../run/reducer";
import type { Companion } from "../scene/companion";
import { robotOf } from "../shell/session";
import { truthChanges } from "../truth/changes";
import { loadMeasured } from "../truth/load_measured";
import { ghostOf, withMeasured } from "./ghost";
import { isPredictionShown } from "./shown";

const loaded = signal<{ readonly run: string; readonly prediction: RunPrediction } | null>(null);

/** The path of the last run that a camera or the robot's localisation saw. */
const measured = signal<{ readonly run: string; readonly path: Companion["measured"] } | null>(
  null,
);

/** The run on a real robot that the page shows; null for none. */
const realRun = computed(() => {
  const { value: run } = liveRun;
  return run && run.link !== SIMULATOR && run.id === live.value.run ? run.id : null;
});

/** The prediction of the live run or of the last one; null in the simulator, and until it is computed. */
export const livePrediction = computed(() =>
  loaded.value?.run === realRun.value ? (loaded.value?.prediction ?? null) : null,
);

/** Changes with each input that a person gives, at the end of the run, and with what is measured then. */
const inputs = computed(() => {
  const { captured, output } = live.value;
  const answers = output.talk.filter(({ kind }) => kind === "answered").at(-1)?.number;
  return `${captured?.tick} ${answers} ${isLive(live.value)} ${truthChanges.value}`;
});

/** Asks for the prediction of each run on a real robot, and again when it can go on; returns its end. */
export function followPrediction(): () => void {
  let followed: string | null = null;
  return effect(() => {
    const run = realRun.value;
    inputs.value;
    if (run === followed && livePrediction.peek()?.awaits_input === false && isLive(live.peek()))
      return;
    followed = run;
    if (!run) return;
    void load(run, () => followed === run);
    if (!isLive(live.peek())) void loadPath(run, () => followed === run);
  });
}

async function loadPath(run: string, isFollowed: () => boolean): Promise<void> {
  const path = await loadMeasured(run);
  if (isFollowed()) measured.value = { run, path };
}

/** Without a prediction, such as one that the judge's process lost, the run goes on without its ghost. */
async function load(run: string, isFollowed: () => boolean): Promise<void> {
  const prediction = await predictionsApi.of(run).catch(() => null);
  if (prediction && isFollowed()) loaded.value = { run, prediction };
}

/**
 * The ghost of the live run, or at the moment of it that the group looks at, and the path that was measured; `world`
 * has its start.
 */
export function liveGhost(world: World | null): Companion | null {
  const path = measured.value?.run === realRun.value ? measured.value?.path : undefined;
  return withMeasured(predictedGhost(world), path, world);
}

function predictedGhost(world: World | null): Companion | null {
  const { value: prediction } = livePrediction;
  if (!prediction || !isPredictionShown.value) return null;
  const robot = robotOf(liveRun.value?.model);
  const { stretches } = record;
  return ghostOf({ prediction, world, robot, stretches, tick: shown.value.tick });
}
