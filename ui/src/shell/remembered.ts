import { signal } from "@preact/signals";
import { put } from "../api/client";

/**
 * Settings of this PC. The server keeps them and writes them into the page, because the page's port may change at every
 * start, and cookies end with the window.
 */
const kept: Record<string, string> = JSON.parse(document.documentElement.dataset.kept ?? "{}");

// A page that is reloaded at once may be served before the server has read what was chosen last: the choice is sent again.
const UNSENT = "pinel_unsent_";
for (const [key, value] of Object.entries(sessionStorage)) {
  if (key.startsWith(UNSENT)) send(key.slice(UNSENT.length), value);
}

/** A setting of this PC, or null. */
export function remembered(name: string): string | null {
  return kept[name] ?? null;
}

export function remember(name: string, value: string): void {
  if (kept[name] !== value) send(name, value);
}

function send(name: string, value: string): void {
  kept[name] = value;
  sessionStorage.setItem(UNSENT + name, value);
  put("/api/settings/page", { body: { name, value }, keepalive: true })
    .then(() => {
      // a later choice of the same setting may still be under way
      if (kept[name] === value) sessionStorage.removeItem(UNSENT + name);
    })
    // where the server cannot keep it, it holds until the window is closed
    .catch(() => {});
}

const MOST_KEPT = 40;

type Entry = readonly [key: string, word: string];

/** A word that this PC keeps for each of its groups or programs, the newest first: "KEY_WORD_KEY_WORD". */
export class KeptById {
  private readonly entries = signal<readonly Entry[]>([]);

  constructor(private readonly name: string) {
    const parts = (remembered(name) ?? "").split("_");
    this.entries.value = parts.flatMap((key, at) =>
      at % 2 || !key ? [] : [[key, parts[at + 1] ?? ""] as const],
    );
  }

  of(id: string): string | null {
    return this.entries.value.find(([key]) => key === keyOf(id))?.[1] ?? null;
  }

  /** Keeps a word; null forgets it. */
  keep(id: string, word: string | null): void {
    const others = this.entries.peek().filter(([key]) => key !== keyOf(id));
    const mine: readonly Entry[] = word === null ? [] : [[keyOf(id), word]];
    this.entries.value = [...mine, ...others].slice(0, MOST_KEPT);
    remember(this.name, this.entries.value.flat().join("_"));
  }
}

/** The random end of an id. */
const keyOf = (id: string) => id.slice(-12);
