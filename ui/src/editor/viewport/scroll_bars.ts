import type * as Blockly from "blockly/core";

/** Shows the workspace's scroll bars only while a part of the program is out of view. */
export class ScrollBars {
  private frame = 0;

  constructor(private readonly workspace: Blockly.WorkspaceSvg) {
    workspace.addChangeListener(this.refresh);
  }

  /** Checks at the next animation frame; several calls before it cause one check. */
  readonly refresh = (): void => {
    this.frame ||= requestAnimationFrame(() => {
      this.frame = 0;
      this.workspace.scrollbar?.setContainerVisible(!this.allIsInView());
    });
  };

  dispose(): void {
    cancelAnimationFrame(this.frame);
    this.workspace.removeChangeListener(this.refresh);
  }

  private allIsInView(): boolean {
    const metrics = this.workspace.getMetricsManager();
    const content = metrics.getContentMetrics(true);
    const view = metrics.getViewMetrics(true);
    return (
      content.left >= view.left &&
      content.top >= view.top &&
      content.left + content.width <= view.left + view.width &&
      content.top + content.height <= view.top + view.height
    );
  }
}
