import { Download, FolderOpen, Trash2 } from "lucide-preact";
import { WORLD_LIMITS } from "../api/declared";
import { worldTitle } from "../api/model";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { NumberField } from "../kit/NumberField";
import { Select } from "../kit/Select";
import { FileButton } from "../shell/files/FileButton";
import { worlds } from "../shell/session";
import { GroundField } from "./AppearanceFields";
import type { EditorStore } from "./editor_store";
import { GRID } from "./geometry";
import type { FloorPlan } from "./plan";

interface WorldPanelProps {
  store: EditorStore;
  plan: FloorPlan;
  /** Null while the program has no world of its own to delete. */
  onForget: (() => void) | null;
  onExport(): void;
  onFile(file: File): void;
}

/** Properties of the world: name, size of the floor, template, files. */
export function WorldPanel({ store, plan, onForget, onExport, onFile }: WorldPanelProps) {
  const labels = texts.value.world;
  const side = (key: "width" | "depth", label: string) => (
    <NumberField
      label={label}
      value={plan[key]}
      min={WORLD_LIMITS.MIN_FLOOR_M}
      max={WORLD_LIMITS.MAX_FLOOR_M}
      step={GRID}
      testId={`world-floor-${key}`}
      onNumber={(value) => store.resize({ width: plan.width, depth: plan.depth, [key]: value })}
    />
  );
  return (
    <section
      class="world-panel column grows shrinks-down gap-2"
      data-testid="world-panel"
      data-kind="world"
    >
      <label class="world-panel__text">
        {labels.name}
        <input
          class="field"
          value={worldTitle(store.world.value, language.value)}
          maxLength={WORLD_LIMITS.MAX_TITLE}
          data-testid="world-name"
          onInput={({ currentTarget: { value } }) => store.rename(value)}
        />
      </label>
      <h3>{labels.floorSize}</h3>
      <div class="numbers">
        {side("width", labels.width)}
        {side("depth", labels.depth)}
      </div>
      <GroundField value={plan.ground} onChange={(ground) => store.cover(ground)} />
      <BeginFrom store={store} />
      <div class="world-panel__acts row wrap gap-2">
        <FileButton icon={FolderOpen} accept=".json" testId="world-file" onFile={onFile}>
          {labels.fromFile}
        </FileButton>
        <Button icon={Download} testId="world-export" onPress={onExport}>
          {labels.toFile}
        </Button>
        {onForget && (
          <Button icon={Trash2} testId="world-forget" onPress={onForget}>
            {labels.forget}
          </Button>
        )}
      </div>
    </section>
  );
}

function BeginFrom({ store }: { store: EditorStore }) {
  const labels = texts.value.world;
  return (
    <label class="world-panel__text">
      {labels.beginFrom}
      <Select
        testId="world-begin"
        value=""
        options={[
          ["", labels.choose],
          ...worlds.value.map((one) => [one.name, worldTitle(one, language.value)] as const),
        ]}
        onChange={(name) => {
          const world = worlds.value.find((one) => one.name === name);
          if (world) store.replace(world);
        }}
      />
    </label>
  );
}
