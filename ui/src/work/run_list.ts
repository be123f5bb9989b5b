import { computed, signal } from "@preact/signals";
import { api } from "../api/client";
import type { Run } from "../api/model";

export const END_STATES = ["finished", "stopped", "failed"] as const;
export type EndState = (typeof END_STATES)[number];

/** Maximum number of pages per request for a filter with few matches; the person can request more. */
const PAGES_AT_ONCE = 8;

/** A group's loaded runs, newest first, and the filter. */
export class RunList {
  readonly runs = signal<Run[]>([]);
  /** Cursor of the next page; null at the end. */
  readonly next = signal<string | null>(null);
  readonly outcome = signal<EndState | null>(null);
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

  /** Loads older runs until at least one matches the filter. */
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

  /** Sets the filter; loads older runs if none matches yet. */
  async choose(outcome: EndState | null, program: string | null): Promise<void> {
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
