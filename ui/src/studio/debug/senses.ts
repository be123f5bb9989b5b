import { computed, effect, signal } from "@preact/signals";
import { api } from "../../api/client";
import { sensorWords } from "../../blocks/sensor_words";
import * as robot from "../../run/live";

/** A sensor as the document has it. */
type Sensor = { readonly sensor: string };
type Row = readonly [name: string, value: unknown];

const MOST = 8;

/** What the sensors that the program asks measure, while it stands. */
export const senses = signal<readonly Row[]>([]);

/** Asks the sensors each time the run pauses; the answer ends that. */
export function watchSensors(documentThatRuns: () => unknown): () => void {
  // telemetry goes on for a moment after a pause, and is no reason to ask again
  const pause = computed(() => {
    const { run, phase, seq } = robot.live.value;
    return phase === "paused" && run ? `${seq} ${run}` : null;
  });
  return effect(() => {
    const { value: asked } = pause;
    senses.value = [];
    const run = asked?.split(" ")[1];
    if (!run) return;
    void measured(run, sensorsIn(documentThatRuns())).then((rows) => {
      if (asked === pause.peek()) senses.value = rows;
    });
  });
}

async function measured(run: string, sensors: readonly Sensor[]): Promise<readonly Row[]> {
  const answers = sensors.map(async (sensor) => {
    const { value, problem } = await api.command(run, { do: "evaluate", expression: sensor });
    return [sensorWords(sensor), problem ?? value] as const;
  });
  return Promise.all(answers).catch(() => []);
}

/** The different sensors in a document whose place is written out, in its order. */
export function sensorsIn(document: unknown): readonly Sensor[] {
  const found = new Map<string, Sensor>();
  const waiting: unknown[] = [document];
  while (waiting.length > 0 && found.size < MOST) {
    const value = waiting.shift();
    if (typeof value !== "object" || value === null) continue;
    if ("sensor" in value && isPlain(value)) found.set(JSON.stringify(value), value as Sensor);
    else waiting.push(...Object.values(value));
  }
  return [...found.values()];
}

const isPlain = (node: object) => Object.values(node).every((part) => typeof part !== "object");
