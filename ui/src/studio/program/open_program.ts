import { computed, effect, type Signal, signal } from "@preact/signals";
import { api } from "../../api/client";
import { ServerGone } from "../../api/errors";
import type { Content, Fault, ProgramWithVersion, SavedVersion, World } from "../../api/model";
import { route } from "../../shell/route";
import { changed, group, program, report } from "../../shell/session";
import { Autosave } from "./autosave";
import { OwnWorld } from "./own_world";
import { VersionLineage } from "./version_lineage";
import { Windows } from "./windows";

/** The program on the desk: what the header, the editor and the run bar share. */
export class OpenProgram {
  readonly autosave: Autosave;
  readonly content = signal<Content | null>(null);
  readonly faults = signal<Fault[]>([]);
  readonly ownWorld: OwnWorld;
  /** What was deleted for good in another window; what is on the screen stays there. */
  readonly deleted = signal<"program" | "group" | null>(null);
  readonly inBin: Signal<boolean>;
  readonly windows: Windows;
  private readonly lineage = new VersionLineage();
  private readonly stopEffects: (() => void)[];

  constructor(readonly program: ProgramWithVersion) {
    const { id, version } = program;
    this.inBin = signal(program.deleted_at !== null);
    this.windows = new Windows(version?.id ?? null);
    this.ownWorld = new OwnWorld(id, version?.world ?? null, api.checkWorld);
    this.autosave = new Autosave(
      (content, last) =>
        this.ownWorld.saveWith(
          content.world ?? null,
          (world) => this.keep({ ...content, world }, last),
          last,
        ),
      version,
    );
    this.stopEffects = [
      effect(() => {
        this.faults.value = this.autosave.version.value?.faults ?? [];
        if (this.autosave.state.value === "deleted") void this.takeLeave();
      }),
      this.listen(),
    ];
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
    if (content) this.lineage.keep({ ...content, world: this.ownWorld.now.peek() }, version);
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
    for (const stop of this.stopEffects) stop();
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
    // a page that closes may send before it knows the version that it sent last: then the newest of all is meant
    const parent = this.windows.isSending ? undefined : this.lineage.of(content);
    const kept = await this.windows.keep(() =>
      api.saveVersion(this.id, parent ? { ...content, parent_id: parent } : content, last),
    );
    this.lineage.keep(content, kept.id);
    this.inBin.value = kept.deleted_at !== null;
    return kept;
  }

  /** Hears what becomes of the program in another window from now on. */
  private listen(): () => void {
    const last = changed.peek();
    return changed.subscribe((event) => {
      if (event === last || event?.program !== this.id) return;
      this.inBin.value = event.deleted_at !== null;
      if (event.version) this.windows.hear(event.version);
    });
  }

  private save(): void {
    const { value: content } = this.content;
    if (content) this.autosave.edit({ ...content, world: this.ownWorld.now.value });
  }
}

export const opened = signal<OpenProgram | null>(null);

/** Counts up when the program on the desk is to be opened anew, as it is on disk. */
export const openings = signal(0);

/** Shows the newest version in place of what is on the screen, which is on disk before it goes. */
export async function openNewest(open: OpenProgram): Promise<void> {
  await open.autosave.flush();
  if (open.windows.isOvertaken.peek()) openings.value += 1;
}

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
