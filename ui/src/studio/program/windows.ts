import { computed, signal } from "@preact/signals";
import type { SavedVersion } from "../../api/model";

/** Distinguishes versions of a program saved in this window from those of other windows. */
export class Windows {
  /** The last version saved in another window. */
  readonly other = signal<string | null>(null);
  private readonly own = new Set<string>();
  private readonly newest = signal("");
  private sending = 0;
  private pendingVersions: string[] = [];

  /** `opened`: the newest version when the program was opened here. */
  constructor(private readonly opened: string | null) {
    if (opened) this.addOwn(opened);
  }

  /** Whether a version of another window is the newest. */
  readonly isStale = computed(() => this.other.value === this.newest.value);

  /** Whether a save is pending, so that the newest version is unknown. */
  get isSending(): boolean {
    return this.sending > 0;
  }

  /** Handles the event of a saved version. The event of an own version may precede the response to its save. */
  receive(version: string): void {
    if (this.isSending) this.pendingVersions.push(version);
    else this.noteForeign(version);
  }

  async trackSave(save: () => Promise<SavedVersion>): Promise<SavedVersion> {
    this.sending += 1;
    try {
      const saved = await save();
      const isNew = !this.own.has(saved.id);
      this.addOwn(saved.id);
      if (isNew && saved.before) this.noteForeign(saved.before);
      return saved;
    } finally {
      this.sending -= 1;
      if (!this.isSending)
        for (const version of this.pendingVersions.splice(0)) this.noteForeign(version);
    }
  }

  private addOwn(version: string): void {
    this.own.add(version);
    this.reach(version);
  }

  private noteForeign(version: string): void {
    if (this.own.has(version) || version <= (this.opened ?? "")) return;
    this.reach(version);
    const known = this.other.peek();
    if (known === null || known < version) this.other.value = version;
  }

  /** Records the newest version; ids of the store increase with time. */
  private reach(version: string): void {
    if (this.newest.peek() < version) this.newest.value = version;
  }
}
