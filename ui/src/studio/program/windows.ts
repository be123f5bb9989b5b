import { computed, signal } from "@preact/signals";
import type { SavedVersion } from "../../api/model";

/** Tells what this window made of a program from what another window made of it meanwhile. */
export class Windows {
  /** The last version that was made elsewhere; it is in the history, whatever is done here. */
  readonly other = signal<string | null>(null);
  private readonly own = new Set<string>();
  private readonly newest = signal("");
  private sending = 0;
  private heard: string[] = [];

  /** `opened`: the version that was the newest when the program was opened here. */
  constructor(private readonly opened: string | null) {
    if (opened) this.isOwn(opened);
  }

  /** Whether what was made elsewhere is the newest of all. */
  readonly isOvertaken = computed(() => this.other.value === this.newest.value);

  /** What is being saved has no answer yet: nobody knows what comes next in the line. */
  get isSending(): boolean {
    return this.sending > 0;
  }

  /** A version of the program is on disk, whoever made it: one's own may be heard of before its answer is here. */
  hear(version: string): void {
    if (this.isSending) this.heard.push(version);
    else this.judge(version);
  }

  async keep(save: () => Promise<SavedVersion>): Promise<SavedVersion> {
    this.sending += 1;
    try {
      const kept = await save();
      const isNew = !this.own.has(kept.id);
      this.isOwn(kept.id);
      if (isNew && kept.before) this.judge(kept.before);
      return kept;
    } finally {
      this.sending -= 1;
      if (!this.isSending) for (const version of this.heard.splice(0)) this.judge(version);
    }
  }

  private isOwn(version: string): void {
    this.own.add(version);
    this.reach(version);
  }

  private judge(version: string): void {
    if (this.own.has(version) || version <= (this.opened ?? "")) return;
    this.reach(version);
    const known = this.other.peek();
    if (known === null || known < version) this.other.value = version;
  }

  /** Each id of the store is greater than the one before. */
  private reach(version: string): void {
    if (this.newest.peek() < version) this.newest.value = version;
  }
}
