import * as Blockly from "blockly/core";
import { blockText } from "../../blocks/texts";

const MENU = "pinel_breakpoint";
const DOT_CLASS = "pinelBreakpoint";
const RADIUS = 7;
/**
 * Offset of the dot from the left edge of the block's first row, which has no text or icon there.
 */
const LEFT = -2;
const MIDDLE = 24;

/** Blocks before which a run pauses. The block's menu and the key F6 toggle their red dots. */
export class Breakpoints {
  private static readonly of = new WeakMap<Blockly.Workspace, Breakpoints>();
  private readonly ids = new Set<string>();

  constructor(
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly changed: (ids: readonly string[]) => void,
  ) {
    Breakpoints.of.set(workspace, this);
    registerMenu();
    registerKey();
  }

  static at(block: Blockly.BlockSvg): Breakpoints | undefined {
    return Breakpoints.of.get(block.workspace);
  }

  has(block: Blockly.Block): boolean {
    return this.ids.has(block.id);
  }

  toggle(block: Blockly.BlockSvg): void {
    if (!this.ids.delete(block.id)) this.ids.add(block.id);
    this.draw(block);
    this.changed([...this.ids]);
  }

  /** Draws the dots of recreated blocks again and drops breakpoints of deleted blocks. */
  refresh(): void {
    const before = this.ids.size;
    for (const id of [...this.ids]) {
      const block = this.workspace.getBlockById(id);
      if (block) this.draw(block);
      else this.ids.delete(id);
    }
    if (this.ids.size !== before) this.changed([...this.ids]);
  }

  clear(): void {
    for (const id of [...this.ids]) {
      this.ids.delete(id);
      const block = this.workspace.getBlockById(id);
      if (block) this.draw(block);
    }
    this.changed([]);
  }

  private draw(block: Blockly.BlockSvg): void {
    const root = block.getSvgRoot();
    root.querySelector(`:scope > .${DOT_CLASS}`)?.remove();
    if (!this.has(block)) return;
    Blockly.utils.dom.createSvgElement(
      Blockly.utils.Svg.CIRCLE,
      { class: DOT_CLASS, r: RADIUS, cx: LEFT, cy: MIDDLE },
      root,
    );
  }
}

/** A run can pause before commands only: values and the start block take no time of their own. */
function canHold(block: Blockly.BlockSvg | undefined): block is Blockly.BlockSvg {
  return Boolean(block?.previousConnection && !block.isInFlyout);
}

function registerMenu(): void {
  const { registry } = Blockly.ContextMenuRegistry;
  if (registry.getItem(MENU)) return;
  registry.register({
    id: MENU,
    associatedKeyboardShortcut: MENU,
    scopeType: Blockly.ContextMenuRegistry.ScopeType.BLOCK,
    weight: 7,
    displayText: ({ block }) =>
      block && Breakpoints.at(block)?.has(block)
        ? blockText("BREAKPOINT_REMOVE")
        : blockText("BREAKPOINT_ADD"),
    preconditionFn: ({ block }) => (canHold(block) && Breakpoints.at(block) ? "enabled" : "hidden"),
    callback: ({ block }) => {
      if (block) Breakpoints.at(block)?.toggle(block);
    },
  });
}

function registerKey(): void {
  const { registry } = Blockly.ShortcutRegistry;
  if (registry.getRegistry()[MENU]) return;
  registry.register({
    name: MENU,
    keyCodes: [Blockly.utils.KeyCodes.F6], // F9 stops a real robot
    preconditionFn: (workspace) => !workspace.isDragging(),
    callback: () => {
      const focused = Blockly.getFocusManager().getFocusedNode();
      if (!(focused instanceof Blockly.BlockSvg) || !canHold(focused)) return false;
      Breakpoints.at(focused)?.toggle(focused);
      return true;
    },
  });
}
