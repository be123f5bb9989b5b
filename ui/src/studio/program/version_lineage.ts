/** Contents are large, and nobody goes back further in one go. */
const MOST = 64;

interface Kept {
  workspace: object;
  world?: object | null;
}

/**
 * Which stored version a content is, for those seen in this session: who comes back to one of them, by undo or by
 * hand, goes on from there, and not from what was tried in between. What is new was made of what was here before it,
 * whatever another window has made of the program meanwhile.
 */
export class VersionLineage {
  private readonly ids = new Map<string, string>();
  private last: string | undefined;

  keep(content: Kept, id: string): void {
    this.last = id;
    const key = keyOf(content);
    if (this.ids.has(key)) return;
    this.ids.set(key, id);
    if (this.ids.size > MOST) {
      const [oldest] = this.ids.keys();
      if (oldest !== undefined) this.ids.delete(oldest);
    }
  }

  /** The version with that content, or for a new one the version that was here before it. */
  of(content: Kept): string | undefined {
    return this.ids.get(keyOf(content)) ?? this.last;
  }
}

function keyOf({ workspace, world }: Kept): string {
  return JSON.stringify([workspace, world ?? null]);
}
