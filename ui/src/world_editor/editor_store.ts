import { batch, computed, signal } from "@preact/signals";
import type { Fault, World } from "../api/model";
import type { XY } from "../scene/frames";
import type { BoxKind } from "../scene/mat/boxes";
import type { Ground } from "../scene/mat/grounds";
import type { PrintKind } from "../scene/mat/prints";
import { aboutOf, documentOf, planOf } from "./document";
import {
  type DragGesture,
  doubled,
  drawing,
  freeName,
  moving,
  type NextObjectOptions,
  nudged,
  pulling,
  type Tool,
  tapped,
} from "./drag_gestures";
import {
  type FloorPlan,
  isOuter,
  objectOf,
  removeObject,
  replaceObject,
  resized,
  type Start,
  type WorldObject,
} from "./plan";
import { UndoHistory } from "./undo_history";

/** State of the world editor: the plan, the selection, and the history for undo. */
export class EditorStore {
  private readonly plan = signal<FloorPlan>(EMPTY);
  /** Preview of the plan during a drag. */
  private readonly draft = signal<FloorPlan | null>(null);
  readonly shown = computed(() => this.draft.value ?? this.plan.value);
  readonly world = computed<World>(() => documentOf(this.shown.value));
  readonly document = computed<World>(() => documentOf(this.plan.value));
  readonly tool = signal<Tool>("select");
  /** Id of the selected object, or "start"; null without a selection. */
  readonly selected = signal<string | null>(null);
  readonly color = signal("red");
  readonly movable = signal(false);
  readonly boxKind = signal<BoxKind | null>(null);
  readonly print = signal<PrintKind>("street");
  readonly faults = signal<readonly Fault[]>([]);
  /** Counts the changes, so that `canUndo` and `canRedo` are computed again. */
  private readonly changes = signal(0);
  readonly canUndo = computed(() => this.changes.value >= 0 && this.history.canUndo);
  readonly canRedo = computed(() => this.changes.value >= 0 && this.history.canRedo);
  private readonly history = new UndoHistory<FloorPlan>();
  private gesture: DragGesture | null = null;

  /** `before` is the world that this one replaces; the first undo restores it. */
  constructor(
    world: World,
    private readonly onChange: (document: World) => void,
    before: World | null = null,
  ) {
    this.plan.value = planOf(world);
    if (before) this.history.push(planOf(before));
  }

  /** Whether the world has only a floor and outer walls. */
  get isBare(): boolean {
    const plan = this.shown.value;
    return plan.objects.every((object) => isOuter(plan, object));
  }

  /** The subject of a fault: an object's id, "start", or null for the world. */
  aboutFault(fault: Fault): string | null {
    return aboutOf(this.plan.value, fault.pointer);
  }

  choose(tool: Tool): void {
    batch(() => {
      this.tool.value = tool;
      if (tool === "start") this.selected.value = "start";
      else if (tool !== "select") this.selected.value = null;
    });
  }

  select(id: string | null): void {
    this.selected.value = id;
    this.history.rest();
  }

  /** Commits a changed plan; see UndoHistory for `stroke`. */
  change(plan: FloorPlan, stroke: string | null = null): void {
    if (plan === this.plan.value) return;
    this.history.push(this.plan.value, stroke);
    this.put(plan);
  }

  /** Replaces the world; undo restores the previous one. */
  replace(world: World, title: World["title"] = this.plan.value.title): void {
    batch(() => {
      const { name } = this.plan.value;
      this.change({ ...planOf(world), name, title });
      this.selected.value = null;
    });
  }

  begin(gesture: DragGesture): void {
    this.gesture = gesture;
  }

  /** Starts a drag at a point: with a handle, on an object, or on the floor. */
  grip(target: { id?: string; handle?: string }, at: XY): void {
    const plan = this.plan.value;
    const tool = this.tool.value;
    if (target.handle && this.selected.value) {
      this.begin(pulling(plan, this.selected.value, target.handle));
    } else if (tool !== "select") {
      this.begin(drawing(plan, tool, at, this.nextObjectOptions()));
    } else {
      this.select(target.id ?? null);
      if (target.id) this.begin(moving(plan, target.id, at));
    }
  }

