import type { Robot, RunWithVersion } from "../api/model";
import { language } from "../i18n";
import type { RecordedStates } from "../run/recorded_states";
import { recentText } from "../run/text_sign";
import { spokenText } from "../run/values";
import type { Colours } from "../scene/colours";
import { contentBounds } from "../scene/framing/content_bounds";
import { EDGE, type Size } from "../scene/framing/viewport";
import type { Livery } from "../scene/livery/livery";
import { SceneRenderer } from "../scene/renderer";

/** A recorded run, and what its pictures show of its group. */
export interface PicturedRun {
  readonly run: RunWithVersion;
  readonly history: RecordedStates;
  readonly robot: Robot | null;
  readonly livery: Livery | null;
}

/** Least height of a floor, as a part of its width. */
const MIN_HEIGHT = 0.5;

/** The size of a floor of this width that shows a run without unused space above and below, at most a square. */
export function floorSize({ run, history }: PicturedRun, width: number): Size {
  const { left, right, top, bottom } = contentBounds(run.world_document, history.end);
  const scale = (width - EDGE.left - EDGE.right) / (right - left);
  const height = Math.round((top - bottom) * scale) + EDGE.top + EDGE.bottom;
  return { width, height: Math.min(width, Math.max(MIN_HEIGHT * width, height)) };
}

/** The floor of a recorded run at any of its ticks, drawn on one canvas that is not in the page. */
export class RecordedFloor {
  private tick = 0;
  private readonly renderer: SceneRenderer;
  private readonly picture: () => HTMLCanvasElement;

  constructor(
    private readonly of: PicturedRun,
    size: Size,
    ratio: number,
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
    this.picture = this.renderer.pictures(size, ratio, colours);
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
