import { ChevronDown, Download, FolderOpen, Trash2 } from "lucide-preact";
import { useRef } from "preact/hooks";
import { worldTitle } from "../api/model";
import { worlds } from "../app/session";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import type { WorldDesk } from "./desk";
import { GRID } from "./geometry";
import { FLOOR_LEAST, LONGEST, TITLE_MOST } from "./limits";
import { NumberField } from "./NumberField";
import type { Plan } from "./plan";

interface WorldPanelProps {
  desk: WorldDesk;
  plan: Plan;
  /** Null while the program has no world of its own to forget. */
  onForget: (() => void) | null;
  onExport(): void;
  onFile(file: File): void;
}

/** The world itself: its name, the floor's size, where to begin from, files. */
export function WorldPanel({ desk, plan, onForget, onExport, onFile }: WorldPanelProps) {
  const words = texts.value.world;
  const side = (key: "width" | "depth", label: string) => (
    <NumberField
      label={label}
      value={plan[key]}
      least={FLOOR_LEAST}
      most={LONGEST}
      step={GRID}
      testId={`world-floor-${key}`}
      onNumber={(value) => desk.resize({ width: plan.width, depth: plan.depth, [key]: value })}
    />
  );
  return (
    <section class="world-panel" data-testid={TEST.worldPanel} data-kind="world">
      <label class="world-panel__text">
        {words.name}
        <input
          class="field"
          value={worldTitle(desk.world.value, language.value)}
          maxLength={TITLE_MOST}
          data-testid={TEST.worldName}
          onInput={({ currentTarget: { value } }) => desk.rename(value)}
        />
      </label>
      <h3>{words.floorSize}</h3>
      <div class="numbers">
        {side("width", words.width)}
        {side("depth", words.depth)}
      </div>
      <BeginFrom desk={desk} />
      <div class="world-panel__acts">
        <OpenFile onFile={onFile} />
        <button type="button" class="button" data-testid={TEST.worldExport} onClick={onExport}>
          <Download class="icon" aria-hidden="true" />
          {words.toFile}
        </button>
        {onForget && (
          <button type="button" class="button" data-testid={TEST.worldForget} onClick={onForget}>
            <Trash2 class="icon" aria-hidden="true" />
            {words.forget}
          </button>
        )}
      </div>
    </section>
  );
}

function BeginFrom({ desk }: { desk: WorldDesk }) {
  const words = texts.value.world;
  return (
    <label class="world-panel__text">
      {words.beginFrom}
      <span class="select">
        <select
          data-testid={TEST.worldBegin}
          value=""
          onChange={({ currentTarget }) => {
            const world = worlds.value.find((one) => one.name === currentTarget.value);
            currentTarget.value = "";
            if (world) desk.replace(world);
          }}
        >
          <option value="">{words.choose}</option>
          {worlds.value.map((one) => (
            <option key={one.name} value={one.name}>
              {worldTitle(one, language.value)}
            </option>
          ))}
        </select>
        <ChevronDown class="icon icon--end" aria-hidden="true" />
      </span>
    </label>
  );
}

function OpenFile({ onFile }: { onFile(file: File): void }) {
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <input
        ref={input}
        type="file"
        accept=".json,application/json"
        hidden
        data-testid={TEST.worldFile}
        onChange={({ currentTarget }) => {
          const [file] = currentTarget.files ?? [];
          currentTarget.value = "";
          if (file) onFile(file);
        }}
      />
      <button type="button" class="button" onClick={() => input.current?.click()}>
        <FolderOpen class="icon" aria-hidden="true" />
        {texts.value.world.fromFile}
      </button>
    </>
  );
}
