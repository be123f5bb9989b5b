import type { VersionOfProgram } from "../../api/model";
import { versionsApi } from "../../api/versions";
import type { OpenProgram } from "./open_program";

/** Continues undo with stored versions once the undo stack of the session is empty. */
export class StoredUndo {
  private walking = false;
  private atBeginning = false;

  constructor(private readonly open: OpenProgram) {}

  /**
   * Passes the ancestors of the shown version to `tryRestore`, newest first, until it returns true.
   * `tryRestore` returns false for a version that looks the same, such as a saved undo. After the
   * first version it gets null, for an empty workspace.
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

  /** Id of the parent; for a version of an earlier release, which records no parent, the preceding version. */
  private async behind({ id, parent_id, number }: VersionOfProgram): Promise<string | null> {
    if (parent_id || number === 1) return parent_id;
    return versionsApi.before(this.open.id, id);
  }
}