  get isGripping(): boolean {
    return this.gesture !== null;
  }

  drag(at: XY, free: boolean): void {
    if (this.gesture) this.draft.value = this.gesture(at, free);
  }

  /** Ends a drag; without movement it counts as a tap. */
  endDrag(at: XY, hasMoved: boolean): void {
    const { value: draft } = this.draft;
    const tool = this.tool.value;
    this.cancel();
    if (hasMoved && draft) this.settle(draft);
    else if (!hasMoved && tool !== "select" && tool !== "wall") this.putDown(at);
  }

  cancel(): void {
    this.gesture = null;
    this.draft.value = null;
  }

  /** Places an object of the current tool in its default size. */
  putDown(at: XY): void {
    this.settle(tapped(this.plan.value, this.tool.value, at, this.nextObjectOptions()));
  }

  /** Commits a plan and selects its new object. */
  private settle(plan: FloorPlan): void {
    batch(() => {
      const before = this.plan.value;
      const last = plan.objects.at(-1);
      this.change(plan);
      if (last && plan.objects.length > before.objects.length) this.selected.value = last.id;
    });
  }

  nudge(dx: number, dy: number): void {
    const { value: id } = this.selected;
    if (id) this.change(nudged(this.plan.value, id, dx, dy), `nudge ${id}`);
  }

  remove(): void {
    const { value: id } = this.selected;
    if (!objectOf(this.plan.value, id) || !id) return;
    batch(() => {
      this.change(removeObject(this.plan.value, id));
      this.selected.value = null;
    });
  }

  double(): void {
    const object = objectOf(this.plan.value, this.selected.value);
    if (!object) return;
    const [plan, id] = doubled(this.plan.value, object);
    batch(() => {
      this.change(plan);
      this.selected.value = id;
    });
  }

  /** Moves an object above, or below, all others of its kind. */
  layer(top: boolean): void {
    const plan = this.plan.value;
    const object = objectOf(plan, this.selected.value);
    if (!object) return;
    const { objects } = removeObject(plan, object.id);
    this.change({ ...plan, objects: top ? [...objects, object] : [object, ...objects] });
  }

  /** Sets the colour of the next objects and of the selected painted area. */
  setPaint(color: string): void {
    const object = objectOf(this.plan.value, this.selected.value);
    batch(() => {
      this.color.value = color;
      if (object?.kind === "paint")
        this.change(replaceObject(this.plan.value, { ...object, color }));
    });
  }

  /** Replaces an object by a copy with other properties. */
  alter(object: WorldObject, stroke: string | null = null): void {
    this.change(replaceObject(this.plan.value, object), stroke);
  }

  setStart(start: Start, stroke: string | null = null): void {
    this.change({ ...this.plan.value, start }, stroke);
  }

  resize({ width, depth }: { width: number; depth: number }): void {
    this.change(resized(this.plan.value, width, depth), "floor");
  }

  cover(ground: Ground | null): void {
    this.change({ ...this.plan.value, ground });
  }

  rename(newTitle: string): void {
    this.change({ ...this.plan.value, title: newTitle }, "title");
  }

  undo(): void {
    this.back(this.history.undo(this.plan.value));
  }

  redo(): void {
    this.back(this.history.redo(this.plan.value));
  }

  private back(plan: FloorPlan): void {
    this.cancel();
    if (plan !== this.plan.value) this.put(plan);
  }

  private put(plan: FloorPlan): void {
    batch(() => {
      this.plan.value = plan;
      this.changes.value++;
      const { value: id } = this.selected;
      if (id !== "start" && !objectOf(plan, id)) this.selected.value = null;
    });
    this.onChange(this.document.value);
  }

  private nextObjectOptions(): NextObjectOptions {
    return {
      color: this.color.value,
      movable: this.movable.value,
      boxKind: this.boxKind.value,
      print: this.print.value,
      name: freeName(this.plan.value),
    };
  }
}

const EMPTY: FloorPlan = {
  name: "",
  title: "",
  width: 8,
  depth: 8,
  ground: null,
  start: { x: 0, y: 0, heading: 0 },
  objects: [],
};
