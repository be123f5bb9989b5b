import { existsSync, readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";

const CATALOGUE = fileURLToPath(new URL("../pinel_desktop/messages/catalogue", import.meta.url));
const BLOCKLY = fileURLToPath(new URL("./node_modules/blockly/msg", import.meta.url));
const TEXTS = /^\0virtual:texts\/([\w-]+)\/(start|lazy)$/;

/** Areas of the page that are fetched with the first part that is loaded lazily. All others are needed at the start. */
const LAZY = [
  "album",
  "camera",
  "captured",
  "exchange",
  "game",
  "help",
  "kiosk",
  "plan",
  "review",
  "teacher",
];
/** Files with messages of the server that the page needs too, by their properties in `Texts`. */
const SERVER_MESSAGES = {
  start: { reasons: ["program", "robots", "run"] },
  lazy: { cameraProblems: ["camera", "gestures"], figures: ["review"] },
};

/**
 * Makes a module of each language from its folder of the catalogue, in two parts, and the list of the languages
 * (`virtual:languages`). A language takes its folder and nothing else.
 */
export function languages(): Plugin {
  return {
    name: "pinel-languages",
    resolveId: (id) => (/^virtual:(languages$|texts\/)/.test(id) ? `\0${id}` : null),
    load(id) {
      if (id === "\0virtual:languages") return listOfLanguages();
      const [, tag, part] = TEXTS.exec(id) ?? [];
      if (!tag || (part !== "start" && part !== "lazy")) return null;
      return part === "start"
        ? `${blocklyImport(tag)}\n${moduleOf(tag, part)}`
        : moduleOf(tag, part);
    },
  };
}

/** The tag of a module of texts for the start, or null. */
export const tagOfStartModule = (id: string | null): string | null =>
  TEXTS.exec(id ?? "")?.[2] === "start" ? (TEXTS.exec(id ?? "")?.[1] ?? null) : null;

function listOfLanguages(): string {
  const rows = readdirSync(CATALOGUE).map((tag) => {
    const { name } = read(`${tag}/language.json`) as { name: string };
    const parts = ["start", "lazy"].map(
      (part) => `${part}: () => import("virtual:texts/${tag}/${part}")`,
    );
    return `${JSON.stringify(tag)}: { name: ${JSON.stringify(name)}, ${parts.join(", ")} }`;
  });
  return `export const rows = { ${rows.join(", ")} };`;
}

/** Blockly's own messages. Where Blockly lacks a language, its English stands for what our catalogue does not say. */
function blocklyImport(tag: string): string {
  const [short = ""] = tag.split("-");
  const known = [tag.toLowerCase(), short, "en"].find((name) =>
    existsSync(`${BLOCKLY}/${name}.js`),
  );
  return `import * as blockly from "blockly/msg/${known}";`;
}

function moduleOf(tag: string, part: "start" | "lazy"): string {
  const names = readdirSync(`${CATALOGUE}/${tag}/page`).map((file) => file.replace(/\.json$/, ""));
  const areas = names.filter((name) => LAZY.includes(name) === (part === "lazy"));
  const { editor, ...texts } = merged(areas.map((area) => `${tag}/page/${area}`));
  const messages = Object.entries(SERVER_MESSAGES[part]).map(([name, files]) => {
    const content = merged(files.map((file) => `${tag}/${file}`));
    return `${name}: ${JSON.stringify(content)}`;
  });
  if (editor) messages.push(`blockly: { ...blockly, ...${JSON.stringify(editor)} }`);
  return `export const texts = ${JSON.stringify(texts)};\nexport const messages = { ${messages.join(", ")} };`;
}

const merged = (paths: readonly string[]): Record<string, unknown> =>
  Object.assign({}, ...paths.map((path) => read(`${path}.json`)));

const read = (path: string): unknown => JSON.parse(readFileSync(`${CATALOGUE}/${path}`, "utf8"));
