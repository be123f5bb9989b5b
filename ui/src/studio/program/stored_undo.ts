import type { VersionOfProgram } from "../../api/model";
import { versionsApi } from "../../api/versions";
import type { OpenProgram } from "./open_program";

/** What lies behind the session: undo goes on through the stored versions when it has undone all that was done here. */
export class StoredUndo {
  private walking = false;
  private atBeginning = false;

  constructor(private readonly open: OpenProgram) {}

  /**
   * Offers the versions that came before the one on the screen, the newest first, until one is taken. One that looks
   * the same, as after an undo that was saved, is not: `take` says so. Before the first there was nothing: null.
   */
  async back(take: (workspace: object | null) => boolean): Promise<void> {
    if (this.walking || this.atBeginning) return;
    this.walking = true;
    try {
      const newest = await this.open.autosave.flush();
      let version = newest && (await versionsApi.version(newest.id));
      while (version) {
        const id = await this.behind(version);
        version = id === null ? null : await versionsApi.version(id);
        if (version && take(version.workspace)) return this.open.remember(version.id);
      }
      this.atBeginning = true;
      take(null);
    } finally {
      this.walking = false;
    }
  }

  /** Versions of earlier releases do not tell what they were made of: the one before in the line, then. */
  private async behind({ id, parent_id, number }: VersionOfProgram): Promise<string | null> {
    if (parent_id || number === 1) return parent_id;
    return versionsApi.before(this.open.id, id);
  }
}
