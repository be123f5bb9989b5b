import { ChevronDown, Map as MapIcon } from "lucide-preact";
import type { World } from "../api/model";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";

interface WorldChoiceProps {
  worlds: readonly World[];
  world: string;
  /** A robot on its way cannot change places. */
  busy: boolean;
  onWorld(name: string): void;
}

/** Where the robot drives, chosen on the floor itself. */
export function WorldChoice({ worlds, world, busy, onWorld }: WorldChoiceProps) {
  const { run } = texts.value;
  return (
    <span class="select">
      <MapIcon class="icon" aria-hidden="true" />
      <select
        aria-label={run.world}
        title={run.world}
        data-testid={TEST.world}
        value={world}
        disabled={busy}
        onChange={(event) => onWorld(event.currentTarget.value)}
      >
        {worlds.map((one) => (
          <option key={one.name} value={one.name}>
            {one.title[language.value]}
          </option>
        ))}
      </select>
      <ChevronDown class="icon icon--end" aria-hidden="true" />
    </span>
  );
}
