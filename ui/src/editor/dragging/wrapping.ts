import * as Blockly from "blockly/core";

const { ConnectionType } = Blockly;

/** The block whose insertion marker is shown. The marker holds no blocks, even if the block does. */
let previewed: Blockly.Block | null = null;

/**
 * The input in which a dragged block, dropped on a stack, takes up the blocks below: its first
 * statement input, if it is empty and no block follows.
 */
function wrappingInput(block: Blockly.Block): Blockly.Connection | null {
  const dragged = (block.isInsertionMarker() && previewed) || block;
  if (dragged.getNextBlock() || bodyOf(dragged)?.targetBlock()) return null;
  return bodyOf(block);
}

function bodyOf(block: Blockly.Block): Blockly.Connection | null {
  const inputs = block.inputList.map(({ connection }) => connection);
  return inputs.find((one) => one?.type === ConnectionType.NEXT_STATEMENT) ?? null;
}

/** Offers a place in a stack also to an endless loop, which has none below it, if it can wrap. */
class Checker extends Blockly.ConnectionChecker {
  override doDragChecks(
    dragged: Blockly.RenderedConnection,
    place: Blockly.RenderedConnection,
    distance: number,
  ): boolean {
    if (super.doDragChecks(dragged, place, distance)) return true;
    const isAfter = dragged.type === ConnectionType.PREVIOUS_STATEMENT;
    return isAfter && this.canWrapBelow(dragged, place, distance);
  }

  private canWrapBelow(
    dragged: Blockly.RenderedConnection,
    place: Blockly.RenderedConnection,
    distance: number,
  ): boolean {
    const block = dragged.getSourceBlock();
    const below = place.targetBlock();
    return (
      !block.nextConnection &&
      wrappingInput(block) !== null &&
      (below?.isMovable() ?? false) &&
      !place.getSourceBlock().isInsertionMarker() &&
      !Blockly.common.draggingConnections.includes(place) &&
      dragged.distanceFrom(place) <= distance
    );
  }
}

/** Shows the blocks inside the insertion marker that would be inside the block. */
class Previewer extends Blockly.InsertionMarkerPreviewer {
  override hidePreview(): void {
    // private in Blockly
    const { markerConn } = this as unknown as { markerConn: Blockly.Connection | null };
    if (markerConn) unwrap(markerConn.getSourceBlock());
    super.hidePreview();
    previewed = null;
  }

  protected override serializeBlockToInsertionMarker(block: Blockly.BlockSvg) {
    previewed = block;
    return super.serializeBlockToInsertionMarker(block);
  }
}

/** Takes the blocks out of a marker, back to where they were: Blockly would delete them with it. */
function unwrap(marker: Blockly.Block): void {
  const place = marker.previousConnection?.targetConnection;
  const wrapped = bodyOf(marker)?.targetBlock();
  if (!place || !wrapped) return;
  Blockly.Events.disable();
  try {
    wrapped.unplug();
    marker.unplug();
    if (wrapped.previousConnection) place.connect(wrapped.previousConnection);
  } finally {
    Blockly.Events.enable();
  }
}

let patched = false;

/**
 * A loop or a condition that is dragged onto a stack takes the blocks below into its first input;
 * Blockly would place it above them. Only for drags: undo and redo move each block themselves.
 */
export function patchOrphans(): void {
  if (patched) return;
  patched = true;
  const { getConnectionForOrphanedConnection } = Blockly.Connection;
  Blockly.Connection.getConnectionForOrphanedConnection = (block, orphan) => {
    const isDrag = (block.workspace as Blockly.WorkspaceSvg).isDragging();
    const body =
      isDrag && orphan.type === ConnectionType.PREVIOUS_STATEMENT && wrappingInput(block);
    return body || getConnectionForOrphanedConnection.call(Blockly.Connection, block, orphan);
  };
}

/** Plugins for `Blockly.inject` that offer and show what `patchOrphans` does. */
export const WRAPPING_PLUGINS = { connectionChecker: Checker, connectionPreviewer: Previewer };
