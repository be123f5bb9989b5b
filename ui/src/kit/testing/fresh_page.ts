/**
 * Run before each file of tests: the files of one worker share their document, module store and Blockly, for new ones
 * would take most of the time. Here they become as at the start.
 */
import * as Blockly from "blockly";
import { vi } from "vitest";

/** Entries of Blockly's own before the first file added any. */
const shared = globalThis as { blocklys?: Set<unknown> };

function stores(): Record<string, unknown>[] {
  return [
    Blockly.Blocks,
    Blockly.Extensions.TEST_ONLY.allExtensions,
    ...Object.values(Blockly.registry.TEST_ONLY.typeMap),
  ];
}

vi.resetModules();
localStorage.clear();
sessionStorage.clear();
document.head.replaceChildren();
document.body.replaceChildren();
for (const { attributes } of [document.documentElement, document.body]) {
  for (const { name } of [...attributes]) attributes.removeNamedItem(name);
}
shared.blocklys ??= new Set(stores().flatMap(Object.values));
for (const store of stores()) {
  for (const [name, entry] of Object.entries(store))
    if (!shared.blocklys.has(entry)) delete store[name];
}
