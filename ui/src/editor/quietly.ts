import * as Blockly from "blockly/core";

/** Makes many blocks at once, without an event for each. */
export function quietly(make: () => void): void {
  Blockly.Events.disable();
  try {
    make();
  } finally {
    Blockly.Events.enable();
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
