import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { JudgedEvent, Robot } from "../api/model";
import { between } from "../run/motion_buffer";
import { IDLE, type Pose } from "../run/reducer";
import type { Companion } from "../scene/companion";
import { prefersStill } from "../shell/theme";

export type JudgedCase = JudgedEvent["cases"][number];

/** Duration of the animation in ms, whatever time the run took. */
const PLAYED_MS = 3000;

/** The robot in a further case of the judge, which drives over the floor beside the group's own run. */
export class Ghost {
  readonly shown = signal<JudgedCase | null>(null);
  readonly companion = computed<Companion | null>(() => {
    const { value: judgedCase } = this.shown;
    if (!judgedCase) return null;
    const pose = poseAt(judgedCase.path, this.part.value);
    const n = Math.round(this.part.value * (judgedCase.path.length - 1));
    const tail = judgedCase.path.slice(0, n + 1).map(([x, y]) => [x, y] as const);
    return {
      world: null, // its poses are in the world frame
      robot: this.robot.value,
      livery: null,
      view: { ...IDLE, run: judgedCase.given, path: { chunks: [], tail } },
      pose: () => pose,
    };
  });
  /** The completed part of the animation, 0 to 1. */
  private readonly part = signal(0);
  private handle = 0;

  constructor(private readonly robot: ReadonlySignal<Robot | null>) {}

  /** Shows the robot of a case, or hides it if it is shown. */
  toggle(judgedCase: JudgedCase): void {
    const isShown = this.shown.peek() === judgedCase;
    this.hide();
    if (isShown) return;
    this.part.value = prefersStill() ? 1 : 0;
    this.shown.value = judgedCase;
    const begin = performance.now();
    const step = (now: number) => {
      this.part.value = Math.min(1, Math.max(0, now - begin) / PLAYED_MS);
      if (this.part.value < 1) this.handle = requestAnimationFrame(step);
    };
    if (this.part.value < 1) this.handle = requestAnimationFrame(step);
  }

  hide(): void {
    cancelAnimationFrame(this.handle);
    this.shown.value = null;
  }
}

/** The pose at a part of a path, interpolated. */
export function poseAt(path: JudgedCase["path"], part: number): Pose {
  const at = part * (path.length - 1);
  const before = Math.floor(at);
  const [from, to] = [poseOf(path[before]), poseOf(path[before + 1] ?? path[before])];
  return between(from, to, at - before);
}

function poseOf(values: JudgedCase["path"][number] | undefined): Pose {
  const [x = 0, y = 0, yaw = 0] = values ?? [];
  return { x, y, yaw };
}
