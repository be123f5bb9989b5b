import { signal } from "@preact/signals";
import type { Robot } from "../api/model";

/** The robot models that the server knows, the default first; empty until they are loaded. */
export const robotModels = signal<readonly Robot[]>([]);

/** The record of a model; the default for null and for one of a newer release, null until the records are loaded. */
export function robotOf(model: string | null | undefined): Robot | null {
  const { value: models } = robotModels;
  return models.find(({ name }) => name === model) ?? models[0] ?? null;
}
