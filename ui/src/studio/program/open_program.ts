import { computed, effect, type Signal, signal } from "@preact/signals";
import { activitiesApi } from "../../api/activities";
import { api } from "../../api/client";
import { ApiError, ServerUnreachable } from "../../api/errors";
import type {
  Activity,
  EditorContent,
  Fault,
  ProgramWithVersion,
  SavedVersion,
  Setup,
  World,
} from "../../api/model";
import { route } from "../../shell/route";
import { changed, group, program, report } from "../../shell/session";
import { Autosave } from "./autosave";
import { OwnWorld } from "./own_world";
import { setupOf } from "./setup";
import { VersionLineage } from "./version_lineage";
import { Windows } from "./windows";

/** Whether a program document has any command. */
export function hasCommands(document: unknown): boolean {
  const { commands } = (document ?? {}) as { commands?: unknown[] };
  return (commands ?? []).length > 0;
}

/** The open program, shared by header, editor and run bar. */
export class OpenProgram {
  readonly autosave: Autosave;
  readonly content = signal<EditorContent | null>(null);
  readonly faults = signal<Fault[]>([]);
  readonly ownWorld: OwnWorld;
  /** The activity of the program; null without one, or if only a newer release knows it. */
  readonly mission = signal<Activity | null>(null);
  /** Names of the activities that the group has passed, as far as known; of a program with an activity only. */
  readonly passed = signal<ReadonlySet<string>>(new Set());
  /** World, robot and other settings of the program's runs. */
  readonly setup: Signal<Setup>;
  /** Whether another window deleted the program or its group for good; the screen keeps its content. */
  readonly deleted = signal<"program" | "group" | null>(null);
  readonly inBin: Signal<boolean>;
  readonly windows: Windows;
  private readonly lineage = new VersionLineage();
  private readonly stopEffects: (() => void)[];

  constructor(readonly program: ProgramWithVersion) {
    const { id, version } = program;
    this.inBin = signal(program.deleted_at !== null);
    this.windows = new Windows(version?.id ?? null);
    this.setup = signal(setupOf(version));
    this.ownWorld = new OwnWorld(id, version?.world ?? null, api.checkWorld);
    this.autosave = new Autosave(
      (content, last) =>
        this.ownWorld.saveWith(
          content.world ?? null,
          (world) => this.saveVersion({ ...content, world }, last),
          last,
        ),
      version,
    );
    this.stopEffects = [
      effect(() => {
        this.faults.value = this.autosave.version.value?.faults ?? [];
        if (this.autosave.state.value === "deleted") void this.onDeleted();
      }),
      this.listen(),
    ];
  }

  get id(): string {
    return this.program.id;
  }

  /** Sets the content of the stored version, as the editor shows it, before any edit. */
  begin(content: EditorContent): void {
    this.content.value = content;
    if (this.program.version) this.setStoredVersion(this.program.version.id);
  }

  /** Records that a version stores the current content: the next edit has that version as its parent. */
  setStoredVersion(version: string): void {
    const { value: content } = this.content;
    if (content) this.lineage.add(this.whole(content), version);
  }

  edit(content: EditorContent): void {
    this.content.value = content;
    this.save();
  }

  /** Sets the program's own world; null removes it. */
  setWorld(world: World | null): void {
    this.ownWorld.now.value = world;
    this.save();
  }

  async loadMission(): Promise<void> {
    const { activity } = this.setup.peek();
    if (!activity) return;
    const [mission, tried] = await Promise.all([
      knownActivity(activity),
      activitiesApi.tried(this.program.group_id).catch(() => []), // the mission is there all the same
    ]);
    this.addPassed(...tried.filter(({ passed }) => passed).map(({ name }) => name));
    this.mission.value = mission;
  }

  /** A pass is never taken back: a response may be older than the pass. */
  addPassed(...names: string[]): void {
    this.passed.value = new Set([...this.passed.peek(), ...names]);
  }

  /** Changes settings of the program's runs. */
  changeSetup(changes: Partial<Setup>): void {
    this.setup.value = { ...this.setup.peek(), ...changes };
    this.save();
  }

  /** Whether the program has no command. */
  get isEmpty(): boolean {
    return !hasCommands(this.content.value?.document);
  }

  close(): void {
    for (const stop of this.stopEffects) stop();
    this.ownWorld.close();
    this.autosave.dispose();
  }

  /** Finds out whether the program or its group was deleted, and removes it from the header. */
  private async onDeleted(): Promise<void> {
    const groups = await api.groups().catch(() => null);
    const isGroupHere = groups?.some(({ id }) => id === this.program.group_id) ?? true;
    this.deleted.value = isGroupHere ? "program" : "group";
    if (opened.peek() !== this) return;
    program.value = null;
    if (!isGroupHere) group.value = null;
  }

  private async saveVersion(content: EditorContent, last: boolean): Promise<SavedVersion> {
    // A closing page may send before the response to its last save. Without a parent in the
    // request, the server takes the newest version as the parent.
    const parent = this.windows.isSending ? undefined : this.lineage.of(content);
    const saved = await this.windows.trackSave(() =>
      api.saveVersion(this.id, parent ? { ...content, parent_id: parent } : content, last),
    );
    this.lineage.add(content, saved.id);
    this.inBin.value = saved.deleted_at !== null;
    return saved;
  }

  /** Listens to changes of the program in other windows. */
  private listen(): () => void {
    const last = changed.peek();
    return changed.subscribe((event) => {
      if (event === last || event?.program !== this.id) return;
      this.inBin.value = event.deleted_at !== null;
      if (event.version) this.windows.receive(event.version);
    });
  }

  private save(): void {
    const { value: content } = this.content;
    if (content) this.autosave.edit(this.whole(content));
  }

  /** The editor's content with the program's world and setup. */
  private whole(content: EditorContent): EditorContent {
    return { ...content, world: this.ownWorld.now.peek(), setup: this.setup.peek() };
  }
}

/** An activity; null if only a newer release knows it. */
async function knownActivity(name: string): Promise<Activity | null> {
  try {
    return await activitiesApi.one(name);
  } catch (error) {
    if (error instanceof ApiError && error.code === "unknown_activity") return null;
    throw error;
  }
}

export const opened = signal<OpenProgram | null>(null);

/** Incremented to load the open program again from the server. */
export const reloads = signal(0);

/** Saves the current content, then shows the newest version. */
export async function openNewest(open: OpenProgram): Promise<void> {
  await open.autosave.flush();
  if (open.windows.isStale.peek()) reloads.value += 1;
}

/** The open program while its studio is on the screen, otherwise null. */
export const programOnScreen = computed(() => {
  const { value: now } = route;
  return now.screen === "studio" && now.program === opened.value?.id ? opened.value : null;
});

/** Handles a program that failed to open: the header must not name another program. */
export function couldNotOpen(error: unknown): void {
  // if the server is unreachable, a closing page still sends the open program's unsaved content
  if (!(error instanceof ServerUnreachable)) opened.value = null;
  group.value = null;
  program.value = null;
  report(error);
}

window.addEventListener("pagehide", () => opened.value?.autosave.flushLast());
document.addEventListener("visibilitychange", () => {
  if (document.visibilityState === "hidden") void opened.value?.autosave.flush().catch(() => {});
});
