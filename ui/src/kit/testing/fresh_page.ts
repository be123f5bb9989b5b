/**
 * Run before each file of tests: the files of one worker share their document, module store and Blockly, for new ones
 * would take most of the time. Here they become as at the start, and nothing of the files before goes on.
 */
import { cleanup } from "@testing-library/preact";
import * as Blockly from "blockly";
import { vi } from "vitest";

/** What outlasts a file: timers that were begun, and the entries that Blockly has by itself. */
interface Lasting {
  timers: number[];
  blocklys: Set<unknown>;
}

const worker = globalThis as { lasting?: Lasting };
worker.lasting ??= {
  timers: trackTimers(),
  blocklys: new Set(blocklyStores().flatMap(Object.values)),
};

/** The ids of all timers that begin from now on. */
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
// no server: what a file before asks for again and again is never answered, so it ends
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
