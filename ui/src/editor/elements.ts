import type * as Blockly from "blockly/core";
import { type BlockType, definitionOf } from "../blocks/definitions";
import type { Highlight } from "./marks/highlight";

/** Parts of the editor as the page draws them at the moment, to point at; null while they are not to be seen. */
export class EditorElements {
  constructor(
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly marked: Highlight,
  ) {}

  /** The blocks of the open category. */
  flyout(): Element | null {
    const flyout = this.workspace.getFlyout();
    return flyout?.isVisible() ? flyout.getWorkspace().getParentSvg() : null;
  }

  /** Where a block can be taken: the block in the palette, else its category. */
  offered(type: BlockType): Element | null {
    const shown = this.flyout()
      ? this.workspace.getFlyout()?.getWorkspace().getBlocksByType(type)
      : [];
    const [block] = (shown ?? []) as Blockly.BlockSvg[];
    return block?.getSvgRoot() ?? this.category(definitionOf(type).style);
  }

  /** The blocks that run, from the start block on. */
  program(): Element | null {
    const [start] = this.workspace.getBlocksByType("program_start") as Blockly.BlockSvg[];
    return start?.getSvgRoot() ?? null;
  }

  /** The highlighted block, without those below it. */
  running(): Element | null {
    const { blockId } = this.marked;
    return (blockId && this.workspace.getBlockById(blockId)?.pathObject.svgPath) || null;
  }

  private category(name: string): Element | null {
    return this.workspace.getInjectionDiv().querySelector(`[data-testid="toolbox-${name}"]`);
  }
}
