import { signal } from "@preact/signals";
import { report } from "../report";

/** Requests a value; the signal is aborted when the response is no longer needed. */
export type Ask<T> = (signal: AbortSignal) => Promise<T>;

export interface Failed {
  readonly status: "failed";
  readonly error: unknown;
  readonly busy: boolean;
}

export interface Ready<T> {
  readonly status: "ready";
  readonly value: T;
  /** Time of the request. */
  readonly at: Date;
  /** A reload is pending. */
  readonly busy: boolean;
}

/** Response of a reload without changes. */
export const UNCHANGED = Symbol("unchanged");

export type LoadState<T> = { readonly status: "loading" } | Failed | Ready<T>;

/** The value, or null. */
export function valueIn<T>(state: LoadState<T>): T | null {
  return state.status === "ready" ? state.value : null;
}

export interface LoadOptions<T> {
  /** Called on a failure without a value to show; by default the failure is reported. */
  onFailed?(error: unknown): void;
  /** Frees a value that is no longer shown. */
  release?(value: T): void;
}

/** A loaded value. The latest request wins; a failed reload leaves the value unchanged. */
export class Load<T> {
  readonly state = signal<LoadState<T>>({ status: "loading" });
  options: LoadOptions<T> = {};
  private running: AbortController | null = null;

  /** Resolves after the response or the failure; never rejects. */
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

  /** Sets a value from another source, for example the response to a change. */
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
    this.setBusy(true);
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
    if (!mine.signal.aborted) this.setBusy(false);
  }

  private setBusy(busy: boolean): void {
    const state = this.state.peek();
    if (state.status !== "loading") this.state.value = { ...state, busy };
  }

  private release(value: T): void {
    this.options.release?.(value);
  }
}
