import { cpSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";
import { defineConfig } from "vitest/config";
import { languages, tagOfStartModule } from "./languages.ts";
import { manuals } from "./manuals.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/**
 * Copies Blockly's cursors and sounds into the page. Otherwise Blockly would load them from its
 * maker's host.
 */
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

/**
 * Preloads the fonts in parallel with the code: blocks that are drawn before their font are drawn
 * twice.
 */
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
 * Builds one page per language, which loads its texts in parallel with the code. The first drawing
 * needs the texts, and a second round trip to the server would delay it.
 * `pinel_desktop/web/page.py` chooses the page.
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
        const tag = tagOfStartModule(chunk.facadeModuleId);
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
  plugins: [languages(), manuals(), blocklyMedia(), fontsEarly(), pagePerLanguage()],
  build: {
    outDir: here("../pinel_desktop/web/static"),
    emptyOutDir: true,
    target: "es2022",
    chunkSizeWarningLimit: 1500,
    modulePreload: { polyfill: false },
    // one file for the start, even for modules that lazy parts also import
    rolldownOptions: {
      output: { codeSplitting: { groups: [{ name: "start", tags: ["$initial"] }] } },
    },
  },
  server: { fs: { allow: [here("..")] } },
  test: {
    environment: "jsdom",
    // test files share document and module store, because creating them took most of the time;
    // fresh_page.ts resets them
    isolate: false,
    maxWorkers: "100%",
    setupFiles: [
      "src/kit/testing/fresh_page.ts",
      "src/i18n/testing/all_languages.ts",
      "src/kit/testing/timeouts.ts",
    ],
    // generous, because lazy parts and axe are slow on a busy PC; no test measures time with it
    testTimeout: 30_000,
    hookTimeout: 30_000,
    include: ["src/**/*.test.ts", "src/**/*.test.tsx", "test/**/*.test.ts"],
  },
});
