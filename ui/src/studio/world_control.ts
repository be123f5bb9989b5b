import { batch, computed, signal } from "@preact/signals";
import { DEFAULT_WORLD } from "../api/declared";
import { OWN_WORLD, type World } from "../api/model";
import { texts } from "../i18n";
import * as robot from "../run/live";
import { chosenRobot } from "../run/real/real_robot";
import { isLive } from "../run/reducer";
import { worlds } from "../shell/session";
import { EditorStore } from "../world_editor/editor_store";
import type { OpenProgram } from "./program/open_program";

/** Selects the world of a program's runs: a shipped one or the group's own. */
export class WorldControl {
  /** The own world that the group has just deleted, for undo. */
  readonly forgotten = signal<World | null>(null);
  /** The editor's store while the editor is open. */
  readonly store = signal<EditorStore | null>(null);
  private lastStore: EditorStore | null = null;

  /** The activity that determines the world; null if the group chooses it. */
  readonly mission = computed(() => this.open.mission.value);
  readonly name = computed(() => {
    const { value: run } = robot.liveRun;
    if (run && isLive(robot.live.value)) return run.world;
    if (this.mission.value) return this.mission.value.world;
    const { world } = this.open.setup.value;
    return this.isThere(world) ? world : DEFAULT_WORLD;
  });
  readonly world = computed<World | null>(() => {
    const { value: run } = robot.liveRun;
    if (run && isLive(robot.live.value) && "world_document" in run) return run.world_document;
    if (chosenRobot.value) return chosenRobot.value.world;
    if (this.mission.value) return this.mission.value.goal_picture.world;
    if (this.name.value === OWN_WORLD) return this.open.ownWorld.now.value;
    return worlds.value.find((world) => world.name === this.name.value) ?? null;
  });
  /** Whether the selected world has faults, so that the server would reject it. */
  readonly isFaulty = computed(
    () => !chosenRobot.value && this.name.value === OWN_WORLD && this.open.ownWorld.isRefused.value,
  );
  /** Whether a change in the editor would replace the group's own world. */
  readonly replaces = computed(
    () =>
      this.store.value !== null &&
      this.open.setup.value.world !== OWN_WORLD &&
      this.open.ownWorld.now.value !== null,
  );

  constructor(private readonly open: OpenProgram) {}

  /** Selects a world, with its own start. */
  choose(name: string): void {
    batch(() => {
      this.open.changeSetup({ world: name, start: null });
      robot.clear();
    });
  }

  /** Opens the selected world in the editor. A shipped world opens as a copy, stored at its first change. */
  edit(): void {
    const world = this.world.peek();
    if (!world || isLive(robot.live.peek())) return;
    if (this.name.peek() === OWN_WORLD) this.store.value = this.storeOf(world);
    else this.store.value = this.newStore(copyOf(world), this.open.ownWorld.now.peek());
  }

  editOwn(): void {
    this.choose(OWN_WORLD);
    this.edit();
  }

  done(): void {
    this.store.value = null;
  }

  forget(): void {
    batch(() => {
      this.forgotten.value = this.open.ownWorld.now.peek();
      this.done();
      this.open.setWorld(null);
      this.choose(DEFAULT_WORLD);
    });
  }

  bringBack(): void {
    const { value: world } = this.forgotten;
    if (world) this.setOwnWorld(world);
  }

  /** Whether a world exists: a world of a newer release and a deleted own world do not. */
  private isThere(name: string): boolean {
    if (name === OWN_WORLD) return this.open.ownWorld.now.value !== null;
    return worlds.value.length === 0 || worlds.value.some((world) => world.name === name);
  }

  /** The last store, with its undo history, if nothing else has changed the world; else a new store. */
  private storeOf(world: World): EditorStore {
    return this.lastStore?.document.peek() === world ? this.lastStore : this.newStore(world);
  }

  private newStore(world: World, before: World | null = null): EditorStore {
    const store = new EditorStore(world, (document) => this.setOwnWorld(document), before);
    store.faults.subscribe((faults) => {
      if (faults.length > 0) this.open.ownWorld.refuse(store.document.peek());
    });
    this.lastStore = store;
    return store;
  }

  private setOwnWorld(world: World): void {
    batch(() => {
      this.forgotten.value = null;
      this.open.setWorld(world);
      this.open.changeSetup({ world: OWN_WORLD });
      robot.clear();
    });
  }
}

const copyOf = (world: World): World => ({
  ...world,
  name: OWN_WORLD,
  title: texts.peek().world.own,
});
