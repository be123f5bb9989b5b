import * as Blockly from "blockly/core";
import { registerBlocks } from "../blocks";
import type { Level } from "../blocks/definition";
import type { BlockType } from "../blocks/definitions";
import { searchBlocks } from "../blocks/toolbox/search";
import { flyoutBlock, type OfferedActions, offeredRows } from "../blocks/toolbox/toolbox";
import type { Language } from "../i18n";
import { applyLanguage } from "./locale";
import { RENDERER, registerRenderer } from "./renderer";
import { blocklyTheme, type ThemeName } from "./themes";
import { patchAriaUpdates, withoutEvents } from "./without_events";

export interface BlockDrawing {
  readonly type: BlockType;
  readonly category: string;
  /** The text of the block, with its default values. */
  readonly text: string;
  readonly svg: SVGSVGElement;
}

export interface BlockDrawings {
  /** Classes for an element around the drawings; Blockly's style sheet depends on them. */
  readonly stageClasses: string;
  /** The blocks that a level offers, in the order of the toolbox. */
  readonly all: readonly BlockDrawing[];
  /** The blocks that the toolbox search finds, best match first. */
  find(query: string): BlockDrawing[];
}

interface DrawingOptions {
  language: Language;
  theme: ThemeName;
  level: Level;
  /** The actions that an activity offers; null for all blocks of the level. */
  offered: OfferedActions;
}

/** Calls need a function definition, and the drawings have none. */
const NOT_ALONE: readonly BlockType[] = ["call", "call_value"];
const SCALE = 0.8;

/** Draws each block of a level as the flyout offers it. The drawings do not change afterwards. */
export function drawBlocks({ language, theme, level, offered }: DrawingOptions): BlockDrawings {
  applyLanguage(language);
  registerBlocks();
  registerRenderer();
  patchAriaUpdates();
  return onStage(theme, (workspace) => {
    const rows = offeredRows(level, offered).filter(({ type }) => !NOT_ALONE.includes(type));
    const all = rows.map(({ type, style }) => ({
      type,
      category: style,
      ...drawn(flyoutBlock(type, level, workspace), workspace),
    }));
    const byType = new Map<string | undefined, BlockDrawing>(all.map((one) => [one.type, one]));
    return {
      stageClasses: stageClassesOf(workspace),
      all,
      find: (query) => [
        ...new Set(
          searchBlocks(query, level, new Blockly.Workspace(), offered).flatMap(
            ({ type }) => byType.get(type) ?? [],
          ),
        ),
      ],
    };
  });
}

const STAGE = "injectionDiv";

/** Classes of the hidden workspace; Blockly's style sheet depends on them. */
export function stageClassesOf(workspace: Blockly.WorkspaceSvg): string {
  return [...workspace.getInjectionDiv().classList].filter((one) => one !== STAGE).join(" ");
}

/**
 * Calls `draw` with a hidden temporary workspace, then restores the editor as Blockly's main
 * workspace.
 */
export function onStage<Drawn>(
  theme: ThemeName,
  draw: (workspace: Blockly.WorkspaceSvg) => Drawn,
): Drawn {
  const editor: Blockly.Workspace | undefined = Blockly.common.getMainWorkspace();
  const container = document.createElement("div");
  container.className = "visually-hidden";
  container.inert = true;
  document.body.append(container);
  const workspace = Blockly.inject(container, {
    theme: blocklyTheme(theme),
    renderer: RENDERER,
    css: false, // the renderer adds it
    media: "/media/",
    sounds: false,
    readOnly: true,
  });
  try {
    return draw(workspace);
  } finally {
    workspace.dispose();
    container.remove();
    if (editor) Blockly.common.setMainWorkspace(editor); // undefined on screens without an editor
  }
}

/** Text and picture of a block; `change` may modify the block before it is drawn. */
export function drawn(
  state: Blockly.serialization.blocks.State,
  workspace: Blockly.WorkspaceSvg,
  change: (block: Blockly.BlockSvg) => void = () => {},
): Pick<BlockDrawing, "text" | "svg"> {
  let block: Blockly.BlockSvg | undefined;
  withoutEvents(() => {
    block = Blockly.serialization.blocks.append(state, workspace) as Blockly.BlockSvg;
    change(block);
  });
  Blockly.renderManagement.triggerQueuedRenders(workspace);
  if (!block) throw new Error(`there is no drawing of ${state.type}`);
  const text = block.toString().replace(/\s+/g, " ");
  const svg = pictureOf(block.getSvgRoot());
  withoutEvents(() => block?.dispose());
  return { text, svg };
}

function pictureOf(root: SVGGElement): SVGSVGElement {
  const { x, y, width, height } = root.getBBox();
  const svg = Blockly.utils.dom.createSvgElement<SVGSVGElement>(Blockly.utils.Svg.SVG, {
    viewBox: `${x - 1} ${y - 1} ${width + 2} ${height + 2}`,
    width: (width + 2) * SCALE,
    height: (height + 2) * SCALE,
    "aria-hidden": "true",
    focusable: "false",
  });
  const copy = root.cloneNode(true) as SVGGElement;
  copy.removeAttribute("transform");
  for (const one of [copy, ...copy.querySelectorAll("*")]) {
    for (const name of ["id", "data-id", "tabindex", "role"]) one.removeAttribute(name);
  }
  svg.append(copy);
  return svg;
}
