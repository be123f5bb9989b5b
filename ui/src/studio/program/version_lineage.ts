/** Maximum number of stored contents, which are large. */
const MAX_CONTENTS = 64;

interface StoredContent {
  workspace: object;
  world?: object | null;
  setup?: object | null;
}

/**
 * Maps the contents of this session to their stored versions. If content equals an earlier version,
 * for example after undo, that version is the parent. The parent of new content is the version that
 * this window showed last, even if other windows have saved meanwhile.
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

  /** The version with a content; for new content, the version that this window showed last. */
  of(content: StoredContent): string | undefined {
    return this.ids.get(keyOf(content)) ?? this.last;
  }
}

function keyOf({ workspace, world, setup }: StoredContent): string {
  return JSON.stringify([workspace, world ?? null, setup ?? null]);
}
