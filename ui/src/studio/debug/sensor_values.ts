import { computed, effect, signal } from "@preact/signals";
import { api } from "../../api/client";
import { sensorText } from "../../blocks/sensor_text";
import * as robot from "../../run/live";

/** A sensor reading of the program document. */
type Sensor = { readonly sensor: string };
type Row = readonly [name: string, value: unknown];

const MAX_SENSORS = 8;

/** Values of the program's sensors while the run is paused. */
export const sensorValues = signal<readonly Row[]>([]);

/** Reads the sensors at each pause of the run; returns the unsubscribe function. */
export function watchSensors(documentThatRuns: () => unknown): () => void {
  // telemetry continues briefly after a pause and must not trigger another reading
  const pause = computed(() => {
    const { run, phase, seq } = robot.live.value;
    return phase === "paused" && run ? `${seq} ${run}` : null;
  });
  return effect(() => {
    const { value: asked } = pause;
    sensorValues.value = [];
    const run = asked?.split(" ")[1];
    if (!run) return;
    void measured(run, sensorsIn(documentThatRuns())).then((rows) => {
      if (asked === pause.peek()) sensorValues.value = rows;
    });
  });
}

async function measured(run: string, sensors: readonly Sensor[]): Promise<readonly Row[]> {
  const answers = sensors.map(async (sensor) => {
    const { value, problem } = await api.command(run, { do: "evaluate", expression: sensor });
    return [sensorText(sensor), problem ?? value] as const;
  });
  return Promise.all(answers).catch(() => []);
}

/** The distinct sensor readings of a document with literal arguments, in document order. */
export function sensorsIn(document: unknown): readonly Sensor[] {
  const found = new Map<string, Sensor>();
  const waiting: unknown[] = [document];
  while (waiting.length > 0 && found.size < MAX_SENSORS) {
    const value = waiting.shift();
    if (typeof value !== "object" || value === null) continue;
    if ("sensor" in value && isPlain(value)) found.set(JSON.stringify(value), value as Sensor);
    else waiting.push(...Object.values(value));
  }
  return [...found.values()];
}

const isPlain = (node: object) => Object.values(node).every((part) => typeof part !== "object");
