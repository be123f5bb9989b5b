import { api } from "../api/client";
import type { Fault, World } from "../api/model";
import { fileName, saveFile } from "../app/save_file";
import { planOf } from "./document";
import { FILE_MOST_BYTES } from "./limits";

/** Why a file was not taken, in the server's words; without any it was too large to be read. */
export interface Refusal {
  readonly faults: readonly Fault[];
}

/** The world that a file holds, or why it was not taken. One with faults that can be drawn is to be mended here. */
export async function worldIn(file: File): Promise<World | Refusal> {
  if (file.size > FILE_MOST_BYTES) return { faults: [] };
  const text = await file.text();
  const world = parsed(text);
  const faults = await api.checkWorld(world ?? text);
  if (faults.length === 0 || canBeDrawn(world)) return world as World;
  return { faults };
}

export const isRefusal = (answer: World | Refusal): answer is Refusal => "faults" in answer;

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

/** Everything that the picture needs is there and of its kind. */
function canBeDrawn(world: unknown): boolean {
  try {
    const { width, depth, start, things } = planOf(world as World);
    return [width, depth, start, ...things].every(isSound);
  } catch {
    return false;
  }
}

/** No part of it is missing, a list, or something that is not a number where one belongs. */
function isSound(value: unknown): boolean {
  if (typeof value === "number") return Number.isFinite(value);
  if (typeof value === "string" || typeof value === "boolean" || value === null) return true;
  if (typeof value !== "object" || Array.isArray(value)) return false;
  return Object.entries(value).every(([key, part]) =>
    TEXTS.has(key) ? typeof part === "string" : typeof part !== "string" && isSound(part),
  );
}

const TEXTS = new Set(["id", "kind", "name", "color"]);

/** Hands a world to the person as a file, to be read by people too. */
export function exportWorld(document: World, title: string): void {
  const text = `${JSON.stringify(document, null, 2)}\n`;
  saveFile(`${fileName(title, "mundo")}.json`, new Blob([text], { type: "application/json" }));
}
