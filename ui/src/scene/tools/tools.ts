import { computed, signal } from "@preact/signals";
import type { XY } from "./frames";
import { type MeasureTool, measured, POINTS_OF } from "./measure";

/** What a person has in the hand over the floor, and what it says. */
export class SceneTools {
  readonly tool = signal<MeasureTool | null>(null);
  /** Set points, world frame, metres. */
  readonly points = signal<readonly XY[]>([]);
  /** Where the next point would be. */
  readonly draft = signal<XY | null>(null);
  readonly follow = signal(false);
  readonly sensors = signal(false);
  readonly isDone = computed(() => {
    const { value: tool } = this.tool;
    return tool !== null && this.points.value.length >= POINTS_OF[tool];
  });
  /** The points with the one that is about to be set. */
  readonly shown = computed<readonly XY[]>(() => {
    const { value: draft } = this.draft;
    return draft && !this.isDone.value ? [...this.points.value, draft] : this.points.value;
  });
  readonly result = computed(() => {
    const { value: tool } = this.tool;
    return tool && measured(tool, this.shown.value);
  });

  /** Takes a tool, or puts it away where it is in the hand already. */
  take(tool: MeasureTool | null): void {
    this.tool.value = this.tool.peek() === tool ? null : tool;
    this.points.value = [];
    this.draft.value = null;
  }

  /** Sets a point; one more than there are begins anew. */
  set(point: XY): void {
    this.points.value = this.isDone.peek() ? [point] : [...this.points.peek(), point];
    this.draft.value = null;
  }
}
