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

export default defineConfig({
  base: "/",
  plugins: [blocklyMedia(), fontsEarly()],
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
    include: ["src/**/*.test.ts", "src/**/*.test.tsx", "test/**/*.test.ts"],
  },
});
