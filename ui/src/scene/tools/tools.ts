import { computed, signal } from "@preact/signals";
import type { XY } from "../frames";
import { type MeasureTool, measured, POINTS_OF } from "./measure";

/** State of the measuring tools: the active tool, its points and its result. */
export class SceneTools {
  readonly tool = signal<MeasureTool | null>(null);
  /** The points set so far, world frame, metres. */
  readonly points = signal<readonly XY[]>([]);
  /** Preview of the next point. */
  readonly draft = signal<XY | null>(null);
  readonly follow = signal(false);
  readonly sensors = signal(false);
  readonly isDone = computed(() => {
    const { value: tool } = this.tool;
    return tool !== null && this.points.value.length >= POINTS_OF[tool];
  });
  /** The points and the preview. */
  readonly shown = computed<readonly XY[]>(() => {
    const { value: draft } = this.draft;
    return draft && !this.isDone.value ? [...this.points.value, draft] : this.points.value;
  });
  readonly result = computed(() => {
    const { value: tool } = this.tool;
    return tool && measured(tool, this.shown.value);
  });

  /** Activates a tool; the active one is deactivated. */
  toggle(tool: MeasureTool | null): void {
    this.tool.value = this.tool.peek() === tool ? null : tool;
    this.points.value = [];
    this.draft.value = null;
  }

  /** Sets a point; after the tool's last point, starts a new measurement. */
  set(point: XY): void {
    this.points.value = this.isDone.peek() ? [point] : [...this.points.peek(), point];
    this.draft.value = null;
  }
}
