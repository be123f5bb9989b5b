import * as Blockly from "blockly/core";
import { HUES } from "../blocks/hues";

/** Themes of the editor; the rest of the page has the same. */
export type ThemeName = "light" | "dark" | "contrast";

interface BlockColours {
  /** Fill of a block, from its category's hue. */
  face(hue: string): string;
  /** Outline of a block, from its fill. */
  edge(face: string): string;
}

const mix = (colour: string, other: string, part: number) =>
  Blockly.utils.colour.blend(other, colour, part) ?? colour;

const COLOURS_BY_THEME: Readonly<Record<ThemeName, BlockColours>> = {
  light: { face: (hue) => hue, edge: (face) => mix(face, "#000000", 0.3) },
  dark: { face: (hue) => hue, edge: (face) => mix(face, "#ffffff", 0.35) },
  // white on the plain hues has a contrast of 4.5 : 1; the contrast theme has 7 : 1
  contrast: { face: (hue) => mix(hue, "#000000", 0.35), edge: () => "#ffffff" },
};

/** CSS variables of the page, which follow its theme. */
const COMPONENTS: Blockly.Theme.ComponentStyle = {
  workspaceBackgroundColour: "var(--ground)",
  toolboxBackgroundColour: "var(--surface)",
  toolboxForegroundColour: "var(--ink)",
  flyoutBackgroundColour: "var(--sunken)",
  flyoutForegroundColour: "var(--ink)",
  flyoutOpacity: 1,
  scrollbarColour: "var(--line-strong)",
  scrollbarOpacity: 0.45,
  insertionMarkerColour: "#000000",
  insertionMarkerOpacity: 0.25,
  selectedGlowColour: "#f5b700",
};

/** Categories whose blocks start a stack; such blocks are drawn with a cap. */
const BEGIN_STACKS = ["start", "functions"];

/** The Zelos theme in our hues and our font. */
export function blocklyTheme(name: ThemeName): Blockly.Theme {
  const { face, edge } = COLOURS_BY_THEME[name];
  const faces = Object.entries(HUES).map(([category, hue]) => [category, face(hue)] as const);
  return Blockly.Theme.defineTheme(nameOf(name), {
    name: nameOf(name),
    base: Blockly.Themes.Zelos,
    blockStyles: Object.fromEntries(
      faces.map(([category, colour]) => [
        category,
        {
          colourPrimary: colour,
          // of shadow blocks: darker, because their words must keep their contrast
          colourSecondary: mix(colour, "#000000", 0.15),
          colourTertiary: edge(colour),
          hat: BEGIN_STACKS.includes(category) ? "cap" : "",
        },
      ]),
    ),
    categoryStyles: Object.fromEntries(faces.map(([category, colour]) => [category, { colour }])),
    componentStyles: COMPONENTS,
    fontStyle: { family: pageFont(), weight: "600", size: 13.5 },
  });
}

const nameOf = (name: ThemeName) => `pinel-${name}`;

/** Sets the theme of a workspace; redraws it only if the theme differs. */
export function showTheme(workspace: Blockly.WorkspaceSvg, name: ThemeName): void {
  if (workspace.getTheme().name === nameOf(name)) return;
  workspace.setTheme(blocklyTheme(name));
  // Blockly shows the toolbox again
  workspace.getToolbox()?.setVisible(!workspace.isReadOnly());
}

/** Name of the page's font: Blockly measures text outside the page, without its CSS variables. */
export function pageFont(): string {
  const font = getComputedStyle(document.documentElement).getPropertyValue("--font").trim();
  return font || "system-ui, sans-serif";
}
