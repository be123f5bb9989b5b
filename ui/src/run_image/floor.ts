import type { Robot, RunWithVersion } from "../api/model";
import { language } from "../i18n";
import type { RecordedStates } from "../run/recorded_states";
import { recentText } from "../run/text_sign";
import { spokenText } from "../run/values";
import type { Colours } from "../scene/colours";
import type { Livery } from "../scene/livery/livery";
import { SceneRenderer } from "../scene/renderer";

/** A recorded run, and what its pictures show of its group. */
export interface PicturedRun {
  readonly run: RunWithVersion;
  readonly history: RecordedStates;
  readonly robot: Robot | null;
  readonly livery: Livery | null;
}

/** The floor of a recorded run at any of its ticks, drawn on one canvas that is not in the page. */
export class RecordedFloor {
  private tick = 0;
  private readonly renderer: SceneRenderer;
  private readonly picture: () => HTMLCanvasElement;

  constructor(
    private readonly of: PicturedRun,
    [size, ratio]: readonly [number, number],
    colours: Colours,
  ) {
    const { run, history, robot, livery } = of;
    const poseNow = () => history.poseAt(this.tick);
    this.renderer = new SceneRenderer(document.createElement("canvas"), poseNow, () => true);
    this.renderer.resize(0, 0); // its own canvas is not shown
    this.renderer.setWorld(run.world_document);
    this.renderer.setRobot(robot);
    this.renderer.setLivery(livery);
    this.renderer.setView(history.end);
    this.picture = this.renderer.pictures({ width: size, height: size }, ratio, colours);
  }

  at(tick: number): HTMLCanvasElement {
    const { history } = this.of;
    this.tick = tick;
    const view = history.at(Math.floor(tick));
    const text = recentText(view);
    this.renderer.setView(view, history.end);
    this.renderer.sign((signs) =>
      signs.setText(text === null ? "" : spokenText(text, language.peek())),
    );
    return this.picture();
  }

  dispose(): void {
    this.renderer.dispose();
  }
}
