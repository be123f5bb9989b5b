import * as Blockly from "blockly/core";
import { type Category, HUES } from "../blocks/hues";

export type ThemeName = "light" | "dark" | "contrast";

interface Look {
  /** Edge of a block and ground of its holes, from its hue. */
  edge(hue: string): string;
  components: Blockly.Theme.ComponentStyle;
}

const mix = (hue: string, other: string, part: number) =>
  Blockly.utils.colour.blend(hue, other, 1 - part) ?? hue;

const LOOKS: Readonly<Record<ThemeName, Look>> = {
  light: {
    edge: (hue) => mix(hue, "#000000", 0.3),
    components: {
      workspaceBackgroundColour: "var(--editor-ground)",
      toolboxBackgroundColour: "var(--editor-toolbox)",
      toolboxForegroundColour: "var(--editor-ink)",
      flyoutBackgroundColour: "var(--editor-flyout)",
      flyoutForegroundColour: "var(--editor-ink)",
      flyoutOpacity: 1,
      scrollbarColour: "var(--editor-scrollbar)",
      scrollbarOpacity: 0.6,
      insertionMarkerColour: "var(--editor-ink)",
      insertionMarkerOpacity: 0.25,
      selectedGlowColour: "#f5b700",
    },
  },
  dark: {
    edge: (hue) => mix(hue, "#ffffff", 0.35),
    components: {},
  },
  contrast: {
    edge: () => "#ffffff",
    components: {},
  },
};

/** Zelos in our hues and our font; the grounds are CSS variables of `editor.css`, which knows the page's tokens. */
export function blocklyTheme(name: ThemeName): Blockly.Theme {
  const { edge } = LOOKS[name];
  const entries = Object.entries(HUES) as [Category, string][];
  return Blockly.Theme.defineTheme(`pinel-${name}`, {
    name: `pinel-${name}`,
    base: Blockly.Themes.Zelos,
    blockStyles: Object.fromEntries(
      entries.map(([category, hue]) => [
        category,
        {
          colourPrimary: hue,
          colourSecondary: mix(hue, "#ffffff", 0.15),
          colourTertiary: edge(hue),
          hat: category === "start" ? "cap" : "",
        },
      ]),
    ),
    categoryStyles: Object.fromEntries(
      entries.map(([category, hue]) => [category, { colour: hue }]),
    ),
    componentStyles: { ...LOOKS.light.components, ...LOOKS[name].components },
    fontStyle: { family: "var(--editor-font)", weight: "600", size: 13.5 },
  });
}
