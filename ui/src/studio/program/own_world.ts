import { computed, effect, signal } from "@preact/signals";
import { ApiError } from "../../api/errors";
import type { Fault, SavedState, World } from "../../api/model";

/** Returns all faults of a world. */
type Check = (world: World) => Promise<readonly Fault[]>;

/**
 * The group's own world of a program. The server rejects a world with faults. Until the faults are
 * corrected, blocks are saved with the last accepted world. The faulty world is a draft in session
 * storage, which survives a reload.
 */
export class OwnWorld {
  /** The current world; null without one. */
  readonly now = signal<World | null>(null);
  private readonly refused = signal<World | null>(null);
  readonly isRefused = computed(
    () => this.now.value !== null && this.now.value === this.refused.value,
  );
  /** Stops storing drafts. */
  readonly close: () => void;

  constructor(
    program: string,
    private accepted: World | null,
    private readonly check: Check,
  ) {
    const key = `pinel_world_${program}`;
    const draft = draftAt(key);
    this.refused.value = draft;
    this.now.value = draft ?? accepted;
    this.close = effect(() => storeDraft(key, this.isRefused.value ? this.now.value : null));
  }

  /** Marks the current world as rejected by the server: it is not sent again. */
  refuse(world: World): void {
    if (world === this.now.peek()) this.refused.value = world;
  }

  /** Saves with a world, or with the last accepted world if it has faults. If `last`, does not check it first. */
  async saveWith(
    world: World | null,
    save: (world: World | null) => Promise<SavedState>,
    last = false,
  ): Promise<SavedState> {
    if (world && world !== this.accepted && !last) await this.ask(world);
    if (world && world === this.refused.peek()) return save(this.accepted);
    try {
      const version = await save(world);
      this.accepted = world;
      return version;
    } catch (error) {
      if (!world || !(error instanceof ApiError) || error.code !== "invalid_world") throw error;
      this.refused.value = world;
      return save(this.accepted);
    }
  }

  private async ask(world: World): Promise<void> {
    if (world === this.refused.peek()) return;
    // if the check fails, saving fails too and reports the error
    const faults = await this.check(world).catch(() => []);
    if (faults.length > 0) this.refused.value = world;
  }
}

function storeDraft(key: string, world: World | null): void {
  if (world) sessionStorage.setItem(key, JSON.stringify(world));
  else sessionStorage.removeItem(key);
}

function draftAt(key: string): World | null {
  const text = sessionStorage.getItem(key);
  return text === null ? null : (JSON.parse(text) as World);
}
