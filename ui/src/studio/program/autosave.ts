import { signal } from "@preact/signals";
import { ApiError } from "../../api/errors";
import type { EditorContent, SavedState } from "../../api/model";

/** `deleted`: the program no longer exists, so retrying is useless. */
export type SaveState = "saved" | "saving" | "failed" | "deleted";

type Save = (content: EditorContent, last: boolean) => Promise<SavedState>;

/** Debounce after the last edit, and its upper bound: continuous edits are on disk within a second. */
const DEBOUNCE_MS = 300;
const MAX_DELAY_MS = 600;
const RETRY_MS = [1000, 2000, 5000];
const DELETED = ["program_not_found", "group_not_found"];
/** Errors that last until PINEL is opened again, or until the program is another one. */
const LASTING = [
  "database_read_only",
  "disk_full_at_start",
  "database_locked_at_start",
  "body_too_large",
  "work_unreadable",
];

/** Whether a failed save may succeed at a later try, without anything else than time. */
export const mayPass = (problem: unknown) =>
  !(problem instanceof ApiError && LASTING.includes(problem.code));

/** Saves one program: the newest content wins, one request at a time. */
export class Autosave {
  readonly state = signal<SaveState>("saved");
  readonly problem = signal<unknown>(null);
  /** The newest version on disk. */
  readonly version = signal<SavedState | null>(null);

  private pending: EditorContent | null = null;
  private pendingSince = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private running: Promise<void> | null = null;
  private failures = 0;

  constructor(
    private readonly save: Save,
    version: SavedState | null = null,
  ) {
    this.version.value = version;
  }

  edit(content: EditorContent): void {
    const now = Date.now();
    if (!this.pending) this.pendingSince = now;
    this.pending = content;
    if (this.isDeleted) return;
    this.failures = 0;
    this.state.value = "saving";
    const left = this.pendingSince + MAX_DELAY_MS - now;
    this.schedule(Math.max(0, Math.min(DEBOUNCE_MS, left)));
  }

  /** Saves now. Resolves when all edits are on disk, rejects on failure. */
  async flush(): Promise<SavedState | null> {
    clearTimeout(this.timer);
    if (this.isDeleted) throw this.problem.value;
    while (this.running || this.pending) await this.push();
    return this.version.value;
  }

  /** Called when the page closes: sends unsaved content without waiting for the response. */
  flushLast(): void {
    clearTimeout(this.timer);
    if (!this.pending || this.isDeleted) return;
    const content = this.pending;
    this.pending = null;
    this.save(content, true).catch(() => {
      this.pending ??= content;
    });
  }

  /** Called when the program leaves the screen: saves now, and tries again as long as that may help. */
  dispose(): void {
    void this.flush().catch(() => {});
  }

  private get isDeleted(): boolean {
    return this.state.peek() === "deleted";
  }

  private schedule(delay: number): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.flush().catch(() => {}), delay);
  }

  private push(): Promise<void> {
    this.running ??= this.pushOnce().finally(() => {
      this.running = null;
    });
    return this.running;
  }

  private async pushOnce(): Promise<void> {
    const content = this.pending;
    if (!content) return;
    this.pending = null;
    try {
      this.version.value = await this.save(content, false);
    } catch (error) {
      this.pending ??= content;
      this.failed(error);
      throw error;
    }
    this.failures = 0;
    this.problem.value = null;
    this.state.value = this.pending ? "saving" : "saved";
  }

  private failed(error: unknown): void {
    this.problem.value = error;
    if (error instanceof ApiError && DELETED.includes(error.code)) {
      this.state.value = "deleted";
      return;
    }
    this.state.value = "failed";
    if (!mayPass(error)) return; // `edit` and `flush` try again
    const delay = RETRY_MS[Math.min(this.failures, RETRY_MS.length - 1)] ?? 5000;
    this.failures += 1;
    this.schedule(delay);
  }
}
