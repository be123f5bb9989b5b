import type * as Blockly from "blockly/core";
import type { TextKey } from "../blocks/texts";
import { blockText } from "../blocks/texts";
import { svgIcon } from "./svg_icon";

const SHAPES = {
  ZOOM_IN: "M12 5v14M5 12h14",
  ZOOM_OUT: "M5 12h14",
  ZOOM_TO_FIT:
    "M8 3H5a2 2 0 0 0-2 2v3m18 0V5a2 2 0 0 0-2-2h-3m0 18h3a2 2 0 0 0 2-2v-3M3 16v3a2 2 0 0 0 2 2h3",
} as const satisfies Partial<Record<TextKey, string>>;

type Control = keyof typeof SHAPES;

/** Adds zoom buttons large enough for touch; Blockly's own are 32 pixels and hard to see. */
export function addZoomControls(workspace: Blockly.WorkspaceSvg, zoomToFit: () => void) {
  const actions: Record<Control, () => void> = {
    ZOOM_IN: () => zoom(workspace, 1),
    ZOOM_OUT: () => zoom(workspace, -1),
    ZOOM_TO_FIT: zoomToFit,
  };
  const bar = document.createElement("div");
  bar.className = "pinelZoom";
  const buttons = (Object.keys(SHAPES) as Control[]).map((control) => {
    const button = zoomButton(control);
    button.addEventListener("click", actions[control]);
    bar.append(button);
    return { control, button };
  });
  const relabel = () => {
    for (const { control, button } of buttons) {
      button.title = blockText(control);
      button.setAttribute("aria-label", blockText(control));
    }
  };
  relabel();
  workspace.getInjectionDiv().append(bar);
  return { relabel, remove: () => bar.remove() };
}

/**
 * Zooms around the upper left corner, where programs start. Around the centre, the program would
 * move below the flyout.
 */
function zoom(workspace: Blockly.WorkspaceSvg, steps: number): void {
  const { left, top } = workspace.getMetricsManager().getAbsoluteMetrics();
  workspace.zoom(left, top, steps);
}

function zoomButton(control: Control): HTMLButtonElement {
  const button = document.createElement("button");
  button.type = "button";
  button.dataset.testid = `editor-${control.toLowerCase().replaceAll("_", "-")}`;
  button.append(svgIcon(SHAPES[control], "pinelZoomIcon"));
  return button;
}
