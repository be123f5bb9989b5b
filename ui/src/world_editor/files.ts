import { api } from "../api/client";
import { WORLD_LIMITS } from "../api/declared";
import type { Fault, World } from "../api/model";
import { fileName, saveFile } from "../shell/files/save_file";
import { planOf } from "./document";

/** Why a file was rejected: the server's faults, or an empty list for a file that is too large to read. */
export interface Refusal {
  readonly faults: readonly Fault[];
}

/** The world in a file, or why it was rejected. Accepts a world with faults if it can be drawn. */
export async function worldIn(file: File): Promise<World | Refusal> {
  if (file.size > WORLD_LIMITS.MAX_BYTES) return { faults: [] };
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

/** Whether the document has all fields that drawing needs, with the right types. */
function canBeDrawn(world: unknown): boolean {
  try {
    const { width, depth, start, objects } = planOf(world as World);
    return [width, depth, start, ...objects].every(isWellFormed);
  } catch {
    return false;
  }
}

/** Checks recursively that no part is missing or a list, and that all numbers are finite. */
function isWellFormed(value: unknown): boolean {
  if (typeof value === "number") return Number.isFinite(value);
  if (typeof value === "string" || typeof value === "boolean" || value === null) return true;
  if (typeof value !== "object" || Array.isArray(value)) return false;
  return Object.entries(value).every(([key, part]) =>
    TEXTS.has(key) ? typeof part === "string" : typeof part !== "string" && isWellFormed(part),
  );
}

const TEXTS = new Set(["id", "kind", "name", "color"]);

/** Downloads a world as an indented JSON file. */
export function exportWorld(document: World, title: string): void {
  const text = `${JSON.stringify(document, null, 2)}\n`;
  saveFile(`${fileName(title, "mundo")}.json`, new Blob([text], { type: "application/json" }));
}
