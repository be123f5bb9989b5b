import type * as Blockly from "blockly/core";
import type { Expression } from "../../blocks/generator/document";
import { VALUES } from "../../blocks/generator/values";

/** Evaluates an expression and formats its value; null if evaluation is not possible now. */
export type EvaluateExpression = (expression: Expression) => Promise<string> | null;

const REST_MS = 250;
const GAP = 8;

/**
 * Shows the value of a block in a tooltip while the pointer rests on it, if evaluation is possible.
 */
export class ValueBubble {
  private readonly bubble = document.createElement("div");
  private block: Blockly.BlockSvg | null = null;
  private timer = 0;

  constructor(
    private readonly workspace: Blockly.WorkspaceSvg,
    private readonly evaluate: EvaluateExpression,
  ) {
    this.bubble.className = "pinelValue";
    this.bubble.setAttribute("role", "status");
    this.bubble.hidden = true;
    workspace.getInjectionDiv().append(this.bubble);
    workspace.getParentSvg().addEventListener("pointerover", this.onPointer);
    workspace.getParentSvg().addEventListener("pointerleave", this.hide);
  }

  dispose(): void {
    window.clearTimeout(this.timer);
    this.workspace.getParentSvg().removeEventListener("pointerover", this.onPointer);
    this.workspace.getParentSvg().removeEventListener("pointerleave", this.hide);
    this.bubble.remove();
  }

  private readonly onPointer = (event: Event): void => {
    const block = this.valueBlockAt(event.target as Element);
    if (block === this.block) return;
    this.hide();
    this.block = block;
    if (block) this.timer = window.setTimeout(() => void this.ask(block), REST_MS);
  };

  private readonly hide = (): void => {
    window.clearTimeout(this.timer);
    this.block = null;
    this.bubble.hidden = true;
  };

  private valueBlockAt(target: Element): Blockly.BlockSvg | null {
    const id = target.closest(".blocklyDraggable")?.getAttribute("data-id");
    const block = id ? this.workspace.getBlockById(id) : null;
    return block?.outputConnection && block.type in VALUES ? block : null;
  }

  private async ask(block: Blockly.BlockSvg): Promise<void> {
    const text = await this.evaluate(VALUES[block.type as keyof typeof VALUES](block));
    if (text === null || this.block !== block || block.disposed) return;
    this.bubble.textContent = text;
    this.bubble.hidden = false;
    const of = block.getSvgRoot().getBoundingClientRect();
    const around = this.workspace.getInjectionDiv().getBoundingClientRect();
    this.bubble.style.left = `${of.left - around.left}px`;
    this.bubble.style.top = `${of.bottom - around.top + GAP}px`;
  }
}
