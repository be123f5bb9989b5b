import * as Blockly from "blockly/core";
import { blockText } from "../../blocks/texts";

const WIDTH = 316;
const HEIGHT = 48;

/** Placeholder below a start block without blocks; it shows where the first block goes. */
export class StartHint {
  private group: SVGElement | null = null;

  show(start: Blockly.BlockSvg): void {
    this.hide();
    const { dom, Svg } = Blockly.utils;
    const top = start.getHeightWidth().height + 8;
    this.group = dom.createSvgElement(Svg.G, {
      class: "pinelStartHint",
      transform: `translate(0 ${top})`,
    });
    dom.createSvgElement(
      Svg.RECT,
      { class: "pinelStartHintPlace", width: WIDTH, height: HEIGHT, rx: 8 },
      this.group,
    );
    const text = dom.createSvgElement(
      Svg.TEXT,
      { class: "pinelStartHintText", x: WIDTH / 2, y: HEIGHT / 2 },
      this.group,
    );
    text.textContent = blockText("HINT_EMPTY");
    start.getSvgRoot().append(this.group);
  }

  hide(): void {
    this.group?.remove();
    this.group = null;
  }
}
