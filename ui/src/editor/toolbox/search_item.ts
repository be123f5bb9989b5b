import * as Blockly from "blockly/core";
import type { Level } from "../../blocks/definition";
import { iconShape } from "../../blocks/icons";
import { blockText } from "../../blocks/texts";
import { searchBlocks } from "../../blocks/toolbox/search";
import { EVERYTHING, type OfferedActions, SEARCH_KIND } from "../../blocks/toolbox/toolbox";
import { svgIcon } from "../svg_icon";

/** The searched blocks: of a level, or of an activity. */
interface SearchScope {
  level: Level;
  offered: OfferedActions;
}

/**
 * Search field at the top of the toolbox; the flyout shows its results like the blocks of a
 * category.
 */
class SearchItem extends Blockly.ToolboxCategory {
  private declare field: HTMLInputElement;
  private declare hasFound: boolean;

  protected override createDom_(): HTMLDivElement {
    const container = super.createDom_();
    container.removeAttribute("id");
    this.field = this.createField();
    this.rowDiv_?.replaceChildren(svgIcon(iconShape("search"), "pinelSearchIcon"), this.field);
    this.rowDiv_?.classList.add("pinelSearch");
    return container;
  }

  override getFocusableElement(): HTMLElement {
    return this.field;
  }

  override getClickTarget(): Element {
    return this.field;
  }

  override onNodeFocus(): void {
    this.find();
    super.onNodeFocus();
  }

  private createField(): HTMLInputElement {
    const field = document.createElement("input");
    field.id = this.getId();
    field.type = "search";
    field.autocomplete = "off";
    field.placeholder = this.name_;
    field.setAttribute("aria-label", this.name_);
    field.dataset.testid = "toolbox-search";
    // the toolbox closes an item on its second click
    field.addEventListener("pointerdown", (event) => event.stopPropagation());
    field.addEventListener("keydown", (event) => this.onKey(event));
    field.addEventListener("input", () => this.search());
    return field;
  }

  /**
   * Arrow keys move the focus out of the field like out of a category; Escape clears the field
   * first.
   */
  private onKey(event: KeyboardEvent): void {
    const atEnd = this.field.selectionStart === this.field.value.length;
    const navigator = this.parentToolbox_.getNavigator();
    if (event.key === "ArrowDown") this.leave(event, navigator.getNextNode(this));
    // a note cannot have the focus: Blockly would lose it, and no key would work
    else if (event.key === "ArrowRight" && atEnd && this.hasFound)
      this.leave(event, navigator.getInNode(this));
    else if (event.key === "Escape" && this.field.value !== "") {
      event.stopPropagation();
      this.field.value = "";
      this.search();
    }
  }

  private leave(event: KeyboardEvent, to: Blockly.IFocusableNode | null): void {
    if (!to) return;
    event.preventDefault();
    event.stopPropagation();
    Blockly.getFocusManager().focusNode(to);
  }

  private search(): void {
    this.find();
    this.parentToolbox_.refreshSelection();
  }

  private find(): void {
    const query = this.field.value.trim();
    const { level, offered } = this.toolboxItemDef_ as unknown as SearchScope;
    const found = query ? searchBlocks(query, level, this.workspace_, offered) : [];
    const note = query ? this.nothingFound(query) : blockText("SEARCH_HINT");
    this.hasFound = found.length > 0;
    this.flyoutItems_ = this.hasFound ? found : [label(note)];
    if (!query) return;
    const announcement = found.length > 0 ? blockText("SEARCH_FOUND", String(found.length)) : note;
    Blockly.utils.aria.announceDynamicAriaState(announcement);
  }

  private nothingFound(query: string): string {
    const atAnyLevel = searchBlocks(query, EVERYTHING, this.workspace_);
    return blockText(atAnyLevel.length > 0 ? "SEARCH_HIGHER" : "SEARCH_NOTHING");
  }
}

function label(text: string) {
  return { kind: "label" as const, text, "web-class": "pinelFlyoutNote" };
}

/** Registers the search field as a toolbox item of Blockly. */
export function registerSearchItem(): void {
  Blockly.registry.register(Blockly.registry.Type.TOOLBOX_ITEM, SEARCH_KIND, SearchItem, true);
}
