import { BrickWall, Flag, MapPin, MousePointer2, Package, PaintBucket } from "lucide-preact";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { Choice } from "../kit/Choice";
import { paintOf } from "../scene/paints";
import type { EditorStore } from "./editor_store";
import { TOOLS } from "./gestures";
import { COLORS, colorWord } from "./words";

const ICONS = {
  select: MousePointer2,
  wall: BrickWall,
  box: Package,
  zone: MapPin,
  paint: PaintBucket,
  start: Flag,
} as const;

/** The drawing tools and the properties of the next thing. */
export function Toolbox({ store }: { store: EditorStore }) {
  const { tools, toolsLabel } = texts.value.world;
  return (
    <div
      class="world-tools column gap-1"
      role="toolbar"
      aria-label={toolsLabel}
      aria-orientation="vertical"
    >
      {TOOLS.map((tool) => {
        const Icon = ICONS[tool];
        return (
          <Button
            icon={Icon}
            kind="plain"
            class="world-tools__tool"
            key={tool}
            pressed={store.tool.value === tool}
            testId="world-tool"
            data-tool={tool}
            onPress={() => store.choose(tool)}
          >
            {tools[tool]}
          </Button>
        );
      })}
      <NextThing store={store} />
    </div>
  );
}

function NextThing({ store }: { store: EditorStore }) {
  const words = texts.value.world;
  if (store.tool.value === "paint") {
    return <Swatches color={store.color.value} onColor={(color) => store.dip(color)} />;
  }
  if (store.tool.value !== "box") return null;
  return (
    <Choice
      label={words.tools.box}
      options={[
        [false, words.fixed],
        [true, words.movable],
      ]}
      value={store.movable.value}
      onChange={(movable) => {
        store.movable.value = movable;
      }}
    />
  );
}

/** The colours that a floor sensor can distinguish. */
export function Swatches({ color, onColor }: { color: string; onColor(color: string): void }) {
  return (
    <fieldset class="swatches" aria-label={texts.value.world.color}>
      {COLORS.map((one) => {
        const word = colorWord(one, language.value);
        return (
          <Button
            label={word}
            kind="bare"
            class="swatch"
            key={one}
            style={{ "--swatch": paintOf(one) }}
            pressed={color === one}
            testId="world-color"
            data-color={one}
            onPress={() => onColor(one)}
          />
        );
      })}
    </fieldset>
  );
}
