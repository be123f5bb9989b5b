import { BrickWall, Flag, MapPin, MousePointer2, Package, PaintBucket } from "lucide-preact";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { paintOf } from "../scene/paints";
import { Choice } from "./Choice";
import type { WorldDesk } from "./desk";
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

/** What a hand can draw, and how what it draws next will be. */
export function Toolbox({ desk }: { desk: WorldDesk }) {
  const { tools, toolsLabel } = texts.value.world;
  return (
    <div class="world-tools" role="toolbar" aria-label={toolsLabel} aria-orientation="vertical">
      {TOOLS.map((tool) => {
        const Icon = ICONS[tool];
        return (
          <button
            key={tool}
            type="button"
            class="button button--plain world-tools__tool"
            aria-pressed={desk.tool.value === tool}
            data-testid={TEST.worldTool}
            data-tool={tool}
            onClick={() => desk.choose(tool)}
          >
            <Icon class="icon" aria-hidden="true" />
            {tools[tool]}
          </button>
        );
      })}
      <NextThing desk={desk} />
    </div>
  );
}

function NextThing({ desk }: { desk: WorldDesk }) {
  const words = texts.value.world;
  if (desk.tool.value === "paint") {
    return <Swatches color={desk.color.value} onColor={(color) => desk.dip(color)} />;
  }
  if (desk.tool.value !== "box") return null;
  return (
    <Choice
      label={words.tools.box}
      options={[
        [false, words.fixed],
        [true, words.movable],
      ]}
      value={desk.movable.value}
      onValue={(movable) => {
        desk.movable.value = movable;
      }}
    />
  );
}

/** The colours that a floor sensor can tell apart. */
export function Swatches({ color, onColor }: { color: string; onColor(color: string): void }) {
  return (
    <fieldset class="swatches" aria-label={texts.value.world.color}>
      {COLORS.map((one) => {
        const word = colorWord(one, language.value);
        return (
          <button
            key={one}
            type="button"
            class="swatch"
            style={{ "--swatch": paintOf(one) }}
            aria-label={word}
            title={word}
            aria-pressed={color === one}
            data-testid={TEST.worldColor}
            data-color={one}
            onClick={() => onColor(one)}
          />
        );
      })}
    </fieldset>
  );
}
