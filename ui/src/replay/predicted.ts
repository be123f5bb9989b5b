import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { RunPrediction, RunWithVersion } from "../api/model";
import { predictionsApi } from "../api/real_runs";
import type { Fault } from "../editor";
import { language, texts } from "../i18n";
import { useInstance } from "../kit/instance";
import { problemOf } from "../kit/requests/problem";
import { ghostOf, withMeasured } from "../prediction/ghost";
import { isPredictionShown } from "../prediction/shown";
import { predictionText } from "../prediction/words";
import { SIMULATOR } from "../run/real/real_robot";
import { isLive } from "../run/reducer";
import type { Companion } from "../scene/companion";
import { robotOf } from "../shell/session";
import { truthChanges } from "../truth/changes";
import { loadMeasured } from "../truth/load_measured";
import type { RecordedRun } from "./recorded_run";

/** The prediction of a recorded run, while it is shown. */
export interface Predicted {
  readonly prediction: ReadonlySignal<RunPrediction | null>;
  /** Why a run on a real robot has no prediction; "" before the answer, and with a prediction. */
  readonly problem: ReadonlySignal<string>;
  readonly companion: ReadonlySignal<Companion | null>;
  /** What the robot did otherwise, at its block, at the end of the run. */
  readonly advice: ReadonlySignal<readonly Fault[]>;
}

class PredictedRun implements Predicted {
  readonly prediction = signal<RunPrediction | null>(null);
  readonly problem = signal("");
  readonly companion = computed(() => {
    const { run, playback, stretches } = this.recordedRun;
    const { value: prediction } = this.shown;
    const [world, robot] = [run.world_document, robotOf(run.model)];
    const ghost =
      prediction && ghostOf({ prediction, world, robot, stretches, tick: playback.tick.value });
    return withMeasured(ghost, this.measured.value, world);
  });
  readonly advice = computed<readonly Fault[]>(() => {
    const { value: prediction } = this.shown;
    const block = prediction?.difference.findings[0]?.block;
    if (!prediction || !block || isLive(this.recordedRun.playback.view.value)) return [];
    const voice = { texts: texts.value, language: language.value };
    return [{ block, message: predictionText(prediction, voice), remedy: "", isQuiet: true }];
  });
  private readonly shown = computed(() => (isPredictionShown.value ? this.prediction.value : null));

  /** The path that a camera or the robot's localisation saw. */
  private readonly measured = signal<Companion["measured"]>(undefined);

  constructor(private readonly recordedRun: RecordedRun) {}

  /** Loads the path that was measured. Without it, the run is shown as it is. */
  async loadMeasured(): Promise<void> {
    this.measured.value = await loadMeasured(this.recordedRun.run.id);
  }

  async load(): Promise<void> {
    try {
      this.prediction.value = await predictionsApi.of(this.recordedRun.run.id);
    } catch (error) {
      const { message, remedy } = problemOf(error);
      this.problem.value = `${message} ${remedy}`.trim();
    }
  }
}

/** Loads the prediction of a run on a real robot; nothing of a simulated one. */
export function usePredicted(recordedRun: RecordedRun): Predicted {
  const predicted = useInstance(() => new PredictedRun(recordedRun));
  useEffect(() => {
    if (!isOfRealRobot(recordedRun.run)) return;
    void predicted.load();
    void predicted.loadMeasured();
  }, [predicted, truthChanges.value]);
  return predicted;
}

export const isOfRealRobot = ({ link }: Pick<RunWithVersion, "link">) => link !== SIMULATOR;
