import { computed, effect, signal } from "@preact/signals";
import { ApiError } from "../../api/errors";
import type { Fault, OnDisk, World } from "../../api/model";

/** Tells all that is wrong with a world. */
type Check = (world: World) => Promise<readonly Fault[]>;

/**
 * The world that a group has made for a program. The server takes none with faults: until they are mended, blocks are
 * saved with the last world that it took, and the faulty one outlives a reload of the page, though not the window.
 */
export class OwnWorld {
  /** Null while there is none. */
  readonly now = signal<World | null>(null);
  private readonly refused = signal<World | null>(null);
  readonly isRefused = computed(
    () => this.now.value !== null && this.now.value === this.refused.value,
  );
  /** Ends the keeping of what the server does not take. */
  readonly close: () => void;

  constructor(
    program: string,
    private taken: World | null,
    private readonly check: Check,
  ) {
    const key = `pinel_world_${program}`;
    const draft = draftAt(key);
    this.refused.value = draft;
    this.now.value = draft ?? taken;
    this.close = effect(() => keepDraft(key, this.isRefused.value ? this.now.value : null));
  }

  /** The server has found faults in that world: it is not sent. */
  refuse(world: World): void {
    if (world === this.now.peek()) this.refused.value = world;
  }

  /** Saves something with a world, or with the last that was taken where this one is not; `last` waits for nothing. */
  async saveWith(
    world: World | null,
    save: (world: World | null) => Promise<OnDisk>,
    last = false,
  ): Promise<OnDisk> {
    if (world && world !== this.taken && !last) await this.ask(world);
    if (world && world === this.refused.peek()) return save(this.taken);
    try {
      const version = await save(world);
      this.taken = world;
      return version;
    } catch (error) {
      if (!world || !(error instanceof ApiError) || error.code !== "invalid_world") throw error;
      this.refused.value = world;
      return save(this.taken);
    }
  }

  private async ask(world: World): Promise<void> {
    if (world === this.refused.peek()) return;
    // who cannot be asked cannot save either, and saving tells why
    const faults = await this.check(world).catch(() => []);
    if (faults.length > 0) this.refused.value = world;
  }
}

function keepDraft(key: string, world: World | null): void {
  if (world) sessionStorage.setItem(key, JSON.stringify(world));
  else sessionStorage.removeItem(key);
}

function draftAt(key: string): World | null {
  const text = sessionStorage.getItem(key);
  return text === null ? null : (JSON.parse(text) as World);
}
