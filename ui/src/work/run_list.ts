import { computed, signal } from "@preact/signals";
import { api } from "../api/client";
import type { Run } from "../api/model";

export const OUTCOMES = ["finished", "stopped", "failed"] as const;
export type Outcome = (typeof OUTCOMES)[number];

/** Whoever asks for a rare kind of run waits for this many pages at most, and can go on by hand. */
const PAGES_AT_ONCE = 8;

/** A group's runs, newest first, as far as they were fetched, and which of them are shown. */
export class RunList {
  readonly runs = signal<Run[]>([]);
  /** What to ask for next; null when all are here. */
  readonly next = signal<string | null>(null);
  readonly outcome = signal<Outcome | null>(null);
  readonly program = signal<string | null>(null);
  readonly shown = computed(() =>
    this.runs.value.filter(
      (run) =>
        (this.outcome.value === null || run.state === this.outcome.value) &&
        (this.program.value === null || run.program_id === this.program.value),
    ),
  );
  private fetching = false;

  constructor(private readonly group: string) {}

  async load(): Promise<void> {
    this.runs.value = [];
    await this.fetch(null);
  }

  /** Older runs: at least one more that is shown, where there is one. */
  async older(): Promise<void> {
    if (this.fetching) return;
    this.fetching = true;
    try {
      const before = this.shown.peek().length;
      for (let page = 0; page < PAGES_AT_ONCE; page += 1) {
        const from = this.next.peek();
        if (from === null || this.shown.peek().length > before) break;
        await this.fetch(from);
      }
    } finally {
      this.fetching = false;
    }
  }

  /** Shows only some; looks further back when none of them is here yet. */
  async choose(outcome: Outcome | null, program: string | null): Promise<void> {
    this.outcome.value = outcome;
    this.program.value = program;
    if (this.shown.peek().length === 0) await this.older();
  }

  private async fetch(before: string | null): Promise<void> {
    const page = await api.runs(this.group, before);
    this.runs.value = [...this.runs.peek(), ...page.runs];
    this.next.value = page.next;
  }
}
