import * as Blockly from "blockly/core";

/** Undo event for the replacement of the whole program; one undo step like any other. */
class ReplaceProgramEvent extends Blockly.Events.Abstract {
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

/** Calls `notify` on undo, by any button or key, if the undo stack of this session is empty. */
export function interceptEmptyUndo(workspace: Blockly.WorkspaceSvg, notify: () => void): void {
  const undo = workspace.undo.bind(workspace);
  workspace.undo = (redo = false) => {
    if (redo || workspace.getUndoStack().length > 0) undo(redo);
    else notify();
  };
}

/** Undoes to a state from before the session; the redo stack stays intact. */
export function undoInto(
  workspace: Blockly.WorkspaceSvg,
  before: object,
  show: (workspace: object) => void,
): void {
  const now = Blockly.serialization.workspaces.save(workspace);
  workspace.getUndoStack().push(new ReplaceProgramEvent(before, now, show));
  workspace.undo(false);
}
