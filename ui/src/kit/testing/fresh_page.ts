/**
 * Runs before each test file. The files of one worker share document, module store and Blockly,
 * because creating new ones would take most of the time. This file resets them, and stops the
 * timers of earlier files.
 */
import { cleanup } from "@testing-library/preact";
import * as Blockly from "blockly";
import { vi } from "vitest";

/**
 * State that outlasts a test file: started timers, and the entries that Blockly registers itself.
 */
interface Lasting {
  timers: number[];
  blocklys: Set<unknown>;
}

const worker = globalThis as { lasting?: Lasting };
worker.lasting ??= {
  timers: trackTimers(),
  blocklys: new Set(blocklyStores().flatMap(Object.values)),
};

/** Records the ids of all timers that start from now on. */
function trackTimers(): number[] {
  const timers: number[] = [];
  for (const name of ["setTimeout", "setInterval"] as const) {
    const begin = globalThis[name] as (...given: unknown[]) => unknown;
    const tracked = (...given: unknown[]) => {
      const timer = begin(...given);
      timers.push(Number(timer));
      return timer;
    };
    Object.assign(globalThis, { [name]: tracked });
  }
  return timers;
}

function blocklyStores(): Record<string, unknown>[] {
  return [
    Blockly.Blocks,
    Blockly.Extensions.TEST_ONLY.allExtensions,
    ...Object.values(Blockly.registry.TEST_ONLY.typeMap),
  ];
}

function emptyDocument(): void {
  document.head.replaceChildren();
  document.body.replaceChildren();
  for (const { attributes } of [document.documentElement, document.body]) {
    for (const { name } of [...attributes]) attributes.removeNamedItem(name);
  }
}

cleanup();
for (const timer of worker.lasting.timers.splice(0)) clearTimeout(timer);
vi.useRealTimers();
vi.unstubAllGlobals();
// requests never get a response, so that polling of an earlier file ends
Object.assign(globalThis, { fetch: () => new Promise(() => {}) });
vi.resetModules();
localStorage.clear();
sessionStorage.clear();
emptyDocument();
for (const store of blocklyStores()) {
  for (const [name, entry] of Object.entries(store)) {
    if (!worker.lasting.blocklys.has(entry)) delete store[name];
  }
}
