import { computed, effect, signal } from "@preact/signals";
import { api } from "../api/client";
import { ApiError } from "../api/errors";
import type { Content, Fault, ProgramWithVersion, SavedVersion, World } from "../api/model";
import { Autosave } from "./autosave";

/** The program on the desk: what the header, the editor and the run bar share. */
export class OpenProgram {
  readonly autosave: Autosave;
  readonly content = signal<Content | null>(null);
  readonly faults = signal<Fault[]>([]);
  /** The world that the group has made for this program; null while it has made none. */
  readonly world = signal<World | null>(null);
  /** A world with faults, which the server does not take: blocks are saved with the last one that it took. */
  private readonly refused = signal<World | null>(null);
  readonly worldIsRefused = computed(
    () => this.world.value !== null && this.world.value === this.refused.value,
  );
  private kept: World | null;
  private readonly stopEffect: () => void;

  constructor(readonly program: ProgramWithVersion) {
    const { version } = program;
    this.kept = version?.world ?? null;
    this.world.value = this.kept;
    this.autosave = new Autosave((content, last) => this.send(content, last), version);
    this.stopEffect = effect(() => {
      this.faults.value = this.autosave.version.value?.faults ?? [];
    });
  }

  get id(): string {
    return this.program.id;
  }

  edit(content: Content): void {
    this.content.value = content;
    this.save();
  }

  /** Keeps the group's own world with the program from now on; null forgets it. */
  setWorld(world: World | null): void {
    this.world.value = world;
    this.save();
  }

  /** Whether there is a command that could run. */
  get isEmpty(): boolean {
    const { commands } = (this.content.value?.document ?? {}) as { commands?: unknown[] };
    return !commands || commands.length === 0;
  }

  close(): void {
    this.stopEffect();
    this.autosave.dispose();
  }

  private save(): void {
    const { value: content } = this.content;
    if (content) this.autosave.edit({ ...content, world: this.world.value });
  }

  private async send({ world = null, ...content }: Content, last: boolean): Promise<SavedVersion> {
    const sendWith = async (sent: World | null) => {
      const version = await api.saveVersion(this.id, { ...content, world: sent }, last);
      this.kept = sent;
      return version;
    };
    if (world && world === this.refused.peek()) return sendWith(this.kept);
    try {
      return await sendWith(world);
    } catch (error) {
      if (!world || !(error instanceof ApiError) || error.code !== "invalid_world") throw error;
      this.refused.value = world;
      return sendWith(this.kept);
    }
  }
}

export const opened = signal<OpenProgram | null>(null);

window.addEventListener("pagehide", () => opened.value?.autosave.flushLast());
document.addEventListener("visibilitychange", () => {
  if (document.visibilityState === "hidden") void opened.value?.autosave.flush().catch(() => {});
});
