/** Contents are large, and nobody goes back further in one go. */
const MOST = 64;

/**
 * Which stored version a content is, for those seen in this session: who comes back to one of them, by undo or by
 * hand, goes on from there, and not from what was tried in between.
 */
export class Parents {
  private readonly ids = new Map<string, string>();

  keep(workspace: object, id: string): void {
    const key = JSON.stringify(workspace);
    if (this.ids.has(key)) return;
    this.ids.set(key, id);
    if (this.ids.size > MOST) {
      const [oldest] = this.ids.keys();
      if (oldest !== undefined) this.ids.delete(oldest);
    }
  }

  /** The version with that content, or undefined for one that is new. */
  of(workspace: object): string | undefined {
    return this.ids.get(JSON.stringify(workspace));
  }
}
