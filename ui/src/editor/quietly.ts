import * as Blockly from "blockly/core";

/**
 * Makes many blocks at once, without an event for each. What Blockly sets aside for it comes back even when it fails;
 * by itself it would go on without undo.
 */
export function quietly(make: () => void): void {
  const recordUndo = Blockly.Events.getRecordUndo();
  const group = Blockly.Events.getGroup();
  Blockly.Events.disable();
  try {
    make();
  } finally {
    Blockly.Events.enable();
    Blockly.Events.setRecordUndo(recordUndo);
    Blockly.Events.setGroup(group);
  }
}

let patched = false;

/**
 * A field that is not drawn yet has nothing to say to a screen reader. Blockly finds that out by throwing and catching,
 * twice a field, which made up half of the time to open a program of 500 blocks.
 */
export function askOnlyDrawnFields(): void {
  if (patched) return;
  patched = true;
  const { prototype } = Blockly.Field;
  const { recomputeAriaContext } = prototype;
  prototype.recomputeAriaContext = function (this: Blockly.Field) {
    return this.getSvgRoot() !== null && recomputeAriaContext.call(this);
  };
}
