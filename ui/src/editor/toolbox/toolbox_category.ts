import * as Blockly from "blockly/core";
import type { Category } from "../../blocks/hues";
import { type IconName, iconShape } from "../../blocks/icons";
import { svgIcon } from "../svg_icon";

const ICONS: Readonly<Record<Exclude<Category, "start">, IconName>> = {
  motion: "arrowUp",
  sensing: "eye",
  flow: "repeat",
  logic: "split",
  gestures: "hand",
  show: "message",
  variables: "box",
  maths: "calculator",
  text: "type",
  lists: "list",
  functions: "puzzle",
};

/** A category as a coloured tile with its icon above its name, wide enough for touch. */
class ToolboxCategory extends Blockly.ToolboxCategory {
  protected override createContainer_(): HTMLDivElement {
    const container = super.createContainer_();
    container.dataset.testid = `toolbox-${this.toolboxItemDef_.id}`;
    return container;
  }

  protected override createIconDom_(): Element {
    const tile = document.createElement("span");
    tile.className = "pinelCategoryTile";
    const icon = ICONS[this.toolboxItemDef_.id as keyof typeof ICONS];
    tile.append(svgIcon(iconShape(icon), "pinelCategoryIcon"));
    return tile;
  }

  protected override addColourBorder_(colour: string): void {
    this.rowDiv_?.style.setProperty("--category-hue", colour);
  }

  override setSelected(selected: boolean): void {
    super.setSelected(selected);
    this.rowDiv_?.style.removeProperty("background-color");
  }
}

/** Registers the tile as Blockly's toolbox category. */
export function registerToolboxCategory(): void {
  Blockly.registry.register(
    Blockly.registry.Type.TOOLBOX_ITEM,
    Blockly.ToolboxCategory.registrationName,
    ToolboxCategory,
    true,
  );
}
