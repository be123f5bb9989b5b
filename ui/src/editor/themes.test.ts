import { expect, test } from "vitest";
import { HUES } from "../blocks/hues";
import { contrast } from "../scene/paints";
import { blocklyTheme } from "./themes";

test.each([
  ["light", 4.5],
  ["dark", 4.5],
  ["contrast", 7],
] as const)("in the theme %s white words stand out on blocks and on shadow blocks", (name, bound) => {
  const { blockStyles } = blocklyTheme(name);
  for (const category of Object.keys(HUES)) {
    const { colourPrimary, colourSecondary } = blockStyles[category] ?? {};
    for (const colour of [colourPrimary, colourSecondary])
      expect(contrast("#ffffff", colour ?? ""), category).toBeGreaterThanOrEqual(bound);
  }
});
