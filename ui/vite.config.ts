import { cpSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import { defineConfig } from "vitest/config";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** Blockly looks for its cursors and sounds at its maker's host unless they are shipped with the page. */
function blocklyMedia(): Plugin {
  let outDir = "";
  return {
    name: "pinel-blockly-media",
    apply: "build",
    configResolved(config) {
      outDir = config.build.outDir;
    },
    closeBundle() {
      cpSync(here("node_modules/blockly/media"), `${outDir}/media`, { recursive: true });
    },
  };
}

/** Blocks that are drawn before their font is there are drawn twice: fonts are fetched beside the code. */
function fontsEarly(): Plugin {
  return {
    name: "pinel-fonts-early",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(_html, { bundle }) {
        const fonts = Object.keys(bundle ?? {}).filter((name) => name.endsWith(".woff2"));
        return fonts.map((name) => ({
          tag: "link",
          attrs: { rel: "preload", as: "font", href: `/${name}`, crossorigin: true },
          injectTo: "head" as const,
        }));
      },
    },
  };
}

/**
 * The texts of the chosen language must be there before the first drawing, without another journey to the server: for
 * each language a page that fetches them beside the code. `pinel_desktop/web/page.py` chooses among them.
 */
function pagePerLanguage(): Plugin {
  return {
    name: "pinel-page-per-language",
    apply: "build",
    enforce: "post",
    generateBundle(_options, bundle) {
      const html = bundle["index.html"];
      if (html?.type !== "asset") throw new Error("there is no index.html");
      for (const chunk of Object.values(bundle)) {
        if (chunk.type !== "chunk") continue;
        const [, tag] = /i18n\/([\w-]+)\/start\.ts$/.exec(chunk.facadeModuleId ?? "") ?? [];
        if (!tag) continue;
        const parts = chunk.imports.filter((name) => !String(html.source).includes(name));
        const texts = [
          `<script type="module" crossorigin src="/${chunk.fileName}"></script>\n    `,
          ...parts.map((name) => `<link rel="modulepreload" crossorigin href="/${name}">\n    `),
        ].join("");
        const source = String(html.source)
          .replace(/<html lang="[\w-]+">/, `<html lang="${tag}">`)
          .replace('<script type="module"', `${texts}<script type="module"`);
        this.emitFile({ type: "asset", fileName: `index.${tag}.html`, source });
      }
    },
  };
}

export default defineConfig({
  base: "/",
  plugins: [blocklyMedia(), fontsEarly(), pagePerLanguage()],
  build: {
    outDir: here("../pinel_desktop/web/static"),
    emptyOutDir: true,
    target: "es2022",
    chunkSizeWarningLimit: 1500,
    modulePreload: { polyfill: false },
    // what the start needs is one file, whatever parts that come later have in common with it
    rolldownOptions: {
      output: { codeSplitting: { groups: [{ name: "start", tags: ["$initial"] }] } },
    },
  },
  server: { fs: { allow: [here("..")] } },
  test: {
    environment: "jsdom",
    // a document and a module store for each file took most of the time: fresh_page.ts empties those of its worker
    isolate: false,
    maxWorkers: "100%",
    setupFiles: [
      "src/kit/testing/fresh_page.ts",
      "src/i18n/testing/all_languages.ts",
      "src/kit/testing/timeouts.ts",
    ],
    // nothing is measured by it: parts that are fetched when needed, and axe, take longer beside other work
    testTimeout: 30_000,
    hookTimeout: 30_000,
    include: ["src/**/*.test.ts", "src/**/*.test.tsx", "test/**/*.test.ts"],
  },
});
