import type * as Blockly from "blockly/core";
import { type BlockType, definitionOf } from "../blocks/definitions";
import type { Highlight } from "./decorations/highlight";

/** Elements of the editor for the guided tour to point at; null while an element is hidden. */
export class EditorElements {
  constructor(
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly marked: Highlight,
  ) {}

  /** The open flyout with the blocks of a category. */
  flyout(): Element | null {
    const flyout = this.workspace.getFlyout();
    return flyout?.isVisible() ? flyout.getWorkspace().getParentSvg() : null;
  }

  /** The place from which to take a block: the block in the flyout, else its category. */
  offered(type: BlockType): Element | null {
    const shown = this.flyout()
      ? this.workspace.getFlyout()?.getWorkspace().getBlocksByType(type)
      : [];
    const [block] = (shown ?? []) as Blockly.BlockSvg[];
    return block?.getSvgRoot() ?? this.category(definitionOf(type).style);
  }

  /** The stack of blocks below the start block, which is included. */
  program(): Element | null {
    const [start] = this.workspace.getBlocksByType("program_start") as Blockly.BlockSvg[];
    return start?.getSvgRoot() ?? null;
  }

  /** The highlighted block, without the blocks below it. */
  running(): Element | null {
    const { blockId } = this.marked;
    return (blockId && this.workspace.getBlockById(blockId)?.pathObject.svgPath) || null;
  }

  private category(name: string): Element | null {
    return this.workspace.getInjectionDiv().querySelector(`[data-testid="toolbox-${name}"]`);
  }
}
