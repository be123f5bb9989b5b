import { effect, signal } from "@preact/signals";
import { api } from "../api/client";
import type { Content, Fault, ProgramWithVersion } from "../api/model";
import { Autosave } from "./autosave";

/** The program on the desk: what the header, the editor and the run bar share. */
export class OpenProgram {
  readonly autosave: Autosave;
  readonly content = signal<Content | null>(null);
  readonly faults = signal<Fault[]>([]);
  private readonly stopEffect: () => void;

  constructor(readonly program: ProgramWithVersion) {
    const { id, version } = program;
    this.autosave = new Autosave((content, last) => api.saveVersion(id, content, last), version);
    this.stopEffect = effect(() => {
      this.faults.value = this.autosave.version.value?.faults ?? [];
    });
  }

  get id(): string {
    return this.program.id;
  }

  edit(content: Content): void {
    this.content.value = content;
    this.autosave.edit(content);
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
}

export const opened = signal<OpenProgram | null>(null);

window.addEventListener("pagehide", () => opened.value?.autosave.flushLast());
document.addEventListener("visibilitychange", () => {
  if (document.visibilityState === "hidden") void opened.value?.autosave.flush().catch(() => {});
});
