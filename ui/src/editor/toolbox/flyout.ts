import * as Blockly from "blockly/core";
import { showFlyoutRole } from "./flyout_roles";

/**
 * Scale and width of a pinned flyout: every block of the first level fits, and half of the pane
 * stays free.
 */
const STAYING_SCALE = 0.75;
const STAYING_WIDTH_PX = 284;

/** The flyout. While pinned it has a fixed width, so that the workspace beside it never moves. */
class PinelFlyout extends Blockly.VerticalFlyout {
  override getFlyoutScale(): number {
    return this.autoClose ? super.getFlyoutScale() : STAYING_SCALE;
  }

  protected override updateAriaContext(): void {
    super.updateAriaContext();
    showFlyoutRole(this.workspace_.getCanvas());
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

/** The toolbox. Its flyout closes after each block, or is pinned open beside the workspace. */
export class PinelToolbox extends Blockly.Toolbox {
  private pinned = false;

  /** Pins the flyout open, starting with the first category, or lets it close again. */
  setPinned(isPinned: boolean): void {
    if (isPinned === this.pinned) return;
    this.pinned = isPinned;
    const flyout = this.getFlyout();
    if (!isPinned) this.setSelectedItem(null);
    if (flyout instanceof PinelFlyout) flyout.setAutoClose(!isPinned);
    if (isPinned) this.open(null);
  }

  /** Opens the first category if no category is open. */
  offer(): void {
    if (!this.getSelectedItem()) this.open(null);
  }

  override clearSelection(): void {
    if (!this.pinned) super.clearSelection();
  }

  /** Replaces the categories; the open category stays open. */
  override render(toolboxDef: Blockly.utils.toolbox.ToolboxInfo): void {
    const before = this.getSelectedItem()?.getId() ?? null;
    this.setSelectedItem(null);
    super.render(toolboxDef);
    if (this.pinned) this.open(before);
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

/** Plugins for `Blockly.inject` that replace Blockly's own toolbox and flyout. */
export const TOOLBOX_PLUGINS = { toolbox: PinelToolbox, flyoutsVerticalToolbox: PinelFlyout };
