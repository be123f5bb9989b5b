import type { ReadonlySignal } from "@preact/signals";
import { language, texts } from "../../i18n";
import { decimal, headingDegrees } from "../../i18n/format";
import type { RunView } from "../reducer";

interface Cell {
  name: string;
  help: string;
  value: number;
  digits: number;
  unit: string;
  testId: string;
}

/** The robot's true position, as the floor shows it, and the elapsed time. */
export function Readout({ view }: { view: ReadonlySignal<RunView> }) {
  const { readout } = texts.value;
  const { truth, tick } = view.value;
  const heading = headingDegrees(truth.yaw);
  const cells: Cell[] = [
    {
      name: readout.x,
      help: readout.xHelp,
      value: truth.x,
      digits: 2,
      unit: "m",
      testId: "pose-x",
    },
    {
      name: readout.y,
      help: readout.yHelp,
      value: truth.y,
      digits: 2,
      unit: "m",
      testId: "pose-y",
    },
    {
      name: readout.heading,
      help: readout.headingHelp,
      value: heading,
      digits: 0,
      unit: "°",
      testId: "pose-heading",
    },
    {
      name: readout.elapsed,
      help: readout.elapsed,
      value: tick / 30,
      digits: 1,
      unit: "s",
      testId: "elapsed",
    },
  ];
  return (
    <dl class="readout grows shrinks" aria-label={readout.label}>
      {cells.map((cell) => (
        <div class="readout__cell column center shrinks" key={cell.testId} title={cell.help}>
          <dt>{cell.name}</dt>
          <dd data-testid={cell.testId} data-value={cell.value.toFixed(4)}>
            {rounded(cell)}
            {cell.unit === "°" ? "" : "\u00a0"}
            <span class="readout__unit">{cell.unit}</span>
          </dd>
        </div>
      ))}
    </dl>
  );
}

function rounded({ value, digits }: Cell): string {
  return decimal(value, digits, language.value);
}
