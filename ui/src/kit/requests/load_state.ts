import { signal } from "@preact/signals";
import { report } from "../report";

/** Asks for a value; the signal is aborted when nobody waits for the answer any more. */
export type Ask<T> = (signal: AbortSignal) => Promise<T>;

export interface Failed {
  readonly status: "failed";
  readonly error: unknown;
  readonly busy: boolean;
}

export interface Ready<T> {
  readonly status: "ready";
  readonly value: T;
  /** When it was asked for. */
  readonly at: Date;
  /** It is asked for again. */
  readonly busy: boolean;
}

/** The answer of a repeat that found nothing to change. */
export const UNCHANGED = Symbol("unchanged");

export type LoadState<T> = { readonly status: "loading" } | Failed | Ready<T>;

/** The value where there is one. */
export function valueIn<T>(state: LoadState<T>): T | null {
  return state.status === "ready" ? state.value : null;
}

export interface LoadOptions<T> {
  /** Hears of a failure that leaves nothing to show; without it the failure is reported. */
  onFailed?(error: unknown): void;
  /** Frees a value that is shown no more. */
  release?(value: T): void;
}

/** A value from elsewhere: the latest request wins, and a value stays when a repeat fails. */
export class Load<T> {
  readonly state = signal<LoadState<T>>({ status: "loading" });
  options: LoadOptions<T> = {};
  private running: AbortController | null = null;

  /** Resolves when the answer is there or has failed; never rejects. */
  async ask(ask: Ask<T | typeof UNCHANGED>): Promise<void> {
    const mine = this.begin();
    const at = new Date();
    try {
      const value = await ask(mine.signal);
      if (value === UNCHANGED) this.end(mine);
      else if (mine.signal.aborted) this.release(value);
      else this.show(value, at);
    } catch (error) {
      if (!mine.signal.aborted) this.fail(error, mine);
    }
  }

  /** Shows a value that the page has from somewhere else, for example from the answer to a change. */
  set(value: T): void {
    this.running?.abort();
    this.show(value, new Date());
  }

  dispose(): void {
    this.running?.abort();
    const state = this.state.peek();
    if (state.status === "ready") this.release(state.value);
  }

  private begin(): AbortController {
    this.running?.abort();
    this.running = new AbortController();
    this.mark(true);
    return this.running;
  }

  private show(value: T, at: Date): void {
    const before = this.state.peek();
    this.state.value = { status: "ready", value, at, busy: false };
    if (before.status === "ready" && before.value !== value) this.release(before.value);
  }

  private fail(error: unknown, mine: AbortController): void {
    if (this.state.peek().status === "ready") {
      this.end(mine);
      report(error);
    } else {
      this.state.value = { status: "failed", error, busy: false };
      (this.options.onFailed ?? report)(error);
    }
  }

  private end(mine: AbortController): void {
    if (!mine.signal.aborted) this.mark(false);
  }

  private mark(busy: boolean): void {
    const state = this.state.peek();
    if (state.status !== "loading") this.state.value = { ...state, busy };
  }

  private release(value: T): void {
    this.options.release?.(value);
  }
}
