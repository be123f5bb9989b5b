import * as Blockly from "blockly/core";

/** Size of a palette that stays open: every block of the first level fits, and the workspace keeps half of the pane. */
const STAYING_SCALE = 0.75;
const STAYING_WIDTH_PX = 284;

/** The blocks of a category. Of a fixed size while it stays open, so that the workspace beside it never moves. */
class PinelFlyout extends Blockly.VerticalFlyout {
  override getFlyoutScale(): number {
    return this.autoClose ? super.getFlyoutScale() : STAYING_SCALE;
  }

  protected override reflowInternal_(): void {
    if (this.autoClose) {
      super.reflowInternal_();
      return;
    }
    this.workspace_.scale = this.getFlyoutScale();
    if (this.getWidth() === STAYING_WIDTH_PX) return;
    this.width_ = STAYING_WIDTH_PX;
    this.position();
    this.targetWorkspace.resizeContents();
    this.targetWorkspace.recordDragTargets();
  }
}

/** The categories. Their palette closes after each block, or stays open beside the workspace. */
export class PinelToolbox extends Blockly.Toolbox {
  private staying = false;

  /** Keeps the palette open, with the first category to begin with, or lets it close again. */
  setStaying(staying: boolean): void {
    if (staying === this.staying) return;
    this.staying = staying;
    const flyout = this.getFlyout();
    if (!staying) this.setSelectedItem(null);
    if (flyout instanceof PinelFlyout) flyout.setAutoClose(!staying);
    if (staying) this.open(null);
  }

  /** Shows the first category, if none is shown. */
  offer(): void {
    if (!this.getSelectedItem()) this.open(null);
  }

  override clearSelection(): void {
    if (!this.staying) super.clearSelection();
  }

  /** Shows other categories; the one that was open stays so. */
  override render(toolboxDef: Blockly.utils.toolbox.ToolboxInfo): void {
    const before = this.getSelectedItem()?.getId() ?? null;
    this.setSelectedItem(null);
    super.render(toolboxDef);
    if (this.staying) this.open(before);
  }

  private open(id: string | null): void {
    const items = this.getToolboxItems();
    const again = items.find((item) => item.getId() === id);
    this.setSelectedItem(again ?? items.find(isCategory) ?? null);
  }
}

function isCategory(item: Blockly.IToolboxItem): boolean {
  return item instanceof Blockly.ToolboxCategory && item.getContents().length > 0;
}

/** What `Blockly.inject` takes in place of its own toolbox and flyout. */
export const TOOLBOX_PLUGINS = { toolbox: PinelToolbox, flyoutsVerticalToolbox: PinelFlyout };
