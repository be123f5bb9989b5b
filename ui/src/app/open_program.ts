import { computed, effect, signal } from "@preact/signals";
import { api } from "../api/client";
import { ServerGone } from "../api/errors";
import type { Content, Fault, ProgramWithVersion, SavedVersion, World } from "../api/model";
import { Autosave } from "./autosave";
import { OwnWorld } from "./own_world";
import { Parents } from "./parents";
import { route } from "./route";
import { group, program, report } from "./session";

/** The program on the desk: what the header, the editor and the run bar share. */
export class OpenProgram {
  readonly autosave: Autosave;
  readonly content = signal<Content | null>(null);
  readonly faults = signal<Fault[]>([]);
  readonly ownWorld: OwnWorld;
  /** What was deleted for good in another window; what is on the screen stays there. */
  readonly deleted = signal<"program" | "group" | null>(null);
  private readonly parents = new Parents();
  private readonly stopEffect: () => void;

  constructor(readonly program: ProgramWithVersion) {
    const { id, version } = program;
    this.ownWorld = new OwnWorld(id, version?.world ?? null);
    this.autosave = new Autosave(
      (content, last) =>
        this.ownWorld.saveWith(content.world ?? null, (world) =>
          this.keep({ ...content, world }, last),
        ),
      version,
    );
    this.stopEffect = effect(() => {
      this.faults.value = this.autosave.version.value?.faults ?? [];
      if (this.autosave.state.value === "deleted") void this.takeLeave();
    });
  }

  get id(): string {
    return this.program.id;
  }

  /** What the editor shows of the stored version, before anything is edited. */
  begin(content: Content): void {
    this.content.value = content;
    if (this.program.version) this.remember(this.program.version.id);
  }

  /** What is on the screen is that version: who goes on from here goes on from there. */
  remember(version: string): void {
    const { value: content } = this.content;
    if (content) this.parents.keep(content.workspace, version);
  }

  edit(content: Content): void {
    this.content.value = content;
    this.save();
  }

  /** Keeps the group's own world with the program from now on; null forgets it. */
  setWorld(world: World | null): void {
    this.ownWorld.now.value = world;
    this.save();
  }

  /** Whether there is a command that could run. */
  get isEmpty(): boolean {
    const { commands } = (this.content.value?.document ?? {}) as { commands?: unknown[] };
    return !commands || commands.length === 0;
  }

  close(): void {
    this.stopEffect();
    this.ownWorld.close();
    this.autosave.dispose();
  }

  /** Learns what was deleted, so that the header no longer offers what cannot be done. */
  private async takeLeave(): Promise<void> {
    const groups = await api.groups().catch(() => null);
    const isGroupHere = groups?.some(({ id }) => id === this.program.group_id) ?? true;
    this.deleted.value = isGroupHere ? "program" : "group";
    if (opened.peek() !== this) return;
    program.value = null;
    if (!isGroupHere) group.value = null;
  }

  private async keep(content: Content, last: boolean): Promise<SavedVersion> {
    const parent = this.parents.of(content.workspace);
    const kept = await api.saveVersion(
      this.id,
      parent ? { ...content, parent_id: parent } : content,
      last,
    );
    this.parents.keep(content.workspace, kept.id);
    return kept;
  }

  private save(): void {
    const { value: content } = this.content;
    if (content) this.autosave.edit({ ...content, world: this.ownWorld.now.value });
  }
}

export const opened = signal<OpenProgram | null>(null);

/** The program on the desk, while it is the one that is looked at. */
export const onDesk = computed(() => {
  const { value: now } = route;
  return now.screen === "studio" && now.program === opened.value?.id ? opened.value : null;
});

/** What was asked for is not there: the header names nothing that would be changed in its place. */
export function couldNotOpen(error: unknown): void {
  // what could not be saved before the server went is sent when the page closes
  if (!(error instanceof ServerGone)) opened.value = null;
  group.value = null;
  program.value = null;
  report(error);
}

window.addEventListener("pagehide", () => opened.value?.autosave.flushLast());
document.addEventListener("visibilitychange", () => {
  if (document.visibilityState === "hidden") void opened.value?.autosave.flush().catch(() => {});
});
