import { computed, type ReadonlySignal, type Signal, signal } from "@preact/signals";
import { put } from "../api/client";
import type { PageSettings } from "../api/model";

/** Names and values of the settings, as the server declares them. */
export type SettingValues = Required<PageSettings>;
export type SettingName = keyof SettingValues;

/**
 * Settings of this PC. The server stores them and writes them into the page: the page's port may
 * change at every start, which empties its local storage, and cookies end with the window.
 */
const served: Partial<SettingValues> = JSON.parse(
  document.documentElement.dataset.settings ?? "{}",
);
const chosen = new Map<SettingName, Signal<string>>();
let sending: Promise<unknown> = Promise.resolve();

/** A setting; reading `.value` in a component subscribes it. */
export function setting<Name extends SettingName>(name: Name): ReadonlySignal<SettingValues[Name]> {
  return signalOf(name) as Signal<string> as Signal<SettingValues[Name]>;
}

function signalOf(name: SettingName): Signal<string> {
  const found = chosen.get(name) ?? signal<string>(served[name] ?? "");
  chosen.set(name, found);
  return found;
}

// If a page is reloaded at once, the server may serve it before it has read the last choice. The
// choice is therefore sent again.
const UNSENT = "pinel_unsent_";
let isLeaving = false;
addEventListener("beforeunload", () => {
  isLeaving = true;
});
for (const [key, value] of Object.entries(sessionStorage)) {
  if (key.startsWith(UNSENT)) void send(key.slice(UNSENT.length) as SettingName, value);
}

/**
 * Stores a choice on this PC; resolves once the server has it. If the server cannot store the
 * choice, it applies until the window closes.
 */
export async function choose<Name extends SettingName>(
  name: Name,
  value: SettingValues[Name],
): Promise<void> {
  if (signalOf(name).peek() !== value) await send(name, value);
}

function send(name: SettingName, value: string): Promise<void> {
  const now = signalOf(name);
  now.value = value;
  sessionStorage.setItem(UNSENT + name, value);
  // in sequence: of two concurrent requests, the server would store the one that arrives last
  const sent = sending
    .then(() => put("/api/settings/page", { body: { name, value }, keepalive: true }))
    .then(() => {
      // A later choice of the same setting may still be on its way, and the server may have served
      // the next page before this response.
      if (now.peek() === value && !isLeaving) sessionStorage.removeItem(UNSENT + name);
    })
    .catch(() => {});
  sending = sent;
  return sent;
}

const MAX_ENTRIES = 40;

type Entry = readonly [key: string, value: string];

/** A value for each of the newest groups or programs, newest first, stored as "KEY_VALUE_KEY_VALUE". */
export class SettingById {
  private readonly entries: ReadonlySignal<readonly Entry[]>;

  constructor(private readonly name: TextSetting) {
    const stored = setting(name);
    this.entries = computed(() => entriesOf(stored.value));
  }

  of(id: string): string | null {
    return this.entries.value.find(([key]) => key === keyOf(id))?.[1] ?? null;
  }

  /** Stores the value of an id; null removes it. */
  set(id: string, value: string | null): void {
    const others = this.entries.peek().filter(([key]) => key !== keyOf(id));
    const mine: readonly Entry[] = value === null ? [] : [[keyOf(id), value]];
    void choose(this.name, [...mine, ...others].slice(0, MAX_ENTRIES).flat().join("_"));
  }
}

/** Settings that may be any text. */
type TextSetting = {
  [Name in SettingName]: string extends SettingValues[Name] ? Name : never;
}[SettingName];

function entriesOf(text: string): readonly Entry[] {
  const parts = text.split("_");
  return parts.flatMap((key, at) => (at % 2 || !key ? [] : [[key, parts[at + 1] ?? ""] as const]));
}

/** The random part of an id, at its end. */
const keyOf = (id: string) => id.slice(-12);
