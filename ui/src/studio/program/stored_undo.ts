import type { VersionOfProgram } from "../../api/model";
import { versionsApi } from "../../api/versions";
import type { OpenProgram } from "./open_program";

/** Continues undo through stored versions after the undo stack of the session is empty. */
export class StoredUndo {
  private walking = false;
  private atBeginning = false;

  constructor(private readonly open: OpenProgram) {}

  /**
   * Offers the ancestors of the shown version to `take`, newest first, until it returns true. It returns false for a
   * version that looks the same, such as a saved undo. Before the first version the workspace is null.
   */
  async back(tryRestore: (workspace: object | null) => boolean): Promise<void> {
    if (this.walking || this.atBeginning) return;
    this.walking = true;
    try {
      const newest = await this.open.autosave.flush();
      let version = newest && (await versionsApi.version(newest.id));
      while (version) {
        const id = await this.behind(version);
        version = id === null ? null : await versionsApi.version(id);
        if (version && tryRestore(version.workspace)) return this.open.setStoredVersion(version.id);
      }
      this.atBeginning = true;
      tryRestore(null);
    } finally {
      this.walking = false;
    }
  }

  /** Id of the parent; for versions of earlier releases, which record none, that of the preceding version. */
  private async behind({ id, parent_id, number }: VersionOfProgram): Promise<string | null> {
    if (parent_id || number === 1) return parent_id;
    return versionsApi.before(this.open.id, id);
  }
}
