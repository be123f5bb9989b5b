import { Map as MapIcon } from "lucide-preact";
import { OWN_WORLD, type World, worldTitle } from "../../api/model";
import { language, texts } from "../../i18n";
import { Select } from "../../kit/Select";

interface WorldChoiceProps {
  worlds: readonly World[];
  world: string;
  /** Name of the group's own world; null without one. */
  own: string | null;
  /** Whether a run is live: the world cannot change meanwhile. */
  busy: boolean;
  onWorld(name: string): void;
}

/** Selects the world of the next run. */
export function WorldChoice({ worlds, world, own, busy, onWorld }: WorldChoiceProps) {
  const { run } = texts.value;
  const shipped = worlds.map((one) => [one.name, worldTitle(one, language.value)] as const);
  return (
    <Select
      icon={MapIcon}
      label={run.world}
      tip={run.world}
      testId="world"
      value={world}
      options={own === null ? shipped : [[OWN_WORLD, own], ...shipped]}
      disabled={busy}
      onChange={onWorld}
    />
  );
}
