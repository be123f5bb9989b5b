import * as Blockly from "blockly/core";

/** Name under which the renderer is registered with Blockly. */
export const RENDERER = "pinel";

/** Kinds of rings around a block. */
export type Ring = "running" | "fault" | "advice" | "added" | "removed" | "changed" | "moved";

const CLASSES: Readonly<Record<Ring, string>> = {
  running: "pinelRunning",
  fault: "pinelFault",
  advice: "pinelAdvice",
  added: "pinelAdded",
  removed: "pinelRemoved",
  changed: "pinelChanged",
  moved: "pinelMoved",
};

/** Where the page has the cursors that the rules name. */
const MEDIA = "/media";
const addedRules = new Set<string>();

/**
 * Draws rings above everything inside a block, because the next block would cover half of an
 * outline. Loose blocks are dimmed; Blockly would hatch them.
 */
class PathObject extends Blockly.zelos.PathObject {
  private readonly rings = new Map<Ring, SVGElement>();

  override setPath(path: string): void {
    super.setPath(path);
    for (const ring of this.rings.values()) ring.setAttribute("d", path);
  }

  setRing(ring: Ring, shown: boolean): void {
    this.rings.get(ring)?.remove();
    this.rings.delete(ring);
    this.setClass_(CLASSES[ring], shown);
    if (!shown) return;
    const path = Blockly.utils.dom.createSvgElement(
      Blockly.utils.Svg.PATH,
      { class: `${CLASSES[ring]}Ring`, d: this.svgPath.getAttribute("d") ?? "", role: "none" },
      this.svgRoot,
    );
    this.rings.set(ring, path);
  }

  protected override updateDisabled_(disabled: boolean): void {
    this.setClass_("blocklyDisabled", disabled);
    this.setClass_("pinelLoose", disabled);
  }
}

/**
 * Adds style rules before all others of the page, once for each name. Blockly would put them into
 * style elements, which the page's security policy refuses.
 */
function addRules(name: string, rules: () => string): void {
  const [first] = document.styleSheets;
  if (!first || addedRules.has(name)) return;
  addedRules.add(name);
  first.insertRule(`@media all {${rules()}}`);
}

/** The rules for all workspaces. Blockly gives them only as a style element, here in no document. */
function commonRules(): string {
  const outside = document.createElement("div").attachShadow({ mode: "open" });
  const container = outside.appendChild(document.createElement("div"));
  Blockly.Css.inject(container, true, MEDIA);
  return outside.querySelector("style")?.textContent ?? "";
}

class Constants extends Blockly.zelos.ConstantProvider {
  protected override injectCSS_(_root: Document | ShadowRoot, selector: string): void {
    addRules("common", commonRules);
    addRules(selector, () => this.getCSS_(selector).join("\n"));
  }
}

class Renderer extends Blockly.zelos.Renderer {
  protected override makeConstants_(): Blockly.zelos.ConstantProvider {
    return new Constants();
  }

  override makePathObject(
    root: SVGElement,
    style: Blockly.Theme.BlockStyle,
  ): Blockly.zelos.PathObject {
    return new PathObject(root, style, this.getConstants());
  }
}

export function registerRenderer(): void {
  if (Blockly.registry.hasItem(Blockly.registry.Type.RENDERER, RENDERER)) return;
  Blockly.blockRendering.register(RENDERER, Renderer);
}

export function setRing(block: Blockly.BlockSvg, ring: Ring, shown: boolean): void {
  (block.pathObject as PathObject).setRing(ring, shown);
}
