import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import { manualOf, NAMES } from "./manual_pages.ts";

const DOCS = fileURLToPath(new URL("../docs/", import.meta.url));
const MODULE = /^\0virtual:manuals\/([\w-]+)$/;

/** How the files of a language end: each page is there in each of these languages. */
const ENDINGS: Readonly<Record<string, string>> = { "pt-BR": ".pt-BR.md", en: ".md" };

/**
 * Makes a module of the manuals in each language that has them, and the list of these languages (`virtual:manuals`).
 */
export function manuals(): Plugin {
  return {
    name: "pinel-manuals",
    resolveId: (id) => (/^virtual:manuals(\/|$)/.test(id) ? `\0${id}` : null),
    load(id) {
      if (id === "\0virtual:manuals") return listOfLanguages();
      const language = MODULE.exec(id)?.[1];
      if (!language) return null;
      for (const name of NAMES) this.addWatchFile(DOCS + name + ENDINGS[language]);
      return moduleOf(language);
    },
  };
}

function listOfLanguages(): string {
  const rows = Object.keys(ENDINGS).map(
    (tag) => `${JSON.stringify(tag)}: () => import("virtual:manuals/${tag}")`,
  );
  return `export const rows = { ${rows.join(", ")} };`;
}

/** A module with all manuals of a language. Their pictures are imported, so that Vite copies them into the page. */
function moduleOf(language: string): string {
  const ending = ENDINGS[language] ?? "";
  const pictures: string[] = [];
  const all = NAMES.map((name) => manualOf(name, readFileSync(DOCS + name + ending, "utf8")));
  const source = JSON.stringify(all).replace(/"picture:(.+?)"/g, (_, path: string) => {
    if (!pictures.includes(path)) pictures.push(path);
    return `picture${pictures.indexOf(path)}`;
  });
  const imports = pictures.map(
    (path, index) => `import picture${index} from ${JSON.stringify(`${DOCS}${path}?url`)};\n`,
  );
  return `${imports.join("")}export const manuals = ${source};`;
}
