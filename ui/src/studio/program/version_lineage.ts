/** Limit of remembered contents, which are large. */
const MAX_CONTENTS = 64;

interface StoredContent {
  workspace: object;
  world?: object | null;
  setup?: object | null;
}

/**
 * Maps the contents of this session to their stored versions. Content that equals an earlier version, for example after
 * undo, has that version as its parent. New content has the version last shown in this window as its parent, whatever
 * other windows have saved meanwhile.
 */
export class VersionLineage {
  private readonly ids = new Map<string, string>();
  private last: string | undefined;

  add(content: StoredContent, id: string): void {
    this.last = id;
    const key = keyOf(content);
    if (this.ids.has(key)) return;
    this.ids.set(key, id);
    if (this.ids.size > MAX_CONTENTS) {
      const [oldest] = this.ids.keys();
      if (oldest !== undefined) this.ids.delete(oldest);
    }
  }

  /** The version with that content; for new content the version last shown here. */
  of(content: StoredContent): string | undefined {
    return this.ids.get(keyOf(content)) ?? this.last;
  }
}

function keyOf({ workspace, world, setup }: StoredContent): string {
  return JSON.stringify([workspace, world ?? null, setup ?? null]);
}
