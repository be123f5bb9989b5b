import * as Blockly from "blockly/core";

/** A whole program took the place of another: one step for undo and redo among those of single blocks. */
class Exchange extends Blockly.Events.Abstract {
  override type = "pinel_exchange";
  override isBlank = false;

  constructor(
    private readonly before: object,
    private readonly after: object,
    private readonly show: (workspace: object) => void,
  ) {
    super();
    this.group = Blockly.utils.idGenerator.genUid();
  }

  override run(forward: boolean): void {
    this.show(forward ? this.after : this.before);
  }
}

/** Tells when undo, by whatever button or key, finds nothing of this session that it could undo. */
export function tellNothingToUndo(workspace: Blockly.WorkspaceSvg, tell: () => void): void {
  const undo = workspace.undo.bind(workspace);
  workspace.undo = (redo = false) => {
    if (redo || workspace.getUndoStack().length > 0) undo(redo);
    else tell();
  };
}

/** Undoes to a state from before the session; what can be redone can still be redone after that. */
export function undoInto(
  workspace: Blockly.WorkspaceSvg,
  before: object,
  show: (workspace: object) => void,
): void {
  const now = Blockly.serialization.workspaces.save(workspace);
  workspace.getUndoStack().push(new Exchange(before, now, show));
  workspace.undo(false);
}
