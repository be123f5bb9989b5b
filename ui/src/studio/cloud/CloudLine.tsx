import { Waypoints, X } from "lucide-preact";
import type { CloudRow } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Select } from "../../kit/Select";
import type { CloudControl } from "./cloud_control";

interface CloudLineProps {
  of: CloudControl;
  /** What the mission gives to the program in each of its cases, as text. */
  cases: readonly string[];
  onCase(number: number): void;
}

/** What the 50 robots did, in a sentence, and what can be chosen; nothing while none were asked for. */
export function CloudLine({ of, cases, onCase }: CloudLineProps) {
  const { value: now } = of.now;
  const { cloud } = texts.value;
  if (!now) return null;
  const isOver = now.end !== null && !of.isStale.value;
  return (
    <section
      class={`cloud-line row middle gap-2 ${of.isStale.value ? "cloud-line--stale" : ""}`}
      aria-label={cloud.label}
      data-testid="cloud-line"
      data-state={of.isStale.value ? "stale" : isOver ? "over" : "under-way"}
      data-good={now.end?.good.length ?? ""}
      data-arrived={now.rows.length}
    >
      <Waypoints class="icon rigid" aria-hidden="true" />
      <p class="grows shrinks" title={sentenceOf(of)} data-testid="cloud-text">
        {sentenceOf(of)}
      </p>
      {/* the sentence at the end only: a reader would otherwise read every robot */}
      <output class="visually-hidden">{of.isRunning.value ? "" : sentenceOf(of)}</output>
      <div class="column gap-1 rigid">
        <Cases of={of} cases={cases} onCase={onCase} />
        {isOver && now.rows.length > 0 && <Robots of={of} rows={of.rows.value} />}
      </div>
      <Button icon={X} tip={cloud.close} testId="cloud-close" onPress={() => of.close()} />
    </section>
  );
}

/** Chooses what a mission gives to the robots, where it tries a program with several signs, answers or starts. */
function Cases({ of, cases, onCase }: CloudLineProps) {
  const { cloud } = texts.value;
  if (cases.length < 2) return null;
  return (
    <Select
      class="cloud-line__choice"
      label={cloud.case}
      tip={cloud.caseHelp}
      testId="cloud-case"
      disabled={of.isRunning.value}
      value={of.now.value?.reads.case ?? 1}
      options={cases.map((given, index) => [index + 1, given] as const)}
      onChange={onCase}
    />
  );
}

function sentenceOf({ now, isStale }: CloudControl): string {
  const { cloud } = texts.value;
  const { value: shown } = now;
  if (!shown) return "";
  const { end, n, rows, before } = shown;
  if (!end) return cloud.arrived({ count: rows.length, all: n });
  if (isStale.value) return cloud.changed({ good: end.good.length, all: rows.length });
  const both = before === null ? "" : cloud.before({ good: before, now: end.good.length });
  return [end.text, both].filter(Boolean).join(" ");
}

/** Chooses a robot, which then drives as a run of its own. */
function Robots({ of, rows }: { of: CloudControl; rows: readonly CloudRow[] }) {
  const { cloud } = texts.value;
  const sorted = [...rows].sort(
    (one, other) => Number(one.well) - Number(other.well) || one.seed - other.seed,
  );
  const nameOf = ({ seed, cause, well }: CloudRow) =>
    well ? `● ${cloud.well({ n: seed })}` : `✕ ${cloud[cause ?? "apart"]({ n: seed })}`;
  return (
    <Select
      class="cloud-line__choice"
      label={cloud.see}
      tip={cloud.seeHelp}
      testId="cloud-see"
      value={0}
      options={[[0, cloud.see] as const, ...sorted.map((row) => [row.seed, nameOf(row)] as const)]}
      onChange={(seed) => (seed ? of.runOne(seed) : undefined)}
    />
  );
}
