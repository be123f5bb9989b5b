import { ChevronDown, Map as MapIcon } from "lucide-preact";
import { OWN_WORLD, type World, worldTitle } from "../api/model";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";

interface WorldChoiceProps {
  worlds: readonly World[];
  world: string;
  /** What the group calls the world that it has made; null while it has made none. */
  own: string | null;
  /** A robot on its way cannot change places. */
  busy: boolean;
  onWorld(name: string): void;
}

/** Where the robot drives, chosen on the floor itself. */
export function WorldChoice({ worlds, world, own, busy, onWorld }: WorldChoiceProps) {
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
        {own !== null && <option value={OWN_WORLD}>{own}</option>}
        {worlds.map((one) => (
          <option key={one.name} value={one.name}>
            {worldTitle(one, language.value)}
          </option>
        ))}
      </select>
      <ChevronDown class="icon icon--end" aria-hidden="true" />
    </span>
  );
}
