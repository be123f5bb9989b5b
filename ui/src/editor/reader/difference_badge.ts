import * as Blockly from "blockly/core";

/** How a block changed between two versions. */
export type Difference = "added" | "removed" | "changed" | "moved";

const { dom, Svg } = Blockly.utils;

/**
 * SVG paths of the badges, drawn in a disc at the block's corner, so that differences do not depend
 * on colour alone.
 */
export const BADGE_PATHS: Readonly<Record<Difference, string>> = {
  added: "M-5 0H5M0 -5V5",
  removed: "M-5 0H5",
  changed: "M-5 -2.5H5M-5 2.5H5M3 -5.5L-3 5.5",
  moved: "M0 -6V6M-3 -3L0 -6L3 -3M-3 3L0 6L3 3",
};

const RADIUS = 11;

/**
 * Draws the badges above all blocks, because the next block in a stack would cover them. They need
 * not follow their block: read-only blocks do not move.
 */
export function addDifferenceBadge(block: Blockly.BlockSvg, kinds: readonly Difference[]): void {
  const { x, y } = block.getRelativeToSurfaceXY();
  const layer = block.workspace.getCanvas();
  kinds.forEach((kind, place) => {
    const badge = dom.createSvgElement(Svg.G, { class: `pinelSign pinelSign--${kind}` }, layer);
    badge.setAttribute("transform", `translate(${x + 2 + place * (2 * RADIUS + 2)} ${y + 1})`);
    dom.createSvgElement(Svg.CIRCLE, { r: RADIUS }, badge);
    dom.createSvgElement(Svg.PATH, { d: BADGE_PATHS[kind] }, badge);
  });
}
