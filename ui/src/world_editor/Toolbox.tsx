import { BrickWall, Flag, MapPin, MousePointer2, Package, PaintBucket, Trees } from "lucide-preact";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { RadioGroup } from "../kit/RadioGroup";
import { paintOf } from "../scene/paints";
import { BoxKindField, PrintField } from "./AppearanceFields";
import { TOOLS } from "./drag_gestures";
import type { EditorStore } from "./editor_store";
import { COLORS, colorLabel } from "./labels";

const ICONS = {
  select: MousePointer2,
  wall: BrickWall,
  box: Package,
  zone: MapPin,
  paint: PaintBucket,
  print: Trees,
  start: Flag,
} as const;

/** The drawing tools and the properties of the next object. */
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
      <NextObject store={store} />
    </div>
  );
}

function NextObject({ store }: { store: EditorStore }) {
  const labels = texts.value.world;
  if (store.tool.value === "paint") {
    return <Swatches color={store.color.value} onColor={(color) => store.setPaint(color)} />;
  }
  if (store.tool.value === "print") {
    return (
      <PrintField
        value={store.print.value}
        onChange={(print) => {
          store.print.value = print;
        }}
      />
    );
  }
  if (store.tool.value !== "box") return null;
  return (
    <>
      <BoxKindField
        value={store.boxKind.value}
        onChange={(boxKind) => {
          store.boxKind.value = boxKind;
        }}
      />
      <RadioGroup
        label={labels.tools.box}
        options={[
          [false, labels.fixed],
          [true, labels.movable],
        ]}
        value={store.movable.value}
        onChange={(movable) => {
          store.movable.value = movable;
        }}
      />
    </>
  );
}

interface SwatchesProps {
  color: string | null;
  /** What gets the colour, if not the floor. */
  label?: string;
  onColor(color: string): void;
}

/** The colours that a floor sensor can distinguish. */
export function Swatches({ color, label, onColor }: SwatchesProps) {
  return (
    <fieldset class="swatches" aria-label={label ?? texts.value.world.color}>
      {COLORS.map((one) => {
        return (
          <Button
            label={colorLabel(one, language.value)}
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
